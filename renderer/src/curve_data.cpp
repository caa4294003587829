// SPDX-License-Identifier: MIT
#include "curve_data.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "packing.h"
#include "vk.h"

namespace flg::render {
namespace {

constexpr uint32_t most_points = 1u << 28;

void check_view(const FlgCurveSetView& view) {
    if (view.curve_count == 0) return;
    if (!view.curve_offsets) fail("The view has %u curves but no curve_offsets.", view.curve_count);
    if (view.curve_offsets[0] != 0) fail("curve_offsets begins with %u instead of 0.", view.curve_offsets[0]);
    for (uint32_t c = 0; c < view.curve_count; ++c)
        if (view.curve_offsets[c + 1] < view.curve_offsets[c])
            fail("curve_offsets falls from %u to %u after curve %u.", view.curve_offsets[c], view.curve_offsets[c + 1],
                 c);
    if (view.curve_offsets[view.curve_count] > most_points)
        fail("The view has %u points; the renderer takes at most %u.", view.curve_offsets[view.curve_count],
             most_points);
    if (view.column_count == 0 || !view.columns) fail("The view has no columns.");
}

void check_look(const CurveLook& look) {
    check_in(look.radius, 0.0f, largest_coordinate, "radius");
    check_in(look.radius_scale, 0.0f, largest_coordinate, "radius_scale");
    check_in(static_cast<float>(look.sides), 3.0f, 32.0f, "sides");
    check_in(look.line_width_px, 0.5f, 64.0f, "line_width_px");
    check_in(look.gloss, 0.0f, 1.0f, "gloss");
    check_color(look.color, "color");
    check_color(look.color_end, "color_end");
}

std::span<const FlgColumn> columns_of(const FlgCurveSetView& view) {
    return {view.columns, view.column_count};
}

class Builder {
public:
    Builder(const FlgCurveSetView& view, const CurveLook& look)
        : view_(view),
          look_(look),
          position_(find_column(columns_of(view), FLG_ATTRIBUTE_POSITION, 3, "POSITION")),
          radius_(find_column(columns_of(view), FLG_ATTRIBUTE_RADIUS, 1, "RADIUS")),
          color_(find_column(columns_of(view), FLG_ATTRIBUTE_COLOR, 4, "COLOR")),
          normal_(find_column(columns_of(view), FLG_ATTRIBUTE_NORMAL, 3, "NORMAL")),
          displacement_(find_column(columns_of(view), FLG_ATTRIBUTE_DISPLACEMENT, 3, "DISPLACEMENT")) {
        if (!position_) fail("The view has no POSITION column.");
    }

    CurveData build() {
        const uint32_t points = view_.curve_offsets[view_.curve_count];
        data_.centers.reserve(points + view_.curve_count);
        data_.looks.reserve(points + view_.curve_count);
        data_.has_displacements = bool(displacement_);
        if (displacement_) data_.displacements.reserve(points + view_.curve_count);
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
        for (uint32_t i = 0; i < count; ++i) add_point(i, count, joined);
        add_chunks(first, count, joined);
    }

    // Tubes are round: following the view's normals could only twist them.
    void make_normals(uint32_t count, bool joined) {
        normals_.assign(count, glm::vec3(0.0f, 1.0f, 0.0f));
        if (look_.shape == Shape::line) return;
        if (!normal_ || look_.shape == Shape::tube) {
            carry_normals(positions_.data(), count, joined, normals_.data());
            return;
        }
        for (uint32_t i = 0; i < count; ++i) normals_[i] = normal_.at<glm::vec3>(kept_[i]);
        follow_normals(positions_.data(), count, joined, normals_.data());
    }

    void gather_points(uint32_t begin, uint32_t end) {
        positions_.clear();
        kept_.clear();
        for (uint32_t i = begin; i < end; ++i) {
            const auto p = position_.at<glm::vec3>(i);
            if (!is_usable(p))
                fail("Point %u is at (%g, %g, %g); positions must be finite, at most 1e30.", i, p.x, p.y, p.z);
            if (!positions_.empty() && positions_.back() == p) continue;
            positions_.push_back(p);
            kept_.push_back(i);
        }
    }

