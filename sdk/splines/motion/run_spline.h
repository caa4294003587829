// SPDX-License-Identifier: MIT
// The spline of one run of a motion, from pause to pause (Hofer, Pottmann 2004, sec. 4.2).
//
// In the metric (9) a motion's energy is that of the barycentre's path, times the mass, and that of the rotation: two
// splines that do not know of each other. The first is a classical one, in closed form (natural_cubic.h). The second is
// found by the optimizer on the manifold of rotations (rotation_manifold.h): from rotations at constant speed, first
// with 6 intervals a segment; the cubic through these is so near that the fine chain takes one round or two.
//
// Where a pause begins or ends the spline is clamped: the least energy of all that stand still there.
//
// E1 of a chain is that of a polyline, off by the square of the step. A second chain with half the step takes that term
// away (Richardson): then the error falls with the fourth power, as that of E2 and E_t.
//
// Among obstacles (sec. 5, Fig. 16) the barycentre's path is a spline around them instead (obstacle_spline.cpp).
#pragma once

#include "splines/manifolds/rotation_manifold.h"
#include "splines/motion/motion.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

// The nodes of a run: where keys are, and when nodes are passed.
struct RunChain {
    uint32_t nodes;
    Buffer<uint32_t> knots;  // one a key
    Buffer<double> times;    // one a key, closed: one more
};

// Goes along the nodes of a chain: each one's segment, and its share of that.
class ChainWalk {
public:
    explicit ChainWalk(const RunChain& chain) : chain_(chain) {}
    void go_to(uint32_t node);

    uint32_t segment = 0;  // at the end of an open chain the number of segments
    double share = 0, time = 0;

private:
    const RunChain& chain_;
};

struct RunScene {
    const MotionInput& input;
    const MotionKeys& keys;
    const RotationManifold& rotations;
    MotionRun run;

    uint32_t segments() const { return run.closed ? run.keys : run.keys - 1; }
    // Of all keys.
    size_t key(uint32_t of_run) const { return (run.first + (of_run == run.keys ? 0 : of_run)) % keys.count(); }
    // Of its splines: infinite for E1.
    double tension() const;
    CubicEnds ends() const;
};

// Who wants to see rounds. The rotations are those of the round.
class RoundWatch {
public:
    virtual Task<void> show(Pace& pace, const SplineReport& report) = 0;

protected:
    ~RoundWatch() = default;
};

// The barycentre's places, 3 numbers a node. Returns the energy, without the mass. Some 100 ns a node.
Task<double> run_path(Pace& pace, const RunScene& scene, const RunChain& chain, double* path);

// The rotations, 9 numbers a node (rotation_manifold.h). Some 12 us a node; E1 three times that. `watch` may be null.
Task<SplineReport> run_rotations(Pace& pace, const RunScene& scene, const RunChain& chain, double* rotations,
                                 RoundWatch* watch);

}  // namespace flg
