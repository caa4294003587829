// SPDX-License-Identifier: MIT
#include "skeletons/contour.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"
#include "runtime/run_now.h"

namespace flg {

namespace {

constexpr double same_place = 1e-11;      // of the diagonal
constexpr double thinnest = 1e-10;        // height of a ring, of its diagonal
constexpr double largest = 1e150;         // products of two coordinates stay finite
constexpr double smallest_size = 1e-150;  // and those of two differences normal

bool is_near(const Point2& a, const Point2& b, double distance) {
    return std::hypot(a.x - b.x, a.y - b.y) <= distance;
}

// What is asked of many points at once.
struct Extent {
    Point2 low, high;

    void add(const Point2& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    double diagonal() const { return std::hypot(high.x - low.x, high.y - low.y); }
};

void check_numbers(const Point2& p, size_t i) {
    if (!(std::fabs(p.x) <= largest && std::fabs(p.y) <= largest))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: point %zu is (%g, %g); coordinates are finite, at most %g",
                      i, p.x, p.y, largest);
}

Task<double> checked_diagonal(Pace& pace, std::span<const Point2> points, std::span<const uint32_t> offsets) {
    if (offsets.size() < 2 || points.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it has no points");
    Extent extent{points[0], points[0]};
    co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t i) {
        check_numbers(points[i], i);
        extent.add(points[i]);
    });
    if (extent.diagonal() < smallest_size)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: all its points are within %g of each other",
                      extent.diagonal());
    co_return extent.diagonal();
}

// How a ring turns at the lowest of its leftmost points, which is how all of it turns if it is simple; 0 if it has no
// area: if all its points are near one line, through two that are far apart.
Task<int> turn_of(Pace& pace, std::span<const Point2> ring) {
    const Point2& a = ring[0];
    Point2 b = a;
    size_t corner = 0;
    Extent extent{a, a};
    co_await each(pace, ring.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Point2 &p = ring[i], &least = ring[corner];
        if (p.x != least.x ? p.x < least.x : p.y < least.y) corner = i;
        if (std::hypot(p.x - a.x, p.y - a.y) > std::hypot(b.x - a.x, b.y - a.y)) b = p;
        extent.add(p);
    });
    const double length = std::hypot(b.x - a.x, b.y - a.y), dx = (b.x - a.x) / length, dy = (b.y - a.y) / length;
    double height = 0;
    co_await each(pace, ring.size(), Cost::some_ns, [&](uint32_t i) {
        height = std::max(height, std::fabs((ring[i].x - a.x) * dy - (ring[i].y - a.y) * dx));
    });
    if (height < thinnest * extent.diagonal()) co_return 0;
    co_return orientation(ring[(corner + ring.size() - 1) % ring.size()], ring[corner],
                          ring[(corner + 1) % ring.size()]);
}

Point2 crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
    const double along = ((c.x - a.x) * vy - (c.y - a.y) * vx) / (ux * vy - uy * vx);
    return {a.x + along * ux, a.y + along * uy};
}

}  // namespace

uint32_t Contour::ring_of(uint32_t point) const {
    return static_cast<uint32_t>(std::upper_bound(offsets.begin(), offsets.end(), point) - offsets.begin()) - 1;
}

uint32_t Contour::next(uint32_t point) const {
    const uint32_t ring = ring_of(point);
    return point + 1 == offsets[ring + 1] ? offsets[ring] : point + 1;
}

