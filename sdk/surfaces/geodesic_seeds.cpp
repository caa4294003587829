// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_seeds.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace flg {

namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

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

// Where the corner above the edge a-b lies once its triangle is unfolded to the other side of it, away from `inner`; from its
// distances to a and b.
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
    constexpr uint32_t most_triangles = 64;              // more are no turn but a fan of slivers
    constexpr double least_turn = 0.3, rounding = 1e-4;  // radians
    constexpr double quarter = std::numbers::pi / 2;
    const bool side = regions.contains(mesh_.regions[triangle_of(corner)]);
    double angle = angle_at(corner);
    Corner last = corner;
    for (uint32_t i = 1;; ++i) {
        const Corner next = mesh_.turn(last);
        if (next == no_index || regions.contains(mesh_.regions[triangle_of(next)]) != side) break;
        if (i == most_triangles || next == corner) return;
        angle += angle_at(next);
        last = next;
    }
    if (angle < 2 * quarter + least_turn) return;
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
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner across = mesh_.opposite(3 * triangle + k);
        if (across == no_index || !within_.contains(mesh_.regions[triangle_of(across)])) continue;
        const uint32_t vertex = mesh_.vertex_at(previous_corner(across));
        const uint32_t next = (k + 1) % 3;
        const Vec2 unfolded =
            unfold(corners[k], corners[next], corners[(k + 2) % 3], (position(vertex) - position(vertices[k])).norm(),
                   (position(vertex) - position(vertices[next])).norm());
        const Foot foot = foot_on_segment(unfolded, from, to);
        if (segments_cross(foot.point, unfolded, corners[k], corners[next])) add(vertex, unfolded, foot, false);
    }
}

// What the curve is at one of its points. (A segment without length says nothing about directions.)
GeodesicSeeds::End CurveSeedsKernel::end_at(uint32_t point) const {
    constexpr double smooth_cosine = 0.87;  // 30 degrees
    const uint32_t first = curves_.offsets[curve_], last = curves_.offsets[curve_ + 1] - 1;
    const bool closed = curves_.closed[curve_];
    if (!closed && (point == first || point == last)) return GeodesicSeeds::End::corner;
    const Vec3 here = seeds_.place(curves_.points[point]);
    const Vec3 in = here - seeds_.place(curves_.points[point == first ? last : point - 1]);
    const Vec3 out = seeds_.place(curves_.points[point == last ? first : point + 1]) - here;
    return in.dot(out) >= smooth_cosine * in.norm() * out.norm() ? GeodesicSeeds::End::joint
                                                                 : GeodesicSeeds::End::corner;
}

bool CurveSeedsKernel::run(uint32_t count) {
    const uint32_t first = curves_.offsets[curve_], end = curves_.offsets[curve_ + 1];
    const uint32_t segments_end = curves_.closed[curve_] ? end : end - 1;
    for (; count > 0 && at_ < segments_end; --count, ++at_) {
        const uint32_t next = at_ + 1 < end ? at_ + 1 : first;
        seeds_.add_segment(curves_.points[at_], curves_.points[next], {end_at(at_), end_at(next)}, label_);
    }
    return at_ >= segments_end;
}

bool BorderSeedsKernel::run(uint32_t count) {
    const uint32_t triangles = mesh_.triangle_count();
    for (; count > 0 && at_ < triangles; --count, ++at_) {
        if (!regions_.contains(mesh_.regions[at_])) continue;
        for (Corner corner = 3 * at_; corner < 3 * at_ + 3; ++corner) {
            const Corner across = mesh_.opposite(corner);
            if (across == no_index) {
                add(corner);
            } else if (!regions_.contains(mesh_.regions[triangle_of(across)])) {
                add(corner);
                add(across);
            }
        }
    }
    return at_ == triangles;
}

// An edge of the border, seen from one side.
void BorderSeedsKernel::add(Corner corner) {
    seeds_.add_edge(corner, label_);
    seeds_.add_turn(corner, regions_, label_);
}

SeedMergeKernel::SeedMergeKernel(const std::pmr::deque<Seed>& found, Memory* memory)
    : found_(found), sorted_(found.size(), memory), scratch_(found.size(), memory) {}

bool SeedMergeKernel::run(uint32_t count) {
    const uint32_t size = static_cast<uint32_t>(found_.size());
    for (; count > 0 && pass_ < byte_count + 2 && size > 0; --count) {
        const uint32_t i = at_++;
        if (pass_ == 0) {
            sorted_[i] = found_[i];
            for (uint32_t byte = 0; byte < byte_count; ++byte) ++starts_[byte][found_[i].vertex >> 8 * byte & 255];
        } else if (pass_ <= byte_count) {
            const Seed& seed = sorted_[i];
            scratch_[starts_[pass_ - 1][seed.vertex >> 8 * (pass_ - 1) & 255]++] = seed;
        } else {
            keep(sorted_[i]);
        }
        if (at_ < size) continue;
        at_ = 0;
        if (pass_ == 0) {
            for (auto& counts : starts_) {
                uint32_t start = 0;
                for (uint32_t& bucket : counts) start += std::exchange(bucket, start);
            }
        } else if (pass_ <= byte_count) {
            std::swap(sorted_, scratch_);
        }
        ++pass_;
    }
    return pass_ == byte_count + 2 || size == 0;
}

void SeedMergeKernel::keep(const Seed& seed) {
    if (kept_ > 0 && sorted_[kept_ - 1].vertex == seed.vertex) {
        if (seed.distance < sorted_[kept_ - 1].distance) sorted_[kept_ - 1] = seed;
    } else {
        sorted_[kept_++] = seed;
    }
}

}  // namespace flg
