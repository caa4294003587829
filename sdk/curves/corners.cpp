// SPDX-License-Identifier: MIT
#include "curves/corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/round_corners.h"
#include "curves/step_scale.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double clearly = 1.7;   // a turn that is a corner whatever is next to it, in corner angles
constexpr double stands_out = 2;  // likewise, in turns next to it

// The turn from one edge to the next.
struct Turn {
    double angle = 0;  // radians
    Vec3 axis = Vec3::Zero();

    Turn() = default;
    Turn(const Vec3& from, const Vec3& to)
        : angle(std::acos(std::clamp(from.dot(to), -1.0, 1.0))), axis(from.cross(to)) {
        const double size = axis.norm();
        if (size > 0) axis /= size;
    }
    bool is_corner(const Turn& before, const Turn& behind, double corner_angle) const {
        if (!(angle > corner_angle)) return false;
        const auto alike = [&](const Turn& other) { return other.angle * std::max(axis.dot(other.axis), 0.0); };
        return angle > clearly * corner_angle || angle > stands_out * std::max(alike(before), alike(behind));
    }
};

// Takes one edge after the other; knows of a corner when it has the edge behind it and one more.
class CornerWalk {
public:
    explicit CornerWalk(double corner_angle) : corner_angle_(corner_angle) {}

    // Of a closed curve, before the first: the last edges.
    void begin(const Vec3& before_last, const Vec3& last) {
        turn_ = {before_last, last};
        direction_ = last;
        begun_ = true;
    }
    // Whether there is a corner where the edge before this one begins.
    bool take(const Vec3& direction) {
        const Turn next = begun_ ? Turn(direction_, direction) : Turn();
        const bool corner = turn_.is_corner(before_, next, corner_angle_);
        before_ = turn_;
        turn_ = next;
        direction_ = direction;
        begun_ = true;
        return corner;
    }
    // The same where an open curve's last edge begins.
    bool take_end() const { return turn_.is_corner(before_, Turn(), corner_angle_); }

private:
    double corner_angle_;
    bool begun_ = false;
    Vec3 direction_ = Vec3::Zero();
    Turn before_, turn_;
};

struct LastEdges {
    Vec3 before_last = Vec3::Zero(), last = Vec3::Zero();
    uint32_t count = 0;
};

Task<LastEdges> find_last_edges(Pace& pace, CurveView curve) {
    LastEdges edges;
    Slice slice(Cost::tens_of_ns);
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        for (uint32_t j = range.first; j < range.last; ++j) {
            edges.before_last = std::exchange(edges.last, stream.block().directions[j]);
            ++edges.count;
        }
        if (slice.is_over(range.last - range.first + 1)) co_await pace;
    }
    co_return edges;
}

// visit(segment) for each that begins at a corner, in order.
template <class Visit>
Task<void> each_corner(Pace& pace, CurveView curve, double corner_angle, Visit visit) {
    CornerWalk walk(corner_angle);
    LastEdges last;
    if (curve.closed) {
        last = co_await find_last_edges(pace, curve);
        if (last.count < 2) co_return;
        walk.begin(last.before_last, last.last);
    }
    Slice slice(Cost::tens_of_ns);
    uint32_t before = 0, taken = 0;
    Vec3 first = Vec3::Zero();
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        for (uint32_t j = range.first; j < range.last; ++j) {
            const Vec3 direction = stream.block().directions[j];
            // A closed curve's last edge has its corner told by its first one, once around.
            if (walk.take(direction) && taken > 0) visit(before);
            before = stream.index_of(j);
            if (taken++ == 0) first = direction;
        }
        if (slice.is_over(4 * (range.last - range.first) + 1)) co_await pace;
    }
    if (taken > 0 && (curve.closed ? walk.take(first) : walk.take_end())) visit(before);
}

}  // namespace

Task<CornerCount> find_corners(Pace& pace, CurveView curve, CornerSearch search, std::span<uint8_t> marks) {
    co_await each(pace, marks.size(), Cost::some_ns, [&](uint32_t i) { marks[i] = 0; });
    co_await each_corner(pace, curve, search.angle, [&](uint32_t segment) { marks[segment] = 1; });
    if (search.longest_bend > 0) co_await mark_round_corners(pace, curve, search.angle, search.longest_bend, marks);
    CornerCount count;
    co_await each(pace, marks.size(), Cost::some_ns, [&](uint32_t i) {
        if (marks[i] == 0) return;
        if (count.corners++ == 0) count.first_segment = i;
    });
    co_return count;
}

Task<std::shared_ptr<const CurveSet>> begin_at_corners(Pace& pace, std::shared_ptr<const CurveSet> set,
                                                       std::span<const CornerCount> counts) {
    bool turned = false;
    const auto first_of = [&](uint32_t c) {
        return set->closed(c) && counts[c].corners > 0 ? counts[c].first_segment : 0;
    };
    co_await each(pace, set->curve_count(), Cost::some_ns, [&](uint32_t c) { turned |= first_of(c) > 0; });
    if (!turned) co_return set;
    const auto out = std::allocate_shared<CurveSet>(std::pmr::polymorphic_allocator<>(pace.memory()), pace.memory());
    out->origin = set->origin;
    out->allocate_curves(set->curve_count());
    co_await each(pace, set->curve_count(), Cost::some_ns, [&](uint32_t c) {
        out->offsets()[c] = set->offsets()[c];
        out->begin_curve(c, set->flags()[c]);
    });
    out->offsets()[set->curve_count()] = set->point_count();
    std::pmr::vector<CurveSet::ColumnLayout> layout(pace.memory());
    for (const Column& column : set->columns()) layout.push_back({column.attribute, column.components});
    out->allocate_columns(layout);
    Slice slice(Cost::some_ns);
    for (size_t k = 0; k < layout.size(); ++k) {
        const size_t width = layout[k].components;
        const float* from = set->columns()[k].values.data();
        float* to = out->columns()[k].values.data();
        for (uint32_t c = 0; c < set->curve_count(); ++c) {
            const uint32_t begin = set->offsets()[c], count = set->offsets()[c + 1] - begin, first = first_of(c);
            for (Portion part(slice, 0, count); part.next();) {
                for (uint32_t i = part.begin; i < part.end; ++i) {
                    const uint32_t source = begin + (i < count - first ? i + first : i - (count - first));
                    std::copy_n(from + source * width, width, to + (begin + i) * width);
                }
                if (part.is_over()) co_await pace;
            }
        }
    }
    co_return out;
}

Task<void> split_at_corners(Pace& pace, CurveView curve, const float* scales, std::span<CurvePiece> pieces) {
    size_t piece = 0;
    bool begun = false;
    Slice slice(Cost::tens_of_ns);
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        const SegmentBlock& block = stream.block();
        for (uint32_t j = range.first; j < range.last; ++j) {
            const uint32_t index = stream.index_of(j);
            const bool corner = begun && piece + 1 < pieces.size() && index == pieces[piece + 1].first_segment;
            piece += corner ? 1 : 0;
            CurvePiece& at = pieces[piece];
            if (!begun || corner) {
                at.first_segment = index;
                at.start = block.points[j];
                at.tangent_start = block.tangents_start[j];
            }
            begun = true;
            at.last_segment = index;
            at.tangent_end = block.tangents_end[j];
            at.metres += block.lengths[j];
            at.length += scales ? step_scale(curve, scales, index).steps(block.lengths[j]) : block.lengths[j];
        }
        if (slice.is_over(range.last - range.first + 1)) co_await pace;
    }
}

}  // namespace flg
