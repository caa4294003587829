// SPDX-License-Identifier: MIT
#include "relative_size.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "support/curve_source.h"

namespace flg::cli {
namespace {

using samples::find_column;
using samples::value_at;

constexpr double kSwingPerRadius = 1.8;   // more: a painted stroke's style swings wider than the paint did
constexpr double kFinest = 16.0;          // times finer than the example's proportion; more: turns too small to see
constexpr double kRadiusPerSwing = 0.12;  // more: thicker lines, whose turns touch
constexpr double kMinScale = 1e-6, kMaxScale = 1e6;
constexpr double kGroupsPerOctave = 2.0;  // of scales; more: scales closer to each curve's own, more jobs

double size_of(const FlgCurveSetView& view, uint32_t curve) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    double low[3], high[3];
    for (uint32_t i = view.curve_offsets[curve]; i < view.curve_offsets[curve + 1]; ++i) {
        const float* p = value_at(positions, i);
        for (int k = 0; k < 3; ++k) {
            const double x = p[k];
            const bool first = i == view.curve_offsets[curve];
            low[k] = first ? x : std::min(low[k], x);
            high[k] = first ? x : std::max(high[k], x);
        }
    }
    const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const double length = samples::curve_length(view, curve);
    return length > 0.0 ? diagonal * std::cbrt(diagonal / length) : 0.0;
}

double mean_radius(const FlgCurveSetView& view, uint32_t curve) {
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    if (radii == nullptr) return 0.0;
    const uint32_t first = view.curve_offsets[curve], end = view.curve_offsets[curve + 1];
    double sum = 0.0;
    for (uint32_t i = first; i < end; ++i) sum += static_cast<double>(*value_at(*radii, i));
    return sum / (end - first);
}

}  // namespace

RelativeSize::RelativeSize(const FlgCurveSetView& guide, float rms) : rms_(rms) {
    for (uint32_t c = 0; c < guide.curve_count; ++c) guide_size_ = std::max(guide_size_, size_of(guide, c));
}

CurveSize RelativeSize::of(const FlgCurveSetView& target, uint32_t curve) const {
    const double size = size_of(target, curve), radius = mean_radius(target, curve);
    if (!(size > 0.0) || !(guide_size_ > 0.0)) return {1.0f, 1.0f};
    double scale = size / guide_size_, thickness = 1.0;
    if (radius > 0.0 && rms_ > 0.0) {
        scale = std::clamp(kSwingPerRadius * radius / rms_, scale / kFinest, scale);
        thickness = std::min(1.0, kRadiusPerSwing * scale * rms_ / radius);
    }
    return {static_cast<float>(std::clamp(scale, kMinScale, kMaxScale)), static_cast<float>(thickness)};
}

float RelativeSize::radius_at(float scale) const {
    return static_cast<float>(kRadiusPerSwing * rms_) * scale;
}

std::vector<ScaleGroup> group_by_scale(const std::vector<CurveSize>& sizes) {
    std::map<double, std::vector<uint32_t>> octaves;
    for (uint32_t c = 0; c < sizes.size(); ++c) {
        octaves[std::floor(kGroupsPerOctave * std::log2(static_cast<double>(sizes[c].scale)))].push_back(c);
    }
    std::vector<ScaleGroup> groups;
    for (auto& [octave, curves] : octaves) {
        const auto smaller = [&](uint32_t a, uint32_t b) { return sizes[a].scale < sizes[b].scale; };
        const auto [least, most] = std::minmax_element(curves.begin(), curves.end(), smaller);
        const float low = sizes[*least].scale, high = sizes[*most].scale;
        const float scale = low == high ? low : std::sqrt(low * high);
        groups.push_back({scale, std::move(curves)});
    }
    return groups;
}

}  // namespace flg::cli
