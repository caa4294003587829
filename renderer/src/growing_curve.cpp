// SPDX-License-Identifier: MIT
#include "growing_curve.h"

#include <algorithm>

#include "vk.h"

namespace flg::render {
namespace {

// A chunk's last point of its curve, where that is in another chunk: nobody asks for it, and it need not be kept up to
// date.
constexpr uint32_t further_on = ~0u;

// The chunk that holds a curve's point `i` as its last one, or the first.
uint32_t chunk_to(uint32_t i) {
    return i == 0 ? 0 : (i - 1) / chunk_segments;
}

}  // namespace

GrowingCurve::GrowingCurve(CurveData& data, const CurveLook& look, uint32_t capacity)
    : data_(data), look_(look), capacity_(capacity), normals_(capacity) {
    const uint32_t chunks = chunk_to(capacity - 1) + 1;
    data.centers.reserve(capacity);
    data.looks.reserve(capacity);
    data.chunks.reserve(chunks);
    data.bounds.reserve(chunks);
    ordinals_.reserve(capacity);
    colors_.reserve(capacity);
    boxes_.reserve(chunks);
}

void GrowingCurve::append(const FlgCurveSetView& view) {
    check_view(view);
    if (view.curve_count == 0) return;
    if (view.curve_count > 1)
        fail("The view has %u curves; a growing curve takes the points of one.", view.curve_count);
    const CurveColumns columns(view);
    const uint32_t count = view.curve_offsets[1];
    check_points(columns, count);
    const auto before = static_cast<uint32_t>(data_.centers.size());
    std::vector<glm::vec4> colors;
    for (uint32_t i = 0; i < count; ++i, ++given_count_) {
        const glm::vec3 p = columns.position(i);
        if (!data_.centers.empty() && glm::vec3(data_.centers.back()) == p) continue;
        data_.centers.emplace_back(p, columns.radius(i, look_));
        colors.emplace_back(columns.color(i, look_, 0.0f), 1.0f);
        ordinals_.push_back(given_count_);
        const bool follows = look_.shape == Shape::ribbon && columns.has_normals();
        normals_.push(follows ? columns.normal(i) : glm::vec3(0));
    }
    if (data_.centers.size() == before) return;
    colors_.resize(data_.centers.size());
    write_colors(colors, &colors_[before], sizeof(uint32_t));
    refresh(std::max(before, 1u) - 1);
}

void GrowingCurve::check_points(const CurveColumns& columns, uint32_t count) const {
    if (count > capacity_ - given_count_)
        fail("The growing curve has %u points; %u more are beyond its capacity, %u.", given_count_, count, capacity_);
    for (uint32_t i = 0; i < count; ++i) {
        columns.position(i);
        columns.check(i);
    }
}

void GrowingCurve::truncate(uint32_t points) {
    if (points > given_count_) fail("The growing curve has %u points; %u can't be left.", given_count_, points);
    given_count_ = points;
    const auto kept = std::lower_bound(ordinals_.begin(), ordinals_.end(), points) - ordinals_.begin();
    if (static_cast<size_t>(kept) == ordinals_.size()) return;
    const auto count = static_cast<uint32_t>(kept);
    data_.centers.resize(count);
    ordinals_.resize(count);
    colors_.resize(count);
    normals_.truncate(count);
    refresh(std::max(count, 1u) - 1);
}

void GrowingCurve::refresh(uint32_t from) {
    const auto count = static_cast<uint32_t>(data_.centers.size());
    const bool line = look_.shape == Shape::line;
    const uint32_t changed = line ? from : normals_.find(data_.centers.data(), from);
    data_.looks.resize(count);
    for (uint32_t i = changed; i < count; ++i) data_.looks[i].color = colors_[i];
    if (changed < count) {
        const std::vector<glm::vec3> up(line ? count - changed : 0, glm::vec3(0.0f, 1.0f, 0.0f));
        const glm::vec3* const normals = line ? up.data() : normals_.from(changed);
        write_normals({normals, count - changed}, &data_.looks[changed].normal, sizeof(PackedLook));
    }
    first_changed_point_ = std::min(first_changed_point_, changed);
    make_chunks(std::min(from, changed));
}

void GrowingCurve::make_chunks(uint32_t from) {
    const auto count = static_cast<uint32_t>(data_.centers.size());
    const uint32_t chunks = count < 2 ? 0 : chunk_to(count - 1) + 1;
    const uint32_t first = std::min(chunk_to(from), chunks);
    first_changed_chunk_ = std::min(first_changed_chunk_, first);
    data_.chunks.resize(chunks);
    data_.bounds.resize(chunks);
    boxes_.resize(chunks);
    for (uint32_t c = first; c < chunks; ++c) {
        const uint32_t begin = c * chunk_segments, last = count - 1;
        const uint32_t segments = std::min(chunk_segments, last - begin);
        const bool ends = begin + segments == last;
        const uint32_t flags = (c == 0 ? Chunk::begins : 0) | (ends ? Chunk::ends : 0);
        data_.chunks[c] = {begin, segments | flags, 0, ends ? last : further_on};
        boxes_[c] = c > 0 ? boxes_[c - 1] : Box();
        data_.bounds[c] =
            bounds_of(&data_.centers[begin], look_.shape == Shape::ribbon ? normals_.from(begin) : nullptr, segments,
                      look_.shape, boxes_[c]);
    }
    data_.box = chunks ? boxes_.back() : Box();
}

GrowingCurve::Changes GrowingCurve::changes() const {
    const auto points = static_cast<uint32_t>(data_.centers.size());
    const auto chunks = static_cast<uint32_t>(data_.chunks.size());
    const uint32_t first_point = std::min(first_changed_point_, points);
    const uint32_t first_chunk = std::min(first_changed_chunk_, chunks);
    return {first_point, points - first_point, first_chunk, chunks - first_chunk};
}

void GrowingCurve::changes_uploaded() {
    first_changed_point_ = static_cast<uint32_t>(data_.centers.size());
    first_changed_chunk_ = static_cast<uint32_t>(data_.chunks.size());
}

}  // namespace flg::render
