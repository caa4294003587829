// SPDX-License-Identifier: MIT
// Smooth random functions of one variable: what makes generated strokes look drawn by hand.
#pragma once

#include <cmath>
#include <cstdint>

namespace flg::scenes {

// Value noise: random numbers in [-1, 1] at the integers, joined by quintics. The mixer is SplitMix64's.
class Noise {
public:
    explicit Noise(uint64_t seed) : seed_(seed) {}

    double operator()(double x) const {
        const double cell = std::floor(x);
        const double t = x - cell;
        const double fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
        const auto index = static_cast<int64_t>(cell);
        const double from = at(index);
        return from + (at(index + 1) - from) * fade;
    }

    // Two octaves.
    double rough(double x) const { return (*this)(x)*0.7 + (*this)(2.0 * x + 57.3) * 0.3; }

private:
    double at(int64_t index) const {
        uint64_t bits = mix(mix(seed_) ^ static_cast<uint64_t>(index));
        return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
    }

    static uint64_t mix(uint64_t x) {
        x += 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    uint64_t seed_;
};

// 0 below 0, 1 above 1, smooth between.
inline double smooth_step(double x) {
    x = x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x);
    return x * x * (3.0 - 2.0 * x);
}

}  // namespace flg::scenes
