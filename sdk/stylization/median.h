// SPDX-License-Identifier: MIT
// The median of many values in slices: radix selection on the bits of non-negative floats, which are ordered as they are.
#pragma once

#include <array>
#include <cstdint>

namespace flg {

class Median {
public:
    Median() = default;
    // The values stay where they are, unchanged, until run() returned true. None may be negative; `count` >= 1.
    Median(const float* values, uint32_t count) : values_(values), count_(count), rank_((count - 1) / 2) {}

    // A unit is up to 256 values, about 0.2 us.
    bool run(uint32_t& units);
    // The lower one of the two in the middle.
    float value() const;

private:
    static constexpr uint32_t digit_bits = 8;
    static constexpr uint32_t digits = 4;

    void pick_digit();

    const float* values_ = nullptr;
    uint32_t count_ = 0;
    uint32_t rank_ = 0;
    uint32_t at_ = 0;
    uint32_t digit_ = 0;
    uint32_t prefix_ = 0;  // the digits found so far
    std::array<uint32_t, 1u << digit_bits> histogram_{};
};

}  // namespace flg
