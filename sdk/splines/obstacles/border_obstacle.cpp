// SPDX-License-Identifier: MIT
#include "splines/obstacles/border_obstacle.h"

#include <algorithm>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t min_edges = 4;
constexpr double support = 2.5;      // of an edge's length: how far its sample counts
constexpr double certain = 0.4;      // of that: so far from the wall several samples count everywhere
constexpr uint32_t wall_hint = 256;  // doubles, more than a sample surface needs

}  // namespace

BorderObstacle::BorderObstacle(OrientedSamples wall, const Box& box, double reach)
    : Obstacle(3, box, false, std::numeric_limits<double>::infinity(), reach), wall_(std::move(wall)) {}

// Where no sample reaches, beyond the wall or far from it: the plane of the nearest one.
double BorderObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double hint[wall_hint] = {}, value = 0, slope[3], bend[9];
    if (wall_.evaluate(x, hint, &value, slope, second != nullptr ? bend : nullptr)) {
        if (gradient != nullptr) std::copy_n(slope, 3, gradient);
        if (second != nullptr) std::copy_n(bend, 9, second);
        return value;
    }
    const OrientedSample& sample = wall_.sample(wall_.nearest_sample({x[0], x[1], x[2]}));
    for (int c = 0; c < 3; ++c) value += sample.normal[c] * (x[c] - sample.position[c]);
    if (gradient != nullptr) std::copy_n(sample.normal.begin(), 3, gradient);
    if (second != nullptr) std::fill_n(second, 9, 0.0);
    return value;
}

namespace {

struct Wall {
    void add_edge(const Mesh& mesh, Corner corner) {
        const Vec3 a = mesh.position(mesh.vertex_at(corner)), b = mesh.position(mesh.vertex_at(next_corner(corner)));
        const Vec3 across = mesh.position(mesh.vertex_at(previous_corner(corner))) - a, along = b - a;
        const Vec3 inwards = across - across.dot(along) / along.squaredNorm() * along;
        if (!(inwards.norm() > 1e-9 * across.norm())) return;
        const Vec3 normal = inwards.normalized(), middle = 0.5 * (a + b);
        const double radius = support * along.norm();
        if (samples.size() == 0) box = {{a.x(), a.y(), a.z()}, {a.x(), a.y(), a.z()}};
        for (int c = 0; c < 3; ++c) {
            box.lower[c] = std::min(box.lower[c], std::min(a[c], b[c]));
            box.upper[c] = std::max(box.upper[c], std::max(a[c], b[c]));
        }
        reach = std::min(reach, certain * radius);
        samples.push_back({.position = {middle.x(), middle.y(), middle.z()},
                           .normal = {normal.x(), normal.y(), normal.z()},
                           .bend = {},
                           .radius = radius});
    }

    GrowingBuffer<OrientedSample> samples;
    Obstacle::Box box;
    double reach = std::numeric_limits<double>::infinity();
};

}  // namespace

Task<BorderObstacle> border_obstacle(Pace& pace, const Mesh& mesh) {
    const size_t corners = size_t{3} * mesh.triangle_count();
    uint32_t edges = 0;
    co_await each(pace, corners, Cost::some_ns, [&](Corner corner) {
        if (mesh.neighbour_at(corner) == no_index) ++edges;
    });
    Wall wall{.samples = GrowingBuffer<OrientedSample>(edges, pace.memory()), .box = {}};
    wall.samples.resize(0);
    co_await each(pace, corners, Cost::tens_of_ns, [&](Corner corner) {
        if (mesh.neighbour_at(corner) == no_index) wall.add_edge(mesh, corner);
    });
    if (wall.samples.size() < min_edges) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the surface has %zu border edges, its borders need %u",
                      wall.samples.size(), min_edges);
    }
    OrientedSamples surface = co_await oriented_samples(pace, wall.samples);
    BorderObstacle border(std::move(surface), wall.box, wall.reach);
    co_return border;
}

}  // namespace flg
