// SPDX-License-Identifier: MIT
// The sections of a curve: its distinct points with the frame that a cross-section is placed by, one after another,
// each as soon as the next point says where the curve goes on. What it takes to go on later is plain data.
//
// Tangents halve the turn between the segments that meet: a TANGENT column may be that of another curve (stylized
// curves carry their target's frame), and a cross-section placed by it would be squashed. Given normals are made
// perpendicular, on the side that keeps the surface from crossing over itself.
#pragma once

#include <cstdint>

#include "brush/brush_curve.h"
#include "brush/cross_section.h"
#include "brush/library.h"
#include "core/moving_frame.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

// How many rows a point needs where the curve turns from one chord to the next: 1, or 2 and more at corners.
class Corners {
public:
    explicit Corners(const Style& style);
    uint32_t rows(const Vec3& in, const Vec3& out) const;

private:
    FlgBrushJoin join_;
    uint32_t sides_;
    double cosine_;  // of the turn from which a point is a corner
};

// A point and the segments that meet in it. Chords are zero at the ends of open curves.
struct Bend {
    Point point;
    Vec3 in = Vec3::Zero(), out = Vec3::Zero();
    float radius_before = 0, radius_after = 0;
};

// Where a walk along a curve is; what is kept between the calls of a growing stroke.
struct WalkPlace {
    uint32_t begun = 0;
    Point last = {};  // whose next is not known yet
    float radius_before = 0;
    double in[3] = {};  // the chord that leads to it
};

// Hands the bends of a curve to sink(bend), as long as that returns true: all of a closed curve's; of an open one's not
// the last, which last_bend(place) tells. Goes on from `place`.
template <class Sink>
void walk(const Curve& curve, WalkPlace& place, Sink&& sink) {
    const uint32_t count = curve.distinct_count();
    const auto leave = [&](const Point& next, const Vec3& out) {
        Bend bend;
        bend.point = place.last;
        bend.in = Vec3::Map(place.in);
        bend.out = out;
        bend.radius_before = place.radius_before;
        bend.radius_after = next.radius;
        const bool more = sink(static_cast<const Bend&>(bend));
        place.radius_before = place.last.radius;
        Vec3::Map(place.in) = out;
        place.last = next;
        return more;
    };
    uint32_t i = 0;
    if (!place.begun) {
        if (count == 0) return;
        place.begun = 1;
        place.last = curve.point(i++);
        place.radius_before = place.last.radius;
        if (curve.closed && count > 1) {
            place.radius_before = curve.radius_at(count - 1);
            Vec3::Map(place.in) = chord(curve.position.at(count - 1), curve.position.at(0));
        }
    }
    for (; i < count; ++i) {
        const float* const position = curve.position.at(i);
        if (same_place(position, place.last.position)) continue;
        if (!leave(curve.point(i), chord(place.last.position, position))) return;
    }
    if (curve.closed && count > 1) leave(curve.point(0), chord(place.last.position, curve.position.at(0)));
}

inline Bend last_bend(const WalkPlace& place) {
    Bend bend;
    bend.point = place.last;
    bend.in = Vec3::Map(place.in);
    bend.radius_before = place.radius_before;
    bend.radius_after = place.last.radius;
    return bend;
}

// A place for a cross-section: each bend has one or, at corners, several.
struct Section {
    Vec3 position, tangent, normal;
    double along = 0;              // metres from the first point
    double slope = 0;              // the radius's change along the curve
    Vec3 widening = Vec3::Zero();  // direction times what it takes to keep the radius in a turn; of mitered sections
    double widening_size = 0;
    const Point* point = nullptr;  // lives as long as its bend
};

struct FramePlace {
    double position[3] = {}, tangent[3] = {}, normal[3] = {};
    double along = 0;
    uint32_t steps = 0;
    uint32_t sections = 0;  // bends seen so far
};

// Carries the frame from bend to bend.
class Framer {
public:
    // Normals are followed where they are given; else they are rotation-minimizing.
    Framer(const Style& style, bool follow, const FramePlace& place);

    FramePlace place() const;
    // What the frame begins with; zero: any normal across the tangent.
    void begin_with(const Vec3& normal) { first_normal_ = normal; }
    // A closed curve's: radians a metre by which frames are turned, to meet at the seam.
    void twist_by(double radians_per_metre) { twist_ = radians_per_metre; }
    double along() const { return along_; }

    // Calls visit_section(section) for each section of a bend.
    template <class Visit>
    void visit(const Bend& bend, Visit&& visit_section) {
        arrive(bend);
        const uint32_t rows = in_length_ > 0 && out_length_ > 0 ? corners_.rows(bend.in, bend.out) : 1;
        for (uint32_t row = 0; row < rows; ++row) {
            turn(bend, row, rows);
            visit_section(static_cast<const Section&>(section_));
        }
        ++sections_;
    }

private:
    void arrive(const Bend& bend);
    void turn(const Bend& bend, uint32_t row, uint32_t rows);
    Vec3 bisector();
    Vec3 corner_tangent(uint32_t row, uint32_t rows) const;
    void follow(const Bend& bend);

    Corners corners_;
    bool narrow_, follow_;
    RotationMinimizingFrame frame_;
    Vec3 first_normal_ = Vec3::Zero();
    Vec3 in_ = Vec3::Zero(), out_ = Vec3::Zero();  // unit
    double in_length_ = 0, out_length_ = 0;
    double along_, twist_ = 0;
    uint32_t sections_;
    Section section_;
};

// The axis that is least along the unit tangent, made perpendicular to it.
Vec3 any_across(const Vec3& tangent);
// A given normal made perpendicular to the tangent; zero where it points along it, and says nothing.
Vec3 leveled(const float* given, const Vec3& tangent);

// What a whole curve's frames begin with, so that they meet what comes later.
struct FrameStart {
    Vec3 normal = Vec3::Zero();  // such that the first normal that is given is met; zero: none is given
    double twist = 0;            // radians a metre, of closed curves that no normal is given for
};
// `place`: of the walk, whose frames have not begun.
FrameStart frame_start(const Curve& curve, const Style& style, WalkPlace place);

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
