// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/geodesic_seeds.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "runtime/each.h"

namespace flg {

namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Triangles beyond the one that holds the source.
constexpr uint32_t max_strip = 4;

// The plane of a triangle: its first corner is the origin, its second on the x axis, its third above it.
struct Plane {
    Plane(const Vec3& a, const Vec3& b, const Vec3& c) : origin(a) {
        const Vec3 edge = b - a, side = c - a;
        const double length = edge.norm();
        x_axis = length > 0 ? Vec3(edge / length) : Vec3::Zero();
        const Vec3 up = side - side.dot(x_axis) * x_axis;
        const double height = up.norm();
        y_axis = height > 0 ? Vec3(up / height) : Vec3::Zero();
    }
    Vec2 operator()(const Vec3& p) const { return {(p - origin).dot(x_axis), (p - origin).dot(y_axis)}; }

    Vec3 origin, x_axis, y_axis;
};

// The point of a segment that is nearest to p.
struct Foot {
    Vec2 point;
    bool on;        // p itself
    double beyond;  // how far p is beyond the nearest end, seen along the segment; below 0: it is not
    uint32_t end;   // that one
};

Foot foot_on_segment(const Vec2& p, const Vec2& begin, const Vec2& end) {
    const Vec2 along = end - begin;
    const double length = along.norm();
    if (!(length > 0)) return {begin, false, (p - begin).norm(), 0};
    const double t = (p - begin).dot(along) / (length * length);
    const Vec2 point = t <= 0 ? begin : t >= 1 ? end : Vec2(begin + t * along);
    return {point, (p - point).norm() <= 1e-6 * length, std::max(-t, t - 1) * length, t > 0.5 ? 1u : 0u};
}

// Where the corner above the edge a-b lies once its triangle is unfolded to the other side of it, away from `inner`;
// from its distances to a and b.
Vec2 unfold(const Vec2& a, const Vec2& b, const Vec2& inner, double from_a, double from_b) {
    const Vec2 edge = b - a;
    const double length = edge.norm();
    if (!(length > 0)) return a;
    const Vec2 along = edge / length;
    const Vec2 away = cross(edge, inner - a) > 0 ? Vec2(along.y(), -along.x()) : Vec2(-along.y(), along.x());
    const double x = (length * length + (from_a - from_b) * (from_a + from_b)) / (2 * length);
    return a + x * along + std::sqrt(std::max(from_a * from_a - x * x, 0.0)) * away;
}

bool segments_cross(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
    const Vec2 edge = b - a;
    const double at_p = cross(edge, p - a), at_q = cross(edge, q - a);
    if (at_p == at_q) return false;
    const Vec2 meeting = p + (at_p / (at_p - at_q)) * (q - p);
    const double t = (meeting - a).dot(edge);
    return t >= 0 && t <= edge.squaredNorm();
}

}  // namespace

Vec3 GeodesicSeeds::place(const SurfacePoint& point) const {
    const Triple& corners = mesh_.triangles[point.triangle];
    const double u = point.u, v = point.v;
    return (1 - u - v) * load_vec3(positions_[corners[0]].data()) + u * load_vec3(positions_[corners[1]].data()) +
           v * load_vec3(positions_[corners[2]].data());
}

void GeodesicSeeds::add_segment(const SurfacePoint& begin, const SurfacePoint& end, std::array<End, 2> ends,
                                uint32_t label) {
    add_from_triangle(begin.triangle, place(begin), place(end), ends, label);
}

void GeodesicSeeds::add_edge(Corner corner, uint32_t label) {
    add_from_triangle(triangle_of(corner), load_vec3(positions_[mesh_.vertex_at(corner)].data()),
                      load_vec3(positions_[mesh_.vertex_at(next_corner(corner))].data()), {End::vertex, End::vertex},
                      label);
}

