// SPDX-License-Identifier: MIT
// A surface pulled at some of its points: a few rounds of the local and the global step of pull_system.h from where it
// was. E never rises from round to round, if rest and handles stay.
//
// Handles are exact: with the factor's columns for what handles hold (kept from frame to frame) a small system, whose
// matrix is the response of each handle to a force at another, gives the forces (a Schur complement). Springs add their
// compliance to its diagonal.
//
// A force at one vertex pulls a spike out of a surface. So a handle with a radius is met at its point, but its force
// acts on a patch: on the surface within a ball around the point at rest that hangs together with it, densest in the
// middle. The surface then has least energy under the loads of the patches. Patches end half way to the next handle.
//
// The rest positions may be those of a pose: rotations are relative to it, and a surface that nobody pulls at is where
// its bones have it.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/vec.h"
#include "pulling/pull_system.h"

namespace flg {

// Something on the surface that is to be somewhere.
struct PullHandle {
    std::array<uint32_t, 3> vertices{};  // of the mesh
    std::array<double, 3> shares{};      // sum 1
    Vec3 at = Vec3::Zero();
    double compliance = 0;  // 0: it is there exactly; c: it gives way by c times what pulls at it
    double radius = 0;      // metres, of its patch; 0: the point alone; below 0: usual_radius

    bool holds_as(const PullHandle& other) const { return vertices == other.vertices && shares == other.shares; }
};

// How a surface answers to a force at a handle, per place.
struct PullResponse {
    PullHandle handle;  // its radius is that of its patch
    Buffer<double> values;
};

struct PulledState {
    explicit PulledState(Memory* memory) : responses(memory) {}

    // By place: three numbers and one that is not used; x, y, z, w.
    Buffer<double> moved;  // from the rest position
    Buffer<double> rotations;
    std::pmr::vector<std::shared_ptr<const PullResponse>> responses;
    double energy = 0;  // in the last round, with its rotations, before positions were found
};

// A share of the mesh's size, but at least two of the edges beside the handle.
double usual_radius(const PullSystem& system, const PullHandle& handle);

// One handle per constraint, at most 256, of which no two hold the same. `rest`: by vertex, three numbers. `previous`:
// null: from rest. Takes about 0.25 ms a round and 1000 vertices, and 0.1 ms for each new handle.
Task<void> pull(Pace& pace, const PullSystem& system, std::span<const float> rest, std::span<const PullHandle> handles,
                const PulledState* previous, uint32_t rounds, PulledState& out);

}  // namespace flg
