// SPDX-License-Identifier: MIT
// Triangles of glTF 2.0 files, .gltf and .glb.
#pragma once

#include <filesystem>

#include "io/mesh_data.h"

namespace flg::io {

MeshData read_gltf_mesh(const std::filesystem::path& path);

}  // namespace flg::io
