// SPDX-License-Identifier: MIT
// The surfaces that points lie on: what a ray meets there, and the manifold that the SDK keeps curves on. Manifolds of
// meshes are made once a mesh and revision.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "shell/workspace.h"
#include "splines/model.h"
#include "splines/shapes.h"

namespace flg::studio::splines {

class SurfaceLookup {
public:
    explicit SurfaceLookup(AppContext& app) : app_(app) {}

    // Points of curves lie in the space of what they are on: that of a mesh, else the world.
    render::Placement placement(const SurfaceRef& ground) const;
    glm::dvec3 to_world(const SurfaceRef& ground, const glm::dvec3& own) const;
    glm::dvec3 to_own(const SurfaceRef& ground, const glm::dvec3& world) const;
    // Whether what is on it is shown: not on a mesh that is hidden or gone.
    bool is_seen(const SurfaceRef& ground) const;

    // The ground's own place under a ray, none where something else is nearer or it isn't met. In space: of the plane
    // that faces the viewer through `anchor`.
    std::optional<Place> meet(const SurfaceRef& ground, const Ray& ray, const glm::dvec3& anchor) const;
    // The same for what is being dragged: where the ray misses, the ground's place near to it.
    std::optional<Place> follow(const SurfaceRef& ground, const Ray& ray, const glm::dvec3& anchor) const;
    // Up, of a body that stands there.
    glm::dvec3 normal(const SurfaceRef& ground, const glm::dvec3& position) const;
    // Whether a place lies behind a surface that is shown; `slack` metres in front of it do not count.
    bool hidden(const glm::dvec3& position, double slack) const;

    struct Surface {
        FlgManifold manifold{};
        FlgSurface mesh{};      // with open borders; else null
        bool is_shape = false;  // in the shape's coordinates (to_shape)
        bool is_space = false;
        bool is_inside_out = false;  // what the SDK calls outwards leads in
        render::Placement placement{};
    };
    // None while there is none: its mesh is gone, or is being changed.
    std::optional<Surface> surface(const SurfaceRef& ground);
    // "Cat", "Space", "A torus".
    std::string title(const SurfaceRef& ground) const;
    bool exists(const SurfaceRef& ground) const;

    // The scene's size, by which new things are sized, metres.
    double size() const;

    // Shows the shapes that are on the ground of something, and no others.
    void show(const std::vector<std::string>& kinds);
    void device_lost();

private:
    struct Smooth {
        uint32_t revision = 0, generation = 0;
        filigree::Manifold manifold;
        bool is_inside_out = false;
    };
    struct Shown {
        render::SurfaceId id{};
        ShapeMesh mesh;
    };
    std::optional<Place> met_mesh(uint32_t id, const Ray& ray) const;
    void upload(Shown& shown);

    AppContext& app_;
    std::map<uint32_t, Smooth> meshes_;
    std::map<std::string, filigree::Manifold, std::less<>> shapes_;
    std::map<std::string, Shown, std::less<>> shown_;
};

}  // namespace flg::studio::splines
