// SPDX-License-Identifier: MIT
#include "skeletons/contour.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double same_place = 1e-11;      // of the diagonal
constexpr double thinnest = 1e-10;        // height of a ring, of its diagonal
constexpr double largest = 1e150;         // products of two coordinates stay finite
constexpr double smallest_size = 1e-150;  // and those of two differences normal

bool is_near(const Point2& a, const Point2& b, double distance) {
    return std::hypot(a.x - b.x, a.y - b.y) <= distance;
}

double diagonal_of(std::span<const Point2> points) {
    Point2 low = points[0], high = points[0];
    for (const Point2& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return std::hypot(high.x - low.x, high.y - low.y);
}

void check_numbers(std::span<const Point2> points) {
    for (size_t i = 0; i < points.size(); ++i) {
        const Point2& p = points[i];
        if (!(std::fabs(p.x) <= largest && std::fabs(p.y) <= largest))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "contour: point %zu is (%g, %g); coordinates are finite, at most %g", i, p.x, p.y, largest);
    }
}

double checked_diagonal(std::span<const Point2> points, std::span<const uint32_t> offsets) {
    if (offsets.size() < 2 || points.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it has no points");
    check_numbers(points);
    const double diagonal = diagonal_of(points);
    if (diagonal < smallest_size)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: all its points are within %g of each other", diagonal);
    return diagonal;
}

// How a ring turns at the lowest of its leftmost points, which is how all of it turns if it is simple.
int turn_of(std::span<const Point2> ring) {
    const auto least = [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    const auto corner = static_cast<size_t>(std::min_element(ring.begin(), ring.end(), least) - ring.begin());
    return orientation(ring[(corner + ring.size() - 1) % ring.size()], ring[corner], ring[(corner + 1) % ring.size()]);
}

// How far the points are from one line at most: the one through two of them that are far apart.
double height_of(std::span<const Point2> ring) {
    const Point2& a = ring[0];
    Point2 b = a;
    for (const Point2& p : ring) {
        if (std::hypot(p.x - a.x, p.y - a.y) > std::hypot(b.x - a.x, b.y - a.y)) b = p;
    }
    const double length = std::hypot(b.x - a.x, b.y - a.y), dx = (b.x - a.x) / length, dy = (b.y - a.y) / length;
    double height = 0;
    for (const Point2& p : ring) height = std::max(height, std::fabs((p.x - a.x) * dy - (p.y - a.y) * dx));
    return height;
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

Contour clean_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory) {
    const double same = same_place * checked_diagonal(points, offsets);
    Contour contour(memory);
    contour.points.reserve(points.size());
    contour.input_points.reserve(points.size());
    contour.offsets.reserve(offsets.size());
    for (size_t r = 0; r + 1 < offsets.size(); ++r) {
        const size_t begin = contour.points.size();
        contour.offsets.push_back(static_cast<uint32_t>(begin));
        for (uint32_t i = offsets[r]; i < offsets[r + 1]; ++i) {
            if (contour.points.size() > begin && is_near(contour.points.back(), points[i], same)) continue;
            contour.points.push_back(points[i]);
            contour.input_points.push_back(i);
        }
        while (contour.points.size() > begin + 1 && is_near(contour.points.back(), contour.points[begin], same)) {
            contour.points.pop_back();
            contour.input_points.pop_back();
        }
        const std::span<Point2> ring(contour.points.data() + begin, contour.points.size() - begin);
        if (ring.size() < 3)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "contour: ring %zu has %zu distinct points; a ring has three or more", r, ring.size());
        const int turn = turn_of(ring);
        if (turn == 0 || height_of(ring) < thinnest * diagonal_of(ring))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "contour: ring %zu, with (%.9g, %.9g), has no area, or runs back on itself", r, ring[0].x,
                          ring[0].y);
        if ((turn > 0) != (r == 0)) {
            std::reverse(ring.begin(), ring.end());
            std::reverse(contour.input_points.begin() + static_cast<ptrdiff_t>(begin), contour.input_points.end());
        }
    }
    contour.offsets.push_back(contour.size());
    return contour;
}

Contour gather_contour(std::span<const Point2> points, std::span<const uint32_t> offsets, Memory* memory) {
    checked_diagonal(points, offsets);
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
