// SPDX-License-Identifier: MIT
// Obstacles: made, released.
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle_polygon.h"
#include "splines/obstacles/obstacle_shapes.h"
#include "splines/obstacles/obstacles.h"

namespace flg {

namespace {

FlgObstacle default_obstacle() {
    auto obstacle = sized<FlgObstacle>();
    obstacle.radius = 1;
    obstacle.cells = 64;
    for (int i = 0; i < 3; ++i) obstacle.half[i] = obstacle.axes[4 * i] = 1;
    return obstacle;
}

FlgObstaclesDesc default_obstacles_desc() {
    auto desc = sized<FlgObstaclesDesc>();
    desc.dimension = 3;
    return desc;
}

std::shared_ptr<const Obstacle> make_box(Memory* memory, const FlgObstacle& in, uint32_t dimension) {
    double axes[9];
    for (uint32_t r = 0; r < dimension; ++r) {
        for (uint32_t c = 0; c < dimension; ++c) axes[r * dimension + c] = in.axes[3 * r + c];
    }
    return make_object<BoxObstacle>(memory, dimension, in.centre, in.half, axes);
}

std::shared_ptr<const Obstacle> make_polygon(Memory* memory, const FlgObstacle& in, uint32_t dimension) {
    require(in.points, "points");
    const std::span<const double> points(in.points, size_t{2} * in.point_count);
    if (dimension == 2) return make_object<PolygonObstacle>(memory, points, memory);
    return make_object<PrismObstacle>(memory, PolygonObstacle(points, memory), in.centre, in.axes, in.half[2]);
}

// Of a host's function: bounded by its box, and as exact and as deep as the header asks.
std::shared_ptr<const Obstacle> make_function(Memory* memory, const FlgObstacle& in, uint32_t dimension) {
    if (!in.value) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "value is null");
    Obstacle::Box box;
    double least = HUGE_VAL;
    for (uint32_t c = 0; c < dimension; ++c) {
        check_range(in.half[c] > 0 && in.half[c] <= 1e30, "half", in.half[c], "above 0");
        check_range(std::abs(in.centre[c]) <= 1e30, "centre", in.centre[c], "finite and at most 1e30 in size");
        box.lower[c] = in.centre[c] - in.half[c];
        box.upper[c] = in.centre[c] + in.half[c];
        least = std::min(least, in.half[c]);
    }
    const FunctionObstacle::Function function{.value = in.value, .second = nullptr, .user = in.user_data};
    return make_object<FunctionObstacle>(memory, dimension, function, box, true, 0.1 * least, 0.5 * least);
}

std::shared_ptr<const Obstacle> make_obstacle(Memory* memory, const FlgObstacle& in, uint32_t dimension) {
    check_enum(in.kind, FLG_OBSTACLE_KIND_BALL, FLG_OBSTACLE_KIND_HALF_SPACE, "kind", "FLG_OBSTACLE_");
    switch (in.kind) {
        case FLG_OBSTACLE_KIND_BALL: return make_object<BallObstacle>(memory, dimension, in.centre, in.radius);
        case FLG_OBSTACLE_KIND_BOX: return make_box(memory, in, dimension);
        case FLG_OBSTACLE_KIND_CAPSULE:
            return make_object<CapsuleObstacle>(memory, dimension, in.centre, in.to, in.radius);
        case FLG_OBSTACLE_KIND_POLYGON: return make_polygon(memory, in, dimension);
        case FLG_OBSTACLE_KIND_FUNCTION: return make_function(memory, in, dimension);
        case FLG_OBSTACLE_KIND_HALF_SPACE: return make_object<HalfSpaceObstacle>(memory, dimension, in.centre, in.to);
        default: return nullptr;
    }
}

// What the job makes of a mesh.
void read_mesh(Context& context, const FlgObstacle& in, uint32_t number, Obstacles& out, Submission& submission) {
    if (out.dimension != 3)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "kind is that of a mesh, which is for space, dimension 3");
    const auto surface = context.surfaces.get(in.surface.id, "surface");
    check_range(in.cells >= min_distance_cells && in.cells <= max_distance_cells, "cells", in.cells, "8 to 192");
    const bool is_layer = in.kind == FLG_OBSTACLE_KIND_LAYER;
    if (is_layer) check_range(in.radius > 0 && in.radius <= 1e30, "radius", in.radius, "above 0");
    submission.read_surface(surface, "surface");
    out.meshes.push_back({number, surface, in.kind, in.cells, in.radius});
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgObstacleInit(FlgObstacle* obstacle, uint32_t struct_size) {
    return init(obstacle, struct_size, default_obstacle(), "obstacle");
}

FlgResult flgObstaclesDescInit(FlgObstaclesDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_obstacles_desc());
}

FlgResult flgObstaclesCreate(FlgContext context, const FlgObstaclesDesc* desc, FlgObstacles* out_obstacles,
                             FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_obstacles, "out_obstacles", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgObstaclesDesc read = read_struct(desc, default_obstacles_desc(), "desc");
        check_range(read.dimension == 2 || read.dimension == 3, "desc.dimension", read.dimension, "2 or 3");
        check_range(read.obstacle_count >= 1 && read.obstacle_count <= ObstacleSet::max_count, "desc.obstacle_count",
                    read.obstacle_count, "1 to 256");
        require(read.obstacles, "desc.obstacles");
        check_range(read.clearance >= 0 && read.clearance <= 1e30, "desc.clearance", read.clearance, "0 to 1e30");
        Submission submission(self, read.job);
        const auto held = self.make(self.obstacles, read.dimension);
        held->origin = read_origin_in(read.dimension, read.origin, "desc.origin");
        held->clearance = read.clearance;
        for (uint32_t i = 0; i < read.obstacle_count; ++i) {
            try {
                const FlgObstacle obstacle = read_element(read.obstacles, i, default_obstacle(), "obstacle");
                held->solids.push_back(make_obstacle(memory, obstacle, read.dimension));
                if (!held->solids.back()) read_mesh(self, obstacle, i, *held, submission);
            } catch (const Failure& failure) {
                throw Failure(failure.result(), "desc.obstacles[%u]: %.200s", i, failure.what());
            }
        }
        submission.job().strand.start(make_obstacles(submission.pace(), held));
        *out_obstacles = {submission.commit(self.obstacles, held, out_job)};
    });
}

FlgResult flgObstaclesRelease(FlgContext context, FlgObstacles obstacles) {
    return release(context, &Context::obstacles, obstacles, "obstacles");
}

}  // extern "C"
