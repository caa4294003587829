// SPDX-License-Identifier: MIT
#include "brush/section_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {
namespace {

// Sine of the angle to the tangent below which a given normal says too little: beside such a point it turns about the
// curve at once.
constexpr double min_said = 0.1;
// Size of the sum of two unit tangents, and of their cross product, below which a curve turns back on itself.
constexpr double turned_back = 1e-6;

template <size_t count>
Vec3 vector(const double (&components)[3][count], uint32_t k) {
    return Vec3(components[0][k], components[1][k], components[2][k]);
}

}  // namespace

Corners::Corners(const Style& style) : join_(style.join), sides_(style.sides) {
    constexpr double max_miter = 4;  // radii
    cosine_ = join_ == FLG_BRUSH_JOIN_MITER ? 2 / (max_miter * max_miter) - 1 : std::cos(style.corner_angle);
}

uint32_t Corners::find(const Bends& bends, int64_t (&is_corner)[Bends::most]) const {
    std::fill_n(is_corner, bends.count, int64_t{0});
    if (join_ == FLG_BRUSH_JOIN_NARROW) return 0;
    const auto& c = bends.chord;
    double size_sq[Bends::most + 1];
    for (uint32_t k = 0; k <= bends.count; ++k) size_sq[k] = c[0][k] * c[0][k] + c[1][k] * c[1][k] + c[2][k] * c[2][k];
    int64_t found = 0;
    for (uint32_t k = 0; k < bends.count; ++k) {
        const double turn = c[0][k] * c[0][k + 1] + c[1][k] * c[1][k + 1] + c[2][k] * c[2][k + 1];
        is_corner[k] = turn < cosine_ * std::sqrt(size_sq[k] * size_sq[k + 1]) ? 1 : 0;
        found += is_corner[k];
    }
    return static_cast<uint32_t>(found);
}

uint32_t Corners::rows(const Bends& bends, uint32_t k) const {
    if (join_ != FLG_BRUSH_JOIN_ROUND) return 2;
    const auto chord_of = [&](uint32_t i) { return Vec3(bends.chord[0][i], bends.chord[1][i], bends.chord[2][i]); };
    const Vec3 in = chord_of(k), out = chord_of(k + 1);
    const double size = std::sqrt(in.squaredNorm() * out.squaredNorm());
    const double angle = std::acos(std::clamp(in.dot(out) / size, -1.0, 1.0));
    return 1 + std::max(1u, static_cast<uint32_t>(std::ceil(sides_ * angle / (2 * std::numbers::pi))));
}

Vec3 any_across(const Vec3& tangent) {
    const double x = std::abs(tangent.x()), y = std::abs(tangent.y()), z = std::abs(tangent.z());
    const Vec3 axis = x <= y && x <= z ? Vec3::UnitX() : (y <= z ? Vec3::UnitY() : Vec3::UnitZ());
    return (axis - axis.dot(tangent) * tangent).normalized();
}

Vec3 leveled(const float* given, const Vec3& tangent) {
    const Vec3 direction = load_vec3(given).stableNormalized();
    const Vec3 across = direction - direction.dot(tangent) * tangent;
    const double size = across.norm();
    return size > min_said ? Vec3(across / size) : Vec3(Vec3::Zero());
}

Framer::Framer(const Style& style, bool follow, const FramePlace& place)
    : corners_(style),
      narrow_(style.join == FLG_BRUSH_JOIN_NARROW),
      follow_(follow),
      frame_(Vec3::Map(place.position), Vec3::Map(place.tangent), Vec3::Map(place.normal), place.steps),
      along_(place.along),
      sections_(place.sections) {}

FramePlace Framer::place() const {
    FramePlace place;
    Vec3::Map(place.position) = frame_.position();
    Vec3::Map(place.tangent) = frame_.tangent();
    Vec3::Map(place.normal) = frame_.normal();
    place.along = along_;
    place.steps = frame_.steps();
    place.sections = sections_;
    return place;
}

