// SPDX-License-Identifier: MIT
#include "stylization/median.h"

#include <algorithm>
#include <bit>

namespace flg {

bool Median::run(uint32_t& units) {
    constexpr uint32_t block_size = 256;
    while (digit_ < digits) {
        if (units == 0) return false;
        --units;
        const uint32_t end = std::min(at_ + block_size, count_);
        const uint32_t shift = digit_bits * (digits - 1 - digit_);
        for (; at_ < end; ++at_) {
            // Adding zero makes -0 a 0.
            const uint64_t bits = std::bit_cast<uint32_t>(values_[at_] + 0.0f);
            if (bits >> (shift + digit_bits) == prefix_) ++histogram_[(bits >> shift) & (histogram_.size() - 1)];
        }
        if (at_ == count_) pick_digit();
    }
    return true;
}

void Median::pick_digit() {
    uint32_t digit = 0;
    while (rank_ >= histogram_[digit]) rank_ -= histogram_[digit++];
    prefix_ = prefix_ << digit_bits | digit;
    ++digit_;
    at_ = 0;
    histogram_.fill(0);
}

float Median::value() const {
    return std::bit_cast<float>(prefix_);
}

}  // namespace flg
