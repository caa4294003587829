// SPDX-License-Identifier: MIT
// Windows: stretches of edges that one source lights along straight lines in a strip of unfolded triangles. (Mitchell,
// Mount, Papadimitriou: The discrete geodesic problem, 1987; Chen, Han: Shortest paths on a polyhedron, 1990.)
#pragma once

#include <algorithm>
#include <cmath>

#include "surfaces/mesh/mesh.h"

namespace flg {

using Vec2 = Eigen::Vector2d;

inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// In the coordinates of the edge (exact_faces.h), seen from the triangle that the light enters.
struct Window {
    // The source, unfolded, at or below the edge. Of a light that comes straight from a line the source is nowhere:
    // this is the direction of its rays, of length 1, y above 0. (Bommes, Kobbelt: Accurate computation of geodesic
    // distance fields for polygonal curves on triangle meshes, 2007.)
    double x, y;
    double before;      // metres from the true source to this one; of a straight light: the distance at (0, 0)
    double begin, end;  // of the edge, metres
    Corner edge;
    uint32_t label;
    uint32_t narrow_run;  // triangles that were narrow, one after the other, and crossed last

    bool is_straight() const { return y > 0; }
    Vec2 ray_to(const Vec2& place) const { return is_straight() ? Vec2(x, y) : Vec2(place.x() - x, place.y() - y); }
    double distance_at(const Vec2& place) const {
        return before + (is_straight() ? x * place.x() + y * place.y() : ray_to(place).norm());
    }
    double least_distance() const {
        const double foot = is_straight() ? (x > 0 ? begin : end) : std::clamp(x, begin, end);
        return distance_at({foot, 0});
    }
    // Where the way to a place, so long, began.
    Vec2 origin_of(const Vec2& place, double distance) const {
        return is_straight() ? Vec2(place.x() - x * distance, place.y() - y * distance) : Vec2(x, y);
    }
    // Into the coordinates of an edge that starts at `start`, in the direction `along`.
    void move_to(const Vec2& start, const Vec2& direction) {
        const Vec2 source(x, y), place = is_straight() ? source : Vec2(source - start);
        if (is_straight()) before += source.dot(start);
        const double turned = cross(direction, place);
        y = is_straight() ? turned : std::min(turned, 0.0);
        x = direction.dot(place);
    }

    // Takes away what is nearer by way of the edge's ends, which are so far from their sources. False if nothing
    // remains. `slack`: ways that differ by less, in metres, are as long.
    bool trim(double at_start, double at_end, double length, double slack) {
        if (is_straight()) {
            const double lead = before - (at_start + slack), lead_end = before + x * length - (at_end + slack);
            if (lead > 0) begin = std::max(begin, x < 1 ? lead / (1 - x) : length);
            if (lead_end > 0) end = std::min(end, x > -1 ? length - lead_end / (1 + x) : 0);
        } else {
            const double height_sq = y * y, back = length - x;
            begin = std::max(begin, nearer_by_end(height_sq, x, at_start + slack - before));
            end = std::min(end, length - nearer_by_end(height_sq, back, at_end + slack - before));
        }
        return is_wide(length);
    }

private:
    // How much of the edge, from one end: what lies as far as s from it, where s + lead < the distance from the source,
    // which is `along` away from the end and at a height.
    static double nearer_by_end(double height_sq, double along, double lead) {
        const double from_end_sq = height_sq + along * along;
        if (lead > 0 && lead * lead >= from_end_sq) return 0;
        const double sum = lead + along;
        return sum > 0 ? (from_end_sq - lead * lead) / (2 * sum) : std::numeric_limits<double>::infinity();
    }
    // What is narrower lights nothing that its neighbours, with some rounding, do not.
    bool is_wide(double length) const {
        constexpr double least_stretch = 1e-12, least_angle = 1e-11;  // of the edge; radians
        const double width = end - begin;
        if (!(width > least_stretch * length)) return false;
        if (is_straight() || (begin < x && x < end)) return true;
        const double from_begin = begin - x, from_end = end - x, height_sq = y * y;
        return height_sq * width * width >
               least_angle * least_angle * (from_begin * from_begin + height_sq) * (from_end * from_end + height_sq);
    }
};

}  // namespace flg
