// SPDX-License-Identifier: MIT
// Surfaces that need no mesh: those the SDK knows exactly, with what it takes to draw and to hit them. They lie around
// the origin, their z axis is the world's y axis.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "filigree/filigree_spline.h"
#include "shell/view.h"

namespace flg::studio::splines {

struct Shape {
    const char* name;                               // in documents
    const char* title;                              // "Tangle cube"
    double half;                                    // of a cube with all of it, metres
    double (*value)(double x, double y, double z);  // negative inside, in the shape's own coordinates
    FlgManifoldShapeDesc (*desc)();
};

std::span<const Shape> shapes();
const Shape* find_shape(std::string_view name);

// Between the world's coordinates and a shape's.
inline glm::dvec3 to_shape(const glm::dvec3& world) {
    return {world.x, -world.z, world.y};
}
inline glm::dvec3 to_world(const glm::dvec3& own) {
    return {own.x, own.z, -own.y};
}

struct Place {
    glm::dvec3 position, normal;  // of the world; unit length, outwards
};

// Where a ray meets it first, to a millionth of its size.
std::optional<Place> meet(const Shape& shape, const Ray& ray);
// The place near a point, by steps down the gradient; none where that leads nowhere.
std::optional<Place> nearest(const Shape& shape, const glm::dvec3& world);

struct ShapeMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<uint32_t> triangles;
};
// By a vertex in each cell that the surface goes through (Gibson 1998). Takes some milliseconds.
ShapeMesh mesh_of(const Shape& shape);

}  // namespace flg::studio::splines
