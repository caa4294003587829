// SPDX-License-Identifier: MIT
// The sections of a curve: its distinct points with the frame that a cross-section is placed by, one after another,
// each as soon as the next point says where the curve goes on. What it takes to go on later is plain data.
//
// Tangents halve the turn between the segments that meet: a TANGENT column may be that of another curve (stylized
// curves carry their target's frame), and a cross-section placed by it would be squashed. Given normals are made
// perpendicular, on the side that keeps the surface from crossing over itself.
//
// Points come in blocks, as arrays, so that roots and quotients are taken of several at once; only the frames go from
// point to point. Nothing depends on where a block begins.
#pragma once

#include <cstdint>

#include "brush/brush_curve.h"
#include "brush/cross_section.h"
#include "brush/library.h"
#include "core/moving_frame.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

// Where a walk along a curve is; what is kept between the calls of a growing stroke.
struct WalkPlace {
    uint32_t begun = 0;
    Point last = {};  // whose next is not known yet
    float radius_before = 0;
    double in[3] = {};  // the chord that leads to it
};

// Points in a row with the segments that meet in them: point k lies between the chords k and k + 1, which are zero at
// the ends of open curves.
struct Bends {
    static constexpr uint32_t most = 32;

    uint32_t count = 0;
    double position[3][most + 1];
    double chord[3][most + 1];
    double radius[most + 2];  // of point k at k + 1, between its neighbours'
    const float* color[most + 1];
    const float* normal[most + 1];  // null: none is given

    Bends() {}  // NOLINT(modernize-use-equals-default): arrays stay as they are
    // Begins with the point that a walk has come to; that and the curve live as long.
    void start(const WalkPlace& place, const Curve& curve) {
        count = 0;
        for (size_t k = 0; k < 3; ++k) {
            position[k][0] = double{place.last.position[k]};
            chord[k][0] = place.in[k];
        }
        radius[0] = double{place.radius_before};
        radius[1] = double{place.last.radius};
        color[0] = place.last.color;
        normal[0] = curve.normal ? place.last.normal : nullptr;
    }
    // The last point's next one is the curve's point i. Room for it is there.
    void add(const Curve& curve, size_t i) {
        const uint32_t to = ++count;
        const float* const place = curve.position.at(i);
        for (size_t k = 0; k < 3; ++k) {
            position[k][to] = double{place[k]};
            chord[k][to] = position[k][to] - position[k][to - 1];
        }
        radius[to + 1] = double{curve.radius_at(i)};
        color[to] = curve.color ? curve.color.at(i) : curve.default_color;
        normal[to] = curve.normal ? curve.normal.at(i) : nullptr;
    }
    // Point `count` is the curve's end.
    void end() {
        const uint32_t to = ++count;
        for (auto& component : chord) component[to] = 0;
        radius[to + 1] = radius[to];
    }
    // Goes on with the point whose next is not known.
    void carry() {
        for (size_t k = 0; k < 3; ++k) {
            position[k][0] = position[k][count];
            chord[k][0] = chord[k][count];
        }
        radius[0] = radius[count];
        radius[1] = radius[count + 1];
        color[0] = color[count];
        normal[0] = normal[count];
        count = 0;
    }
};

// Hands the bends of a curve to sink(bends), as long as that returns true: all of a closed curve's; of an open one's
// not the last, which last_bend(place) tells. Goes on from `place`.
template <class Sink>
void walk(const Curve& curve, WalkPlace& place, Sink&& sink) {
    const uint32_t count = curve.distinct_count();
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
    const WalkPlace from = place;
    Bends bends;
    bends.start(from, curve);
    const float* last = from.last.position;
    uint32_t last_point = count;  // none
    const auto add = [&](uint32_t point) {
        bends.add(curve, point);
        last = curve.position.at(point);
        last_point = point;
        if (bends.count < Bends::most) return true;
        const bool more = sink(static_cast<const Bends&>(bends));
        bends.carry();
        return more;
    };
    for (; i < count; ++i) {
        if (same_place(curve.position.at(i), last)) continue;
        if (!add(i)) return;
    }
    if (curve.closed && count > 1 && !add(0)) return;
    if (bends.count > 0) {
        sink(static_cast<const Bends&>(bends));
        bends.carry();
    }
    if (last_point == count) return;
    place.last = curve.point(last_point);
    place.radius_before = static_cast<float>(bends.radius[0]);
    for (size_t k = 0; k < 3; ++k) place.in[k] = bends.chord[k][0];
}

// The end of an open curve, at which a walk has come.
inline void last_bend(const WalkPlace& place, const Curve& curve, Bends& bends) {
    bends.start(place, curve);
    bends.end();
}

// Where a curve turns so sharply from one chord to the next that its section needs two rows, or more.
class Corners {
public:
    explicit Corners(const Style& style);
    // Writes 1 for each corner, else 0; returns how many there are.
    uint32_t find(const Bends& bends, int64_t (&is_corner)[Bends::most]) const;
    // Of a corner.
    uint32_t rows(const Bends& bends, uint32_t k) const;

private:
    FlgBrushJoin join_;
    uint32_t sides_;
    double cosine_;  // of the turn from which a point is a corner
};

// A place for a cross-section: each bend has one or, at corners, several.
struct Section {
    Vec3 position, tangent, normal;
    Vec3 widening;         // direction times what it takes to keep the radius in a turn; of mitered sections
    double widening_size;  // 0: none
    double radius;
    double along;  // metres from the first point
    double slope;  // the radius's change along the curve
    float color[4];
};

// Sections in a row.
struct Sections {
    static constexpr uint32_t most = Bends::most;

    uint32_t count = 0;
    Section list[most];
    const float* given[most];  // the normal given for a point, at its first section; else null
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

    // Hands all sections of the bends to sink(sections).
    template <class Sink>
    void visit(const Bends& bends, Sink&& sink) {
        Turns turns;
        measure(bends, turns);
        Sections sections;
        for (Progress at; at.bend < bends.count;) {
            fill(bends, turns, at, sections);
            sink(static_cast<const Sections&>(sections));
        }
    }

private:
    // What is known of bends by themselves, and the steps between those that are no corners.
    struct Turns {
        double length[Bends::most + 1], direction[3][Bends::most + 1];  // of chords; 0 where there is none
        double tangent[3][Bends::most];                                 // halfway between the two
        double widening_size[Bends::most], slope[Bends::most];
        double left_by[3][Bends::most + 1];  // the tangent with which the point before is left
        // The steps, as Reflections, of which the chords are the first vectors; and the second one's squared norm.
        double second[3][Bends::most], first_factor[Bends::most], second_factor[Bends::most], both[Bends::most];
        double second_sq[Bends::most];
        int64_t is_corner[Bends::most];

        Turns() {}  // NOLINT(modernize-use-equals-default): arrays stay as they are
    };
    // The next section's bend, and which of its rows it is.
    struct Progress {
        uint32_t bend = 0, row = 0, rows = 0;
    };
    void measure(const Bends& bends, Turns& turns) const;
    void fill(const Bends& bends, const Turns& turns, Progress& at, Sections& sections);
    static Vec3 corner_tangent(const Vec3& in, const Vec3& out, const Vec3& normal, const Progress& at);
    void follow(const float* given, RotationMinimizingFrame& frame) const;

    Corners corners_;
    bool narrow_, follow_;
    RotationMinimizingFrame frame_;
    Vec3 first_normal_ = Vec3::Zero();
    double along_, twist_ = 0;
    uint32_t sections_;
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
FrameStart frame_start(const Curve& curve, const Style& style, const WalkPlace& place);

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
