// SPDX-License-Identifier: MIT
// Rotations of a body that looks: along its -z, with its +y upwards, as cameras do.
//
// It looks at a point, at the place of another one that moves along a natural cubic spline, or ahead along its path.
// Where that is nowhere (the target is where the body is, or the path stands still) it goes on looking as before. Where
// it looks straight along `up` it keeps its right side.
//
// Banking leans it into curves, as riders do: by the angle whose tangent is the acceleration to its right over that of
// gravity, times `bank`. The acceleration is smoothed over `bank_time` by an exponential filter, forwards and
// backwards: symmetric in time, and the angle has a continuous rate.
#pragma once

#include <span>

#include "core/vec.h"
#include "runtime/each.h"

namespace flg {

enum class LookKind { keys, target, path };

struct Look {
    explicit Look(Memory* memory) : points(memory), times(memory) {}

    LookKind kind = LookKind::keys;
    std::pmr::vector<double> points, times;  // of the target: 3 a point; one a point, none: evenly over the motion
    Vec3 up = Vec3::UnitY();
    double bank = 0, bank_time = 0.25;  // s
};

// When and where a body is: in parameters of its path, in which the target's times are, and in seconds.
struct LookNodes {
    std::span<const double> parameters, places;  // one and 3 a node
    double begin, end;                           // of the parameters; of closed motions the first place again
    bool closed = false;
};

// The body's rotations, 9 numbers a node, column by column. Some 200 ns a node. Throws a Failure that names a point.
Task<void> look(Pace& pace, const Look& how, LookNodes nodes, double* rotations);

// `times`: one a node, of closed motions one more. Returns the greatest angle, rad.
Task<double> bank(Pace& pace, const Look& how, std::span<const double> times, LookNodes nodes, double* rotations);

}  // namespace flg
