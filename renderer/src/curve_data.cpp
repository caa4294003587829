// SPDX-License-Identifier: MIT
#include "curve_data.h"

#include <algorithm>
#include <cmath>

#include "curve_columns.h"
#include "curve_frames.h"
#include "packing.h"

namespace flg::render {
namespace {

class Builder {
public:
    Builder(const FlgCurveSetView& view, const CurveLook& look) : view_(view), look_(look), columns_(view) {}

    CurveData build() {
        const uint32_t points = view_.curve_offsets[view_.curve_count];
        data_.centers.reserve(points + view_.curve_count);
        data_.looks.reserve(points + view_.curve_count);
        data_.has_displacements = columns_.has_displacements();
        if (data_.has_displacements) data_.displacements.reserve(points + view_.curve_count);
        for (uint32_t c = 0; c < view_.curve_count; ++c) add_curve(c);
        return std::move(data_);
    }

private:
    void add_curve(uint32_t curve) {
        const bool closed = view_.curve_flags && (view_.curve_flags[curve] & FLG_CURVE_CLOSED);
        gather_points(view_.curve_offsets[curve], view_.curve_offsets[curve + 1]);
        bool joined = false;
        if (closed && kept_.size() > 1) {
            if (positions_.front() == positions_.back()) {
                positions_.pop_back();
                kept_.pop_back();
            }
            if (kept_.size() >= 3) {
                positions_.push_back(positions_.front());
                kept_.push_back(kept_.front());
                joined = true;
            }
        }
        const auto count = static_cast<uint32_t>(kept_.size());
        if (count < 2) return;  // without length: nothing to draw
        make_normals(count, joined);
        const auto first = static_cast<uint32_t>(data_.centers.size());
        colors_.clear();
        for (uint32_t i = 0; i < count; ++i) add_point(i, count, joined);
        data_.looks.resize(data_.centers.size());
        write_normals(normals_, &data_.looks[first].normal, sizeof(PackedLook));
        write_colors(colors_, &data_.looks[first].color, sizeof(PackedLook));
        if (data_.has_displacements) add_displacements(count);
        add_chunks(first, count, joined);
    }

    // Tubes are round: following the view's normals could only twist them.
    void make_normals(uint32_t count, bool joined) {
        normals_.assign(count, glm::vec3(0.0f, 1.0f, 0.0f));
        if (look_.shape == Shape::line) return;
        if (!columns_.has_normals() || look_.shape == Shape::tube) {
            carry_normals(positions_.data(), count, joined, normals_.data());
            return;
        }
        for (uint32_t i = 0; i < count; ++i) normals_[i] = columns_.normal(kept_[i]);
        follow_normals(positions_.data(), count, joined, normals_.data());
    }

    void gather_points(uint32_t begin, uint32_t end) {
        positions_.clear();
        kept_.clear();
        for (uint32_t i = begin; i < end; ++i) {
            const glm::vec3 p = columns_.position(i);
            if (!positions_.empty() && positions_.back() == p) continue;
            columns_.check(i);
            positions_.push_back(p);
            kept_.push_back(i);
        }
    }

    void add_point(uint32_t i, uint32_t count, bool joined) {
        const uint32_t source = kept_[i];
        const float along = static_cast<float>(i) / static_cast<float>(count - 1);
        // Closed curves go there and back: no seam.
        const float to_end = joined ? 1.0f - std::abs(2.0f * along - 1.0f) : along;
        data_.centers.emplace_back(positions_[i], columns_.radius(source, look_));
        colors_.emplace_back(columns_.color(source, look_, to_end), 1.0f);
    }

    // With the normals as given, where there are some.
    void add_displacements(uint32_t count) {
        const size_t first = data_.displacements.size();
        const bool given = columns_.has_normals() && look_.shape == Shape::ribbon;
        given_normals_ = normals_;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t source = kept_[i];
            data_.displacements.push_back({columns_.displacement(source), 0});
            if (given && columns_.normal(source) != glm::vec3(0)) given_normals_[i] = columns_.normal(source);
        }
        write_normals(given_normals_, &data_.displacements[first].normal, sizeof(PackedDisplacement));
    }

