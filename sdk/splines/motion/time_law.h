// SPDX-License-Identifier: MIT
// When a path is passed: a time law says which of the path's parameters comes at a time. The path itself stays.
//
// Between its entries a law is the cubic with given rates at both ends (Hermite), so it rises with them (Fritsch,
// Carlson: Monotone piecewise cubic interpolation, 1980: no rate is above three times the mean one).
//
// Limits of speed and acceleration (Bobrow, Dubowsky, Gibson: Time-optimal control of robotic manipulators along
// specified paths, 1985; Pham, Pham: A new approach to time-optimal path parameterization based on reachability
// analysis, 2018). With the square v of the rate the acceleration of x(s) is x'' v + x' v' / 2. So each node bounds v,
// and v' as a function of v; the greatest v that keeps to both comes of one pass forwards and one backwards. Between
// nodes v is linear: the rates' mean is that of the interval, and the law exact. Where the velocity jumps v is so small
// that a step would take up the jump.
#pragma once

#include <span>

#include "core/vec.h"
#include "runtime/each.h"

namespace flg {

struct TimeLaw {
    TimeLaw(size_t count, Memory* memory) : times(count, memory), parameters(count, memory), rates(2 * count, memory) {}

    Buffer<double> times, parameters;  // entries, both ascending
    Buffer<double> rates;              // two an entry, before it and after it: parameters a second
};

// Goes along a law with times that do not fall. At entries it is exact.
class LawWalk {
public:
    explicit LawWalk(const TimeLaw& law) : law_(law) {}
    double parameter_at(double time);

private:
    const TimeLaw& law_;
    size_t entry_ = 0;
};

// Slower at some entries: `eases`, two an entry (before it, after it), take that share of the rate, which is 1
// otherwise. Times of entries stay.
Task<TimeLaw> eased_law(Pace& pace, std::span<const double> times, std::span<const double> eases);

// Bounds of a body's motion; 0: none.
struct MotionLimits {
    double speed = 0, acceleration = 0;      // of its barycentre: m/s, m/s^2
    double turn = 0, turn_acceleration = 0;  // rad/s, rad/s^2
    bool any() const { return speed > 0 || acceleration > 0 || turn > 0 || turn_acceleration > 0; }
    bool accelerates() const { return acceleration > 0 || turn_acceleration > 0; }
};

// A motion at nodes. Steps between them: in place, and turns as vectors of an axis times an angle.
struct MotionSteps {
    std::span<const double> times;          // one a node, of closed motions one more
    std::span<const double> moved, turned;  // 3 a step
    bool closed = false;
    // Ascending: nodes at which derivatives may jump, as at keys. There each side has its own.
    std::span<const uint32_t> kinks;
};

// Derivatives at a node, just before or after it, from the steps beside it: exact for parabolas.
struct NodeMotion {
    Vec3 velocity, acceleration, turn, turn_acceleration;
};
enum class NodeSide { before, after };
NodeMotion motion_at(const MotionSteps& steps, uint32_t node, NodeSide side);

// Keeps a motion within limits, nowhere faster than it was: parameters are its times. With a limit of acceleration an
// open one begins and ends at rest. Some 1 us a node.
Task<TimeLaw> limited_law(Pace& pace, MotionSteps steps, MotionLimits limits);

}  // namespace flg
