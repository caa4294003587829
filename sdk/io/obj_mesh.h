// SPDX-License-Identifier: MIT
// Faces of Wavefront OBJ files.
#pragma once

#include <string>
#include <string_view>

#include "io/checked_mesh.h"
#include "io/mesh_data.h"

namespace flg::io {

MeshData read_obj_mesh(std::string_view text);
std::string write_obj_mesh(const CheckedMesh& mesh);

}  // namespace flg::io
