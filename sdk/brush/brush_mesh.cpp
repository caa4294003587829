// SPDX-License-Identifier: MIT
#include "brush/brush_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

Sweep::Sweep(const Style& style, const CrossSection& section, const Output& output)
    : style_(style), section_(section), writer_(style, section, output) {}

void Sweep::begin(bool closed, double length, bool continues) {
    closed_ = closed;
    length_ = length;
    begun_ = continues;
    previous_ = -static_cast<int64_t>(section_.vertices);
}

double Sweep::coordinate(double along) const {
    return style_.uv_along_unit ? std::clamp(along / length_, 0.0, 1.0) : along;
}

Row Sweep::row_at(const Section& section, double along) const {
    Row row;
    const double radius = section.point->radius;
    row.center = section.position;
    row.tangent = section.tangent;
    row.normal = section.normal;
    row.binormal = section.tangent.cross(section.normal);
    row.arm[0] = radius * row.normal;
    row.arm[1] = radius * row.binormal;
    if (section.widening_size != 0) {
        for (Vec3& arm : row.arm) arm += section.widening_size * arm.dot(section.widening) * section.widening;
    }
    if (style_.tube()) {
        row.normal_out = 1 / std::sqrt(1 + section.slope * section.slope);
        row.normal_along = -section.slope * row.normal_out;
    }
    row.along = coordinate(along);
    if (!style_.uv_around_unit) row.width = (style_.tube() ? 2 * std::numbers::pi : 2) * radius;
    row.color = section.point->color;
    return row;
}

void Sweep::add(const Section& section) {
    const Row row = row_at(section, section.along);
    if (!begun_ && !closed_) add_cap(section, CapProfile(style_, style_.start_cap), true);
    const int64_t number = writer_.write(row);
    if (begun_) {
        writer_.strip(previous_, number, false);
    } else if (closed_) {
        first_ = number;
        first_row_ = row;
        first_point_ = *section.point;
    }
    begun_ = true;
    previous_ = number;
    last_ = section;
    last_point_ = *section.point;
}

void Sweep::end() {
    last_.point = &last_point_;
    if (!closed_) return add_cap(last_, CapProfile(style_, style_.end_cap), false);
    int64_t seam = first_;
    if (style_.uv) {
        first_row_.along = coordinate(length_);
        first_row_.color = first_point_.color;
        seam = writer_.write(first_row_);
    }
    writer_.strip(previous_, seam, false);
}

void Sweep::add_cap(const Section& section, const CapProfile& profile, bool back) {
    const double radius = section.point->radius;
    if (profile.row_count == 0 || radius == 0) return;
    const double side = back ? -1 : 1;
    int64_t before = 0;
    Row row;
    for (uint32_t i = 0; i < profile.row_count; ++i) {
        const CapRow& cap = profile.rows[i];
        const double ahead = side * radius * double{cap.ahead};
        row = row_at(section, section.along + ahead);
        row.center += ahead * section.tangent;
        for (Vec3& arm : row.arm) arm *= double{cap.size};
        row.width *= double{cap.size};
        if (style_.tube()) {
            row.normal_out = double{cap.normal_out};
            row.normal_along = side * double{cap.normal_ahead};
        }
        const int64_t number = writer_.write(row);
        const bool is_tip = !profile.apex && i + 1 == profile.row_count;
        if (is_tip)
            writer_.tip(before, number, back);
        else if (i > 0)
            writer_.strip(before, number, back);
        before = number;
    }
    if (!profile.apex) return;
    const double ahead = side * radius * double{profile.apex_ahead};
    row.center = section.position + ahead * section.tangent;
    row.along = coordinate(section.along + ahead);
    const int64_t apex = writer_.write_apex(row, style_.tube() ? Vec3(side * section.tangent) : section.normal);
    writer_.fan(before, apex, back);
}

uint32_t sides_within(double radius, double tolerance, uint32_t most) {
    const double inside = 1 - tolerance / radius;  // of a unit circle; not a number for 0 / 0
    const double fewest = inside > 0 ? std::ceil(std::numbers::pi / std::acos(std::min(inside, 1.0))) : 0;
    return fewest < most ? std::max(min_sides, static_cast<uint32_t>(fewest)) : most;
}

