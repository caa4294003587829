// SPDX-License-Identifier: MIT
#include "splines/border_obstacle.h"

#include <algorithm>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t least_edges = 4;
constexpr double support = 2.5;        // of an edge's length: how far its sample counts
constexpr double certain = 0.4;        // of that: so far from the wall several samples count everywhere
constexpr uint32_t wall_memory = 256;  // doubles, more than a sample surface needs

}  // namespace

BorderObstacle::BorderObstacle(OrientedSamples wall, const Box& box, double reach)
    : Obstacle(3, box, false, std::numeric_limits<double>::infinity(), reach), wall_(std::move(wall)) {}

// Where no sample reaches, beyond the wall or far from it: the plane of the nearest one.
double BorderObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double memory[wall_memory] = {}, value = 0, slope[3], bend[9];
    if (wall_.evaluate(x, memory, &value, slope, second != nullptr ? bend : nullptr)) {
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

BorderObstacleKernel::BorderObstacleKernel(const Mesh& mesh, Memory* memory) : mesh_(mesh), memory_(memory) {}

bool BorderObstacleKernel::run(uint32_t count) {
    const uint32_t corners = 3 * mesh_.triangle_count();
    for (; at_ < 2 * corners; ++at_) {
        if (count-- == 0) return false;
        if (at_ == corners) samples_ = GrowingBuffer<OrientedSample>(edges_, memory_), samples_.resize(0);
        const Corner corner = at_ % corners;
        if (mesh_.neighbour_at(corner) != no_index) continue;
        if (at_ < corners) {
            ++edges_;
        } else {
            add_edge(corner);
        }
    }
    if (!sort_) {
        if (samples_.size() < least_edges) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the surface has %zu border edges, its borders need %u",
                          samples_.size(), least_edges);
        }
        sort_.emplace(std::move(samples_), memory_);
    }
    return sort_->run(count);
}

void BorderObstacleKernel::add_edge(Corner corner) {
    const Vec3 a = mesh_.position(mesh_.vertex_at(corner)), b = mesh_.position(mesh_.vertex_at(next_corner(corner)));
    const Vec3 across = mesh_.position(mesh_.vertex_at(previous_corner(corner))) - a, along = b - a;
    const Vec3 inwards = across - across.dot(along) / along.squaredNorm() * along;
    if (!(inwards.norm() > 1e-9 * across.norm())) return;
    const Vec3 normal = inwards.normalized(), middle = 0.5 * (a + b);
    const double radius = support * along.norm();
    if (samples_.size() == 0) box_ = {{a.x(), a.y(), a.z()}, {a.x(), a.y(), a.z()}};
    for (int c = 0; c < 3; ++c) {
        box_.lower[c] = std::min(box_.lower[c], std::min(a[c], b[c]));
        box_.upper[c] = std::max(box_.upper[c], std::max(a[c], b[c]));
    }
    reach_ = std::min(reach_, certain * radius);
    samples_.push_back({.position = {middle.x(), middle.y(), middle.z()},
                        .normal = {normal.x(), normal.y(), normal.z()},
                        .bend = {},
                        .radius = radius});
}

}  // namespace flg
