// SPDX-License-Identifier: MIT
#include "splines/spline_offset.h"

#include <algorithm>
#include <cmath>

#include "core/moving_frame.h"
#include "splines/manifolds/manifold_walk.h"
#include "splines/spline_rows.h"

namespace flg {

namespace {

constexpr double least_sideways = 1e-6;  // of a direction across the way: less is none
constexpr double steps_of_size = 256;    // of a walk over a surface: so many as long as it is large
constexpr double most_steps = 1024;      // of a walk: then they are longer
constexpr uint32_t look_units = 4;       // of Cost::microseconds: a step of a walk
constexpr uint32_t search_units = 16;    // of Cost::hundreds_of_ns: whether a chord is near
constexpr double own_tolerance = 1e-9;   // of a distance
constexpr uint32_t leaf_chords = 8;      // of a box of ChordBoxes

// A place beside the curve.
struct BesideRow {
    Vec3 place, up;
    double away;  // metres from the curve
    double time;  // parameter
};

using BesideRows = std::pmr::vector<BesideRow>;

Vec3 upright(const Vec3& up, const Vec3& way, const Vec3* before) {
    Vec3 out = up - up.dot(way) * way;
    if (out.norm() < least_sideways) out = before != nullptr ? Vec3(*before - before->dot(way) * way) : Vec3::Zero();
    return out.norm() < least_sideways ? way.unitOrthogonal() : Vec3(out.normalized());
}

// Upwards at each row, a unit vector across the way.
Task<std::pmr::vector<Vec3>> frames_along(Pace& pace, const SplineRows& rows, const OffsetShape& shape, bool closed,
                                          bool on_surface) {
    const auto count = static_cast<uint32_t>(rows.rows.size());
    std::pmr::vector<Vec3> ups(pace.memory());
    ups.reserve(count);
    const bool by_normals = on_surface && shape.up.isZero(0);
    if (!shape.turns_least && (by_normals || !shape.up.isZero(0))) {
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            const SplineRow& row = rows.rows[i];
            ups.push_back(upright(by_normals ? row.normal : shape.up, row.way, i > 0 ? &ups.back() : nullptr));
        });
        co_return ups;
    }
    const SplineRow& first = rows.rows[0];
    const Vec3 up = by_normals ? first.normal : shape.up.isZero(0) ? Vec3::UnitZ() : shape.up;
    const bool is_along = upright(up, first.way, nullptr).dot(up) < least_sideways;
    RotationMinimizingFrame frame(first.place, first.way, upright(is_along ? Vec3::UnitY() : up, first.way, nullptr));
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (i > 0) frame.step(rows.rows[i].place, rows.rows[i].way);
        ups.push_back(frame.normal());
    });
    if (!closed || !(rows.length > 0)) co_return ups;
    // Around a closed curve it comes back turned: each row is turned back by its share.
    const double turn = angle_about(first.way, ups[count - 1], ups[0]);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        ups[i] = turned_about(rows.rows[i].way, ups[i], turn * rows.rows[i].length / rows.length);
    });
    co_return ups;
}

Task<BesideRows> lay_beside(Pace& pace, const Spline& spline, const SplineRows& rows, const std::pmr::vector<Vec3>& ups,
                            const OffsetShape& shape, bool over_surface) {
    const auto count = static_cast<uint32_t>(rows.rows.size());
    BesideRows out(pace.memory());
    out.reserve(count);
    if (!over_surface) {
        const double away = std::hypot(shape.left, shape.above);
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            const SplineRow& row = rows.rows[i];
            const Vec3 place = row.place + shape.left * ups[i].cross(row.way) + shape.above * ups[i];
            out.push_back({place, ups[i], away, row.time});
        });
        co_return out;
    }
    const Manifold& manifold = *spline.manifold->manifold;
    const double far = std::abs(shape.left);
    const double steps = std::clamp(std::ceil(steps_of_size * far / manifold.size()), 1.0, most_steps);
    ManifoldWalk walk(manifold, pace.memory());
    Slice slice(Cost::microseconds);
    for (uint32_t i = 0; i < count; ++i) {
        const SplineRow& row = rows.rows[i];
        const Vec3 left = ups[i].cross(row.way);
        if (!walk.begin(row.place, shape.left < 0 ? Vec3(-left) : left))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.spline can't be put onto its surface at its parameter %g",
                          row.time);
        for (uint32_t step = 0; step < static_cast<uint32_t>(steps) && far > 0; ++step) {
            if (!walk.step(far / steps)) break;
            if (slice.is_over(look_units)) co_await pace;
        }
        const Vec3 place = walk.place() + shape.above * walk.up();
        out.push_back({place, walk.up(), (place - row.place).norm(), row.time});
        if (slice.is_over(look_units)) co_await pace;
    }
    co_return out;
}

