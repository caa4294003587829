// SPDX-License-Identifier: MIT
#include "chunk_select.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace flg::render {
namespace {

constexpr float min_step_px = 2.0f;       // points nearer to each other than this are skipped
constexpr float largest_step_px = 16.0f;  // over which colours and shading may be interpolated
constexpr float straying_px = 0.25f;      // how far what is drawn may lie off the curve
constexpr float min_radius_px = 0.5f;     // of ribbons whose turning is looked at: shading turns as well
constexpr float roundness_px = 0.15f;     // how far a tube's polygon may fall short of its circle
constexpr float min_cap_px = 0.8f;        // caps of thinner tubes are left away
constexpr uint32_t min_segments = 4;      // of a bin
constexpr uint32_t min_sides = 3, max_sides = 32;
constexpr uint32_t max_stride_log2 = 6;

// Buckets: by segments, part, columns, which make a bin, and stride.
constexpr uint32_t stride_count = max_stride_log2 + 1, columns_count = max_sides + 1, part_count = 3;
constexpr uint32_t segments_count = std::countr_zero(chunk_segments) + 1;
constexpr uint32_t bucket_count = segments_count * part_count * columns_count * stride_count;

uint32_t bin_of(uint32_t segments, Part part, uint32_t columns) {
    const auto segments_log2 = static_cast<uint32_t>(std::countr_zero(segments));
    return (segments_log2 * part_count + static_cast<uint32_t>(part)) * columns_count + columns;
}

DrawBin draw_bin(uint32_t bin, uint32_t first_instance) {
    return {bin % columns_count, 1u << bin / (columns_count * part_count),
            static_cast<Part>(bin / columns_count % part_count), first_instance, 0};
}

// Even numbers, for fewer bins: by half of them, the largest radius in pixels that they are enough for.
std::array<float, max_sides / 2 + 1> largest_radii() {
    std::array<float, max_sides / 2 + 1> radii{};
    for (uint32_t half = 2; half < radii.size(); ++half)
        radii[half] = roundness_px / (1.0f - std::cos(std::numbers::pi_v<float> / static_cast<float>(2 * half)));
    return radii;
}

uint32_t sides_for(float radius_px, uint32_t most) {
    static const auto radii = largest_radii();
    if (radius_px <= 2.0f * roundness_px) return min_sides;
    uint32_t half = 2;
    while (2 * half < most && radii[half] < radius_px) ++half;
    return std::min(2 * half, most);
}

// Floor of the logarithm, of numbers >= 0.
int log2_of(float x) {
    constexpr int exponent_bias = 127, mantissa_bits = 23;
    return static_cast<int>(std::bit_cast<uint32_t>(x) >> mantissa_bits) - exponent_bias;
}

// How many times the steps between points may be doubled: until they are two pixels long, or further where nobody can
// see it.
uint32_t stride_for(const ChunkBounds& bounds, float pixel_m) {
    constexpr float tiny = std::numeric_limits<float>::min();
    const float steps_a_pixel = pixel_m / std::max(bounds.segment, tiny);
    const float bend = bounds.bend + std::max(bounds.thickness, min_radius_px * pixel_m) * bounds.turn;
    const float straight = std::sqrt(8.0f * straying_px * pixel_m / std::max(bend, tiny));
    const int doublings =
        std::max(log2_of(min_step_px * steps_a_pixel), log2_of(std::min(straight, largest_step_px * steps_a_pixel)));
    return static_cast<uint32_t>(std::clamp(doublings, 0, static_cast<int>(max_stride_log2)));
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

float ChunkSelector::View::metres_per_pixel(const ChunkBounds& bounds) const {
    if (!perspective) return pixel_m;
    const float distance = glm::distance(bounds.center, eye) - bounds.extent;
    return pixel_m * std::max(distance, 1e-3f * bounds.extent);
}

float ChunkSelector::metres_per_pixel(const ChunkBounds& bounds) const {
    float smallest = std::numeric_limits<float>::infinity();
    for (size_t v = 0; v < view_count_; ++v)
        if (views_[v].sees(bounds)) smallest = std::min(smallest, views_[v].metres_per_pixel(bounds));
    return smallest;
}

void ChunkSelector::choose(uint32_t bucket, uint32_t instance) {
    if (counts_[bucket]++ == 0) used_.push_back(bucket);
    choices_.push_back({bucket, instance});
}

void ChunkSelector::select(const CurveData& curves, const CurveLook& look, float magnitude_offset,
                           std::vector<uint32_t>& instances, std::vector<DrawBin>& bins) {
    counts_.resize(bucket_count);
    choices_.clear();
    used_.clear();
    const bool tube = look.shape == Shape::tube;
    for (uint32_t i = 0; i < curves.chunks.size(); ++i) {
        ChunkBounds bounds = curves.bounds[i];
        if (magnitude_offset != 0.0f) {
            bounds.extent += std::abs(magnitude_offset) * curves.growths[i].extent;
            bounds.segment += std::abs(magnitude_offset) * curves.growths[i].segment;
            bounds.bend += std::abs(magnitude_offset) * curves.growths[i].bend;
        }
        const float pixel_m = metres_per_pixel(bounds);
        if (pixel_m == std::numeric_limits<float>::infinity()) continue;
        const uint32_t stride_log2 = stride_for(bounds, pixel_m);
        const uint32_t segments = (curves.chunks[i].segments() + (1u << stride_log2) - 1) >> stride_log2;
        const uint32_t drawn = std::max(std::bit_ceil(segments), min_segments);
        const float radius_px = tube ? bounds.thickness / pixel_m : 0.0f;
        const uint32_t columns = tube ? sides_for(radius_px, look.sides) : 2;
        const uint32_t instance = i | stride_log2 << instance_chunk_bits;
        choose(bin_of(drawn, Part::body, columns) * stride_count + stride_log2, instance);
        if (!tube || look.caps == Caps::none || radius_px < min_cap_px) continue;
        const uint32_t flags = curves.chunks[i].segments_and_flags;
        for (const Part part : {Part::begin_cap, Part::end_cap})
            if (flags & (part == Part::begin_cap ? Chunk::begins : Chunk::ends))
                choose(bin_of(cap_rings, part, columns) * stride_count + stride_log2, instance);
    }
    std::sort(used_.begin(), used_.end());
    auto next = static_cast<uint32_t>(instances.size());
    uint32_t last_bin = ~0u;
    for (const uint32_t bucket : used_) {
        const uint32_t bin = bucket / stride_count;
        if (bin != last_bin) bins.push_back(draw_bin(bin, next));
        last_bin = bin;
        const uint32_t count = counts_[bucket];
        bins.back().instance_count += count;
        counts_[bucket] = next;  // from now on where the bucket's next one goes
        next += count;
    }
    instances.resize(next);
    for (const Choice& choice : choices_) instances[counts_[choice.bucket]++] = choice.instance;
    for (const uint32_t bucket : used_) counts_[bucket] = 0;
}

}  // namespace flg::render
