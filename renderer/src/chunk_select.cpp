// SPDX-License-Identifier: MIT
#include "chunk_select.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace flg::render {
namespace {

constexpr float least_step_px = 2.0f;   // points nearer to each other than this are skipped
constexpr float roundness_px = 0.15f;   // how far a tube's polygon may fall short of its circle
constexpr float least_cap_px = 0.8f;    // caps of thinner tubes are left away
constexpr uint32_t least_segments = 4;  // of a bin
constexpr uint32_t part_shift = 40, columns_shift = 34, segments_shift = 42;

uint32_t sides_for(float radius_px, uint32_t most) {
    if (radius_px <= 2.0f * roundness_px) return 3;
    const float sides = 3.14159265f / std::acos(1.0f - roundness_px / radius_px);
    // Even numbers: fewer bins.
    const uint32_t even = 2 * static_cast<uint32_t>(std::ceil(0.5f * std::min(sides, 32.0f)));
    return std::clamp(even, 3u, most);
}

}  // namespace

ChunkSelector::ChunkSelector(std::span<const ViewUniforms> views) : view_count_(views.size()) {
    for (size_t v = 0; v < view_count_; ++v) {
        const ViewUniforms& from = views[v];
        View& view = views_[v];
        view.eye = glm::vec3(from.eye);
        view.pixel_m = from.eye.w;
        view.perspective = from.bounce_color.w != 0.0f;
        const glm::mat4 rows = glm::transpose(from.clip_from_world);
        const glm::vec4 planes[4] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
        for (int i = 0; i < 4; ++i) view.planes[i] = planes[i] / glm::length(glm::vec3(planes[i]));
    }
}

bool ChunkSelector::View::sees(const ChunkBounds& bounds) const {
    for (const glm::vec4& plane : planes)
        if (glm::dot(glm::vec3(plane), bounds.center) + plane.w < -bounds.extent) return false;
    return true;
}

float ChunkSelector::View::pixels_per_metre(const ChunkBounds& bounds) const {
    if (!perspective) return 1.0f / pixel_m;
    const float distance = glm::distance(bounds.center, eye) - bounds.extent;
    return 1.0f / (pixel_m * std::max(distance, 1e-3f * bounds.extent));
}

float ChunkSelector::pixels_per_metre(const ChunkBounds& bounds) const {
    float largest = 0.0f;
    for (size_t v = 0; v < view_count_; ++v)
        if (views_[v].sees(bounds)) largest = std::max(largest, views_[v].pixels_per_metre(bounds));
    return largest;
}

void ChunkSelector::select(const CurveData& curves, const CurveLook& look, float magnitude_offset,
                           std::vector<uint32_t>& instances, std::vector<DrawBin>& bins) {
    keyed_.clear();
    const bool tube = look.shape == Shape::tube;
    for (uint32_t i = 0; i < curves.chunks.size(); ++i) {
        ChunkBounds bounds = curves.bounds[i];
        if (magnitude_offset != 0.0f) {
            bounds.extent += std::abs(magnitude_offset) * curves.growths[i].extent;
            bounds.segment += std::abs(magnitude_offset) * curves.growths[i].segment;
        }
        const float scale = pixels_per_metre(bounds);
        if (scale == 0.0f) continue;
        const float step_px = bounds.segment * scale;
        uint32_t stride_log2 = 0;
        while (stride_log2 < 6 && step_px * static_cast<float>(2u << stride_log2) <= least_step_px) ++stride_log2;
        const uint32_t segments = (curves.chunks[i].segments() + (1u << stride_log2) - 1) >> stride_log2;
        const uint32_t drawn = std::max(std::bit_ceil(segments), least_segments);
        const float radius_px = bounds.thickness * scale;
        const uint32_t columns = tube ? sides_for(radius_px, look.sides) : 2;
        // Segments of a bin are a power of two; 7 bits hold 64. Order of the keys: bins, then chunks as they come.
        const uint64_t instance = i | static_cast<uint64_t>(stride_log2) << instance_chunk_bits;
        const uint64_t side_key = static_cast<uint64_t>(columns) << columns_shift;
        keyed_.push_back(instance | side_key | static_cast<uint64_t>(drawn) << segments_shift);
        if (!tube || look.caps == Caps::none || radius_px < least_cap_px) continue;
        const uint64_t cap_key = instance | side_key | static_cast<uint64_t>(cap_rings) << segments_shift;
        if (curves.chunks[i].segments_and_flags & Chunk::begins) keyed_.push_back(cap_key | 1ull << part_shift);
        if (curves.chunks[i].segments_and_flags & Chunk::ends) keyed_.push_back(cap_key | 2ull << part_shift);
    }
    std::sort(keyed_.begin(), keyed_.end());
    constexpr uint64_t bin_mask = ~((1ull << columns_shift) - 1);
    for (size_t i = 0; i < keyed_.size(); ++i) {
        const uint64_t bin = keyed_[i] & bin_mask;
        if (i == 0 || bin != (keyed_[i - 1] & bin_mask))
            bins.push_back({static_cast<uint32_t>(bin >> columns_shift & 63),
                            static_cast<uint32_t>(bin >> segments_shift), static_cast<Part>(bin >> part_shift & 3),
                            static_cast<uint32_t>(instances.size()), 0});
        instances.push_back(static_cast<uint32_t>(keyed_[i]));
        ++bins.back().instance_count;
    }
}

}  // namespace flg::render
