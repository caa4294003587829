// SPDX-License-Identifier: MIT
// Rigid motions of least energy through keyframes, or near them (Hofer, Pottmann 2004, sec. 4.2).
//
// In the metric (9) a motion's energy is that of the barycentre's path, times the mass, and that of the rotation: two
// splines that do not know of each other. The first is a classical one, in closed form (natural_cubic.h). The second is
// found by the optimizer on the manifold of rotations (rotation_manifold.h): from rotations at constant speed, first
// with 6 intervals a segment; the cubic through these is so near that the fine chain takes one round or two.
//
// Among obstacles (sec. 5, Fig. 16) the barycentre's path is a spline around them instead (obstacle_spline.cpp). With a
// clearance of the body's radius the whole body stays out of them, however it turns.
//
// Invariants: keys are passed through to rounding, unless smoothing; the barycentre's path does not depend on the
// rotations.
#pragma once

#include <memory>
#include <vector>

#include "core/origin.h"
#include "filigree/filigree_motion.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "splines/motion/motion_keys.h"
#include "splines/spline.h"

namespace flg {

struct MotionInput {
    explicit MotionInput(Memory* memory) : times(memory), poses(memory), sides(memory) {}

    FlgMotionDesc desc{};  // checked, its defaults filled in; its handles are resolved below, its arrays copied
    Origin origin{};       // of the poses' positions
    BodyInertia body;
    std::pmr::vector<double> times, poses;  // of keys, see motion_keys.h
    // What the barycentre keeps out of, or null; see SplineRequest.
    std::shared_ptr<const Obstacles> obstacles;
    std::pmr::vector<ObstacleSide> sides;

    // The energy's, see SplineProblem; tension: per second squared.
    double bending() const { return desc.energy == FLG_SPLINE_ENERGY_E1 ? 0 : 1; }
    double tension() const {
        return desc.energy == FLG_SPLINE_ENERGY_ET ? desc.tension : desc.energy == FLG_SPLINE_ENERGY_E1 ? 1 : 0;
    }
};

// The motion after a round.
struct MotionState {
    Buffer<double> poses, quaternions;  // 12 and 4 (x, y, z, w) a position
    SplineReport report;                // of the rotations
    double barycentre_energy = 0;       // without the mass
};

class Motion final : public Product {
public:
    Motion(MotionInput given, Memory* memory);

    MotionInput input;
    Buffer<double> times;            // one a position, closed: one more
    Buffer<uint32_t> key_positions;  // one a key
    double greatest_stretch = 0;     // of the keys' poses
    TripleBuffer<MotionState> states;

    const FlgMotionView& view() const { return view_; }
    void publish_partial() noexcept override;

private:
    void show() noexcept override;

    FlgMotionView view_{};
};

// The whole of flgMotionCreate.
Task<void> make_motion(Pace& pace, std::shared_ptr<Motion> out);

}  // namespace flg