    void add_chunks(uint32_t first, uint32_t count, bool joined) {
        const uint32_t last = first + count - 1;
        for (uint32_t at = first; at < last; at += chunk_segments) {
            const uint32_t segments = std::min(chunk_segments, last - at);
            uint32_t flags = joined ? Chunk::closed : 0;
            if (!joined && at == first) flags |= Chunk::begins;
            if (!joined && at + segments == last) flags |= Chunk::ends;
            data_.chunks.push_back({at, segments | flags, first, last});
            data_.bounds.push_back(
                bounds_of(&data_.centers[at], &normals_[at - first], segments, look_.shape, data_.box));
            if (data_.has_displacements) add_growth(at, segments);
        }
    }

    void add_growth(uint32_t first, uint32_t segments) {
        const float reach = look_.shape == Shape::line ? 0.0f : data_.bounds.back().thickness;
        ChunkGrowth growth{};
        for (uint32_t i = first; i <= first + segments; ++i) {
            const glm::vec3 displacement = data_.displacements[i].displacement;
            data_.displaced_box.add(glm::vec3(data_.centers[i]), displacement, reach);
            growth.extent = std::max(growth.extent, glm::length(displacement));
            if (i > first)
                growth.segment +=
                    glm::distance(displacement, data_.displacements[i - 1].displacement) / static_cast<float>(segments);
            if (i > first && i < first + segments)
                growth.bend =
                    std::max(growth.bend, glm::length(data_.displacements[i - 1].displacement - 2.0f * displacement +
                                                      data_.displacements[i + 1].displacement));
        }
        data_.growths.push_back(growth);
    }

    const FlgCurveSetView& view_;
    const CurveLook& look_;
    CurveColumns columns_;
    CurveData data_;
    // Of the curve at hand.
    std::vector<glm::vec3> positions_, normals_, given_normals_;
    std::vector<glm::vec4> colors_;
    std::vector<uint32_t> kept_;  // which of the view's points they are
};

}  // namespace

ChunkBounds bounds_of(const glm::vec4* centers, const glm::vec3* normals, uint32_t segments, Shape shape,
                      Box& in_out_box) {
    glm::vec3 low(centers[0]), high = low;
    float thickness = centers[0].w, length = 0.0f, bend = 0.0f, turn = 0.0f;
    for (uint32_t i = 1; i <= segments; ++i) {
        const glm::vec3 p(centers[i]);
        low = glm::min(low, p);
        high = glm::max(high, p);
        thickness = std::max(thickness, centers[i].w);
        length += glm::distance(p, glm::vec3(centers[i - 1]));
        if (i == segments) break;
        const glm::vec4 second = centers[i - 1] - 2.0f * centers[i] + centers[i + 1];
        // Uneven steps along the curve don't show.
        const glm::vec3 chord(centers[i + 1] - centers[i - 1]), off(second);
        const float square = glm::dot(chord, chord);
        const glm::vec3 across = square > 0.0f ? off - chord * (glm::dot(off, chord) / square) : off;
        bend = std::max(bend, glm::length(across) + (shape == Shape::line ? 0.0f : std::abs(second.w)));
        if (shape == Shape::ribbon)
            turn = std::max(turn, glm::length(normals[i - 1] - 2.0f * normals[i] + normals[i + 1]));
    }
    const float reach = shape == Shape::line ? 0.0f : thickness;
    in_out_box.add({low - reach, high + reach});
    // Joints and caps reach up to two radii from the centre line.
    return {0.5f * (low + high),
            0.5f * glm::distance(low, high) + 2.0f * reach,
            thickness,
            length / static_cast<float>(segments),
            bend,
            turn};
}

CurveData prepare_curves(const FlgCurveSetView& view, const CurveLook& look) {
    check_look(look);
    check_view(view);
    if (view.curve_count == 0) return {};
    return Builder(view, look).build();
}

}  // namespace flg::render
