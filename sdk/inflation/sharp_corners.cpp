// SPDX-License-Identifier: MIT
#include "inflation/sharp_corners.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr double buried = 0.5, cut_away = 1;  // by the length: how far corners may be from the surface of all parts

// One ring of a contour by the way along it.
struct RingWalk {
    RingWalk(std::span<const Point2> of_ring, Memory* memory) : points(of_ring), way(of_ring.size() + 1, memory) {}

    double whole() const { return way[points.size()]; }
    const Point2& point(size_t i) const { return points[i % points.size()]; }
    // Where one is after a way from the ring's first point, which may be before it or beyond the last.
    Point2 at(double s) const {
        s -= std::floor(s / whole()) * whole();
        const auto after = static_cast<size_t>(std::upper_bound(way.begin() + 1, way.end() - 1, s) - way.begin());
        const double length = way[after] - way[after - 1];
        const double share = length > 0 ? (s - way[after - 1]) / length : 0;
        const Point2 &a = point(after - 1), &b = point(after);
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    double turn(uint32_t i, double length) const {
        const Point2 before = at(way[i] - length), &here = points[i], after = at(way[i] + length);
        const double ax = here.x - before.x, ay = here.y - before.y, bx = after.x - here.x, by = after.y - here.y;
        return std::fabs(std::atan2(ax * by - ay * bx, ax * bx + ay * by));
    }

    std::span<const Point2> points;
    Buffer<double> way;  // to each point, and around all
};

struct Turn {
    uint32_t point;
    double way, angle;
};

Task<void> add_ring(Pace& pace, const PartUnion& parts, uint32_t part, std::span<const Point2> points, double angle,
                    double length, std::pmr::vector<SharpCorner>& out) {
    const ImplicitPart& shape = parts.parts()[part];
    const double own_length = length / shape.scale();
    RingWalk ring(points, pace.memory());
    ring.way[0] = 0;
    co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t i) {
        const Point2 &a = ring.point(i), &b = ring.point(i + 1);
        ring.way[i + 1] = ring.way[i] + std::hypot(b.x - a.x, b.y - a.y);
    });
    if (!(ring.whole() > 4 * own_length)) co_return;
    std::pmr::vector<Turn> turns(pace.memory());
    co_await each(pace, points.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        const double turn = ring.turn(i, own_length);
        if (turn > angle) turns.push_back({i, ring.way[i], turn});
    });
    co_await each_by_work(pace, turns.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const auto count = static_cast<uint32_t>(turns.size());
        uint32_t work = 4;
        bool is_sharpest = true;
        for (const uint32_t step : {1u, count - 1}) {
            for (uint32_t k = (i + step) % count; k != i && is_sharpest; k = (k + step) % count, ++work) {
                const double apart = std::fabs(turns[k].way - turns[i].way);
                if (std::min(apart, ring.whole() - apart) > own_length) break;
                is_sharpest = turns[k].angle < turns[i].angle || (turns[k].angle == turns[i].angle && k > i);
            }
        }
        if (!is_sharpest) return work;
        const Point2& p = points[turns[i].point];
        const Vec3 at = shape.place(Vec3(p.x, p.y, shape.lift(p.x, p.y)));
        const double value = parts.sample(at).value;
        if (value < buried * length && value > -cut_away * length) out.push_back({at, part});
        return work + 4;
    });
}

}  // namespace

Task<std::pmr::vector<SharpCorner>> sharp_corners(Pace& pace, const PartUnion& parts, double angle, double length) {
    std::pmr::vector<SharpCorner> corners(pace.memory());
    for (uint32_t part = 0; part < parts.parts().size(); ++part) {
        const Contour& contour = parts.parts()[part].part().contour;
        for (size_t ring = 0; ring + 1 < contour.offsets.size(); ++ring) {
            const std::span<const Point2> points(contour.points.data() + contour.offsets[ring],
                                                 contour.points.data() + contour.offsets[ring + 1]);
            co_await add_ring(pace, parts, part, points, angle, length, corners);
        }
    }
    co_return corners;
}

Task<Buffer<uint32_t>> vertices_at(Pace& pace, std::span<const SharpCorner> corners, std::span<const Vec3> positions,
                                   double reach) {
    Buffer<uint32_t> vertex(corners.size(), pace.memory());
    Buffer<double> distance(corners.size(), pace.memory());
    Buffer<uint8_t> is_taken(positions.size(), pace.memory());
    co_await each(pace, corners.size(), Cost::some_ns, [&](uint32_t c) {
        vertex[c] = none;
        distance[c] = reach * reach;
    });
    co_await each(pace, positions.size(), Cost::some_ns, [&](uint32_t v) { is_taken[v] = 0; });
    for (uint32_t c = 0; c < corners.size(); ++c) {
        co_await each(pace, positions.size(), Cost::some_ns, [&](uint32_t v) {
            const double squared = (positions[v] - corners[c].at).squaredNorm();
            if (!(squared < distance[c])) return;
            distance[c] = squared;
            vertex[c] = v;
        });
        if (vertex[c] == none) continue;
        if (is_taken[vertex[c]])
            vertex[c] = none;
        else
            is_taken[vertex[c]] = 1;
    }
    co_return vertex;
}

}  // namespace flg
