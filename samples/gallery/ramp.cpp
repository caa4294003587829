// SPDX-License-Identifier: MIT
#include "gallery/ramp.h"

#include "support/curve_source.h"

namespace flg::gallery {

Ramp::Ramp(const FlgCurveSetView& view, const std::function<float(const float* position)>& magnitude) : columns_(view) {
    const FlgColumn &styled = *samples::find_column(view, FLG_ATTRIBUTE_POSITION),
                    &displacements = *samples::find_column(view, FLG_ATTRIBUTE_DISPLACEMENT);
    const uint32_t count = view.curve_offsets[view.curve_count];
    for (uint32_t i = 0; i < count; ++i) {
        const float *p = samples::value_at(styled, i), *d = samples::value_at(displacements, i);
        const float bare[3] = {p[0] - d[0], p[1] - d[1], p[2] - d[2]};
        const float less = magnitude(bare) - 1.0f;
        for (int k = 0; k < 3; ++k) positions_.push_back(p[k] + less * d[k]);
    }
    columns_ = columns_.with({FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0});
}

}  // namespace flg::gallery