Task<Contour> clean_contour(Pace& pace, std::span<const Point2> points, std::span<const uint32_t> offsets) {
    const double same = same_place * co_await checked_diagonal(pace, points, offsets);
    Contour contour(pace.memory());
    contour.points.reserve(points.size());
    contour.input_points.reserve(points.size());
    contour.offsets.reserve(offsets.size());
    for (size_t r = 0; r + 1 < offsets.size(); ++r) {
        const size_t begin = contour.points.size();
        contour.offsets.push_back(static_cast<uint32_t>(begin));
        co_await each(pace, offsets[r], offsets[r + 1], Cost::tens_of_ns, [&](uint32_t i) {
            if (contour.points.size() > begin && is_near(contour.points.back(), points[i], same)) return;
            contour.points.push_back(points[i]);
            contour.input_points.push_back(i);
        });
        co_await repeat(pace, Cost::tens_of_ns, [&] {
            if (contour.points.size() <= begin + 1 || !is_near(contour.points.back(), contour.points[begin], same))
                return false;
            contour.points.pop_back();
            contour.input_points.pop_back();
            return true;
        });
        const std::span<Point2> ring(contour.points.data() + begin, contour.points.size() - begin);
        if (ring.size() < 3)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "contour: ring %zu has %zu distinct points; a ring has three or more", r, ring.size());
        const int turn = co_await turn_of(pace, ring);
        if (turn == 0)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "contour: ring %zu, with (%.9g, %.9g), has no area, or runs back on itself", r, ring[0].x,
                          ring[0].y);
        if ((turn > 0) == (r == 0)) continue;
        const auto last = static_cast<uint32_t>(ring.size()) - 1;
        co_await each(pace, ring.size() / 2, Cost::some_ns, [&](uint32_t i) {
            std::swap(ring[i], ring[last - i]);
            std::swap(contour.input_points[begin + i], contour.input_points[begin + last - i]);
        });
    }
    contour.offsets.push_back(contour.size());
    co_return contour;
}

Contour clean_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory) {
    return run_now(memory, [&](Pace& pace) { return clean_contour(pace, points, offsets); });
}

Contour gather_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory) {
    run_now(memory, [&](Pace& pace) { return checked_diagonal(pace, points, offsets); });
    Contour contour(memory);
    for (size_t r = 0; r + 1 < offsets.size(); ++r) {
        if (r > 0 && offsets[r + 1] - offsets[r] < 3) continue;
        contour.offsets.push_back(contour.size());
        for (uint32_t i = offsets[r]; i < offsets[r + 1]; ++i) {
            contour.points.push_back(points[i]);
            contour.input_points.push_back(i);
        }
    }
    contour.offsets.push_back(contour.size());
    return contour;
}

Failure describe_fault(const Contour& contour, const ContourFault& fault) {
    using Kind = ContourFault::Kind;
    constexpr FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;
    const uint32_t a = fault.first, b = fault.second, after_a = contour.next(a), after_b = contour.next(b);
    const Point2& p = contour.points[a];
    const auto input = [&](uint32_t point) { return contour.input_points[point]; };
    switch (fault.kind) {
        case Kind::same_point:
            return Failure(invalid, "contour: points %u and %u are at one place, (%.9g, %.9g)", input(a), input(b), p.x,
                           p.y);
        case Kind::point_on_edge:
            return Failure(invalid, "contour: point %u is on the edge between points %u and %u, at (%.9g, %.9g)",
                           input(a), input(b), input(after_b), p.x, p.y);
        case Kind::edges_cross: {
            const Point2 at = crossing(p, contour.points[after_a], contour.points[b], contour.points[after_b]);
            return Failure(invalid,
                           "contour: the edges between points %u and %u and between %u and %u cross at (%.9g, %.9g)",
                           input(a), input(after_a), input(b), input(after_b), at.x, at.y);
        }
        case Kind::outside:
            return Failure(invalid, "contour: ring %u, with (%.9g, %.9g), is outside of ring 0", contour.ring_of(a),
                           p.x, p.y);
        case Kind::nested:
            return Failure(invalid, "contour: ring %u, with (%.9g, %.9g), is a hole with a ring in it",
                           contour.ring_of(a), p.x, p.y);
        default: return Failure(FLG_ERROR_INTERNAL, "contour: no triangulation was found");
    }
}

}  // namespace flg
