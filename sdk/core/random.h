// SPDX-License-Identifier: MIT
// Random numbers keyed by what they are for: draw i of item k under a seed is a function of (seed, k, i) and of nothing
// else, so that results do not depend on which thread computes what, or in which order.
// The mixer is SplitMix64's finalizer (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014).
#pragma once

#include <cstdint>

namespace flg {

constexpr uint64_t mix64(uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// 64 random bits of draw `index` for `item` under `seed`.
constexpr uint64_t random_bits(uint64_t seed, uint64_t item, uint64_t index) {
    return mix64(mix64(mix64(seed) ^ item) ^ index);
}

// A whole number in [0, count), count > 0. The bias is below count / 2^32.
constexpr uint32_t random_below(uint64_t seed, uint64_t item, uint64_t index, uint32_t count) {
    return static_cast<uint32_t>(((random_bits(seed, item, index) >> 32) * count) >> 32);
}

// In [0, 1).
constexpr double random_unit(uint64_t seed, uint64_t item, uint64_t index) {
    return static_cast<double>(random_bits(seed, item, index) >> 11) * 0x1.0p-53;
}

}  // namespace flg
