// SPDX-License-Identifier: MIT
#include "brush/brush_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

namespace {

Lanes lanes(const Vec3& v) {
    return Lanes{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}

Lanes cross(const Lanes& a, const Lanes& b) {
    const auto turned = [](const Lanes& v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); };
    return turned(a * turned(b) - turned(a) * b);
}

float dot(const Lanes& a, const Lanes& b) {
    const Lanes product = a * b;
    return product[0] + product[1] + product[2];
}

}  // namespace

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

Row Sweep::row_of(const Section& section) const {
    const Lanes tangent = lanes(section.tangent), normal = lanes(section.normal), binormal = cross(tangent, normal);
    const auto radius = static_cast<float>(section.radius);
    const Lanes sides = {1, 1, style_.left_handed ? -1.0f : 1.0f, 0};
    Lanes arms[] = {radius * normal, radius * binormal};
    if (section.widening_size != 0) {
        const auto size = static_cast<float>(section.widening_size);
        const Lanes widening = lanes(section.widening);
        for (Lanes& arm : arms) arm += size * dot(arm, widening) * widening;
    }
    Row row;
    row.center = sides * lanes(section.position);
    row.arm[0] = sides * arms[0];
    row.arm[1] = sides * arms[1];
    row.tangent = sides * tangent;
    row.normal = sides * normal;
    row.binormal = sides * binormal;
    row.normal_out = 1;
    row.normal_along = 0;
    if (style_.tube() && section.slope != 0) {
        const double out = 1 / std::sqrt(1 + section.slope * section.slope);
        row.normal_out = static_cast<float>(out);
        row.normal_along = static_cast<float>(-section.slope * out);
    }
    row.along = static_cast<float>(coordinate(section.along));
    const double around = style_.tube() ? 2 * std::numbers::pi : 2;
    row.width = style_.uv_around_unit ? 1 : static_cast<float>(around * section.radius);
    std::copy(section.color, section.color + 4, row.color);
    return row;
}

void Sweep::add(const Section* sections, uint32_t count) {
    if (!begun_ && !closed_) add_cap(sections[0], CapProfile(style_, style_.start_cap), true);
    int64_t number = 0;
    for (uint32_t i = 0; i < count; ++i) {
        number = writer_.write(row_of(sections[i]));
        if (begun_) {
            writer_.strip_ahead(previous_);
        } else {
            begun_ = true;
            first_ = number;
            first_section_ = sections[0];
        }
        previous_ = number;
    }
    last_section_ = sections[count - 1];
}

void Sweep::end() {
    if (!closed_) return add_cap(last_section_, CapProfile(style_, style_.end_cap), false);
    int64_t seam = first_;
    if (style_.uv) {
        first_section_.along = length_;
        seam = writer_.write(row_of(first_section_));
    }
    writer_.strip(previous_, seam, false);
}

void Sweep::add_cap(const Section& section, const CapProfile& profile, bool back) {
    if (profile.row_count == 0 || section.radius == 0) return;
    const double side = back ? -1 : 1;
    const auto row_ahead = [&](float ahead, float size) {
        const double distance = side * section.radius * double{ahead};
        Section moved = section;
        moved.position += distance * section.tangent;
        moved.along += distance;
        moved.radius *= double{size};
        Row row = row_of(moved);
        if (style_.uv_around_unit) row.width *= size;
        return row;
    };
    int64_t before = 0;
    for (uint32_t i = 0; i < profile.row_count; ++i) {
        const CapRow& cap = profile.rows[i];
        Row row = row_ahead(cap.ahead, cap.size);
        if (style_.tube()) {
            row.normal_out = cap.normal_out;
            row.normal_along = static_cast<float>(side) * cap.normal_ahead;
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
    const Row apex = row_ahead(profile.apex_ahead, profile.rows[profile.row_count - 1].size);
    const Lanes facing = style_.tube() ? static_cast<float>(side) * apex.tangent : apex.normal;
    writer_.fan(before, writer_.write_apex(apex, facing), back);
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
    const float start_radius = place.begun ? place.last.radius : curve.count > 0 ? curve.radius_at(0) : 0;
    walk(curve, place, [&](const Bends& bends) {
        int64_t is_corner[Bends::most];
        uint32_t left = corners.find(bends, is_corner);
        rows += bends.count;
        for (uint32_t k = 0; left > 0; ++k) {
            if (is_corner[k] == 0) continue;
            rows += corners.rows(bends, k) - 1;
            --left;
        }
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
    const auto add = [&](const Bends& bends) {
        framer.visit(bends, [&](const Sections& sections) { sweep.add(sections.list, sections.count); });
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
    if (!curve.closed) {
        Bends bends;
        last_bend(now.walk, curve, bends);
        add(bends);
    }
    sweep.end();
    return sweep.written();
}

void advance(Output& output, const Counts& written) {
    for (FlgBufferColumn& column : output.columns) {
        if (column.data) column.data = static_cast<char*>(column.data) + written.vertices * column.stride;
    }
    output.first_index_value += static_cast<uint32_t>(written.vertices);
    const size_t bytes = output.narrow_indices ? sizeof(uint16_t) : sizeof(uint32_t);
    if (output.indices) output.indices = static_cast<char*>(output.indices) + written.indices * bytes;
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
