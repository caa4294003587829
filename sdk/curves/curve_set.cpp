// SPDX-License-Identifier: MIT
#include "curves/curve_set.h"

#include <algorithm>

namespace flg {

void CurveSet::allocate_curves(uint32_t curve_count) {
    offsets_ = Buffer<uint32_t>(size_t{curve_count} + 1, memory_);
    flags_ = Buffer<uint8_t>(curve_count, memory_);
    complete_ = Buffer<std::atomic<bool>>(curve_count, memory_);
    curve_count_ = curve_count;
}

void CurveSet::allocate_columns(const std::pmr::vector<ColumnLayout>& layout) {
    columns_.reserve(layout.size());
    view_columns_.reserve(layout.size());
    for (const ColumnLayout& column : layout) {
        columns_.push_back(
            {column.attribute, column.components, Buffer<float>(size_t{point_count()} * column.components, memory_)});
        view_columns_.push_back({column.attribute, column.components, columns_.back().values.data(), 0, 0});
    }
    laid_out_.store(true, std::memory_order_release);
}

Buffer<float>& CurveSet::allocate_scales() {
    scales_ = Buffer<float>(curve_count_, memory_);
    return scales_;
}

const Column* CurveSet::find(FlgAttribute attribute) const {
    const auto place = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const Column& column) { return column.attribute == attribute; });
    return place == columns_.end() ? nullptr : &*place;
}

FlgCurveSetScales CurveSet::scales() const {
    return {.struct_size = sizeof(FlgCurveSetScales),
            .curve_count = static_cast<uint32_t>(scales_.size()),
            .scales = scales_.size() > 0 ? scales_.data() : nullptr};
}

void CurveSet::show_curves(uint32_t curves) noexcept {
    visible_curves_ = curves;
    view_ = {.struct_size = sizeof(FlgCurveSetView),
             .curve_count = curves,
             .curve_offsets = offsets_.data(),
             .curve_flags = flags_.data(),
             .columns = view_columns_.data(),
             .column_count = static_cast<uint32_t>(view_columns_.size()),
             .reserved = 0,
             .origin = {}};
    write_origin(origin, view_.origin);
}

void CurveSet::publish_partial() noexcept {
    if (!laid_out_.load(std::memory_order_acquire)) return;
    constexpr uint32_t max_at_a_time = 10'000;  // bounds the tick: tens of microseconds
    uint32_t curves = visible_curves_;
    const uint32_t end = std::min(curve_count_, curves + max_at_a_time);
    while (curves < end && complete_[curves].load(std::memory_order_acquire)) ++curves;
    if (curves == 0) return;
    show_early();
    show_curves(curves);
}

}  // namespace flg