void Framer::measure(const Bends& bends, Turns& turns) const {
    const uint32_t count = bends.count;
    auto& direction = turns.direction;
    const auto& chord = bends.chord;
    for (uint32_t k = 0; k <= count; ++k) {
        const double x = chord[0][k], y = chord[1][k], z = chord[2][k];
        const double length = std::sqrt(x * x + y * y + z * z);
        const double inverse = length > 0 ? 1 / length : 0;
        turns.length[k] = length;
        direction[0][k] = x * inverse;
        direction[1][k] = y * inverse;
        direction[2][k] = z * inverse;
    }
    const double widens = narrow_ ? 0 : 1;
    for (uint32_t k = 0; k < count; ++k) {
        const double in[] = {direction[0][k], direction[1][k], direction[2][k]};
        const double out[] = {direction[0][k + 1], direction[1][k + 1], direction[2][k + 1]};
        const double x = in[0] + out[0], y = in[1] + out[1], z = in[2] + out[2];
        const double size = std::sqrt(x * x + y * y + z * z);
        const double inverse = size >= turned_back ? 1 / size : 0;
        turns.tangent[0][k] = size >= turned_back ? x * inverse : in[0];
        turns.tangent[1][k] = size >= turned_back ? y * inverse : in[1];
        turns.tangent[2][k] = size >= turned_back ? z * inverse : in[2];
        // A round section of the same radius, cut aslant, is longer the way the curve turns.
        const double u = out[0] - in[0], v = out[1] - in[1], w = out[2] - in[2];
        const double turn_sq = u * u + v * v + w * w;
        const double turned = turns.length[k] * turns.length[k + 1] * turn_sq;
        const double widening = size >= turned_back ? widens * (2 * inverse - 1) : 0;
        turns.widening_size[k] = turned > 0 ? widening / turn_sq : 0;
        const double span = turns.length[k] + turns.length[k + 1];
        const double change = bends.radius[k + 2] - bends.radius[k];
        turns.slope[k] = span > 0 ? change / span : 0;
    }
    const bool has_corners = corners_.find(bends, turns.is_corner) > 0;
    for (uint32_t c = 0; c < 3; ++c) {
        turns.left_by[c][0] = frame_.tangent()[c];
        for (uint32_t k = 0; k < count; ++k) turns.left_by[c][k + 1] = turns.tangent[c][k];
        for (uint32_t k = 0; has_corners && k < count; ++k) {
            if (turns.is_corner[k]) turns.left_by[c][k + 1] = direction[c][k + 1];
        }
    }
    for (uint32_t k = 0; k < count; ++k) {
        const double x = chord[0][k], y = chord[1][k], z = chord[2][k];
        const double from[] = {turns.left_by[0][k], turns.left_by[1][k], turns.left_by[2][k]};
        const double first_sq = x * x + y * y + z * z;
        const double factor = first_sq > 0 ? 2 / first_sq : 0;
        const double ahead = factor * (x * from[0] + y * from[1] + z * from[2]);
        const double u = turns.tangent[0][k] - from[0] + ahead * x;
        const double v = turns.tangent[1][k] - from[1] + ahead * y;
        const double w = turns.tangent[2][k] - from[2] + ahead * z;
        const double second_sq = u * u + v * v + w * w;
        turns.second[0][k] = u;
        turns.second[1][k] = v;
        turns.second[2][k] = w;
        turns.first_factor[k] = factor;
        turns.second_sq[k] = first_sq > 0 ? second_sq : 0;
        turns.second_factor[k] = second_sq > 0 ? 2 / second_sq : 0;
        turns.both[k] = u * x + v * y + w * z;
    }
}