double GeodesicSeeds::angle_at(Corner corner) const {
    const Vec3 place = load_vec3(positions_[mesh_.vertex_at(corner)].data());
    const Vec3 a = load_vec3(positions_[mesh_.vertex_at(next_corner(corner))].data()) - place;
    const Vec3 b = load_vec3(positions_[mesh_.vertex_at(previous_corner(corner))].data()) - place;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

void GeodesicSeeds::add_turn(Corner corner, const RegionSet& regions, uint32_t label) {
    constexpr uint32_t max_triangles = 64;             // more are no turn but a fan of slivers
    constexpr double min_turn = 0.3, rounding = 1e-4;  // radians
    constexpr double quarter = std::numbers::pi / 2;
    const bool side = regions.contains(mesh_.regions[triangle_of(corner)]);
    double angle = angle_at(corner);
    Corner last = corner;
    for (uint32_t i = 1;; ++i) {
        const Corner next = mesh_.turn(last);
        if (next == no_index || regions.contains(mesh_.regions[triangle_of(next)]) != side) break;
        if (i == max_triangles || next == corner) return;
        angle += angle_at(next);
        last = next;
    }
    if (angle < 2 * quarter + min_turn) return;
    const Vec3 centre = load_vec3(positions_[mesh_.vertex_at(corner)].data());
    double turned = 0;
    for (Corner at = corner; at != last; at = mesh_.turn(at)) {
        turned += angle_at(at);
        if (turned < quarter - rounding || turned > angle - quarter + rounding) continue;
        if (!within_.contains(mesh_.regions[triangle_of(at)])) continue;
        const uint32_t neighbour = mesh_.vertex_at(previous_corner(at));
        const double length = (load_vec3(positions_[neighbour].data()) - centre).norm();
        found_.push_back({neighbour, static_cast<float>(length), label});
    }
}

void GeodesicSeeds::add_from_triangle(uint32_t triangle, const Vec3& begin, const Vec3& end, std::array<End, 2> ends,
                                      uint32_t label) {
    if (!within_.contains(mesh_.regions[triangle])) return;
    const auto position = [&](uint32_t vertex) { return load_vec3(positions_[vertex].data()); };
    const Triple& vertices = mesh_.triangles[triangle];
    const Plane plane(position(vertices[0]), position(vertices[1]), position(vertices[2]));
    const Vec2 from = plane(begin), to = plane(end);
    // What is nearest to a vertex of the mesh or, unless it `must` be there, to a joint, is told better by others.
    const auto add = [&](uint32_t vertex, const Vec2& place, const Foot& foot, bool must) {
        constexpr double slant = 0.3, rounding = 1e-4;  // beyond an end, of the way to it
        const double away = (place - foot.point).norm();
        const End kind = ends[foot.end];
        const bool upright = foot.on || foot.beyond <= (kind == End::joint ? slant : -rounding) * away;
        if (!upright && (kind == End::vertex || (!must && kind == End::joint))) return;
        found_.push_back({vertex, static_cast<float>(away), label, upright || kind == End::joint});
    };
    std::array<Vec2, 3> corners;
    for (uint32_t k = 0; k < 3; ++k) {
        corners[k] = plane(position(vertices[k]));
        add(vertices[k], corners[k], foot_on_segment(corners[k], from, to), true);
    }
    // Straight ways through a strip of triangles, each of which crosses all the edges between them.
    const uint32_t last = flipped_ && flipped_->find(triangle) ? max_strip : 1;
    std::array<std::array<Vec2, 2>, max_strip> strip;
    const auto follow = [&](const auto& self, Corner edge, const Vec2& a, const Vec2& b, const Vec2& inner,
                            uint32_t number) -> void {
        const Corner across = mesh_.opposite(edge);
        if (across == no_index || !within_.contains(mesh_.regions[triangle_of(across)])) return;
        strip[number] = {a, b};
        const uint32_t vertex = mesh_.vertex_at(previous_corner(across));
        const Vec2 unfolded = unfold(a, b, inner, (position(vertex) - position(mesh_.vertex_at(edge))).norm(),
                                     (position(vertex) - position(mesh_.vertex_at(next_corner(edge)))).norm());
        const Foot foot = foot_on_segment(unfolded, from, to);
        bool is_straight = true;
        for (uint32_t i = 0; i <= number; ++i) {
            is_straight = is_straight && segments_cross(foot.point, unfolded, strip[i][0], strip[i][1]);
        }
        if (is_straight) add(vertex, unfolded, foot, false);
        if (number + 1 == last) return;
        self(self, next_corner(across), a, unfolded, b, number + 1);
        self(self, previous_corner(across), unfolded, b, a, number + 1);
    };
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t next = (k + 1) % 3;
        follow(follow, 3 * triangle + k, corners[k], corners[next], corners[(k + 2) % 3], 0);
    }
}

