// SPDX-License-Identifier: MIT
// Splines that keep out of solids, after figures 12 to 15 of Hofer, Pottmann: Energy-minimizing splines in manifolds
// (2004), on shapes made here.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/pictures.h"
#include "gallery/spline_forms.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

FlgObstacle ball(const glm::dvec3& centre, double radius) {
    FlgObstacle obstacle = flgObstacleDefaults();
    obstacle.kind = FLG_OBSTACLE_KIND_BALL;
    obstacle.radius = radius;
    for (int c = 0; c < 3; ++c) obstacle.centre[c] = centre[c];
    return obstacle;
}

FlgObstacle box(const glm::dvec3& centre, const glm::dvec3& half) {
    FlgObstacle obstacle = flgObstacleDefaults();
    obstacle.kind = FLG_OBSTACLE_KIND_BOX;
    for (int c = 0; c < 3; ++c) obstacle.centre[c] = centre[c], obstacle.half[c] = half[c];
    return obstacle;
}

FlgObstacle capsule(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    FlgObstacle obstacle = ball(from, radius);
    obstacle.kind = FLG_OBSTACLE_KIND_CAPSULE;
    for (int c = 0; c < 3; ++c) obstacle.to[c] = to[c];
    return obstacle;
}

FlgObstacle solid_of(const filigree::Surface& surface) {
    FlgObstacle obstacle = flgObstacleDefaults();
    obstacle.kind = FLG_OBSTACLE_KIND_MESH;
    obstacle.surface = surface.get();
    obstacle.cells = 128;
    return obstacle;
}

glm::dvec3 place(const double* p) {
    return {p[0], p[1], p[2]};
}

// As it is, in space.
void show(Workshop& workshop, Stage& stage, const FlgObstacle& obstacle, const glm::vec3& color) {
    const glm::dvec3 centre = place(obstacle.centre);
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX) {
        stage.surface(surface_of(workshop, box_mesh(centre, place(obstacle.half))), color, true);
    } else {
        const glm::dvec3 to = obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE ? place(obstacle.to) : centre;
        stage.surface(surface_of(workshop, capsule_mesh(centre, to, obstacle.radius)), color);
    }
}

void show(Stage& stage, const Points& nodes, const filigree::Spline& curve, const Points& given, const glm::vec3& color,
          float radius) {
    stage.curve(nodes, color, radius, curve.view().closed != 0);
    stage.dots(given, kPearl, 1.8f * radius);
}

// ---- Fig. 12

void among(Workshop& workshop, Studio& studio) {
    constexpr double kThick = 0.013;
    std::vector<FlgObstacle> list;
    for (int i = 0; i < 4; ++i) {
        const double x = -0.66 + 0.44 * i;
        for (const double z : {-0.28, 0.28}) list.push_back(capsule({x, 0.0, z}, {x, 0.55, z}, 0.075));
        list.push_back(i % 2 == 0 ? box({x, 0.66, 0.0}, {0.09, 0.05, 0.40}) : ball({x, 0.24, 0.0}, 0.16));
    }
    const filigree::Obstacles obstacles = obstacles_of(workshop, list, 3, kThick);
    const filigree::Manifold manifold = space(workshop, 3);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    desc.obstacles = obstacles.get();
    Stage stage(workshop, {-0.45f, -0.42f, -1.0f});
    const auto draw = [&](const Points& points, const glm::vec3& color) {
        const filigree::Spline curve = spline(workshop, points, desc);
        show(stage, nodes_of(curve), curve, given_of(curve), color, static_cast<float>(kThick));
    };
    draw({{-1.0, 0.30, 0.45}, {-0.44, 0.30, -0.42}, {0.0, 0.35, 0.46}, {0.44, 0.30, -0.42}, {1.0, 0.30, 0.40}}, kRed);
    draw({{-1.0, 0.12, 0.0}, {0.0, 0.50, 0.0}, {1.0, 0.20, 0.0}}, kGold);
    draw({{-0.95, 0.62, -0.40}, {-0.30, 0.40, 0.10}, {0.46, 0.85, 0.0}, {0.95, 0.45, 0.10}}, kBlue);
    for (const FlgObstacle& obstacle : list)
        show(workshop, stage, obstacle,
             obstacle.kind == FLG_OBSTACLE_KIND_BALL  ? kClay
             : obstacle.kind == FLG_OBSTACLE_KIND_BOX ? kSand
                                                      : kSlate);
    studio.take("spline_obstacles", {&stage.panel, 1}, 1, kWidth, 560);
}

