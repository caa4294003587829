// SPDX-License-Identifier: MIT
// What the scene of a glTF document shows: its primitives, each placed by the nodes above it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "core/origin.h"
#include "io/base/memory.h"
#include "io/gltf/gltf_document.h"

namespace flg::io {

// An affine map: columns x, y, z and translation.
using Transform = std::array<double, 12>;

constexpr Transform identity_transform = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

// a after b.
Transform compose(const Transform& a, const Transform& b);

double determinant(const Transform& transform);

// Translation, rotation (x, y, z, w) and scale, in this order from the left.
struct NodeMotion {
    std::array<double, 3> translation = {0, 0, 0};
    std::array<double, 4> rotation = {0, 0, 0, 1};
    std::array<double, 3> scale = {1, 1, 1};
    Transform transform() const;
};

// Of a node without a `matrix`.
NodeMotion node_motion(const Json& node, const String& place);

// Of any node, to its parent.
Transform local_transform(const Json& node, const String& place);

// A member that lists nodes; empty where it is absent.
Vector<uint64_t> read_node_list(const Json& object, const char* key, const String& place);

// Of the scene to be shown; without scenes, all nodes that are no other's child.
Vector<uint64_t> root_nodes(const GltfDocument& document);

constexpr uint64_t gltf_lines = 1;
constexpr uint64_t gltf_line_loop = 2;
constexpr uint64_t gltf_line_strip = 3;
constexpr uint64_t gltf_triangles = 4;  // the default
constexpr uint64_t gltf_triangle_strip = 5;
constexpr uint64_t gltf_triangle_fan = 6;

constexpr uint64_t no_node = UINT64_MAX;

// A primitive of a mesh at a node.
struct GltfPrimitive {
    const Json& json;
    uint64_t node;  // no_node without nodes
    uint64_t mesh;
    uint64_t index;      // in its mesh
    uint64_t placement;  // counts the nodes with meshes in the order they are shown
    uint64_t mode;
    const Transform& transform;
    String place;
};

// Calls `visit` for every primitive, in the order of the nodes, placed relative to the origin; without nodes for those
// of all meshes, in place.
void visit_primitives(const GltfDocument& document, const Origin& origin,
                      const std::function<void(const GltfPrimitive&)>& visit);

// Where a primitive is placed.
inline Origin place_of(const GltfPrimitive& primitive) {
    return {primitive.transform[9], primitive.transform[10], primitive.transform[11]};
}

// What POSITION and COLOR_0 hold, checked: three floats a vertex, and colours for as many vertices.
struct GltfVertices {
    GltfValues positions;
    std::optional<GltfValues> colors;

    // A position placed. Bit for bit what is stored under the identity.
    std::array<float, 3> position(uint32_t vertex, const Transform& transform) const;
    // Linear RGBA; white without colours.
    std::array<float, 4> color(uint32_t vertex) const;
};

GltfVertices read_vertices(const GltfDocument& document, const GltfPrimitive& primitive);

// An attribute besides those, if the primitive has it.
std::optional<GltfValues> read_attribute(const GltfDocument& document, const GltfPrimitive& primitive,
                                         const char* name);

// The accessor of a primitive's indices, unsigned integers; none: the vertices in their order.
std::optional<GltfValues> read_index_values(const GltfDocument& document, const GltfPrimitive& primitive);

// All indices, below `vertex_count`.
Vector<uint32_t> read_indices(const std::optional<GltfValues>& values, uint64_t vertex_count);

// Refuses a value that a vertex gives.
[[noreturn]] void refuse_value(const GltfValues& values, uint32_t vertex, float value);

}  // namespace flg::io
