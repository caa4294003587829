// SPDX-License-Identifier: MIT
// Labels of regions that an operation keeps to: one bit a label.
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"

namespace flg {

class RegionSet {
public:
    // All of them.
    explicit RegionSet(Memory* memory) : bits_(memory) {}
    // Those listed; their largest takes a bit for each one below it.
    RegionSet(const uint32_t* labels, uint32_t count, Memory* memory) : bits_(memory), all_(false) {
        for (uint32_t i = 0; i < count; ++i) {
            if (labels[i] / 64 >= bits_.size()) bits_.resize(labels[i] / 64 + 1);
            bits_[labels[i] / 64] |= uint64_t{1} << labels[i] % 64;
        }
    }

    bool all() const { return all_; }
    bool contains(uint32_t label) const {
        return all_ || (label / 64 < bits_.size() && (bits_[label / 64] >> label % 64 & 1) != 0);
    }

private:
    std::pmr::vector<uint64_t> bits_;
    bool all_ = true;
};

}  // namespace flg
