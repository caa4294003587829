// SPDX-License-Identifier: MIT
#include "gallery/sketch.h"

#include "gallery/marks.h"

namespace flg::gallery {
namespace {

// From stroke to stroke, of the unit.
constexpr double kAbove = 0.02;

}  // namespace

void Sketch::add(const std::vector<scenes::Curve>& curves, glm::vec3 color, double radius) {
    if (curves.empty()) return;
    sets_.push_back(workshop_.curves(curves));
    render::CurveLook look = tube(color, static_cast<float>(radius));
    look.casts_shadow = false;
    look.gloss = 0.0f;
    layers_.push_back({Columns(sets_.back().view()).without(FLG_ATTRIBUTE_COLOR), look});
    height_ += static_cast<float>(unit_ * kAbove);
}

void Sketch::lines(std::span<const Line> list, glm::vec3 color, double width) {
    std::vector<scenes::Curve> curves;
    for (const Line& from : list) {
        scenes::Curve& to = curves.emplace_back();
        for (const glm::dvec2& p : from) to.points.push_back(to_point({p.x, p.y, height_}));
    }
    add(curves, color, 0.5 * width * unit_);
}

void Sketch::ring(Line points, glm::vec3 color, double width) {
    points.push_back(points.front());
    line(points, color, width);
}

void Sketch::dots(std::span<const glm::dvec2> places, glm::vec3 color, double width) {
    std::vector<scenes::Curve> curves;
    for (const glm::dvec2& p : places) curves.push_back(dot({p.x, p.y, height_}));
    add(curves, color, 0.5 * width * unit_);
}

void Sketch::cone(glm::dvec2 from, double from_radius, glm::dvec2 to, double to_radius, glm::vec3 color) {
    scenes::Curve curve;
    constexpr int kSteps = 24;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        const glm::dvec2 p = from + t * (to - from);
        curve.points.push_back(to_point({p.x, p.y, 0.0f}));
        curve.radii.push_back(static_cast<float>(from_radius + t * (to_radius - from_radius)));
    }
    sets_.push_back(workshop_.curve(curve));
    render::CurveLook look = body();
    look.color = look.color_end = color;
    look.caps = render::Caps::round;
    bodies_.push_back({Columns(sets_.back().view()).without(FLG_ATTRIBUTE_COLOR), look});
    in_front_ = true;
}

Sketch::Fill& Sketch::add(const FlgPartMeshView& body, glm::vec3 color) {
    Fill& fill = fills_.emplace_back();
    fill.positions.assign(body.positions, body.positions + size_t{3} * body.vertex_count);
    fill.column = {FLG_ATTRIBUTE_POSITION, 3, fill.positions.data(), 0, 0};
    fill.color = color;
    return fill;
}

void Sketch::fill(const FlgPartMeshView& body, glm::vec3 color) {
    constexpr double kBelow = 3.0;  // units: no line reaches down to it
    Fill& fill = add(body, color);
    for (size_t i = 2; i < fill.positions.size(); i += 3) fill.positions[i] = static_cast<float>(-kBelow * unit_);
    const auto at = [&](uint32_t vertex) {
        return glm::vec2(body.positions[3 * size_t{vertex}], body.positions[3 * size_t{vertex} + 1]);
    };
    for (size_t i = 0; i < body.triangle_count; ++i) {
        const uint32_t* const t = body.triangles + 3 * i;
        const glm::vec2 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]);
        if (a.x * b.y - a.y * b.x > 0.0f) fill.triangles.insert(fill.triangles.end(), t, t + 3);  // the upper side
    }
}

void Sketch::stand(const FlgPartMeshView& body, glm::vec3 color) {
    add(body, color).triangles.assign(body.triangles, body.triangles + size_t{3} * body.triangle_count);
    in_front_ = true;
    sight_ = {-0.35f, 0.45f, -1.0f};
}

Panel Sketch::panel(float margin) const {
    Panel panel;
    panel.layers = bodies_;
    for (Layer layer : layers_) {
        layer.look.in_front = in_front_;
        panel.layers.push_back(std::move(layer));
    }
    for (const Fill& fill : fills_) {
        SurfaceLayer layer{flgMeshViewDefaults(), {}};
        layer.mesh.vertex_count = static_cast<uint32_t>(fill.positions.size() / 3);
        layer.mesh.columns = &fill.column;
        layer.mesh.column_count = 1;
        layer.mesh.triangles = fill.triangles.data();
        layer.mesh.triangle_count = static_cast<uint32_t>(fill.triangles.size() / 3);
        layer.look.material = {fill.color, 0.0f, 1.0f};
        layer.look.casts_shadow = false;
        panel.surfaces.push_back(layer);
    }
    panel.sight = sight_;
    panel.margin = margin;
    panel.ground = false;
    return panel;
}

}  // namespace flg::gallery
