// SPDX-License-Identifier: MIT
// Brush meshes in pieces: their sections, less those that the tolerance spares, half of which is for the sections that
// are left out, half for a tube's sides. Rings stand across the tangent, so tubes get thinner in sharp corners.
#include "io/gltf/swept_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "brush/brush_mesh.h"
#include "io/base/failure.h"
#include "io/base/limits.h"

namespace flg::io {

namespace {

brush::Column resolved_floats(const Column& column) {
    return {column.data, column.stride / sizeof(float)};
}

brush::Curve curve_of(const CheckedView& view, uint32_t c, float default_radius) {
    const size_t first = view.begin(c);
    const auto from = [&](const Column& whole) {
        brush::Column column = resolved_floats(whole);
        if (column) column.data = column.at(first);
        return column;
    };
    brush::Curve curve;
    curve.position = from(view.position);
    curve.radius = from(view.radius);
    curve.color = from(view.color);
    curve.normal = from(view.normal);
    curve.count = static_cast<uint32_t>(view.end(c) - first);
    curve.closed = view.closed(c);
    curve.default_radius = default_radius;
    return curve;
}

Vector<brush::Section> sections_of(const brush::Curve& curve, const brush::Style& style) {
    Vector<brush::Section> list;
    list.reserve(size_t{curve.count} + 1);
    const brush::FrameStart start = brush::frame_start(curve, style, {});
    brush::Framer framer(style, !style.tube() && curve.normal, {});
    framer.begin_with(start.normal);
    framer.twist_by(start.twist);
    const auto add = [&](const brush::Bends& bends) {
        framer.visit(bends, [&](const brush::Sections& sections) {
            list.insert(list.end(), sections.list, sections.list + sections.count);
        });
        return true;
    };
    brush::WalkPlace place;
    brush::walk(curve, place, add);
    if (curve.closed || list.empty()) return list;
    brush::Bends end;
    brush::last_bend(place, curve, end);
    add(end);
    return list;
}

// ---- Which cross sections a surface along a curve needs
//
// Source: Douglas, Peucker: Algorithms for the Reduction of the Number of Points Required to Represent a Digitized
// Line, 1973. Measured at the cross sections' rims, and at the place where the arc length says: a kept section stands
// for those near it in position, width, twist and colour.

constexpr double color_tolerance = 0.01;

class Reducer {
public:
    Reducer(const Vector<brush::Section>& sections, double tolerance)
        : sections_(sections), tolerance_(tolerance), kept_(sections.size()) {}

    void keep(size_t i) { kept_[i] = true; }

    // Frames from `first` to `last`, both kept.
    void reduce(size_t first, size_t last) {
        Vector<std::pair<size_t, size_t>> spans = {{first, last}};
        while (!spans.empty()) {
            const auto [begin, end] = spans.back();
            spans.pop_back();
            double most = 1;
            size_t worst = end;
            for (size_t i = begin + 1; i < end; ++i) {
                const double error = error_at(i, begin, end);
                if (error <= most) continue;
                most = error;
                worst = i;
            }
            if (worst == end) continue;
            keep(worst);
            spans.push_back({begin, worst});
            spans.push_back({worst, end});
        }
    }

    Vector<size_t> kept() const {
        Vector<size_t> list;
        for (size_t i = 0; i < kept_.size(); ++i) {
            if (kept_[i]) list.push_back(i);
        }
        return list;
    }

private:
    flg::Vec3 arm(size_t i) const { return sections_[i].radius * sections_[i].normal; }
    flg::Vec3 other_arm(size_t i) const {
        return sections_[i].radius * sections_[i].tangent.cross(sections_[i].normal);
    }

    // In units of what is allowed.
    double error_at(size_t i, size_t begin, size_t end) const {
        const brush::Section &a = sections_[begin], &b = sections_[end];
        const double span = b.along - a.along;
        const double t = span > 0 ? (sections_[i].along - a.along) / span : 0;
        const auto off = [&](const flg::Vec3& from, const flg::Vec3& to, const flg::Vec3& at) {
            return (from + t * (to - from) - at).norm();
        };
        double error =
            (off(a.position, b.position, sections_[i].position) +
             std::max(off(arm(begin), arm(end), arm(i)), off(other_arm(begin), other_arm(end), other_arm(i)))) /
            tolerance_;
        for (size_t k = 0; k < 4; ++k) {
            const double from = a.color[k], to = b.color[k];
            const double color = sections_[i].color[k];
            error = std::max(error, std::abs(from + t * (to - from) - color) / color_tolerance);
        }
        return error;
    }

