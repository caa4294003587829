// SPDX-License-Identifier: MIT
#include "joined_curves.h"

#include <algorithm>

#include "support/curve_source.h"

namespace flg::cli {

using samples::find_column;
using samples::value_at;

void JoinedCurves::add(const FlgCurveSetView& set, uint32_t curve) {
    if (columns_.empty()) {
        columns_.assign(set.columns, set.columns + set.column_count);
        values_.resize(columns_.size());
        std::copy(std::begin(set.origin), std::end(set.origin), origin_.begin());
    }
    const uint32_t begin = set.curve_offsets[curve], end = set.curve_offsets[curve + 1];
    for (size_t k = 0; k < columns_.size(); ++k) {
        const FlgColumn& column = *find_column(set, columns_[k].attribute);
        for (uint32_t i = begin; i < end; ++i) {
            const float* value = value_at(column, i);
            for (uint32_t c = 0; c < columns_[k].components; ++c) {
                const bool moves = columns_[k].attribute == FLG_ATTRIBUTE_POSITION && set.origin[c] != origin_[c];
                values_[k].push_back(moves ? static_cast<float>(value[c] + (set.origin[c] - origin_[c])) : value[c]);
            }
        }
    }
    offsets_.push_back(offsets_.back() + (end - begin));
    flags_.push_back(set.curve_flags == nullptr ? uint8_t{0} : set.curve_flags[curve]);
}

void JoinedCurves::set_color(const float* rgba) {
    const auto is_color = [](const FlgColumn& column) { return column.attribute == FLG_ATTRIBUTE_COLOR; };
    if (std::any_of(columns_.begin(), columns_.end(), is_color)) return;
    for (size_t i = last_begin(); i < offsets_.back(); ++i) colors_.insert(colors_.end(), rgba, rgba + 4);
}

FlgCurveSetView JoinedCurves::view() {
    for (size_t k = 0; k < values_.size(); ++k) {
        columns_[k].data = values_[k].data();
        columns_[k].stride = 0;
    }
    if (!colors_.empty() && columns_.size() == values_.size())
        columns_.push_back({FLG_ATTRIBUTE_COLOR, 4, colors_.data(), 0, 0});
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = curve_count();
    view.curve_offsets = offsets_.data();
    view.curve_flags = flags_.data();
    view.columns = columns_.data();
    view.column_count = static_cast<uint32_t>(columns_.size());
    std::copy(origin_.begin(), origin_.end(), view.origin);
    return view;
}

}  // namespace flg::cli
