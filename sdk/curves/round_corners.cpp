// SPDX-License-Identifier: MIT
#include "curves/round_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "core/memory.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double stands_out = 16;
constexpr double widest_turn = 2.8;  // radians, 160 degrees
constexpr double side = 3;           // length of one, in bends
constexpr double least_side = 1.5;   // at an open curve's ends
constexpr double least_chord = 0.9;  // of a sharp corner's, from end to end of the bend
constexpr int sizes_max = 8;
constexpr uint32_t units_at_once = 1000;

// Distinct points, by arc length of the polyline.
struct Places {
    CurveView curve;
    Buffer<uint32_t> index;
    Buffer<double> arc;
    uint32_t count = 0;
    double length = 0;

    // Of a closed curve they go on around.
    double arc_of(uint32_t k) const {
        const uint32_t laps = k / count;
        return arc[k % count] + length * laps;
    }
    Vec3 point(uint32_t k) const { return curve.point(index[k % count]); }
};

Task<Places> find_places(Pace& pace, CurveView curve) {
    Places places{curve, Buffer<uint32_t>(curve.count, pace.memory()), Buffer<double>(curve.count, pace.memory())};
    const auto add = [&](uint32_t index) {
        places.index[places.count] = index;
        places.arc[places.count++] = places.length;
    };
    Slice slice(Cost::tens_of_ns);
    uint32_t last = 0;
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        for (uint32_t j = range.first; j < range.last; ++j) {
            last = stream.index_of(j);
            add(last);
            places.length += stream.block().chords[j];
        }
        if (slice.is_over(range.last - range.first + 1)) co_await pace;
    }
    if (places.count > 0 && !curve.closed) add(curve.following(last));
    co_return places;
}

// A point that moves on along the polyline, between two places.
class ArcCursor {
public:
    // Not before the last one; beyond a closed curve's end around it. A unit is a place that it passes: false if there
    // are too few of them, then again.
    bool go_to(const Places& places, double arc, uint32_t& units) {
        if (to_ == 0 && lap_ == 0) step(places);
        while (to_arc_ < arc && (places.curve.closed || to_ + 1 < places.count)) {
            if (units == 0) return false;
            --units;
            step(places);
        }
        const double t = std::clamp((arc - from_arc_) / (to_arc_ - from_arc_), 0.0, 1.0);
        point_ = (1 - t) * places.point(from_) + t * places.point(to_);
        return true;
    }
    const Vec3& point() const { return point_; }
    // Of the first place that isn't before it.
    double next_arc() const { return to_arc_; }

private:
    void step(const Places& places) {
        from_ = to_;
        from_arc_ = to_arc_;
        if (++to_ == places.count) {
            to_ = 0;
            lap_ += places.length;
        }
        to_arc_ = places.arc[to_] + lap_;
    }

    uint32_t from_ = 0, to_ = 0;
    double from_arc_ = 0, to_arc_ = 0, lap_ = 0;
    Vec3 point_ = Vec3::Zero();
};

double turn(const Vec3& from, const Vec3& to) {
    return std::atan2(from.cross(to).norm(), from.dot(to));
}

// The bend around one place after the other, in one size.
class Bend {
public:
    Bend(const Places& places, double angle, double length)
        : places_(places), angle_(angle), cosine_(std::cos(angle)), length_(length) {}

    double length() const { return length_; }
    // As ArcCursor has it. Of a closed curve there is something before its first place: it has been around once.
    bool go_to(uint32_t place, uint32_t& units) {
        place_ = place;
        const bool closed = places_.curve.closed;
        const double here = places_.arc_of(place) + (closed ? places_.length : 0.0);
        const double end = closed ? HUGE_VAL : places_.length;
        const double before = here - 0.5 * length_, behind = here + 0.5 * length_;
        const double first = std::max(before - side * length_, 0.0), last = std::min(behind + side * length_, end);
        for (size_t q = 0; q <= quarters; ++q) {
            const double share = static_cast<double>(q) / quarters;
            arcs_[q] = first + (before - first) * share;
            arcs_[bend_end + q] = behind + (last - behind) * share;
        }
        turned_ = 0;
        if (!has_sides()) return true;
        const auto move = [&](std::initializer_list<size_t> cursors) {
            return std::all_of(cursors.begin(), cursors.end(),
                               [&](size_t c) { return cursors_[c].go_to(places_, arcs_[c], units); });
        };
        if (!move({0, bend_begin, bend_end, sides_end})) return false;
        // Most places turn less, and need no more.
        const Vec3 a = point(bend_begin) - point(0), b = point(sides_end) - point(bend_end);
        if (a.dot(b) > cosine_ * std::sqrt(a.squaredNorm() * b.squaredNorm())) return true;
        turned_ = turn(a, b);
        return !turns() || move({1, 2, 3, bend_end + 1, bend_end + 2, bend_end + 3});
    }
    bool is_corner() const;
    // How much the halves of the bend turn against each other.
    double sharpness() const {
        const Vec3 middle = places_.point(place_);
        return turn(middle - point(bend_begin), point(bend_end) - middle);
    }

private:
    // By quarters of the sides.
    static constexpr size_t quarters = 4, bend_begin = quarters, bend_end = quarters + 1, sides_end = 2 * quarters + 1;

