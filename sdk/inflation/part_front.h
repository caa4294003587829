// SPDX-License-Identifier: MIT
// Distances within a part's contour: they spread over its triangulation from vertex to vertex, the nearest first, in
// the part's plane (fast marching: Kimmel, Sethian, Computing geodesic paths on manifolds, 1998). Each vertex also
// learns which source it is nearest to.
#pragma once

#include <queue>

#include "inflation/inflate_part.h"
#include "runtime/each.h"

namespace flg {

// The corners of triangles (3 * triangle + corner) at each vertex.
inline Task<Groups> corners_by_vertex(Pace& pace, const InflatedPart& part) {
    return group_by(pace, 3 * part.triangles.size(), part.points.size(),
                    [&part](uint32_t i) { return part.triangles[i / 3][i % 3]; });
}

class PartFront {
public:
    static constexpr uint32_t not_reached = UINT32_MAX;

    // All outlive the front; `source_of` has a place for each vertex.
    PartFront(const InflatedPart& part, const Groups& corners, Buffer<uint32_t>& source_of, Memory* memory);

    void clear(uint32_t vertex);
    void offer(uint32_t vertex, double distance, uint32_t source);
    // Goes on from one vertex; returns what that cost, 0 at the end.
    uint32_t advance();
    double distance(uint32_t vertex) const { return distance_[vertex]; }

private:
    struct Reached {
        double distance;
        uint32_t vertex;
        auto operator<=>(const Reached&) const = default;
    };

    void update(uint32_t vertex, uint32_t from, uint32_t third);
    double across(const Point2& p, const Point2& a, const Point2& b, uint32_t from, uint32_t third) const;

    const InflatedPart& part_;
    const Groups& corners_;
    Buffer<uint32_t>& source_of_;
    Buffer<double> distance_;
    // A vector that grows would be copied in one slice.
    std::priority_queue<Reached, std::pmr::deque<Reached>, std::greater<>> queue_;
};

}  // namespace flg