// ---- Fig. 13 and 14: in the plane

// Distances of discs and boxes, negative inside.
double distance(const FlgObstacle& obstacle, const glm::dvec2& p) {
    const glm::dvec2 from = p - glm::dvec2(obstacle.centre[0], obstacle.centre[1]);
    if (obstacle.kind == FLG_OBSTACLE_KIND_BALL) return glm::length(from) - obstacle.radius;
    const glm::dvec2 beyond = glm::abs(from) - glm::dvec2(obstacle.half[0], obstacle.half[1]);
    return glm::length(glm::max(beyond, 0.0)) + std::min(std::max(beyond.x, beyond.y), 0.0);
}

double distance(const std::vector<FlgObstacle>& list, const glm::dvec2& p) {
    double least = 1e9;
    for (const FlgObstacle& obstacle : list) least = std::min(least, distance(obstacle, p));
    return least;
}

// How high a barrier of this radius is over a free place: 1 - z / r is the root of the product of 1 - (1 - d / r)^2.
double barrier(const std::vector<FlgObstacle>& list, double radius, const glm::dvec2& p) {
    double product = 1;
    for (const FlgObstacle& obstacle : list) {
        const double a = std::clamp(1 - distance(obstacle, p) / radius, 0.0, 1.0);
        product *= 1 - a * a;
    }
    return radius * (1 - std::sqrt(product));
}

// The free plane in a rectangle, at the heights of a barrier. Corners in an obstacle come to its border.
filigree::Surface free_plane(Workshop& workshop, const std::vector<FlgObstacle>& list, double radius,
                             const glm::dvec2& low, const glm::dvec2& high) {
    constexpr uint32_t kColumns = 620;
    constexpr double kBit = 1e-4;
    const auto rows = static_cast<uint32_t>(kColumns * (high.y - low.y) / (high.x - low.x));
    std::vector<bool> inside;
    scenes::Mesh mesh = sheet(kColumns, rows, false, [&](double u, double v) {
        glm::dvec2 p = glm::mix(low, high, glm::dvec2(u, v));
        const double d = distance(list, p);
        inside.push_back(d < 0);
        if (d < 0) {
            const glm::dvec2 slope(distance(list, p + glm::dvec2(kBit, 0.0)) - d,
                                   distance(list, p + glm::dvec2(0.0, kBit)) - d);
            p -= d / kBit * slope;
        }
        return laid({p, barrier(list, radius, p)});
    });
    std::erase_if(mesh.triangles, [&](const auto& t) { return inside[t[0]] && inside[t[1]] && inside[t[2]]; });
    return surface_of(workshop, mesh);
}

// A solid of the plane, standing this high.
void stand(Workshop& workshop, Stage& stage, const FlgObstacle& obstacle, double height, const glm::vec3& color) {
    const glm::dvec3 foot = laid({obstacle.centre[0], obstacle.centre[1], 0.0});
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX) {
        stage.surface(surface_of(workshop, box_mesh(foot + glm::dvec3(0.0, height / 2, 0.0),
                                                    {obstacle.half[0], height / 2, obstacle.half[1]})),
                      color, true);
        return;
    }
    const double angle = 2 * std::numbers::pi;
    const auto ring = [&](double u, double radius, double y) {
        return foot + glm::dvec3(radius * std::cos(angle * u), y, -radius * std::sin(angle * u));
    };
    stage.surface(surface_of(workshop, sheet(96, 2, true,
                                             [&](double u, double v) { return ring(u, obstacle.radius, height * v); })),
                  color);
    stage.surface(
        surface_of(
            workshop,
            sheet(96, 2, true, [&](double u, double v) { return ring(u, obstacle.radius * (1 - 0.999 * v), height); })),
        color);
}

