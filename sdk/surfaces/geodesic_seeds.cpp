// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_seeds.h"

#include <algorithm>
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

struct Foot {
    Vec2 point;
    bool inside;  // not an end
};

// The point of a segment that is nearest to p.
Foot foot_on_segment(const Vec2& p, const Vec2& begin, const Vec2& end) {
    const Vec2 along = end - begin;
    const double square = along.squaredNorm();
    const double t = square > 0 ? (p - begin).dot(along) / square : 0.0;
    if (t <= 0) return {begin, false};
    if (t >= 1) return {end, false};
    return {begin + t * along, true};
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

void GeodesicSeeds::add_segment(const SurfacePoint& begin, const SurfacePoint& end, uint32_t label) {
    const auto place = [&](const SurfacePoint& point) {
        const Triple& corners = mesh_.triangles[point.triangle];
        const double u = point.u, v = point.v;
        return Vec3((1 - u - v) * load_vec3(positions_[corners[0]].data()) +
                    u * load_vec3(positions_[corners[1]].data()) + v * load_vec3(positions_[corners[2]].data()));
    };
    add_from_triangle(begin.triangle, place(begin), place(end), label);
}

void GeodesicSeeds::add_edge(Corner corner, uint32_t label) {
    add_from_triangle(triangle_of(corner), load_vec3(positions_[mesh_.vertex_at(corner)].data()),
                      load_vec3(positions_[mesh_.vertex_at(next_corner(corner))].data()), label);
}

void GeodesicSeeds::add_from_triangle(uint32_t triangle, const Vec3& begin, const Vec3& end, uint32_t label) {
    if (!within_.contains(mesh_.regions[triangle])) return;
    const auto position = [&](uint32_t vertex) { return load_vec3(positions_[vertex].data()); };
    const Triple& vertices = mesh_.triangles[triangle];
    const Plane plane(position(vertices[0]), position(vertices[1]), position(vertices[2]));
    const Vec2 from = plane(begin), to = plane(end);
    std::array<Vec2, 3> corners;
    for (uint32_t k = 0; k < 3; ++k) {
        corners[k] = plane(position(vertices[k]));
        const Foot foot = foot_on_segment(corners[k], from, to);
        found_.push_back({vertices[k], static_cast<float>((corners[k] - foot.point).norm()), label, foot.inside});
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
        if (!segments_cross(foot.point, unfolded, corners[k], corners[next])) continue;
        found_.push_back({vertex, static_cast<float>((unfolded - foot.point).norm()), label, foot.inside});
    }
}

bool CurveSeedsKernel::run(uint32_t count) {
    const uint32_t first = curves_.offsets[curve_], end = curves_.offsets[curve_ + 1];
    const uint32_t segments_end = curves_.closed[curve_] ? end : end - 1;
    for (; count > 0 && at_ < segments_end; --count, ++at_) {
        seeds_.add_segment(curves_.points[at_], curves_.points[at_ + 1 < end ? at_ + 1 : first], label_);
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
                seeds_.add_edge(corner, label_);
            } else if (!regions_.contains(mesh_.regions[triangle_of(across)])) {
                seeds_.add_edge(corner, label_);
                seeds_.add_edge(across, label_);
            }
        }
    }
    return at_ == triangles;
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
