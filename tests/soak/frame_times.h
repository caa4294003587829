// SPDX-License-Identifier: MIT
// Times of many frames, and what share of them stays below what.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace flg::soak {

class FrameTimes {
public:
    explicit FrameTimes(size_t frames) { us_.reserve(frames); }

    void add(double us) { us_.push_back(static_cast<float>(us)); }
    // The time that this share of all frames does not exceed.
    float quantile(double share) const {
        if (us_.empty()) return 0;
        std::vector<float> sorted = us_;
        const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(sorted.size())));
        const size_t index = std::clamp<size_t>(rank, 1, sorted.size()) - 1;
        std::nth_element(sorted.begin(), sorted.begin() + static_cast<ptrdiff_t>(index), sorted.end());
        return sorted[index];
    }

private:
    std::vector<float> us_;
};

}  // namespace flg::soak