Task<void> add_curve(Pace& pace, const SurfaceCurves& curves, uint32_t curve, uint32_t label, GeodesicSeeds& seeds) {
    using End = GeodesicSeeds::End;
    const uint32_t first = curves.offsets[curve], end = curves.offsets[curve + 1], last = end - 1;
    const bool closed = curves.closed[curve];
    const auto after = [=](uint32_t point) { return point == last ? first : point + 1; };
    // What the curve is at one of its points. (A segment without length says nothing about directions.)
    const auto end_at = [&](uint32_t point) {
        constexpr double smooth_cosine = 0.87;  // 30 degrees
        if (!closed && (point == first || point == last)) return End::corner;
        const Vec3 here = seeds.place(curves.points[point]);
        const Vec3 in = here - seeds.place(curves.points[point == first ? last : point - 1]);
        const Vec3 out = seeds.place(curves.points[after(point)]) - here;
        return in.dot(out) >= smooth_cosine * in.norm() * out.norm() ? End::joint : End::corner;
    };
    co_await each(pace, first, closed ? end : last, Cost::microseconds, [&](uint32_t i) {
        seeds.add_segment(curves.points[i], curves.points[after(i)], {end_at(i), end_at(after(i))}, label);
    });
}

Task<void> add_border(Pace& pace, const Mesh& mesh, const RegionSet& regions, uint32_t label, GeodesicSeeds& seeds) {
    // An edge of the border, seen from one side. Returns what it cost.
    const auto add = [&](Corner corner) {
        seeds.add_edge(corner, label);
        seeds.add_turn(corner, regions, label);
        return 50u;
    };
    co_await each_by_work(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) {
        uint32_t work = 1;
        if (!regions.contains(mesh.regions[t])) return work;
        for (Corner corner = 3 * t; corner < 3 * t + 3; ++corner) {
            const Corner across = mesh.opposite(corner);
            const bool ends = across == no_index || !regions.contains(mesh.regions[triangle_of(across)]);
            work += 2;
            if (ends) work += add(corner);
            if (ends && across != no_index) work += add(across);
        }
        return work;
    });
}

Task<Buffer<Seed>> merge_seeds(Pace& pace, const std::pmr::deque<Seed>& found) {
    uint32_t largest = 0;  // vertex
    co_await each(pace, found.size(), Cost::some_ns, [&](uint32_t i) { largest = std::max(largest, found[i].vertex); });
    Buffer<Seed> sorted = co_await sort_by(pace, found, largest, [](const Seed& seed) { return seed.vertex; });
    uint32_t kept = 0;
    co_await each(pace, sorted.size(), Cost::some_ns, [&](uint32_t i) {
        if (kept > 0 && sorted[kept - 1].vertex == sorted[i].vertex) {
            if (sorted[i].distance < sorted[kept - 1].distance) sorted[kept - 1] = sorted[i];
        } else {
            sorted[kept++] = sorted[i];
        }
    });
    Buffer<Seed> seeds(kept, pace.memory());
    co_await each(pace, kept, Cost::some_ns, [&](uint32_t i) { seeds[i] = sorted[i]; });
    co_return seeds;
}

}  // namespace flg
