// SPDX-License-Identifier: MIT
// Whether floats can hold a mesh. Far from the origin they are too far apart: vertices fall together, and welding would
// then take whole parts of the mesh away. A mesh is too coarse if most of its edges are. Edges of no length do not
// count: honest meshes have them, too. What floats can hold near an edge counts, not near the mesh's far end: small
// parts near the origin of a large scene are as precise as any.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/failure.h"

namespace flg {

// The distance between floats of this size, >= 0 and finite.
inline float float_step(float size) {
    constexpr uint32_t exponent = 0x7f800000;
    const float power = std::bit_cast<float>(std::bit_cast<uint32_t>(size) & exponent);
    return std::max(power * std::numeric_limits<float>::epsilon(), std::numeric_limits<float>::denorm_min());
}

class EdgePrecision {
public:
    // Edges shorter than so many steps of the floats at their ends are coarse: rounding bends them by some degrees, or
    // more.
    static constexpr double coarse_steps = 8;

    void add(const float* a, const float* b) {
        double square = 0;
        float size = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            const double side = double{a[k]} - double{b[k]};
            square += side * side;
            size = std::max({size, std::abs(a[k]), std::abs(b[k])});
        }
        if (square == 0) return;
        const double least = coarse_steps * double{float_step(size)};
        if (square >= least * least) {
            ++fine_;
        } else {
            ++coarse_;
            farthest_ = std::max(farthest_, size);
        }
    }

    // `what` is where the host gives the positions and says what they are relative to.
    void check(const char* what, const char* remedy) const {
        if (coarse_ <= fine_) return;
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "%s has coordinates up to %g m, where floats are %g m apart: too coarse for %.0f %% of its edges; %s", what,
            double{farthest_}, double{float_step(farthest_)},
            100.0 * static_cast<double>(coarse_) / static_cast<double>(coarse_ + fine_), remedy);
    }

private:
    uint64_t fine_ = 0, coarse_ = 0;
    float farthest_ = 0;  // the largest coordinate of a coarse edge
};

}  // namespace flg