// The chords of a curve, in boxes of eight, these in boxes of two and so on.
class ChordBoxes {
public:
    static Task<ChordBoxes> make(Pace& pace, const SplineRows& rows) {
        ChordBoxes out(rows, pace.memory());
        const auto chords = static_cast<uint32_t>(rows.rows.size()) - 1;
        uint32_t leaves = 1;
        while (leaves * leaf_chords < chords) leaves *= 2;
        out.leaves_ = leaves;
        out.boxes_.resize(size_t{2} * leaves);
        co_await each(pace, leaves, Cost::hundreds_of_ns, [&](uint32_t leaf) {
            Box& box = out.boxes_[leaves + leaf];
            for (uint32_t i = leaf * leaf_chords; i <= std::min((leaf + 1) * leaf_chords, chords); ++i) {
                box.lower = box.lower.cwiseMin(rows.rows[i].place);
                box.upper = box.upper.cwiseMax(rows.rows[i].place);
            }
        });
        co_await each(pace, leaves - 1, Cost::tens_of_ns, [&, leaves](uint32_t i) {
            const uint32_t at = leaves - 1 - i;
            Box& box = out.boxes_[at];
            box.lower = out.boxes_[2 * at].lower.cwiseMin(out.boxes_[2 * at + 1].lower);
            box.upper = out.boxes_[2 * at].upper.cwiseMax(out.boxes_[2 * at + 1].upper);
        });
        co_return out;
    }
    // Whether one of the chords from begin to end, that not among them, is nearer than `away` metres.
    bool is_near(const Vec3& place, uint32_t begin, uint32_t end, double away) const {
        return begin < end && is_near_in(1, 0, leaves_ * leaf_chords, place, begin, end, away * away);
    }

private:
    struct Box {
        Vec3 lower = Vec3::Constant(HUGE_VAL), upper = Vec3::Constant(-HUGE_VAL);
    };

    ChordBoxes(const SplineRows& rows, Memory* memory) : rows_(&rows), boxes_(memory) {}

    bool is_near_in(uint32_t box, uint32_t first, uint32_t size, const Vec3& place, uint32_t begin, uint32_t end,
                    double square) const {
        if (first >= end || first + size <= begin) return false;
        const Box& own = boxes_[box];
        const Vec3 to = (own.lower - place).cwiseMax(place - own.upper).cwiseMax(0);
        if (!(to.squaredNorm() < square)) return false;
        if (size > leaf_chords)
            return is_near_in(2 * box, first, size / 2, place, begin, end, square) ||
                   is_near_in(2 * box + 1, first + size / 2, size / 2, place, begin, end, square);
        for (uint32_t i = std::max(first, begin); i < std::min(first + size, end); ++i) {
            const Vec3 a = rows_->rows[i].place, chord = rows_->rows[i + 1].place - a;
            const double own_square = chord.squaredNorm();
            const double t = own_square > 0 ? std::clamp((place - a).dot(chord) / own_square, 0.0, 1.0) : 0;
            if ((place - a - t * chord).squaredNorm() < square) return true;
        }
        return false;
    }

    const SplineRows* rows_;
    std::pmr::vector<Box> boxes_;  // the children of i are 2 i and 2 i + 1
    uint32_t leaves_ = 0;
};

// Rows from `begin` to `end`, both left out, run back or beside what does.
struct Loop {
    int64_t begin, end;
};

using Loops = std::pmr::vector<Loop>;

struct FoundLoops {
    Loops loops;
    uint32_t first = 0;  // the row that they are counted from
};

