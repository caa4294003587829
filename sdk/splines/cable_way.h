// SPDX-License-Identifier: MIT
// The way that a cable is laid along before it falls: straight or, where that is blocked, over what blocks it or, if
// the cable is too short for that, the shortest way that is found. It is looked for among the obstacles that the cable
// can reach, no farther than it can reach.
#pragma once

#include <span>

#include "splines/cable_contacts.h"

namespace flg {

struct CableSpan {
    Vec3 from, to;
    double length;  // metres
    Vec3 down;
    double slack;     // metres: so deep it may be beside its ends
    uint32_t number;  // of its first point
};

// To `places`, each as far from the next as the others, if that is free. Empty breaches: the straight way is. Throws a
// Failure where there is no way, or only longer ones; unless the cable hangs free: then returns false.
Task<bool> lay_over(Pace& pace, const ObstacleSet& set, const CableSpan& span, const std::pmr::vector<Breach>& breaches,
                    bool hangs_free, Buffer<Vec3>& places);

// Along a polyline, evenly.
Task<void> lay_along(Pace& pace, std::span<const Vec3> line, Buffer<Vec3>& places);

// Whether a cable that falls freely from the straight way to `places` meets nothing: neither what falls with a node nor
// shorter catenaries do.
Task<bool> is_swept_free(Pace& pace, const ObstacleSet& set, const CableSpan& span,
                         const std::pmr::vector<Vec3>& places);

}  // namespace flg
