// SPDX-License-Identifier: MIT
// Curves of several sets as one, in an order of the caller's.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "filigree/filigree.h"

namespace flg::cli {

class JoinedCurves {
public:
    // Adds a curve of a set. Columns and origin are those of the first curve; all must have the columns.
    void add(const FlgCurveSetView& set, uint32_t curve);
    // One colour for all points of the last curve; sets that have colours keep theirs.
    void set_color(const float* rgba);

    uint32_t curve_count() const { return static_cast<uint32_t>(flags_.size()); }
    // Until the next change.
    FlgCurveSetView view();

private:
    size_t last_begin() const { return offsets_[offsets_.size() - 2]; }

    std::vector<FlgColumn> columns_;
    std::vector<std::vector<float>> values_;
    std::vector<float> colors_;
    std::array<double, 3> origin_ = {};
    std::vector<uint32_t> offsets_ = {0};
    std::vector<uint8_t> flags_;
};

}  // namespace flg::cli
