// SPDX-License-Identifier: MIT
// Rigid motions of least energy through keyframes, or near them (Hofer, Pottmann 2004, sec. 4.2).
//
// Pauses cut a motion into runs; each run is a spline of its own (run_spline.h). What comes after moves no place: time
// laws (time_law.h) say when the path is passed. In turn: constant speed, eases at keys, limits. A law's motion is
// sampled from the cubics through the spline's nodes, whose error falls with the fourth power of their distance. Last,
// bodies that look get their rotations (look_at.h).
//
// With a clearance of the body's radius the whole body stays out of obstacles, however it turns.
//
// Invariants: keys are passed through to rounding, unless smoothing; the barycentre's path does not depend on the
// rotations; without laws the spline's nodes are the motion, to the bit.
#pragma once

#include <memory>
#include <vector>

#include "core/origin.h"
#include "filigree/filigree_motion.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "splines/motion/look_at.h"
#include "splines/motion/motion_keys.h"
#include "splines/motion/time_law.h"
#include "splines/spline.h"

namespace flg {

struct MotionInput {
    explicit MotionInput(Memory* memory) : times(memory), poses(memory), eases(memory), sides(memory), look(memory) {}

    FlgMotionDesc desc{};  // checked, its defaults filled in; its handles are resolved below, its arrays copied
    Origin origin{};       // of the poses' positions
    BodyInertia body;
    std::pmr::vector<double> times, poses, eases;  // of keys, see motion_keys.h
    // What the barycentre keeps out of, or null; see SplineRequest.
    std::shared_ptr<const Obstacles> obstacles;
    std::pmr::vector<ObstacleSide> sides;
    Look look;

    // The energy's, see SplineProblem; tension: per second squared.
    double bending() const { return desc.energy == FLG_SPLINE_ENERGY_E1 ? 0 : 1; }
    double tension() const {
        return desc.energy == FLG_SPLINE_ENERGY_ET ? desc.tension : desc.energy == FLG_SPLINE_ENERGY_E1 ? 1 : 0;
    }
    MotionLimits limits() const {
        return {desc.max_speed, desc.max_acceleration, desc.max_turn, desc.max_turn_acceleration};
    }
};

// The motion after a round.
struct MotionState {
    Buffer<double> poses, quaternions;  // 12 and 4 (x, y, z, w) a position
    SplineReport report;                // of the rotations
    double barycentre_energy = 0;       // without the mass
    double length = 0;                  // of the barycentre's path, m
    // The greatest of all positions: m/s, m/s^2, rad/s, rad.
    double speed = 0, acceleration = 0, turn = 0, bank = 0;
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
