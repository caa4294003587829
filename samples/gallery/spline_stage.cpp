// SPDX-License-Identifier: MIT
#include "gallery/spline_stage.h"

#include "gallery/looks.h"
#include "gallery/marks.h"

namespace flg::gallery {
namespace {

scenes::Curve curve_of(const Points& points, bool closed) {
    scenes::Curve curve;
    for (const glm::dvec3& p : points) curve.points.push_back(to_point(glm::vec3(p)));
    curve.closed = closed;
    return curve;
}

}  // namespace

Stage::Stage(Workshop& workshop, const glm::vec3& sight) : workshop_(workshop) {
    panel.sight = sight;
    panel.margin = 1.06f;
}

void Stage::surface(filigree::Surface surface, const glm::vec3& color, bool flat) {
    render::SurfaceLook look;
    look.smooth = !flat;
    look.material = {color, 0.0f, 0.75f};
    surfaces_.push_back(std::move(surface));
    panel.surfaces.push_back({surfaces_.back().view().mesh, look, {}});
}

void Stage::surface(filigree::Surface surface, std::span<const float> field, float isoline_spacing) {
    render::SurfaceLook look;
    look.isoline_spacing = isoline_spacing;
    look.isoline_color = {1.0f, 1.0f, 1.0f};
    surfaces_.push_back(std::move(surface));
    panel.surfaces.push_back({surfaces_.back().view().mesh, look, field});
}

void Stage::add(const std::vector<scenes::Curve>& curves, const render::CurveLook& look) {
    curves_.push_back(workshop_.curves(curves));
    panel.layers.push_back(shape_of(curves_.back().view(), look));
}

void Stage::curve(const Points& points, const glm::vec3& color, float radius, bool closed) {
    add({curve_of(points, closed)}, tube(color, radius));
}

void Stage::lines(const std::vector<Points>& lines, const glm::vec3& color, float radius) {
    std::vector<scenes::Curve> curves;
    for (const Points& line : lines) curves.push_back(curve_of(line, false));
    add(curves, tube(color, radius));
}

void Stage::dots(const Points& points, const glm::vec3& color, float radius) {
    std::vector<scenes::Curve> balls;
    for (const glm::dvec3& p : points) balls.push_back(dot(glm::vec3(p)));
    add(balls, tube(color, radius));
}

filigree::Spline spline(Workshop& workshop, const Points& points, FlgSplineDesc desc) {
    FlgManifoldView manifold = flgManifoldViewDefaults();
    filigree::check(flgManifoldGetView(workshop.context().get(), desc.manifold, &manifold));
    std::vector<double> numbers;
    for (const glm::dvec3& p : points) {
        for (uint32_t c = 0; c < manifold.ambient; ++c) numbers.push_back(p[static_cast<glm::length_t>(c)]);
    }
    desc.points = numbers.data();
    desc.point_count = static_cast<uint32_t>(points.size());
    return workshop.finished(workshop.context().spline(desc));
}

Points nodes_of(const filigree::Spline& spline, double height) {
    const FlgSplineView view = spline.view();
    Points nodes;
    for (uint32_t i = 0; i < view.node_count; ++i) {
        glm::dvec3 p(0.0);
        for (uint32_t c = 0; c < std::min(view.ambient, 3u); ++c) {
            p[static_cast<glm::length_t>(c)] = view.nodes[size_t{view.ambient} * i + c];
        }
        if (view.normals != nullptr) {
            const float* const n = view.normals + size_t{3} * i;
            p += height * glm::dvec3(n[0], n[1], n[2]);
        }
        nodes.push_back(p);
    }
    return nodes;
}

Points given_of(const filigree::Spline& spline, double height) {
    const FlgSplineView view = spline.view();
    const Points nodes = nodes_of(spline, height);
    Points given;
    for (uint32_t i = 0; i < view.point_count; ++i) given.push_back(nodes[view.point_nodes[i]]);
    return given;
}

glm::dvec3 laid(const glm::dvec3& p) {
    return {p.x, p.z, -p.y};
}

Points laid(Points points) {
    for (glm::dvec3& p : points) p = laid(p);
    return points;
}

filigree::Manifold manifold_of(Workshop& workshop, const filigree::Surface& surface) {
    FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
    desc.surface = surface.get();
    return workshop.finished(workshop.context().manifold_from_surface(desc));
}

filigree::Obstacles obstacles_of(Workshop& workshop, std::span<const FlgObstacle> list, uint32_t dimension,
                                 double clearance) {
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.dimension = dimension;
    desc.obstacles = list.data();
    desc.obstacle_count = static_cast<uint32_t>(list.size());
    desc.clearance = clearance;
    filigree::Obstacles obstacles = workshop.context().obstacles(desc);
    workshop.context().run();
    return obstacles;
}

filigree::Manifold space(Workshop& workshop, uint32_t dimension) {
    FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
    desc.ambient = dimension;
    return workshop.context().manifold_shape(desc);
}

}  // namespace flg::gallery
