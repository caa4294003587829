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

}  // namespace

Corners::Corners(const Style& style) : join_(style.join), sides_(style.sides) {
    constexpr double max_miter = 4;  // radii
    cosine_ = join_ == FLG_BRUSH_JOIN_MITER ? 2 / (max_miter * max_miter) - 1 : std::cos(style.corner_angle);
}

uint32_t Corners::rows(const Vec3& in, const Vec3& out) const {
    if (join_ == FLG_BRUSH_JOIN_NARROW) return 1;
    const double size = std::sqrt(in.squaredNorm() * out.squaredNorm());
    const double turn = in.dot(out);
    if (!(turn < cosine_ * size)) return 1;
    if (join_ != FLG_BRUSH_JOIN_ROUND) return 2;
    const double angle = std::acos(std::clamp(turn / size, -1.0, 1.0));
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

void Framer::arrive(const Bend& bend) {
    const auto unit = [](const Vec3& chord, double& length) {
        length = chord.norm();
        return length > 0 ? Vec3(chord / length) : Vec3(Vec3::Zero());
    };
    in_ = unit(bend.in, in_length_);
    out_ = unit(bend.out, out_length_);
    if (sections_ > 0) along_ += in_length_;
    const double span = in_length_ + out_length_;
    section_.slope = span > 0 ? (double{bend.radius_after} - double{bend.radius_before}) / span : 0;
    section_.position = load_vec3(bend.point.position);
    section_.along = along_;
    section_.point = &bend.point;
}

void Framer::turn(const Bend& bend, uint32_t row, uint32_t rows) {
    section_.widening_size = 0;
    const Vec3 tangent = rows == 1 ? bisector() : corner_tangent(row, rows);
    if (sections_ == 0 && row == 0) {
        const Vec3 normal = first_normal_.isZero(0) ? any_across(tangent) : first_normal_;
        frame_ = RotationMinimizingFrame(section_.position, tangent, normal);
    } else {
        frame_.step(section_.position, tangent);
    }
    if (follow_ && row == 0) follow(bend);
    section_.tangent = tangent;
    section_.normal = twist_ == 0 ? frame_.normal() : turned_about(tangent, frame_.normal(), twist_ * along_);
}

// Of a bend with one section.
Vec3 Framer::bisector() {
    const Vec3 sum = in_ + out_;
    const double size = sum.norm();
    if (size < turned_back) return in_;
    // A round section of the same radius, cut aslant, is longer the way the curve turns.
    if (!narrow_ && in_length_ > 0 && out_length_ > 0) {
        section_.widening = out_ - in_;
        const double turn_sq = section_.widening.squaredNorm();
        if (turn_sq > 0) section_.widening_size = (2 / size - 1) / turn_sq;
    }
    return sum / size;
}

Vec3 Framer::corner_tangent(uint32_t row, uint32_t rows) const {
    if (row == 0) return in_;
    if (row + 1 == rows) return out_;
    const Vec3 across = in_.cross(out_);
    const double sine = across.norm();
    // Turning back, it goes about the normal, which then stays.
    const Vec3 axis = sine > turned_back ? Vec3(across / sine) : frame_.normal();
    return turned_about(axis, in_, std::atan2(sine, in_.dot(out_)) * row / (rows - 1));
}

void Framer::follow(const Bend& bend) {
    const Vec3 level = leveled(bend.point.normal, frame_.tangent());
    if (level.isZero(0)) return;
    const bool other_side = sections_ > 0 && level.dot(frame_.normal()) < 0;
    frame_.set_normal(other_side ? Vec3(-level) : level);
}

FrameStart frame_start(const Curve& curve, const Style& style, WalkPlace place) {
    FrameStart start;
    Framer framer(style, false, {});
    Bend first_bend;
    Section first;
    bool begun = false, given = false;
    const bool follow = !style.tube() && curve.normal;
    const auto look = [&](const Bend& bend) {
        bool first_row = true;
        framer.visit(bend, [&](const Section& section) {
            if (!begun) {
                first_bend = bend;
                first = section;
                begun = true;
            }
            const Vec3 level = follow && first_row ? leveled(bend.point.normal, section.tangent) : Vec3(Vec3::Zero());
            first_row = false;
            if (level.isZero(0)) return;
            // What is carried on keeps its angle to any other that is.
            given = true;
            const double angle = angle_about(section.tangent, section.normal, level);
            start.normal = turned_about(first.tangent, first.normal, angle);
        });
        return !given && (follow || curve.closed);
    };
    walk(curve, place, look);
    if (!given && !curve.closed && place.begun) look(last_bend(place));
    if (given || !curve.closed || !begun) return start;
    bool arrived = false;
    framer.visit(first_bend, [&](const Section& section) {
        if (!arrived) start.twist = angle_about(first.tangent, section.normal, first.normal) / framer.along();
        arrived = true;
    });
    return start;
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