void barriers(Workshop& workshop, Studio& studio) {
    const glm::dvec2 low(-1.0, -0.73), high(1.0, 0.66);
    const std::vector<FlgObstacle> list = {ball({-0.42, 0.18, 0.0}, 0.20), box({0.12, -0.24, 0.0}, {0.12, 0.26, 1.0}),
                                           ball({0.58, 0.28, 0.0}, 0.20)};
    const filigree::Obstacles obstacles = obstacles_of(workshop, list, 2);
    const filigree::Manifold manifold = space(workshop, 2);
    const Points points = {{-0.92, -0.10, 0.0}, {-0.10, 0.28, 0.0}, {0.34, 0.02, 0.0}, {0.92, -0.05, 0.0}};
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    desc.obstacles = obstacles.get();
    // The diameter of all that there is, whose share the radius is.
    const double size = glm::length(glm::dvec2(1.84, 0.98));
    std::deque<Stage> stages;
    std::deque<std::vector<float>> fields;
    for (const double radius : {0.20, 0.10, 0.03}) {
        desc.obstacle_radius = radius / size;
        const filigree::Spline curve = spline(workshop, points, desc);
        const auto lifted = [&](Points all) {
            for (glm::dvec3& p : all) p = laid({p.x, p.y, barrier(list, radius, glm::dvec2(p)) + 0.006});
            return all;
        };
        Stage& stage = stages.emplace_back(workshop, glm::vec3(0.12f, -0.68f, -1.0f));
        show(stage, lifted(nodes_of(curve)), curve, lifted(given_of(curve)), kRed, 0.012f);
        filigree::Surface free = free_plane(workshop, list, radius, low, high);
        std::vector<float>& heights = fields.emplace_back();
        const FlgMeshView& mesh = free.view().mesh;
        for (uint32_t i = 0; i < mesh.vertex_count; ++i) heights.push_back(samples::value_at(mesh.columns[0], i)[1]);
        stage.surface(std::move(free), heights, 0.02f);
        for (const FlgObstacle& obstacle : list) stand(workshop, stage, obstacle, radius, kSlate);
        stage.panel.ground = false;
        for (const float x : {-0.95f, 0.95f}) {
            for (const float z : {-0.50f, 0.40f}) stage.panel.aim.emplace_back(x, 0.1f, z);
        }
        stage.panel.margin = 1.0f;
    }
    desc.obstacle_radius = flgSplineDefaults().obstacle_radius;
    const filigree::Spline curve = spline(workshop, points, desc);
    Stage& flat = stages.emplace_back(workshop, glm::vec3(0.0f, -1.0f, -0.02f));
    show(flat, laid(nodes_of(curve)), curve, laid(given_of(curve)), kRed, 0.012f);
    flat.surface(free_plane(workshop, list, 1e-6, low, high), kSand);
    for (const FlgObstacle& obstacle : list) stand(workshop, flat, obstacle, 0.02, kSlate);
    flat.panel.ground = false;
    std::vector<Panel> panels;
    for (const Stage& stage : stages) panels.push_back(stage.panel);
    entitle(panels, {"A wide barrier", "A narrower one", "Narrower still", "The plane that is left"});
    studio.take("spline_barriers", panels, 2, kWidth, 640);
}

void first_curves(Workshop& workshop, Studio& studio) {
    const glm::dvec2 low(-1.0, -0.75), high(1.0, 0.95);
    constexpr float kTube = 0.013f;
    const filigree::Manifold manifold = space(workshop, 2);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    const glm::vec3 above(0.0f, -1.0f, -0.02f);
    Stage left(workshop, above), right(workshop, above);

    // Distances from the first point, and the shortest way back from the second.
    const std::vector<FlgObstacle> list = {box({-0.42, 0.33, 0.0}, {0.12, 0.46, 1.0}),
                                           box({0.26, -0.17, 0.0}, {0.13, 0.44, 1.0}), ball({0.62, 0.58, 0.0}, 0.16)};
    const filigree::Obstacles obstacles = obstacles_of(workshop, list, 2, kTube);
    filigree::Surface plane = free_plane(workshop, list, 1e-6, low, high);
    const glm::dvec3 begin(-0.82, 0.40, 0.0), end(0.82, -0.30, 0.0);
    const FlgMeshView& mesh = plane.view().mesh;
    uint32_t source = 0;
    double least = 1e9;
    for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
        const float* const p = samples::value_at(mesh.columns[0], i);
        const double d = glm::distance(glm::dvec3(p[0], p[1], p[2]), laid(begin));
        if (d < least) least = d, source = i;
    }
    FlgFieldGeodesicDesc geodesic = flgFieldGeodesicDefaults();
    geodesic.surface = plane.get();
    geodesic.vertices = &source;
    geodesic.vertex_count = 1;
    const filigree::Field field = workshop.finished(workshop.context().field_geodesic(geodesic));
    const FlgFieldView distances = field.view();
    left.surface(std::move(plane), {distances.values, distances.vertex_count}, 0.08f);
    desc.obstacles = obstacles.get();
    desc.energy = FLG_SPLINE_ENERGY_E1;
    const Points ends = {begin, end};
    const filigree::Spline shortest = spline(workshop, ends, desc);
    desc.energy = FLG_SPLINE_ENERGY_E2;
    const filigree::Spline smooth = spline(workshop, ends, desc);
    left.curve(laid(nodes_of(smooth)), kGold, kTube);
    show(left, laid(nodes_of(shortest)), shortest, laid(given_of(shortest)), kRed, kTube);
    for (const FlgObstacle& obstacle : list) stand(workshop, left, obstacle, 0.03, kSlate);

    // Through a tunnel, or over the block above it.
    const std::vector<FlgObstacle> blocks = {box({0.0, 0.31, 0.0}, {0.26, 0.29, 1.0}),
                                             box({0.0, -0.36, 0.0}, {0.26, 0.28, 1.0})};
    const filigree::Obstacles walls = obstacles_of(workshop, blocks, 2, kTube);
    desc.obstacles = walls.get();
    FlgObstacleSide side = {};
    desc.sides = &side;
    desc.side_count = 1;
    for (const double up : {-1.0, 1.0}) {
        side.direction[1] = up;
        const filigree::Spline curve =
            spline(workshop, {{-0.78, -0.45, 0.0}, {-0.55, 0.18, 0.0}, {0.55, 0.18, 0.0}, {0.78, -0.45, 0.0}}, desc);
        show(right, laid(nodes_of(curve)), curve, laid(given_of(curve)), up < 0 ? kRed : kBlue, kTube);
    }
    right.surface(free_plane(workshop, blocks, 1e-6, low, high), kSand);
    for (const FlgObstacle& obstacle : blocks) stand(workshop, right, obstacle, 0.03, kSlate);
    std::vector<Panel> panels = {left.panel, right.panel};
    for (Panel& panel : panels) panel.ground = false, panel.margin = 1.02f;
    entitle(panels, {"Distances, the first curve, the spline", "Through the tunnel, or over the block"});
    studio.take("spline_ways", panels, 2, kWidth, 410);
}