// Of rows that go round and round.
struct RingRows {
    uint32_t turned(int64_t i) const { return static_cast<uint32_t>((i + first) % steps); }
    const BesideRow& beside_at(int64_t i) const { return closed ? beside[turned(i)] : beside[static_cast<size_t>(i)]; }
    bool runs_back(int64_t i) const {
        const uint32_t at = closed ? turned(i) : static_cast<uint32_t>(i);
        const Vec3 way = rows.rows[at].way + rows.rows[at + 1].way;
        return !((beside[at + 1].place - beside[at].place).dot(way) > 0);
    }
    // Whether a place beside is nearer to the curve between two rows than to where it comes from.
    bool is_beyond(const ChordBoxes& boxes, int64_t i, int64_t begin, int64_t end) const {
        const BesideRow& row = beside_at(i);
        const double away = row.away * (1 - own_tolerance);
        if (!closed) return boxes.is_near(row.place, static_cast<uint32_t>(begin), static_cast<uint32_t>(end), away);
        if (begin >= end) return false;
        const uint32_t low = turned(begin), high = turned(end);
        if (low < high) return boxes.is_near(row.place, low, high, away);
        return boxes.is_near(row.place, low, steps, away) || boxes.is_near(row.place, 0, high, away);
    }

    const SplineRows& rows;
    const BesideRows& beside;
    uint32_t steps;  // of the curve
    bool closed;
    uint32_t first = 0;  // where counting begins: the middle of the longest stretch that runs ahead
};

Task<FoundLoops> find_loops(Pace& pace, RingRows ring) {
    const auto steps = static_cast<int64_t>(ring.steps);
    FoundLoops found{Loops(pace.memory())};
    Loops& loops = found.loops;
    int64_t back = 0, ahead = 0, longest = 0, middle = 0;
    co_await each(pace, ring.steps * (ring.closed ? 2u : 1u), Cost::tens_of_ns, [&](uint32_t i) {
        const bool runs_back = ring.runs_back(i % ring.steps);
        if (runs_back) ++back;
        ahead = runs_back ? 0 : ahead + 1;
        if (ahead > longest) longest = ahead, middle = (int64_t{i} - ahead / 2) % steps;
    });
    if (back == 0) co_return found;
    if (longest == 0) {
        loops.push_back({-1, steps + 1});
        co_return found;
    }
    if (ring.closed) found.first = ring.first = static_cast<uint32_t>((middle + steps) % steps);
    const ChordBoxes boxes = co_await ChordBoxes::make(pace, ring.rows);
    Slice slice(Cost::hundreds_of_ns);
    for (int64_t i = 0; i < steps;) {
        if (slice.is_over()) co_await pace;
        if (!ring.runs_back(i)) {
            ++i;
            continue;
        }
        Loop loop{i, i + 1};
        while (loop.end < steps && ring.runs_back(loop.end)) {
            ++loop.end;
            if (slice.is_over()) co_await pace;
        }
        const int64_t turn = (loop.begin + loop.end) / 2;
        while (loop.begin >= 0 && ring.is_beyond(boxes, loop.begin, turn, steps)) {
            --loop.begin;
            if (slice.is_over(search_units)) co_await pace;
            // Loops that meet are one.
            if (!loops.empty() && loop.begin < loops.back().end) {
                loop.begin = loops.back().begin;
                loops.pop_back();
            }
        }
        while (loop.end <= steps && ring.is_beyond(boxes, loop.end, 0, turn)) {
            ++loop.end;
            if (slice.is_over(search_units)) co_await pace;
        }
        loops.push_back(loop);
        i = loop.end;
    }
    co_return found;
}

