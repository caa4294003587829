// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2.1 attributes, 3.7.2.2 morph targets, 3.7.3.3 skinned mesh attributes).
// The attributes of vertices between those of a primitive, by the kind of each: numbers linearly, whole ones of an
// application's own from the nearest vertex; directions of length 1; tangents with the sign of the nearest vertex;
// joints and weights as one, the union of the influences, of which as many as the primitive has are kept, the largest,
// their sum 1.
//
// Values are written as floats but joints, which keep their type.
#pragma once

#include <array>
#include <span>

#include "io/base/vec3.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/gltf_document.h"

namespace flg::io {

struct MixedVertex {
    uint32_t vertex = 0;  // of the surface
    uint32_t count = 1;   // of those that are mixed; 1: it is one of them
    std::array<uint32_t, 3> from{};
    std::array<double, 3> weights{1, 0, 0};
    // Of those that were moved, or whose triangles were: in the mesh's coordinates.
    bool is_moved = false, is_bent = false;
    Vec3 position, normal;
};

// The members of a primitive's `attributes`; those of COLOR_0, with a comma before, apart.
struct MixedAttributes {
    String uncolored, colors;
};

// Adds them all. Refuses values that are not finite.
MixedAttributes add_mixed_attributes(const GltfDocument& document, const Json& attributes, const String& place,
                                     std::span<const MixedVertex> vertices, GlbBuilder& glb);

// Of one of its `targets`: how the vertices move.
String add_mixed_target(const GltfDocument& document, const Json& target, const String& place,
                        std::span<const MixedVertex> vertices, GlbBuilder& glb);

}  // namespace flg::io