void Framer::fill(const Bends& bends, const Turns& turns, Progress& at, Sections& sections) {
    RotationMinimizingFrame frame = frame_;
    uint32_t count = 0;
    for (; at.bend < bends.count && count < Sections::most; ++count) {
        const uint32_t k = at.bend;
        Section& section = sections.list[count];
        section.position = vector(bends.position, k);
        const Vec3 in = vector(turns.direction, k), out = vector(turns.direction, k + 1);
        if (at.row == 0) {
            at.rows = turns.is_corner[k] ? corners_.rows(bends, k) : 1;
            if (sections_ > 0) along_ += turns.length[k];
        }
        const bool smooth = at.rows == 1;
        section.tangent = smooth ? vector(turns.tangent, k) : corner_tangent(in, out, frame.normal(), at);
        if (sections_ == 0 && at.row == 0) {
            const Vec3 normal = first_normal_.isZero(0) ? any_across(section.tangent) : first_normal_;
            frame = RotationMinimizingFrame(section.position, section.tangent, normal);
        } else if (smooth && turns.second_sq[k] >= RotationMinimizingFrame::across_sq) {
            frame.step(section.position, section.tangent,
                       {vector(bends.chord, k), vector(turns.second, k), turns.first_factor[k], turns.second_factor[k],
                        turns.both[k]});
        } else {
            frame.step(section.position, section.tangent);
        }
        sections.given[count] = at.row == 0 ? bends.normal[k] : nullptr;
        if (follow_ && sections.given[count]) follow(sections.given[count], frame);
        section.normal = twist_ == 0 ? frame.normal() : turned_about(section.tangent, frame.normal(), twist_ * along_);
        section.widening = out - in;
        section.widening_size = smooth ? turns.widening_size[k] : 0;
        section.radius = bends.radius[k + 1];
        section.along = along_;
        section.slope = turns.slope[k];
        std::copy(bends.color[k], bends.color[k] + 4, section.color);
        if (++at.row < at.rows) continue;
        at.row = 0;
        ++at.bend;
        ++sections_;
    }
    frame_ = frame;
    sections.count = count;
}

Vec3 Framer::corner_tangent(const Vec3& in, const Vec3& out, const Vec3& normal, const Progress& at) {
    if (at.row == 0) return in;
    if (at.row + 1 == at.rows) return out;
    const Vec3 across = in.cross(out);
    const double sine = across.norm();
    // Turning back, it goes about the normal, which then stays.
    const Vec3 axis = sine > turned_back ? Vec3(across / sine) : normal;
    return turned_about(axis, in, std::atan2(sine, in.dot(out)) * at.row / (at.rows - 1));
}

void Framer::follow(const float* given, RotationMinimizingFrame& frame) const {
    const Vec3 level = leveled(given, frame.tangent());
    if (level.isZero(0)) return;
    const bool other_side = sections_ > 0 && level.dot(frame.normal()) < 0;
    frame.set_normal(other_side ? Vec3(-level) : level);
}

FrameStart frame_start(const Curve& curve, const Style& style, const WalkPlace& place) {
    FrameStart start;
    Framer framer(style, false, {});
    Section first;
    bool begun = false, given = false;
    const bool follow = !style.tube() && curve.normal;
    const auto look = [&](const Bends& bends) {
        framer.visit(bends, [&](const Sections& sections) {
            if (!begun) first = sections.list[0];
            begun = true;
            for (uint32_t i = 0; follow && !given && i < sections.count; ++i) {
                const Section& section = sections.list[i];
                if (!sections.given[i]) continue;
                const Vec3 level = leveled(sections.given[i], section.tangent);
                if (level.isZero(0)) continue;
                // What is carried on keeps its angle to any other that is.
                given = true;
                const double angle = angle_about(section.tangent, section.normal, level);
                start.normal = turned_about(first.tangent, first.normal, angle);
            }
        });
        return !given && (follow || curve.closed);
    };
    WalkPlace end = place;
    walk(curve, end, look);
    if (!given && !curve.closed && end.begun) {
        Bends bends;
        last_bend(end, curve, bends);
        look(bends);
    }
    if (given || !curve.closed || !begun) return start;
    // The first section once more, where the curve comes back to it.
    bool arrived = false;
    WalkPlace again = place;
    walk(curve, again, [&](const Bends& bends) {
        framer.visit(bends, [&](const Sections& sections) {
            const Section& back = sections.list[0];
            if (!arrived) start.twist = angle_about(first.tangent, back.normal, first.normal) / back.along;
            arrived = true;
        });
        return false;
    });
    return start;
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
