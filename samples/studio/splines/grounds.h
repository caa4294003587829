// SPDX-License-Identifier: MIT
// The surfaces that points lie on: what a ray meets there, and the manifold that the SDK keeps curves on. Manifolds of meshes
// are made once a mesh and revision.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "shell/workspace.h"
#include "splines/model.h"
#include "splines/shapes.h"

namespace flg::studio::splines {

class Grounds {
public:
    explicit Grounds(Desk& desk) : desk_(desk) {}

    // The ground's own place under a ray, none where something else is nearer or it isn't met. In space: of the plane that faces
    // the viewer through `anchor`.
    std::optional<Place> meet(const Ground& ground, const Ray& ray, const glm::dvec3& anchor) const;
    // The same for what is being dragged: where the ray misses, the ground's place near to it.
    std::optional<Place> follow(const Ground& ground, const Ray& ray, const glm::dvec3& anchor) const;
    // Up, of a body that stands there.
    glm::dvec3 normal(const Ground& ground, const glm::dvec3& position) const;
    // Whether a place lies behind a surface that is shown; `slack` metres in front of it do not count.
    bool hidden(const glm::dvec3& position, double slack) const;

    struct Surface {
        FlgManifold manifold{};
        FlgSurface mesh{};      // with open borders; else null
        bool is_shape = false;  // in the shape's coordinates (to_shape)
        bool is_space = false;
        bool is_inside_out = false;  // what the SDK calls outwards leads in
    };
    // None while there is none: its mesh is gone, or is being changed.
    std::optional<Surface> surface(const Ground& ground);
    // "Cat", "Space", "A torus".
    std::string title(const Ground& ground) const;
    bool exists(const Ground& ground) const;

    // The scene's size, by which new things are sized, metres.
    double size() const;

    // Shows the shapes that are on the ground of something, and no others.
    void show(const std::vector<std::string>& kinds);
    void device_lost();

private:
    struct Smooth {
        uint32_t revision = 0;
        filigree::Manifold manifold;
        bool is_inside_out = false;
    };
    struct Shown {
        render::SurfaceId id{};
        ShapeMesh mesh;
    };
    std::optional<Place> met_mesh(uint32_t id, const Ray& ray) const;
    void upload(Shown& shown);

    Desk& desk_;
    std::map<uint32_t, Smooth> meshes_;
    std::map<std::string, filigree::Manifold, std::less<>> shapes_;
    std::map<std::string, Shown, std::less<>> shown_;
};

}  // namespace flg::studio::splines