float widest_radius(const Curve& curve) {
    float widest = 0;
    for (uint32_t i = 0; i < curve.count; ++i) widest = std::max(widest, curve.radius_at(i));
    return widest;
}

namespace {

double length_of(const Curve& curve) {
    double length = 0;
    for (uint32_t i = 0; i + 1 < curve.count; ++i)
        length += chord(curve.position.at(i), curve.position.at(i + 1)).norm();
    if (curve.closed) length += chord(curve.position.at(curve.count - 1), curve.position.at(0)).norm();
    return length;
}

}  // namespace

Counts counts_of(const Style& style, uint64_t rows, bool closed, bool continues, float start_radius, float end_radius) {
    const uint32_t row_vertices = CrossSection::vertex_count(style), quads = CrossSection::quad_count(style);
    const uint64_t strips = closed || continues ? rows : rows - 1;
    Counts counts = {rows * row_vertices, 6 * quads * strips};
    const auto add_cap = [&](FlgBrushCap cap, float radius) {
        if (radius == 0) return;
        const CapProfile profile(style, cap);
        counts.vertices += profile.vertex_count(row_vertices);
        counts.indices += 3 * uint64_t{profile.triangle_count(quads)};
    };
    if (closed) {
        if (style.uv) counts.vertices += row_vertices;
        return counts;
    }
    if (!continues) add_cap(style.start_cap, start_radius);
    add_cap(style.end_cap, end_radius);
    return counts;
}

Counts count(const Curve& curve, const Style& style, const Growth* growth) {
    const Corners corners(style);
    WalkPlace place = growth ? growth->walk : WalkPlace{};
    const bool continues = growth && growth->frame.sections > 0;
    uint64_t rows = 0;
    float start_radius = 0;
    walk(curve, place, [&](const Bend& bend) {
        if (rows == 0) start_radius = bend.point.radius;
        rows += bend.in.isZero(0) ? 1 : corners.rows(bend.in, bend.out);
        return true;
    });
    if (rows == 0 && !continues) return {};
    if (!curve.closed) ++rows;
    return counts_of(style, rows, curve.closed, continues, start_radius, place.last.radius);
}

Counts write(const Curve& curve, const Style& style, const Output& output, Growth* growth) {
    const CrossSection section(style);
    Growth now = growth ? *growth : Growth{};
    const bool follow = !style.tube() && curve.normal;
    Framer framer(style, follow, now.frame);
    if (now.frame.sections == 0) {
        const FrameStart start = follow || curve.closed ? frame_start(curve, style, now.walk) : FrameStart{};
        framer.begin_with(start.normal);
        framer.twist_by(start.twist);
    }
    Sweep sweep(style, section, output);
    sweep.begin(curve.closed, style.uv_along_unit || (curve.closed && style.uv) ? length_of(curve) : 1,
                now.frame.sections > 0);
    const auto add = [&](const Bend& bend) {
        framer.visit(bend, [&](const Section& s) { sweep.add(s); });
        return true;
    };
    walk(curve, now.walk, add);
    now.frame = framer.place();
    if (now.frame.sections == 0) {
        if (growth) *growth = now;
        return {};
    }
    if (growth) {
        now.before.vertices += sweep.written().vertices;
        now.before.indices += sweep.written().indices;
        *growth = now;
    }
    if (!curve.closed) add(last_bend(now.walk));
    sweep.end();
    return sweep.written();
}

void advance(Output& output, const Counts& written) {
    for (FlgVertexColumn& column : output.columns) {
        if (column.data) column.data = static_cast<char*>(column.data) + written.vertices * column.stride;
    }
    output.first_index_value += static_cast<uint32_t>(written.vertices);
    const size_t bytes = output.narrow_indices ? sizeof(uint16_t) : sizeof(uint32_t);
    if (output.indices) output.indices = static_cast<char*>(output.indices) + written.indices * bytes;
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
