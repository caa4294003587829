// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacles.h"

#include "core/failure.h"
#include "runtime/pace.h"
#include "splines/obstacles/border_obstacle.h"
#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle_mesh.h"

namespace flg {

namespace {

constexpr double layer_cells = 4.2;
constexpr double solid_reach = 0.15;  // of a solid's size: how far around it the distance is exact

template <class T, class... Arguments>
std::shared_ptr<T> make_shared_in(Memory* memory, Arguments&&... arguments) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(memory), std::forward<Arguments>(arguments)...);
}

double max_side(const Surface& surface) {
    double longest = 0;
    for (int c = 0; c < 3; ++c) longest = std::max(longest, double{surface.extent.upper[c]} - surface.extent.lower[c]);
    return longest;
}

Obstacle::Place moved(Obstacle::Place place, const Vec3& shift) {
    for (uint32_t c = 0; c < Obstacle::max_dimension; ++c) place[c] += shift[c];
    return place;
}

}  // namespace

PlacedObstacle::PlacedObstacle(const Obstacle& obstacle, const Vec3& shift)
    : Obstacle(obstacle.dimension(), {moved(obstacle.box().lower, shift), moved(obstacle.box().upper, shift)},
               obstacle.bounded(), obstacle.core_depth(), obstacle.reach()),
      obstacle_(obstacle),
      shift_(shift) {
    set_core(moved(obstacle.core(), shift));
}

Obstacle::Place PlacedObstacle::moved_back(const double* x) const {
    Place own{};
    for (uint32_t c = 0; c < dimension(); ++c) own[c] = x[c] - shift_[c];
    return own;
}

double PlacedObstacle::evaluate(const double* x, double* gradient, double* second) const {
    return obstacle_.evaluate(moved_back(x).data(), gradient, second);
}

double PlacedObstacle::evaluate_exactly(const double* x, double* gradient, double* second, double exact_below) const {
    return obstacle_.evaluate_exactly(moved_back(x).data(), gradient, second, exact_below);
}

Obstacle::Meets PlacedObstacle::meets(const double* a, const double* b) const {
    return obstacle_.meets(moved_back(a).data(), moved_back(b).data());
}

uint32_t PlacedObstacle::part(const double* a, const double* b, double reach, std::span<Parting> out,
                              uint32_t before) const {
    const auto move = [&](uint32_t first, uint32_t end, double way) {
        for (uint32_t i = first; i < end; ++i)
            for (uint32_t c = 0; c < dimension(); ++c) out[i].height += way * out[i].outwards[c] * shift_[c];
    };
    move(0, before, -1);
    const uint32_t count = obstacle_.part(moved_back(a).data(), moved_back(b).data(), reach, out, before);
    move(0, count == no_parting ? before : count, 1);
    return count;
}

PlacedObstacles::PlacedObstacles(std::shared_ptr<const Obstacles> obstacles, const Origin& from, double more_clearance,
                                 Memory* memory)
    : obstacles_(std::move(obstacles)), placed_(memory) {
    if (obstacles_->origin == from && more_clearance == 0) return;
    const Vec3 shift = origin_shift(obstacles_->origin, from);
    placed_.reserve(obstacles_->solids.size());
    std::pmr::vector<const Obstacle*> pointers(memory);
    for (const auto& solid : obstacles_->solids) pointers.push_back(&placed_.emplace_back(*solid, shift));
    set_.emplace(pointers, obstacles_->clearance + more_clearance, memory);
}

Task<void> make_obstacles(Pace& pace, std::shared_ptr<Obstacles> out) {
    pace.stage("distances");
    for (const Obstacles::OfMesh& mesh : out->meshes) {
        if (mesh.kind == FLG_OBSTACLE_KIND_BORDER) {
            BorderObstacle border = co_await border_obstacle(pace, mesh.surface->mesh());
            out->solids[mesh.at] = make_shared_in<BorderObstacle>(pace.memory(), std::move(border));
            continue;
        }
        const bool is_layer = mesh.kind == FLG_OBSTACLE_KIND_LAYER;
        const double reach = is_layer ? 1.5 * mesh.layer : solid_reach * max_side(*mesh.surface) + out->clearance;
        const double cell = (max_side(*mesh.surface) + 2 * reach) / mesh.cells;
        if (is_layer && mesh.layer < layer_cells * cell) {
            throw Failure(
                FLG_ERROR_INVALID_ARGUMENT,
                "desc.obstacles[%u].radius is %g, a layer must be %g thick at least with %u cells, %g with 192",
                mesh.at, mesh.layer, layer_cells * cell, mesh.cells, layer_cells * cell * mesh.cells / 192);
        }
        SampledDistance sampled = co_await mesh_distance(pace, mesh.surface->mesh(), reach, mesh.cells, !is_layer);
        auto distance = make_shared_in<SampledDistance>(pace.memory(), std::move(sampled));
        if (is_layer) {
            out->solids[mesh.at] = make_shared_in<LayerObstacle>(pace.memory(), *distance, mesh.layer);
        } else {
            TriangleSolid triangles = co_await triangle_solid(pace, mesh.surface->mesh());
            out->solids[mesh.at] = make_shared_in<MeshObstacle>(pace.memory(), *distance, std::move(triangles));
        }
        out->distances.push_back(std::move(distance));
    }
    for (const Obstacles::OfMesh& mesh : out->meshes) {
        if (mesh.surface->origin == out->origin) continue;
        const Vec3 shift = origin_shift(mesh.surface->origin, out->origin);
        out->moved.push_back(std::move(out->solids[mesh.at]));
        out->solids[mesh.at] = make_shared_in<PlacedObstacle>(pace.memory(), *out->moved.back(), shift);
    }
    std::pmr::vector<const Obstacle*> pointers(pace.memory());
    for (const auto& solid : out->solids) pointers.push_back(solid.get());
    out->set.emplace(pointers, out->clearance, pace.memory());
}

}  // namespace flg