// Half way between where two pieces are nearest to each other.
BesideRow meeting(const BesideRow& a, const BesideRow& b, const BesideRow& c, const BesideRow& d) {
    const Vec3 u = b.place - a.place, v = d.place - c.place, w = a.place - c.place;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), det = uu * vv - uv * uv;
    double s = det > least_sideways * uu * vv ? std::clamp((uv * v.dot(w) - vv * u.dot(w)) / det, 0.0, 1.0) : 0.5;
    const double t = vv > 0 ? std::clamp((uv * s + v.dot(w)) / vv, 0.0, 1.0) : 0;
    if (uu > 0) s = std::clamp((uv * t - u.dot(w)) / uu, 0.0, 1.0);
    BesideRow out = a;
    out.place = 0.5 * (a.place + s * u + c.place + t * v);
    const Vec3 up = a.up + d.up;
    if (up.norm() > least_sideways) out.up = up.normalized();
    out.time = a.time + s * (b.time - a.time);
    return out;
}

// All rows but those of loops, where these were with a corner.
Task<BesideRows> without_loops(Pace& pace, const RingRows& ring, const Loops& loops, uint32_t first) {
    BesideRows out(pace.memory());
    out.reserve(ring.beside.size() + loops.size());
    RingRows turned = ring;
    turned.first = first;
    const auto last = static_cast<int64_t>(ring.steps) - (ring.closed ? 1 : 0);
    int64_t at = 0;
    for (size_t k = 0; k <= loops.size(); ++k) {
        const int64_t end = k < loops.size() ? std::min(loops[k].begin, last) : last;
        if (at <= end) {
            const int64_t from = at;
            co_await each(pace, static_cast<size_t>(end - from + 1), Cost::tens_of_ns,
                          [&, from](uint32_t i) { out.push_back(turned.beside_at(from + i)); });
        }
        if (k == loops.size()) break;
        const Loop& loop = loops[k];
        const int64_t steps = ring.steps;
        if (loop.begin >= 0 && loop.end <= steps)
            out.push_back(meeting(turned.beside_at(loop.begin), turned.beside_at(loop.begin + 1),
                                  turned.beside_at(loop.end - 1), turned.beside_at(loop.end)));
        at = loop.end;
    }
    co_return out;
}

}  // namespace

Task<void> offset_spline(Pace& pace, std::shared_ptr<const Spline> spline, OffsetShape shape,
                         std::shared_ptr<CurveSet> out) {
    pace.stage("rows");
    co_await check_precision(pace, spline->chain.nodes);
    const SplineRows rows = co_await rows_along(pace, *spline, shape.spacing);
    const bool on_surface = spline->manifold->has_normals(),
               over_surface = on_surface && shape.up.isZero(0) && !shape.turns_least;
    const std::pmr::vector<Vec3> ups = co_await frames_along(pace, rows, shape, spline->closed, on_surface);
    pace.stage("offset");
    BesideRows beside = co_await lay_beside(pace, *spline, rows, ups, shape, over_surface);
    if (!shape.keeps_loops) {
        const RingRows ring{rows, beside, static_cast<uint32_t>(rows.rows.size()) - 1, spline->closed};
        FoundLoops found = co_await find_loops(pace, ring);
        BesideRows kept(pace.memory());
        if (!found.loops.empty()) {
            kept = co_await without_loops(pace, ring, found.loops, found.first);
            if (kept.size() < (spline->closed ? 3 : 2))
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "nothing is left of the curve %g m to the left and %g m above without its loops: it is "
                              "farther away than its bends are wide; desc.keeps_loops keeps it",
                              shape.left, shape.above);
            beside = std::move(kept);
        } else if (spline->closed) {
            beside.pop_back();
        }
    } else if (spline->closed) {
        beside.pop_back();
    }
    pace.stage("copy");
    const auto points = static_cast<uint32_t>(beside.size());
    out->allocate_curves(1);
    out->offsets()[0] = 0;
    out->offsets()[1] = points;
    out->begin_curve(0, spline->closed ? FLG_CURVE_CLOSED : 0);
    out->allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TIME, 1}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()));
    float* const positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* const times = out->find(FLG_ATTRIBUTE_TIME)->values.data();
    float* const normals = out->find(FLG_ATTRIBUTE_NORMAL)->values.data();
    co_await each(pace, points, Cost::some_ns, [&](uint32_t i) {
        store_vec3(beside[i].place, positions + size_t{3} * i);
        store_vec3(beside[i].up, normals + size_t{3} * i);
        times[i] = static_cast<float>(beside[i].time);
    });
    out->complete_curve(0);
}

}  // namespace flg
