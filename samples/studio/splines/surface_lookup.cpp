// SPDX-License-Identifier: MIT
#include "splines/surface_lookup.h"

#include <algorithm>

#include "support/curve_source.h"

namespace flg::studio::splines {
namespace {

constexpr glm::vec3 kShapeColor{0.115f, 0.165f, 0.215f};

// By the volume that its triangles enclose, or would with a lid.
bool is_inside_out(const FlgMeshView& mesh) {
    const FlgColumn* column = mesh.columns;
    while (column->attribute != FLG_ATTRIBUTE_POSITION) ++column;
    const auto corner = [&](size_t i) {
        const float* const p = samples::value_at(*column, mesh.triangles[i]);
        return glm::dvec3(p[0], p[1], p[2]);
    };
    const glm::dvec3 from = corner(0);
    double volume = 0.0;
    for (size_t i = 0; i < size_t{3} * mesh.triangle_count; i += 3)
        volume += glm::dot(corner(i) - from, glm::cross(corner(i + 1) - from, corner(i + 2) - from));
    return volume < 0.0;
}

}  // namespace

render::Placement SurfaceLookup::placement(const SurfaceRef& ground) const {
    const SceneMesh* const mesh = ground.kind == "mesh" ? app_.scene.find(ground.mesh) : nullptr;
    return mesh != nullptr ? mesh->placement : render::Placement{};
}

glm::dvec3 SurfaceLookup::to_world(const SurfaceRef& ground, const glm::dvec3& own) const {
    const render::Placement p = placement(ground);
    return p.is_identity() ? own : glm::dvec3(p.at) + static_cast<double>(p.scale) * (glm::dquat(p.turn) * own);
}

glm::dvec3 SurfaceLookup::to_own(const SurfaceRef& ground, const glm::dvec3& world) const {
    const render::Placement p = placement(ground);
    if (p.is_identity()) return world;
    return glm::conjugate(glm::dquat(p.turn)) * (world - glm::dvec3(p.at)) / static_cast<double>(p.scale);
}

bool SurfaceLookup::is_seen(const SurfaceRef& ground) const {
    if (ground.kind != "mesh") return true;
    const SceneMesh* const mesh = app_.scene.find(ground.mesh);
    return mesh != nullptr && mesh->visible;
}

std::optional<Place> SurfaceLookup::met_mesh(uint32_t id, const Ray& ray) const {
    const auto hit = app_.scene.hit(ray);
    if (!hit || hit->mesh->id != id) return std::nullopt;
    // What is seen is outside.
    const glm::vec3 normal = hit->normal();
    return Place{hit->position(), glm::dot(normal, ray.direction) > 0.0f ? -normal : normal};
}

std::optional<Place> SurfaceLookup::meet(const SurfaceRef& ground, const Ray& ray, const glm::dvec3& anchor) const {
    if (ground.kind == "mesh") return met_mesh(ground.mesh, ray);
    if (const Shape* const shape = find_shape(ground.kind)) return splines::meet(*shape, ray);
    const render::Camera& camera = app_.view.orbit.camera;
    const glm::vec3 towards = glm::normalize(camera.eye - camera.target);
    const auto at = meet_plane(ray, glm::vec3(anchor), towards);
    if (!at) return std::nullopt;
    return Place{*at, towards};
}

std::optional<Place> SurfaceLookup::follow(const SurfaceRef& ground, const Ray& ray, const glm::dvec3& anchor) const {
    if (auto met = meet(ground, ray, anchor)) return met;
    const auto beside = meet({"space", 0}, ray, anchor);
    if (!beside) return std::nullopt;
    if (const Shape* const shape = find_shape(ground.kind)) return nearest(*shape, beside->position);
    const SceneMesh* const mesh = app_.scene.find(ground.mesh);
    if (mesh == nullptr || !mesh->ready) return std::nullopt;
    const auto hit = app_.scene.nearest(*mesh, glm::vec3(beside->position));
    if (!hit) return std::nullopt;
    return Place{hit->position(), hit->normal()};
}

glm::dvec3 SurfaceLookup::normal(const SurfaceRef& ground, const glm::dvec3& position) const {
    if (const Shape* const shape = find_shape(ground.kind)) {
        if (const auto place = nearest(*shape, position)) return place->normal;
    } else if (const SceneMesh* const mesh = app_.scene.find(ground.mesh); mesh != nullptr && mesh->ready) {
        const auto smooth = meshes_.find(mesh->id);
        const float sign = smooth != meshes_.end() && smooth->second.is_inside_out ? -1.0f : 1.0f;
        if (const auto hit = app_.scene.nearest(*mesh, glm::vec3(position))) return sign * hit->normal();
    }
    return {0.0, 1.0, 0.0};
}

bool SurfaceLookup::hidden(const glm::dvec3& position, double slack) const {
    const glm::vec3 eye = app_.view.orbit.camera.eye;
    const glm::dvec3 way = position - glm::dvec3(eye);
    const double distance = glm::length(way);
    if (!(distance > slack)) return false;
    const Ray ray{eye, glm::vec3(way / distance)};
    if (const auto hit = app_.scene.hit(ray);
        hit && glm::distance(glm::dvec3(hit->position()), glm::dvec3(eye)) < distance - slack)
        return true;
    return std::any_of(shown_.begin(), shown_.end(), [&](const auto& shown) {
        const auto met = splines::meet(*find_shape(shown.first), ray);
        return met && glm::distance(met->position, glm::dvec3(eye)) < distance - slack;
    });
}

std::optional<SurfaceLookup::Surface> SurfaceLookup::surface(const SurfaceRef& ground) {
    Surface out;
    if (ground.kind != "mesh") {
        const Shape* const shape = find_shape(ground.kind);
        filigree::Manifold& manifold = shapes_[ground.kind];
        if (!manifold)
            manifold = app_.context.manifold_shape(shape != nullptr ? shape->desc() : flgManifoldShapeDefaults());
        out.manifold = manifold.get();
        out.is_shape = shape != nullptr;
        out.is_space = shape == nullptr;
        return out;
    }
    SceneMesh* const mesh = app_.scene.find(ground.mesh);
    if (mesh == nullptr) {
        meshes_.erase(ground.mesh);
        return std::nullopt;
    }
    // A step of its ornament may have begun in this frame.
    FlgSurfaceView view = flgSurfaceViewDefaults();
    if (!mesh->ready || flgSurfaceGetView(app_.context.get(), mesh->surface.get(), &view) != FLG_OK)
        return std::nullopt;
    Smooth& smooth = meshes_[mesh->id];
    if (!smooth.manifold || smooth.revision != view.revision || smooth.generation != mesh->generation) {
        FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
        desc.surface = mesh->surface.get();
        filigree::Job job;
        smooth.manifold = app_.context.manifold_from_surface(desc, &job);
        smooth.revision = view.revision;
        smooth.generation = mesh->generation;
        smooth.is_inside_out = is_inside_out(*view.mesh);
        app_.jobs.add("Smoothing " + mesh->name, std::move(job));
    }
    out.manifold = smooth.manifold.get();
    out.is_inside_out = smooth.is_inside_out;
    out.placement = mesh->placement;
    if (mesh->surface.report().border_count > 0) out.mesh = mesh->surface.get();
    return out;
}

std::string SurfaceLookup::title(const SurfaceRef& ground) const {
    if (ground.kind == "space") return "Space";
    if (const Shape* const shape = find_shape(ground.kind)) return shape->title;
    const SceneMesh* const mesh = app_.scene.find(ground.mesh);
    return mesh != nullptr ? mesh->name : "a removed mesh";
}

bool SurfaceLookup::exists(const SurfaceRef& ground) const {
    return ground.kind != "mesh" || app_.scene.find(ground.mesh) != nullptr;
}

double SurfaceLookup::size() const {
    render::Box box = app_.scene.box();
    for (const auto& [name, shown] : shown_) {
        const auto half = static_cast<float>(0.7 * find_shape(name)->half);
        box.add({glm::vec3(-half), glm::vec3(half)});
    }
    constexpr double kDiagonal = 1.7;  // of a box as long as it is high and wide
    return box.empty() || !(box.diagonal() > 0.0f) ? 1.0 : static_cast<double>(box.diagonal()) / kDiagonal;
}

void SurfaceLookup::upload(Shown& shown) {
    const ShapeMesh& mesh = shown.mesh;
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &mesh.positions[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, &mesh.normals[0].x, 0, 0}};
    FlgMeshView view = flgMeshViewDefaults();
    view.vertex_count = static_cast<uint32_t>(mesh.positions.size());
    view.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
    view.column_count = 2;
    view.columns = columns;
    view.triangles = mesh.triangles.data();
    render::SurfaceLook look;
    look.material = {kShapeColor, 0.0f, 0.6f};
    shown.id = app_.renderer.upload(view, look);
}

void SurfaceLookup::show(const std::vector<std::string>& kinds) {
    std::erase_if(shown_, [&](const auto& shown) {
        if (std::find(kinds.begin(), kinds.end(), shown.first) != kinds.end()) return false;
        app_.renderer.remove(shown.second.id);
        return true;
    });
    for (const std::string& kind : kinds) {
        const Shape* const shape = find_shape(kind);
        if (shape == nullptr || shown_.contains(kind)) continue;
        Shown& shown = shown_[kind];
        shown.mesh = mesh_of(*shape);
        upload(shown);
    }
}

void SurfaceLookup::device_lost() {
    for (auto& [name, shown] : shown_) upload(shown);
}

}  // namespace flg::studio::splines
