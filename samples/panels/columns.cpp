// SPDX-License-Identifier: MIT
#include "panels/columns.h"

#include "support/curve_source.h"

namespace flg::panels {

Columns::Columns(const FlgCurveSetView& view)
    : columns_(view.columns, view.columns + view.column_count),
      offsets_(view.curve_offsets, view.curve_offsets + view.curve_count + 1),
      view_(view) {}

Columns Columns::without(FlgAttribute attribute) const {
    Columns fewer = *this;
    std::erase_if(fewer.columns_, [=](const FlgColumn& column) { return column.attribute == attribute; });
    return fewer;
}

Columns Columns::with(const FlgColumn& column) const {
    Columns other = without(column.attribute);
    other.columns_.push_back(column);
    return other;
}

Columns Columns::range(uint32_t first, uint32_t count) const {
    Columns part = *this;
    part.offsets_.assign(offsets_.begin() + first, offsets_.begin() + first + count + 1);
    const uint32_t start = part.offsets_[0];
    for (uint32_t& offset : part.offsets_) offset -= start;
    for (FlgColumn& column : part.columns_) column.data = samples::value_at(column, start);
    if (view_.curve_flags != nullptr) part.view_.curve_flags = view_.curve_flags + first;
    return part;
}

FlgCurveSetView Columns::view() const {
    FlgCurveSetView view = view_;
    view.curve_count = static_cast<uint32_t>(offsets_.size() - 1);
    view.curve_offsets = offsets_.data();
    view.columns = columns_.data();
    view.column_count = static_cast<uint32_t>(columns_.size());
    return view;
}

}  // namespace flg::panels