    const Vector<brush::Section>& sections_;
    double tolerance_;
    Vector<bool> kept_;
};

// The sections to keep, in order, the first and the last among them: in between, straight lines from one kept cross
// section to the next are nowhere farther than `tolerance` from those left out. 0 keeps all.
Vector<size_t> needed_samples(const Vector<brush::Section>& sections, bool closed, double tolerance) {
    const size_t last = sections.size() - 1;
    if (!(tolerance > 0)) {
        Vector<size_t> all(sections.size());
        std::iota(all.begin(), all.end(), size_t{0});
        return all;
    }
    Reducer reducer(sections, tolerance);
    reducer.keep(0);
    reducer.keep(last);
    // A closed curve has no ends that are far from each other: thirds are kept.
    const size_t third = closed && last >= 3 ? last / 3 : 0;
    if (third > 0) {
        for (const size_t i : {third, 2 * third}) reducer.keep(i);
        reducer.reduce(0, third);
        reducer.reduce(third, 2 * third);
        reducer.reduce(2 * third, last);
    } else {
        reducer.reduce(0, last);
    }
    return reducer.kept();
}

constexpr size_t max_vertices = 65535;  // that 16 bits number; the last number has another meaning

class Sweeper {
public:
    Sweeper(const CheckedView& view, const FlgCurveFileWriteDesc& desc) : view_(view), desc_(desc) {}

    Vector<SweptPiece> sweep() {
        for (uint32_t c = 0; c < view_.curve_count(); ++c) add_curve(c);
        return std::move(pieces_);
    }

private:
    void add_curve(uint32_t c) {
        const FlgCurveGeometry geometry =
            desc_.geometries ? static_cast<FlgCurveGeometry>(desc_.geometries[c]) : desc_.geometry;
        const brush::Curve curve = curve_of(view_, c, desc_.default_radius);
        brush::Style style;
        style.shape = geometry == FLG_CURVE_GEOMETRY_TUBE ? FLG_BRUSH_SHAPE_TUBE : FLG_BRUSH_SHAPE_RIBBON;
        style.join = FLG_BRUSH_JOIN_NARROW;
        style.sides = desc_.tube_sides;
        const double tolerance = 0.5 * double{desc_.tolerance};
        if (tolerance > 0) {
            const double widest = double{brush::widest_radius(curve)};
            style.sides = brush::sides_within(widest, tolerance, desc_.tube_sides);
        }
        Vector<brush::Section> sections = sections_of(curve, style);
        if (sections.empty()) return;
        const Vector<size_t> kept = needed_samples(sections, curve.closed, tolerance);
        for (size_t i = 0; i < kept.size(); ++i) sections[i] = sections[kept[i]];
        const brush::Counts counts =
            brush::counts_of(style, kept.size(), curve.closed, false, static_cast<float>(sections.front().radius),
                             static_cast<float>(sections[kept.size() - 1].radius));
        const brush::CrossSection section(style);
        brush::Sweep sweep(style, section, room(geometry, counts));
        sweep.begin(curve.closed, 1, false);
        sweep.add(sections.data(), static_cast<uint32_t>(kept.size()));
        sweep.end();
    }

    // In the last piece of its geometry, if there is room, or in a new one.
    brush::Output room(FlgCurveGeometry geometry, const brush::Counts& counts) {
        // A vertex takes 40 bytes, its share of the triangles 24: refused before the memory is taken.
        constexpr uint64_t bytes_per_vertex = 64;
        vertex_total_ += counts.vertices;
        if (vertex_total_ * bytes_per_vertex > max_bytes) {
            fail(FLG_ERROR_LIMIT, "", "the surface takes more than the limit of 2 GiB");
        }
        const auto fits = [&](const SweptPiece& piece) {
            return piece.geometry == geometry && piece.vertex_count() + counts.vertices <= max_vertices;
        };
        const size_t recent = pieces_.size() < 2 ? 0 : pieces_.size() - 2;
        const auto found = std::find_if(pieces_.begin() + static_cast<std::ptrdiff_t>(recent), pieces_.end(), fits);
        const auto number = static_cast<size_t>(found - pieces_.begin());
        if (found == pieces_.end()) pieces_.push_back({geometry, {}, {}, {}, {}});
        SweptPiece& piece = pieces_[number];
        brush::Output output;
        output.first_index_value = static_cast<uint32_t>(piece.vertex_count());
        const auto add_column = [&](brush::Of kind, Vector<float>& values, uint32_t components) {
            const size_t before = values.size();
            values.resize(before + components * counts.vertices);
            FlgBufferColumn& column = output[kind];
            column.data = values.data() + before;
            column.stride = static_cast<uint32_t>(components * sizeof(float));
            column.components = components;
        };
        add_column(brush::Of::position, piece.positions, 3);
        add_column(brush::Of::normal, piece.normals, 3);
        if (view_.color) add_column(brush::Of::color, piece.colors, 4);
        const size_t before = piece.indices.size();
        piece.indices.resize(before + counts.indices);
        output.indices = piece.indices.data() + before;
        return output;
    }

    const CheckedView& view_;
    const FlgCurveFileWriteDesc& desc_;
    Vector<SweptPiece> pieces_;
    uint64_t vertex_total_ = 0;
};

}  // namespace

Vector<SweptPiece> sweep(const CheckedView& view, const FlgCurveFileWriteDesc& desc) {
    return Sweeper(view, desc).sweep();
}

}  // namespace flg::io
