// SPDX-License-Identifier: MIT
// How long something takes in each frame, for a report.
#pragma once

#include <algorithm>
#include <vector>

namespace viewer {

class FrameTimes {
public:
    void add(double time) { times_.push_back(time); }
    size_t count() const { return times_.size(); }

    // The time that a share of all are not above; 0 if there are none.
    double quantile(double share) const {
        if (times_.empty()) return 0;
        std::vector<double> sorted = times_;
        const auto rank = static_cast<size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5);
        std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank), sorted.end());
        return sorted[rank];
    }

private:
    std::vector<double> times_;
};

}  // namespace viewer
