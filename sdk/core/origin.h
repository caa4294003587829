// SPDX-License-Identifier: MIT
// Where coordinates are counted from: the place of an object in a world that floats cannot span.
//
// Algorithms never see an origin: they compute with what is relative to it, so that results do not depend on where in
// the world an object is, to the bit. Where objects of different origins meet, one takes the other's coordinates by
// origin_shift(): a difference of doubles, exact where both origins are multiples of one step, and 0 where they are
// the same.
#pragma once

#include <algorithm>
#include <array>

#include "core/vec.h"

namespace flg {

using Origin = std::array<double, 3>;  // metres

// What to add to coordinates relative to `from` to have them relative to `to`.
inline Vec3 origin_shift(const Origin& from, const Origin& to) {
    return Vec3(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
}

inline void write_origin(const Origin& origin, double (&out)[3]) {
    std::copy(origin.begin(), origin.end(), out);
}

}  // namespace flg
