// SPDX-License-Identifier: MIT
// What style strokes are made of: offsets from an axis, as a hand makes them.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "noise.h"
#include "scenes.h"

namespace flg::scenes {

constexpr double kTau = 2.0 * std::numbers::pi;

// Metres along the axis, up and sideways from it.
struct Offset {
    double along, up, side;
};

// A hand's irregularity: one noise each for timing, size and shake.
struct Hand {
    Noise timing, size, shake;

    explicit Hand(uint64_t seed) : timing(seed), size(seed + 1), shake(seed + 2) {}

    // Angle after `turns` turns over the whole stroke, at u in [0, 1]; never runs backwards for small `unevenness`.
    double angle(double u, double turns, double unevenness) const {
        return kTau * (turns * u + unevenness * timing(turns * u * 0.8));
    }
    // A factor around 1 that also fades the stroke in and out.
    double strength(double u, double turns, double spread) const {
        const double ends = smooth_step(u / 0.05) * smooth_step((1.0 - u) / 0.05);
        return ends * (1.0 + spread * size(turns * u * 0.6 + 11.0));
    }
};

struct Recipe {
    const char* name;
    Offset (*offset)(double u);
    uint32_t count;
    uint64_t seed;
    Color color;
    bool planar = false;
    // Null: a pen's pressure, no angle, one colour.
    double (*radius)(double u) = nullptr;
    double (*angle)(double u) = nullptr;
    Color (*varied_color)(double u) = nullptr;
};

// Those that are made of motifs, one after the other along the axis (motifs.cpp).
std::span<const Recipe> motif_recipes();

}  // namespace flg::scenes