    void add_point(uint32_t i, uint32_t count, bool joined) {
        const uint32_t source = kept_[i];
        float radius = radius_ ? radius_.at<float>(source) : look_.radius;
        if (!(radius >= 0.0f && radius <= largest_coordinate))
            fail("Point %u has the radius %g; it must be in 0 to 1e30.", source, radius);
        radius *= look_.radius_scale;
        if (normal_ && !is_usable(normal_.at<glm::vec3>(source)))
            fail("Point %u has a normal that is not finite.", source);
        glm::vec3 color;
        if (color_) {
            color = color_.at<glm::vec4>(source);
            if (!is_usable(color)) fail("Point %u has a colour that is not finite.", source);
        } else {
            const float along = static_cast<float>(i) / static_cast<float>(count - 1);
            // Closed curves go there and back: no seam.
            color = glm::mix(look_.color, look_.color_end, joined ? 1.0f - std::abs(2.0f * along - 1.0f) : along);
        }
        data_.centers.emplace_back(positions_[i], radius);
        data_.looks.push_back({pack_normal(normals_[i]), pack_color(color)});
        if (displacement_) add_displacement(i);
    }

    void add_displacement(uint32_t i) {
        const uint32_t source = kept_[i];
        const auto displacement = displacement_.at<glm::vec3>(source);
        if (!is_usable(displacement))
            fail("Point %u has a displacement that is not finite, or longer than 1e30.", source);
        glm::vec3 normal = normals_[i];
        if (normal_ && look_.shape == Shape::ribbon && normal_.at<glm::vec3>(source) != glm::vec3(0))
            normal = normal_.at<glm::vec3>(source);
        data_.displacements.push_back({displacement, pack_normal(normal)});
    }

    void add_chunks(uint32_t first, uint32_t count, bool joined) {
        const uint32_t last = first + count - 1;
        for (uint32_t at = first; at < last; at += chunk_segments) {
            const uint32_t segments = std::min(chunk_segments, last - at);
            uint32_t flags = joined ? Chunk::closed : 0;
            if (!joined && at == first) flags |= Chunk::begins;
            if (!joined && at + segments == last) flags |= Chunk::ends;
            data_.chunks.push_back({at, segments | flags, first, last});
            data_.bounds.push_back(bounds_of(at, segments));
            if (displacement_) add_growth(at, segments);
        }
    }

    ChunkBounds bounds_of(uint32_t first, uint32_t segments) {
        glm::vec3 low(data_.centers[first]), high = low;
        float thickness = data_.centers[first].w, length = 0.0f;
        for (uint32_t i = first + 1; i <= first + segments; ++i) {
            const glm::vec3 p(data_.centers[i]);
            low = glm::min(low, p);
            high = glm::max(high, p);
            thickness = std::max(thickness, data_.centers[i].w);
            length += glm::distance(p, glm::vec3(data_.centers[i - 1]));
        }
        const float reach = look_.shape == Shape::line ? 0.0f : thickness;
        data_.box.add({low - reach, high + reach});
        // Joints and caps reach up to two radii from the centre line.
        return {0.5f * (low + high), 0.5f * glm::distance(low, high) + 2.0f * reach, thickness,
                length / static_cast<float>(segments)};
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
        }
        data_.growths.push_back(growth);
    }

    const FlgCurveSetView& view_;
    const CurveLook& look_;
    Column position_, radius_, color_, normal_, displacement_;
    CurveData data_;
    std::vector<glm::vec3> positions_, normals_;  // of the curve at hand
    std::vector<uint32_t> kept_;                  // which of the view's points they are
};

}  // namespace

CurveData prepare_curves(const FlgCurveSetView& view, const CurveLook& look) {
    check_look(look);
    check_view(view);
    if (view.curve_count == 0) return {};
    return Builder(view, look).build();
}

}  // namespace flg::render
