// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/intrinsic_fan.h"

#include "surfaces/mesh/fan_walk.h"

namespace flg {

bool IntrinsicFan::gather(uint32_t vertex, std::span<const Corner> corners) {
    lanes_.clear();
    corners_.clear();
    is_flipped_ = false;
    for (const Corner corner : corners) {
        if (std::find(corners_.begin(), corners_.end(), corner) == corners_.end()) gather_stretch(corner);
    }
    gather_edges(vertex);
    return is_flipped_;
}

// From its clockwise end or, if it has none, from its least corner: the order must not depend on where it was found.
void IntrinsicFan::gather_stretch(Corner corner) {
    Corner begin = corner, least = corner;
    for (Corner back = surface_.turn_back(begin); back != no_index; back = surface_.turn_back(begin)) {
        if (back == corner) {
            begin = least;
            break;
        }
        begin = back;
        least = std::min(least, begin);
    }
    float tangent = 0;
    for (Corner at = begin;;) {
        const IntrinsicTriangle triangle = surface_.triangle(triangle_of(at));
        is_flipped_ = is_flipped_ || triangle.vertices != surface_.mesh.triangles[triangle_of(at)];
        const uint32_t k = at % 3, next = following_corner(k), previous = following_corner(next);
        lanes_.push_back(
            {blocks_.rank_of_vertex[triangle.vertices[next]], static_cast<float>(triangle.lengths[k]), tangent});
        corners_.push_back(at);
        tangent = static_cast<float>(triangle.half_tangent(k));
        at = surface_.turn(at);
        if (at != begin && at != no_index) continue;
        lanes_.push_back({blocks_.rank_of_vertex[triangle.vertices[previous]],
                          static_cast<float>(triangle.lengths[previous]), tangent});
        return;
    }
}

void IntrinsicFan::gather_edges(uint32_t vertex) {
    const Mesh& mesh = surface_.mesh;
    const Vec3 centre = load_vec3(surface_.positions[vertex].data());
    const size_t spanned = lanes_.size();
    const auto add = [&](uint32_t neighbour) {
        const uint32_t rank = blocks_.rank_of_vertex[neighbour];
        const double length = (load_vec3(surface_.positions[neighbour].data()) - centre).norm();
        constexpr double rounding = 1e-6;
        const auto leads_there = [&](const Lane& lane) {
            return lane.rank == rank && lane.length <= (1 + rounding) * length;
        };
        if (std::none_of(lanes_.begin(), lanes_.end(), leads_there)) {
            lanes_.push_back({rank, static_cast<float>(length), 0.0f});
        }
    };
    const Corner first = mesh.corner_of_vertex[vertex];
    for (Corner corner = first;;) {
        if (surface_.contains(triangle_of(corner))) {
            add(mesh.vertex_at(next_corner(corner)));
            add(mesh.vertex_at(previous_corner(corner)));
        }
        corner = mesh.turn(corner);
        if (corner == first || corner == no_index) break;
    }
    is_flipped_ = is_flipped_ || lanes_.size() > spanned;
}

Task<Buffer<CornerOfVertex>> corners_by_vertex(Pace& pace, const IntrinsicSurface& surface,
                                               const std::pmr::deque<uint32_t>& triangles) {
    std::pmr::deque<CornerOfVertex> corners(pace.memory());
    co_await each(pace, triangles.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (triangles[i] >= surface.mesh.triangle_count() || !surface.contains(triangles[i])) return;
        for (Corner corner = 3 * triangles[i]; corner < 3 * triangles[i] + 3; ++corner) {
            corners.push_back({surface.vertex_at(corner), corner});
        }
    });
    co_return co_await sort_by(pace, corners, surface.mesh.vertex_count(),
                               [](const CornerOfVertex& of) { return of.vertex; });
}

}  // namespace flg
