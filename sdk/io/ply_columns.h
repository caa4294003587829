// SPDX-License-Identifier: MIT
// How the columns of a mesh are named as properties of PLY vertices; filigree_io.h lists them.
#pragma once

#include <string>
#include <vector>

#include "io/mesh_data.h"
#include "io/ply_header.h"

namespace flg::io {

std::string ply_property_name(FlgAttribute attribute, uint32_t components, uint32_t component);

// The columns besides positions that the properties of an element make up, still without values.
std::vector<VertexColumn> ply_vertex_columns(const PlyElement& vertex);

}  // namespace flg::io
