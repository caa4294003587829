// SPDX-License-Identifier: MIT
// Obstacles as hosts hold them, and as they are seen from another origin than their own: from where a curve is; or one
// of a mesh that has its own origin.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "filigree/filigree_spline.h"
#include "runtime/product.h"
#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle_grid.h"
#include "surfaces/surface.h"

namespace flg {

class Obstacles final : public Product {
public:
    explicit Obstacles(uint32_t of_dimension, Memory* memory)
        : dimension(of_dimension), solids(memory), meshes(memory), distances(memory), moved(memory) {}

    // One that a job makes: solids[at], of a mesh.
    struct OfMesh {
        uint32_t at;
        std::shared_ptr<Surface> surface;
        FlgObstacleKind kind;  // MESH, LAYER or BORDER
        uint32_t cells;
        double layer;  // its thickness, m
    };

    const uint32_t dimension;
    Origin origin{};  // of all places; 0 in the plane
    double clearance = 0;
    std::pmr::vector<std::shared_ptr<const Obstacle>> solids;
    std::pmr::vector<OfMesh> meshes;
    std::pmr::vector<std::shared_ptr<SampledDistance>> distances;  // what the solids of meshes look into
    std::pmr::vector<std::shared_ptr<const Obstacle>> moved;       // solids of meshes with another origin, before that
    std::optional<ObstacleSet> set;                                // of these; by the job
};

// An obstacle that is `shift` away. `obstacle` outlives it.
class PlacedObstacle final : public Obstacle {
public:
    PlacedObstacle(const Obstacle& obstacle, const Vec3& shift);
    double evaluate(const double* x, double* gradient, double* second) const override;
    double evaluate_exactly(const double* x, double* gradient, double* second, double exact_below = 0) const override;
    bool is_convex() const override { return obstacle_.is_convex(); }
    Meets meets(const double* a, const double* b) const override;
    uint32_t part(const double* a, const double* b, double reach, std::span<Parting> out,
                  uint32_t before) const override;

private:
    Place moved_back(const double* x) const;

    const Obstacle& obstacle_;
    Vec3 shift_;
};

class PlacedObstacles {
public:
    // Keeps `obstacles`, which are ready. `more_clearance` comes to theirs; throws a Failure if that is too much.
    PlacedObstacles(std::shared_ptr<const Obstacles> obstacles, const Origin& from, double more_clearance,
                    Memory* memory);
    const ObstacleSet& set() const { return set_ ? *set_ : *obstacles_->set; }

private:
    std::shared_ptr<const Obstacles> obstacles_;
    std::pmr::vector<PlacedObstacle> placed_;
    std::optional<ObstacleSet> set_;  // of these; none if origin and clearance are theirs
};

// The whole of flgObstaclesCreate.
Task<void> make_obstacles(Pace& pace, std::shared_ptr<Obstacles> out);

}  // namespace flg