    const Vec3& point(size_t cursor) const { return cursors_[cursor].point(); }
    bool turns() const { return turned_ > angle_ && turned_ < widest_turn; }
    bool has_sides() const {
        return arcs_[bend_begin] - arcs_[0] >= least_side * length_ &&
               arcs_[sides_end] - arcs_[bend_end] >= least_side * length_;
    }
    // What a side turns by: one half against the other, and its first and last quarter against all of it.
    double side_turn(size_t first) const {
        const auto at = [&](size_t quarter) -> const Vec3& { return point(first + quarter); };
        const Vec3 chord = at(4) - at(0);
        return std::max({turn(at(2) - at(0), at(4) - at(2)), turn(at(1) - at(0), chord), turn(chord, at(4) - at(3))});
    }

    const Places& places_;
    double angle_, cosine_, length_;
    uint32_t place_ = 0;
    double turned_ = 0;  // from one side's chord to the other's
    std::array<double, sides_end + 1> arcs_{};
    std::array<ArcCursor, sides_end + 1> cursors_;
};

bool Bend::is_corner() const {
    if (!turns()) return false;
    if (!(turned_ > stands_out * std::max(side_turn(0), side_turn(bend_end)))) return false;
    for (size_t half : {size_t{0}, size_t{2}, bend_end, bend_end + 2}) {
        if (cursors_[half].next_arc() >= arcs_[half + 2]) return false;
    }
    return (point(bend_end) - point(bend_begin)).norm() > least_chord * length_ * std::cos(0.5 * turned_);
}

// Places that are corners, in order.
Task<void> list_marks(Pace& pace, const Places& places, std::span<const uint8_t> marks,
                      std::pmr::vector<uint32_t>& list) {
    uint32_t count = 0;
    co_await each(pace, places.count, Cost::some_ns, [&](uint32_t k) { count += marks[places.index[k]]; });
    list.clear();
    list.reserve(count);
    co_await each(pace, places.count, Cost::some_ns, [&](uint32_t k) {
        if (marks[places.index[k]] != 0) list.push_back(k);
    });
}

// The corners before and behind a place that moves on; around a closed curve twice.
class Neighbours {
public:
    Neighbours(const Places& places, std::span<const uint32_t> corners) : places_(places), corners_(corners) {
        if (places.curve.closed && !corners.empty()) before_ = places.arc[corners.back()] - places.length;
    }
    void go_to(double arc) {
        while (next_ < corners_.size() && arc_of_next() <= arc) {
            before_ = arc_of_next();
            if (++next_ == corners_.size() && places_.curve.closed && lap_ < 2 * places_.length) {
                next_ = 0;
                lap_ += places_.length;
            }
        }
    }
    void add(double arc) {
        before_ = arc;
        first_new_ = std::min(first_new_, arc);
    }
    bool any_within(double arc, double reach) const {
        const double next = next_ < corners_.size() ? arc_of_next() : HUGE_VAL;
        return arc - before_ <= reach || std::min(next, first_new_ + places_.length) - arc <= reach;
    }

private:
    double arc_of_next() const { return places_.arc[corners_[next_]] + lap_; }

    const Places& places_;
    std::span<const uint32_t> corners_;
    size_t next_ = 0;
    double before_ = -HUGE_VAL, lap_ = 0;
    double first_new_ = HUGE_VAL;  // a closed curve comes back to it
};

// Corners of one size. `known`: those that there are before.
Task<void> mark_bends(Pace& pace, const Places& places, Bend bend, std::span<const uint32_t> known,
                      std::span<uint8_t> marks) {
    const bool closed = places.curve.closed;
    Neighbours neighbours(places, known);
    bool in_run = false, whole_run = false;
    uint32_t best = 0;
    double sharpest = 0;
    Slice slice(Cost::hundreds_of_ns);
    // A run over a closed curve's start is taken at its end.
    for (uint32_t k = 0; k < places.count || (closed && in_run && k < 2 * places.count); ++k) {
        for (uint32_t units = units_at_once; !bend.go_to(k, units); units = units_at_once) co_await pace;
        neighbours.go_to(places.arc_of(k));
        if (bend.is_corner()) {
            if (!in_run) {
                whole_run = k > 0 || !closed;
                sharpest = 0;
            }
            in_run = true;
            if (const double sharpness = bend.sharpness(); sharpness > sharpest) {
                sharpest = sharpness;
                best = k;
            }
        } else if (std::exchange(in_run, false) && whole_run &&
                   !neighbours.any_within(places.arc_of(best), bend.length())) {
            marks[places.index[best % places.count]] = 1;
            neighbours.add(places.arc_of(best));
        }
        if (slice.is_over()) co_await pace;
    }
}

}  // namespace

Task<void> mark_round_corners(Pace& pace, CurveView curve, double angle, double longest, std::span<uint8_t> marks) {
    const Places places = co_await find_places(pace, curve);
    std::pmr::vector<uint32_t> known(pace.memory());
    // The smallest first: they know best where a corner is.
    for (int size = sizes_max - 1; size >= 0; --size) {
        const double length = longest * std::exp2(-0.5 * size);
        const bool too_small = length * places.count<places.length, too_large = (2 * side + 1) * length> places.length;
        if (too_small || (too_large && curve.closed)) continue;
        co_await list_marks(pace, places, marks, known);
        co_await mark_bends(pace, places, Bend(places, angle, length), {known.data(), known.size()}, marks);
    }
}

}  // namespace flg
