// SPDX-License-Identifier: MIT
#include "gallery/painted.h"

#include "gallery/marks.h"
#include "support/curve_source.h"

namespace flg::gallery {

Painted::Painted(const FlgCurveSetView& view, FlgAttribute attribute,
                 const std::function<glm::vec3(const float* value)>& color)
    : columns_(view) {
    const FlgColumn& values = *samples::find_column(view, attribute);
    for (uint32_t i = 0; i < view.curve_offsets[view.curve_count]; ++i) {
        colors_.emplace_back(color(samples::value_at(values, i)), 1.0f);
    }
    columns_ = columns_.with({FLG_ATTRIBUTE_COLOR, 4, &colors_[0].x, 0, 0});
}

Ramp::Ramp(const FlgCurveSetView& view, const std::function<float(const glm::vec3& position)>& magnitude)
    : positions_(vectors_of(view)), columns_(view) {
    const std::vector<glm::vec3> displacements = vectors_of(view, FLG_ATTRIBUTE_DISPLACEMENT);
    for (size_t i = 0; i < positions_.size(); ++i) {
        positions_[i] += (magnitude(positions_[i] - displacements[i]) - 1.0f) * displacements[i];
    }
    columns_ = columns_.with({FLG_ATTRIBUTE_POSITION, 3, &positions_[0].x, 0, 0});
}

}  // namespace flg::gallery
