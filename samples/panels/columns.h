// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "filigree/filigree.h"

namespace flg::panels {

// Some columns of a view, without a copy of the data.
class Columns {
public:
    Columns(const FlgCurveSetView& view);  // NOLINT: a view is all of its columns
    Columns without(FlgAttribute attribute) const;
    // With this column in place of the one of its attribute.
    Columns with(const FlgColumn& column) const;
    // Only curves [first, first + count).
    Columns range(uint32_t first, uint32_t count) const;
    FlgCurveSetView view() const;

private:
    std::vector<FlgColumn> columns_;
    std::vector<uint32_t> offsets_;
    FlgCurveSetView view_;
};

}  // namespace flg::panels
