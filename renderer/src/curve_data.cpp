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
    Builder(const FlgCurveSetView& view, const CurveLook& look, uint32_t max_points)
        : view_(view), look_(look), columns_(view), max_points_(max_points) {}

    std::vector<CurveData> build() {
        const uint64_t points = uint64_t{view_.curve_offsets[view_.curve_count]} + view_.curve_count;
        begin_part(points);
        for (uint32_t c = 0; c < view_.curve_count; ++c) add_curve(c);
        return std::move(parts_);
    }

private:
    void begin_part(uint64_t points) {
        const auto room = static_cast<size_t>(std::min<uint64_t>(points, max_points_));
        CurveData& part = parts_.emplace_back();
        part.centers.reserve(room);
        part.looks.reserve(room);
        part.has_displacements = columns_.has_displacements();
        if (part.has_displacements) part.displacements.reserve(room);
    }

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
        if (parts_.back().centers.size() + count <= max_points_) return add_run({0, count - 1, count, joined});
        // A part of the curve has a neighbour at each end, that frames look at.
        const uint32_t segments = count <= max_points_ ? count : (max_points_ - 3) / chunk_segments * chunk_segments;
        for (uint32_t begin = 0, end; begin < count - 1; begin = end) {
            end = begin + std::min(segments, count - 1 - begin);
            if (!parts_.back().centers.empty()) begin_part(max_points_);
            add_run({begin, end, count, joined});
        }
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

    // Points `begin` to `end` of the curve at hand, which has `count`.
    struct Run {
        uint32_t begin, end, count;
        bool joined;
        bool whole() const { return begin == 0 && end == count - 1; }
        // Of a part of the curve: the points before and after it, none at an open curve's ends.
        bool has_before() const { return !whole() && (begin > 0 || joined); }
        bool has_after() const { return !whole() && (end < count - 1 || joined); }
        uint32_t before() const { return begin > 0 ? begin - 1 : count - 2; }
        uint32_t after() const { return end < count - 1 ? end + 1 : 1; }
    };

    void add_run(const Run& run) {
        CurveData& part = parts_.back();
        const auto first = static_cast<uint32_t>(part.centers.size());
        colors_.clear();
        run_normals_.clear();
        given_normals_.clear();
        if (run.has_before()) add_point(run.before(), run);
        for (uint32_t i = run.begin; i <= run.end; ++i) add_point(i, run);
        if (run.has_after()) add_point(run.after(), run);
        part.looks.resize(part.centers.size());
        write_normals(run_normals_, &part.looks[first].normal, sizeof(PackedLook));
        write_colors(colors_, &part.looks[first].color, sizeof(PackedLook));
        if (part.has_displacements)
            write_normals(given_normals_, &part.displacements[first].normal, sizeof(PackedDisplacement));
        add_chunks(first, run);
    }

    void add_point(uint32_t i, const Run& run) {
        CurveData& part = parts_.back();
        const uint32_t source = kept_[i];
        const float along = static_cast<float>(i) / static_cast<float>(run.count - 1);
        // Closed curves go there and back: no seam.
        const float to_end = run.joined ? 1.0f - std::abs(2.0f * along - 1.0f) : along;
        part.centers.emplace_back(positions_[i], columns_.radius(source, look_));
        colors_.emplace_back(columns_.color(source, look_, to_end), 1.0f);
        run_normals_.push_back(normals_[i]);
        if (!part.has_displacements) return;
        part.displacements.push_back({columns_.displacement(source), 0});
        const bool given =
            columns_.has_normals() && look_.shape == Shape::ribbon && columns_.normal(source) != glm::vec3(0);
        given_normals_.push_back(given ? columns_.normal(source) : normals_[i]);
    }

    // `first`: the run's first point in its part.
    void add_chunks(uint32_t first, const Run& run) {
        CurveData& part = parts_.back();
        const auto end = static_cast<uint32_t>(part.centers.size()) - 1;
        const uint32_t start = first + (run.has_before() ? 1 : 0), last = end - (run.has_after() ? 1 : 0);
        for (uint32_t at = start; at < last; at += chunk_segments) {
            const uint32_t segments = std::min(chunk_segments, last - at);
            uint32_t flags = run.joined && run.whole() ? Chunk::closed : 0;
            if (!run.joined && run.begin == 0 && at == start) flags |= Chunk::begins;
            if (!run.joined && run.end == run.count - 1 && at + segments == last) flags |= Chunk::ends;
            part.chunks.push_back({at, segments | flags, first, end});
            part.bounds.push_back(
                bounds_of(&part.centers[at], &run_normals_[at - first], segments, look_.shape, part.box));
            if (part.has_displacements) add_growth(at, segments);
        }
    }

    void add_growth(uint32_t first, uint32_t segments) {
        CurveData& part = parts_.back();
        const float reach = look_.shape == Shape::line ? 0.0f : part.bounds.back().thickness;
        ChunkGrowth growth{};
        for (uint32_t i = first; i <= first + segments; ++i) {
            const glm::vec3 displacement = part.displacements[i].displacement;
            part.displaced_box.add(glm::vec3(part.centers[i]), displacement, reach);
            growth.extent = std::max(growth.extent, glm::length(displacement));
            if (i > first)
                growth.segment +=
                    glm::distance(displacement, part.displacements[i - 1].displacement) / static_cast<float>(segments);
            if (i > first && i < first + segments)
                growth.bend =
                    std::max(growth.bend, glm::length(part.displacements[i - 1].displacement - 2.0f * displacement +
                                                      part.displacements[i + 1].displacement));
        }
        part.growths.push_back(growth);
    }

    const FlgCurveSetView& view_;
    const CurveLook& look_;
    CurveColumns columns_;
    uint32_t max_points_;
    std::vector<CurveData> parts_;
    // Of the curve at hand.
    std::vector<glm::vec3> positions_, normals_;
    // Of the run at hand.
    std::vector<glm::vec3> run_normals_, given_normals_;
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

std::vector<CurveData> prepare_curves(const FlgCurveSetView& view, const CurveLook& look, uint32_t max_points) {
    check_look(look);
    check_view(view);
    if (view.curve_count == 0) return {};
    return Builder(view, look, max_points).build();
}

}  // namespace flg::render
