// SPDX-License-Identifier: MIT
// Cables that hang between points, do not stretch or bend back, and rest on solids: the chain of least potential energy
// among those that go around the solids as it does.
//
// Free ones are catenaries in closed form. Others fall from the straight way between their ends or, where that is
// blocked, from the shortest way over the solids (cable_way.h), onto planes that part them from these
// (cable_contacts.h), and slide until they rest (hanging_chain.h).
//
// Invariants: ends stay where they are, to the bit; each segment of one that rests is as long as `lengths` says, to
// 1e-8 of it; all of it keeps out of solids by their clearance: of balls, boxes, capsules and half-spaces by the
// convexity of their distance, of meshes by their triangles, of others at places that are looked at.
#pragma once

#include "curves/curve_set.h"
#include "runtime/pace.h"
#include "splines/obstacles/obstacles.h"

namespace flg {

struct CableRequest {
    Buffer<double> points;     // 3 numbers each
    Buffer<uint32_t> offsets;  // of cables, one more than there are
    Buffer<double> lengths;    // metres, one a span
    uint32_t segments = 64;    // of a span
    Vec3 down = -Vec3::UnitZ();
    std::shared_ptr<const Obstacles> obstacles;  // or null
    std::shared_ptr<CurveSet> out;               // has its origin, that of the points
};

// The whole of flgCableHang.
Task<void> hang_cables(Pace& pace, CableRequest request);

struct HungCable {
    explicit HungCable(Memory* memory) : places(memory), lengths(memory) {}
    std::pmr::vector<Vec3> places;     // segments + 1
    std::pmr::vector<double> lengths;  // of the cable from its first end, as many
    uint32_t rounds = 0;               // of Newton's method; 0: a catenary
};

// One span of it. `size`: of the scene, metres. Throws a Failure that names points `number` and the next.
Task<HungCable> hang_cable(Pace& pace, const ObstacleSet* obstacles, Vec3 from, Vec3 to, double length,
                           uint32_t segments, Vec3 down, double size, uint32_t number);

}  // namespace flg