// ---- Fig. 15

void solids(Workshop& workshop, Studio& studio) {
    constexpr double kThick = 0.014;
    filigree::Surface figure = cat(workshop);
    const auto ring = [](const glm::dvec3& p) {
        return std::hypot(std::hypot(p.x + 0.62, p.y - 0.34) - 0.26, p.z - 0.10) - 0.075;
    };
    Solid hoop = solid(workshop, 1.0, 150, ring);
    const auto stone = [](const glm::dvec3& p) {
        const glm::dvec3 q = (p - glm::dvec3(0.30, 0.17, 0.72)) / glm::dvec3(0.26, 0.17, 0.18);
        const glm::dvec3 s = q * q;
        return s.x * s.x + s.y * s.y + s.z * s.z - 1;
    };
    Solid block = solid(workshop, 1.0, 150, stone);
    const FlgObstacle list[] = {solid_of(figure), solid_of(hoop.surface), solid_of(block.surface)};
    const filigree::Obstacles obstacles = obstacles_of(workshop, list, 3, kThick);
    const filigree::Manifold manifold = space(workshop, 3);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    desc.obstacles = obstacles.get();
    desc.closed = 1;
    // Through the hoop, under the belly, around the stone, over the back.
    const Points points = {{-0.62, 0.34, 0.10}, {-0.30, 0.12, -0.22}, {0.25, 0.09, 0.15},
                           {0.62, 0.16, 0.66},  {0.20, 0.40, 0.80},   {0.22, 0.46, 0.12},
                           {0.10, 0.55, -0.30}, {-0.42, 0.75, -0.10}, {-0.72, 0.55, 0.45}};
    const filigree::Spline curve = spline(workshop, points, desc);
    Stage stage(workshop, {-0.40f, -0.42f, -1.0f});
    show(stage, nodes_of(curve), curve, given_of(curve), kRed, static_cast<float>(kThick));
    stage.surface(std::move(figure), kSlate);
    stage.surface(std::move(hoop.surface), kSand);
    stage.surface(std::move(block.surface), kClay);
    studio.take("spline_solids", {&stage.panel, 1}, 1, kWidth, 600);
}

constexpr Picture kPictures[] = {
    {"spline_obstacles", "Fig. 12: splines among obstacles in space", true, among},
    {"spline_barriers", "Fig. 13: barriers of falling radius, and the spline of the plane", true, barriers},
    {"spline_ways", "Fig. 14: the first curve down a distance, and a tunnel or the way around", true, first_curves},
    {"spline_solids", "Fig. 15: one spline that avoids solids", true, solids},
};

}  // namespace

std::span<const Picture> obstacle_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
