// SPDX-License-Identifier: MIT
// Columns of curves as attributes of glTF lines, besides positions, colours and radii; filigree_io.h lists them.
// Lengths and speeds grow by the cube root of the volume's change under their node, directions are turned by it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/column_names.h"
#include "io/gltf_scene.h"

namespace flg::io {

constexpr uint32_t most_gltf_components = 4;

// "NORMAL", "_WIDTH", "_USER3"; empty for what has no name in glTF lines, or is named elsewhere.
std::string gltf_column_name(FlgAttribute attribute);

// One of a primitive's, checked to fit its vertices.
struct GltfColumn {
    FlgAttribute attribute;
    GltfValues values;
};
std::vector<GltfColumn> read_columns(const GltfDocument& document, const GltfPrimitive& primitive,
                                     uint64_t vertex_count);

// A vertex' values, placed: `components` of them are added to `out`.
void append_placed(const GltfColumn& column, uint32_t vertex, const Transform& transform, std::vector<float>& out);

}  // namespace flg::io
