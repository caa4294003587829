// SPDX-License-Identifier: MIT
// Ribbons: two vertices a point, at the radius on both sides along tangent x normal, facing the normal. Tubes: a ring
// of vertices a point, with normals that follow the change of the radius, and flat caps with vertices of their own at
// open ends of a radius above 0. Triangles are counter-clockwise seen from outside (from the normal's side). Rings
// stand across the tangent, so tubes get thinner in sharp corners. With a tolerance, half of it is for the rings that
// are left out, half for a tube's sides.
#include "io/gltf/swept_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "io/base/failure.h"
#include "io/base/limits.h"
#include "io/base/vec3.h"

namespace flg::io {

namespace {

// ---- Frames along one curve: what a cross section is placed by
//
// Source: Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008 (double reflection, section 4).
// Tangents halve the turn between the segments that meet: a TANGENT column may be that of another curve (results of
// flgStylize carry their target's frame), and a cross section placed by it would be squashed. Normals that are asked
// for are made perpendicular, on the side that keeps the surface from crossing over itself, and carried along where
// they point along the curve. All others are carried along by double reflection, on closed curves with the twist that
// is left spread evenly over the length.

struct SweptFrame {
    Vec3 position;
    Vec3 tangent;
    Vec3 normal;   // unit length, across the tangent
    double along;  // arc length from the first point
    size_t point;  // of the view
};

enum class Normals {
    followed,  // the view's, where it has any: they say how a ribbon lies
    carried    // rotation-minimizing: nothing round shows another, and following it could only twist the surface
};

// Below it, what is left of a vector across the tangent is rounding.
constexpr double least_across = 1e-6;
// Sine of the angle to the tangent below which a given normal says too little: beside such a point it turns about the
// curve at once.
constexpr double least_said = 0.1;

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

Vec3 any_across(const Vec3& tangent) {
    // The axis least along the tangent.
    const double x = std::abs(tangent.x), y = std::abs(tangent.y), z = std::abs(tangent.z);
    const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : (y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
    return normalized(axis - dot(axis, tangent) * tangent);
}

Vec3 make_across(const Vec3& normal, const Vec3& tangent) {
    const Vec3 across = normal - dot(normal, tangent) * tangent;
    return length(across) > least_across ? normalized(across) : any_across(tangent);
}

// v mirrored in the plane across `axis`.
Vec3 reflect(const Vec3& v, const Vec3& axis) {
    const double size_sq = dot(axis, axis);
    return size_sq > 0 ? v - (2 * dot(axis, v) / size_sq) * axis : v;
}

Vec3 carry(const SweptFrame& from, const SweptFrame& to) {
    const Vec3 chord = to.position - from.position;
    const Vec3 normal = reflect(from.normal, chord);
    const Vec3 tangent = reflect(from.tangent, chord);
    return make_across(reflect(normal, to.tangent - tangent), to.tangent);
}

void carry_normals(std::vector<SweptFrame>& frames, bool closed) {
    frames[0].normal = any_across(frames[0].tangent);
    for (size_t i = 1; i < frames.size(); ++i) frames[i].normal = carry(frames[i - 1], frames[i]);
    if (!closed) return;
    const SweptFrame& first = frames.front();
    const Vec3 arrived = carry(frames.back(), first);
    const double twist = std::atan2(dot(cross(arrived, first.normal), first.tangent), dot(arrived, first.normal));
    const double around = frames.back().along + length(first.position - frames.back().position);
    for (SweptFrame& frame : frames) {
        const double angle = twist * frame.along / around;
        frame.normal = std::cos(angle) * frame.normal + std::sin(angle) * cross(frame.tangent, frame.normal);
    }
}

// The frame's given normal across its tangent; zero where it points along it.
Vec3 said_normal(const CheckedView& view, const SweptFrame& frame) {
    const Vec3 given = normalized(load(view.normal.at(frame.point)));
    const Vec3 across = given - dot(given, frame.tangent) * frame.tangent;
    return length(across) > least_said ? normalized(across) : Vec3{};
}

void follow_normals(const CheckedView& view, std::vector<SweptFrame>& frames, bool closed) {
    for (SweptFrame& frame : frames) frame.normal = said_normal(view, frame);
    const auto says = [](const SweptFrame& frame) { return dot(frame.normal, frame.normal) > 0; };
    const auto first = static_cast<size_t>(std::find_if(frames.begin(), frames.end(), says) - frames.begin());
    if (first == frames.size()) return carry_normals(frames, closed);
    for (size_t i = first; i-- > 0;) frames[i].normal = carry(frames[i + 1], frames[i]);
    for (size_t i = first + 1; i < frames.size(); ++i) {
        const Vec3 carried = carry(frames[i - 1], frames[i]);
        const double side = dot(frames[i].normal, carried);
        if (!says(frames[i])) {
            frames[i].normal = carried;
        } else if (side < 0) {
            frames[i].normal = -1 * frames[i].normal;
        }
    }
}

// One frame a point, points repeated in a row only once; empty for a curve without length.
std::vector<SweptFrame> swept_frames(const CheckedView& view, uint32_t curve, Normals normals) {
    std::vector<SweptFrame> frames;
    for (size_t i = view.begin(curve); i < view.end(curve); ++i) {
        const Vec3 position = load(view.position.at(i));
        const double step = frames.empty() ? 0 : length(position - frames.back().position);
        if (!frames.empty() && step == 0) continue;
        frames.push_back({position, {}, {}, frames.empty() ? 0 : frames.back().along + step, i});
    }
    const bool closed = view.closed(curve);
    while (closed && frames.size() > 1 && length(frames.back().position - frames.front().position) == 0) {
        frames.pop_back();
    }
    if (frames.size() < 2) return {};

    const size_t count = frames.size();
    for (size_t i = 0; i < count; ++i) {
        SweptFrame& frame = frames[i];
        const bool has_before = i > 0 || closed;
        const bool has_after = i + 1 < count || closed;
        const Vec3 before = has_before ? normalized(frame.position - frames[(i + count - 1) % count].position) : Vec3{};
        const Vec3 after = has_after ? normalized(frames[(i + 1) % count].position - frame.position) : Vec3{};
        frame.tangent = normalized(before + after);
        // The curve turns back on itself: it still arrives somehow.
        if (dot(frame.tangent, frame.tangent) == 0) frame.tangent = before;
    }
    if (view.normal && normals == Normals::followed) {
        follow_normals(view, frames, closed);
    } else {
        carry_normals(frames, closed);
    }
    return frames;
}

// ---- Which cross sections a surface along a curve needs
//
// Source: Douglas, Peucker: Algorithms for the Reduction of the Number of Points Required to Represent a Digitized
// Line, 1973. Measured at the cross sections' rims, and at the place where the arc length says: a kept section stands
// for those near it in position, width, twist and colour.

// What the cross sections are, one a frame.
struct SweptSections {
    std::vector<double> radii;
    std::vector<const float*> colors;  // four floats each; empty: none
};

constexpr double color_tolerance = 0.01;

class Reducer {
public:
    Reducer(const std::vector<SweptFrame>& frames, const SweptSections& sections, double tolerance)
        : frames_(frames), sections_(sections), tolerance_(tolerance), kept_(frames.size()) {}

    void keep(size_t i) { kept_[i] = true; }

    // Frames from `first` to `last`, both kept.
    void reduce(size_t first, size_t last) {
        std::vector<std::pair<size_t, size_t>> spans = {{first, last}};
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

    std::vector<size_t> kept() const {
        std::vector<size_t> list;
        for (size_t i = 0; i < kept_.size(); ++i) {
            if (kept_[i]) list.push_back(i);
        }
        return list;
    }

private:
    Vec3 arm(size_t i) const { return sections_.radii[i] * frames_[i].normal; }
    Vec3 other_arm(size_t i) const { return sections_.radii[i] * cross(frames_[i].tangent, frames_[i].normal); }

    // In units of what is allowed.
    double error_at(size_t i, size_t begin, size_t end) const {
        const SweptFrame &a = frames_[begin], &b = frames_[end];
        const double span = b.along - a.along;
        const double t = span > 0 ? (frames_[i].along - a.along) / span : 0;
        const auto off = [&](const Vec3& from, const Vec3& to, const Vec3& at) {
            return length(from + t * (to - from) - at);
        };
        double error =
            (off(a.position, b.position, frames_[i].position) +
             std::max(off(arm(begin), arm(end), arm(i)), off(other_arm(begin), other_arm(end), other_arm(i)))) /
            tolerance_;
        for (size_t k = 0; k < 4 && !sections_.colors.empty(); ++k) {
            const double from = sections_.colors[begin][k], to = sections_.colors[end][k];
            error = std::max(error, std::abs(from + t * (to - from) - sections_.colors[i][k]) / color_tolerance);
        }
        return error;
    }

    const std::vector<SweptFrame>& frames_;
    const SweptSections& sections_;
    double tolerance_;
    std::vector<bool> kept_;
};

// The frames to keep, in order, the first and the last among them: in between, straight lines from one kept cross
// section to the next are nowhere farther than `tolerance` from those left out. 0 keeps all.
std::vector<size_t> needed_samples(const std::vector<SweptFrame>& frames, const SweptSections& sections, bool closed,
                                   double tolerance) {
    const size_t last = frames.size() - 1;
    if (!(tolerance > 0)) {
        std::vector<size_t> all(frames.size());
        std::iota(all.begin(), all.end(), size_t{0});
        return all;
    }
    Reducer reducer(frames, sections, tolerance);
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

constexpr size_t most_vertices = 65535;  // that 16 bits number; the last number has another meaning
constexpr uint32_t least_sides = 3;

class Sweeper {
public:
    Sweeper(const CheckedView& view, const FlgCurveWriteDesc& desc) : view_(view), desc_(desc) {}

    std::vector<SweptPiece> sweep() {
        for (uint32_t c = 0; c < view_.curve_count(); ++c) add_curve(c);
        return std::move(pieces_);
    }

private:
    void add_curve(uint32_t curve) {
        const FlgGeometry geometry =
            desc_.geometries ? static_cast<FlgGeometry>(desc_.geometries[curve]) : desc_.geometry;
        const bool tube = geometry == FLG_GEOMETRY_TUBE, closed = view_.closed(curve);
        std::vector<SweptFrame> frames = swept_frames(view_, curve, tube ? Normals::carried : Normals::followed);
        if (frames.empty()) return;
        SweptSections sections;
        for (const SweptFrame& frame : frames) {
            sections.radii.push_back(radius(frame));
            if (view_.color) sections.colors.push_back(view_.color.at(frame.point));
        }
        set_sides(*std::max_element(sections.radii.begin(), sections.radii.end()));
        slopes_.clear();
        for (size_t i = 0; i < frames.size(); ++i) slopes_.push_back(slope(frames, i, closed));
        const std::vector<size_t> kept = needed_samples(frames, sections, closed, 0.5 * double{desc_.tolerance});
        for (size_t i = 0; i < kept.size(); ++i) {
            frames[i] = frames[kept[i]];
            slopes_[i] = slopes_[kept[i]];
        }
        frames.resize(kept.size());
        begin_curve(geometry, tube ? frames.size() * sides() + (closed ? 0 : 2 * (sides() + 1)) : 2 * frames.size());
        if (tube)
            add_tube(frames, closed);
        else
            add_ribbon(frames, closed);
    }

    uint32_t sides() const { return static_cast<uint32_t>(circle_.size()); }

    // As few as keep the flat sides within half of the tolerance.
    void set_sides(double radius) {
        uint32_t count = desc_.tube_sides;
        const double inside = 1 - 0.5 * double{desc_.tolerance} / radius;  // of a unit circle; not a number for 0 / 0
        if (desc_.tolerance > 0) {
            const double fewest = inside > 0 ? std::ceil(std::numbers::pi / std::acos(std::min(inside, 1.0))) : 0;
            if (fewest < count) count = std::max(least_sides, static_cast<uint32_t>(fewest));
        }
        if (count == sides()) return;
        circle_.clear();
        for (uint32_t k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            circle_.push_back({std::cos(angle), std::sin(angle), 0});
        }
    }

    // Into the last piece of its geometry, if there is room.
    void begin_curve(FlgGeometry geometry, size_t vertices) {
        // A vertex takes 40 bytes, its share of the triangles 24: refused before the memory is taken.
        constexpr uint64_t bytes_per_vertex = 64;
        vertex_total_ += vertices;
        if (vertex_total_ * bytes_per_vertex > max_bytes) {
            fail(FLG_ERROR_LIMIT, "", "the surface takes more than the limit of 2 GiB");
        }
        const auto fits = [&](const SweptPiece& piece) {
            return piece.geometry == geometry && piece.vertex_count() + vertices <= most_vertices;
        };
        const size_t recent = pieces_.size() < 2 ? 0 : pieces_.size() - 2;
        const auto found = std::find_if(pieces_.begin() + static_cast<std::ptrdiff_t>(recent), pieces_.end(), fits);
        piece_ = static_cast<size_t>(found - pieces_.begin());
        if (found == pieces_.end()) pieces_.push_back({geometry, {}, {}, {}, {}});
    }

    double radius(const SweptFrame& frame) const {
        return view_.radius ? double{*view_.radius.at(frame.point)} : double{desc_.default_radius};
    }

    SweptPiece& piece() { return pieces_[piece_]; }
    uint32_t vertex_count() { return static_cast<uint32_t>(piece().vertex_count()); }

    void add_vertex(const Vec3& position, const Vec3& normal, const SweptFrame& frame) {
        SweptPiece& to = piece();
        for (double value : {position.x, position.y, position.z}) to.positions.push_back(static_cast<float>(value));
        for (double value : {normal.x, normal.y, normal.z}) to.normals.push_back(static_cast<float>(value));
        if (!view_.color) return;
        const float* color = view_.color.at(frame.point);
        to.colors.insert(to.colors.end(), color, color + 4);
    }

    void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
        std::vector<uint32_t>& indices = piece().indices;
        indices.insert(indices.end(), {a, b, c});
    }

    void add_ribbon(const std::vector<SweptFrame>& frames, bool closed) {
        const uint32_t first = vertex_count();
        const uint32_t count = static_cast<uint32_t>(frames.size());
        for (const SweptFrame& frame : frames) {
            const Vec3 half = radius(frame) * cross(frame.tangent, frame.normal);
            add_vertex(frame.position - half, frame.normal, frame);
            add_vertex(frame.position + half, frame.normal, frame);
        }
        for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            const uint32_t a = first + 2 * i;
            const uint32_t b = first + 2 * ((i + 1) % count);
            add_triangle(a, b + 1, b);
            add_triangle(a, a + 1, b + 1);
        }
    }

    // How the radius changes along the curve.
    double slope(const std::vector<SweptFrame>& frames, size_t i, bool closed) const {
        const size_t count = frames.size();
        const size_t before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
        const size_t after = i + 1 < count ? i + 1 : (closed ? 0 : count - 1);
        const double step =
            length(frames[i].position - frames[before].position) + length(frames[after].position - frames[i].position);
        return step > 0 ? (radius(frames[after]) - radius(frames[before])) / step : 0;
    }

    void add_tube(const std::vector<SweptFrame>& frames, bool closed) {
        const uint32_t first = vertex_count();
        const uint32_t count = static_cast<uint32_t>(frames.size());
        for (uint32_t i = 0; i < count; ++i) add_ring(frames[i], slopes_[i]);
        for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            const uint32_t a = first + sides() * i;
            const uint32_t b = first + sides() * ((i + 1) % count);
            for (uint32_t k = 0; k < sides(); ++k) {
                const uint32_t next = (k + 1) % sides();
                add_triangle(a + k, a + next, b + next);
                add_triangle(a + k, b + next, b + k);
            }
        }
        if (closed) return;
        add_cap(frames.front(), -1);
        add_cap(frames.back(), 1);
    }

    Vec3 across(const SweptFrame& frame, uint32_t k) const {
        return circle_[k].x * frame.normal + circle_[k].y * cross(frame.tangent, frame.normal);
    }

    void add_ring(const SweptFrame& frame, double slope) {
        for (uint32_t k = 0; k < sides(); ++k) {
            const Vec3 out = across(frame, k);
            add_vertex(frame.position + radius(frame) * out, normalized(out - slope * frame.tangent), frame);
        }
    }

    // `side`: -1 at the start, 1 at the end.
    void add_cap(const SweptFrame& frame, int side) {
        if (radius(frame) == 0) return;
        const uint32_t centre = vertex_count();
        const Vec3 normal = static_cast<double>(side) * frame.tangent;
        add_vertex(frame.position, normal, frame);
        for (uint32_t k = 0; k < sides(); ++k) {
            add_vertex(frame.position + radius(frame) * across(frame, k), normal, frame);
        }
        for (uint32_t k = 0; k < sides(); ++k) {
            const uint32_t a = centre + 1 + k;
            const uint32_t b = centre + 1 + (k + 1) % sides();
            if (side > 0)
                add_triangle(centre, a, b);
            else
                add_triangle(centre, b, a);
        }
    }

    const CheckedView& view_;
    const FlgCurveWriteDesc& desc_;
    std::vector<Vec3> circle_;
    std::vector<double> slopes_;  // of the radius, at the frames of the curve at hand
    std::vector<SweptPiece> pieces_;
    size_t piece_ = 0;
    uint64_t vertex_total_ = 0;
};

}  // namespace

std::vector<SweptPiece> sweep(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    return Sweeper(view, desc).sweep();
}

}  // namespace flg::io
