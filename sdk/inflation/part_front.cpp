// SPDX-License-Identifier: MIT
#include "inflation/part_front.h"

#include <algorithm>
#include <cmath>

namespace flg {

PartFront::PartFront(const InflatedPart& part, const Groups& corners, Buffer<uint32_t>& source_of, Memory* memory)
    : part_(part),
      corners_(corners),
      source_of_(source_of),
      distance_(part.points.size(), memory),
      queue_(std::greater<>(), std::pmr::deque<Reached>(memory)) {}

void PartFront::clear(uint32_t vertex) {
    distance_[vertex] = HUGE_VAL;
    source_of_[vertex] = not_reached;
}

void PartFront::offer(uint32_t vertex, double distance, uint32_t source) {
    if (!(distance < distance_[vertex])) return;
    distance_[vertex] = distance;
    source_of_[vertex] = source;
    queue_.push({distance, vertex});
}

uint32_t PartFront::advance() {
    if (queue_.empty()) return 0;
    const auto [reached, from] = queue_.top();
    queue_.pop();
    if (reached > distance_[from]) return 1;
    uint32_t work = 1;
    for (const uint32_t corner : corners_.of(from)) {
        const TriangleVertices& t = part_.triangles[corner / 3];
        const uint32_t a = t[(corner + 1) % 3], b = t[(corner + 2) % 3];
        update(a, from, b);
        update(b, from, a);
        work += 2;
    }
    return work;
}

// From one corner, and across the triangle if the front has passed the third with the same source.
void PartFront::update(uint32_t vertex, uint32_t from, uint32_t third) {
    const Point2 &p = part_.points[vertex], &a = part_.points[from], &b = part_.points[third];
    double reached = distance_[from] + flg::distance(p, a);
    if (source_of_[third] == source_of_[from]) reached = std::min(reached, across(p, a, b, from, third));
    offer(vertex, reached, source_of_[from]);
}

// A straight front through a and b: |gradient| = 1, if it comes from between them.
double PartFront::across(const Point2& p, const Point2& a, const Point2& b, uint32_t from, uint32_t third) const {
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
    const double aa = ax * ax + ay * ay, ab = ax * bx + ay * by, bb = bx * bx + by * by;
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 0)) return HUGE_VAL;
    const double ta = distance_[from], tb = distance_[third];
    const auto dot = [&](double x0, double x1, double y0, double y1) {
        return (bb * x0 * y0 - ab * (x0 * y1 + x1 * y0) + aa * x1 * y1) / determinant;
    };
    const double q = dot(1, 1, 1, 1), r = dot(1, 1, ta, tb), s = dot(ta, tb, ta, tb) - 1;
    const double root = r * r - q * s;
    if (!(root >= 0)) return HUGE_VAL;
    const double t = (r + std::sqrt(root)) / q;
    const bool between = bb * (ta - t) - ab * (tb - t) < 0 && aa * (tb - t) - ab * (ta - t) < 0;
    return between ? t : HUGE_VAL;
}

}  // namespace flg
