// SPDX-License-Identifier: MIT
#include "strokes/strokes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace flg::samples {
namespace {

// The style swings this many radii away from the stroke, but no further than this share of its length.
constexpr float kDisplacementPerRadius = 1.8f, kMaxDisplacementPerLength = 0.05f;
// Strokes without a radius: the style swings this share of their length.
constexpr float kDisplacementPerLength = 0.03f;
// The styled line is thinner than the stroke it replaces, so that its turns stay apart.
constexpr float kThinning = 0.22f, kRadiusPerDisplacement = 0.12f;
constexpr float kSmallestDisplacement = 1e-5f;
constexpr float kInk[4] = {0.10f, 0.11f, 0.14f, 1.0f};

float mean_radius(const FlgCurveSetView& view, uint32_t index) {
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    if (radii == nullptr) return 0.0f;
    const uint32_t first = view.curve_offsets[index], end = view.curve_offsets[index + 1];
    double sum = 0.0;
    for (uint32_t i = first; i < end; ++i) sum += *value_at(*radii, i);
    return static_cast<float>(sum / (end - first));
}

}  // namespace

void StrokeSet::add(const FlgCurveSetView& view, uint32_t index, float radius, const float* color,
                    float radius_factor) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn* colors = find_column(view, FLG_ATTRIBUTE_COLOR);
    for (uint32_t i = view.curve_offsets[index]; i < view.curve_offsets[index + 1]; ++i) {
        const float* p = value_at(positions, i);
        positions_.insert(positions_.end(), p, p + 3);
        radii_.push_back(radii != nullptr ? radius_factor * *value_at(*radii, i) : radius);
        const float* c = colors != nullptr ? value_at(*colors, i) : color;
        colors_.insert(colors_.end(), c, c + 4);
    }
    offsets_.push_back(static_cast<uint32_t>(radii_.size()));
    flags_.push_back(view.curve_flags != nullptr ? view.curve_flags[index] : uint8_t{0});
}

void StrokeSet::add_all(const FlgCurveSetView& view) {
    const FlgColumn* normals = find_column(view, FLG_ATTRIBUTE_NORMAL);
    for (uint32_t c = 0; c < view.curve_count; ++c) add(view, c, 0.0f, kInk, 1.0f);
    for (uint32_t i = 0; normals != nullptr && i < view.curve_offsets[view.curve_count]; ++i) {
        const float* n = value_at(*normals, i);
        normals_.insert(normals_.end(), n, n + 3);
    }
}

FlgCurveSetView StrokeSet::view() {
    columns_ = {{FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0},
                {FLG_ATTRIBUTE_RADIUS, 1, radii_.data(), 0, 0},
                {FLG_ATTRIBUTE_COLOR, 4, colors_.data(), 0, 0}};
    if (!normals_.empty()) columns_.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals_.data(), 0, 0});
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = curve_count();
    view.curve_offsets = offsets_.data();
    view.curve_flags = flags_.data();
    view.columns = columns_.data();
    view.column_count = static_cast<uint32_t>(columns_.size());
    return view;
}

std::vector<StrokeGroup> group_by_size(const std::vector<CurveSource>& sources) {
    std::map<int, StrokeGroup, std::greater<>> octaves;
    for (const CurveSource& source : sources) {
        for (uint32_t c = 0; c < source.view().curve_count; ++c) {
            const auto length = static_cast<float>(curve_length(source.view(), c));
            const float radius = mean_radius(source.view(), c);
            const float wanted = radius > 0.0f
                                     ? std::min(kDisplacementPerRadius * radius, kMaxDisplacementPerLength * length)
                                     : kDisplacementPerLength * length;
            const float displacement = std::max(wanted, kSmallestDisplacement);
            const int octave = static_cast<int>(std::floor(std::log2(displacement)));
            StrokeGroup& group = octaves[octave];
            group.displacement = std::exp2(static_cast<float>(octave) + 0.5f);
            group.strokes.add(source.view(), c, kRadiusPerDisplacement * displacement, kInk, kThinning);
        }
    }
    std::vector<StrokeGroup> groups;
    for (auto& [octave, group] : octaves) groups.push_back(std::move(group));
    return groups;
}

}  // namespace flg::samples
