// SPDX-License-Identifier: MIT
// Meshes of PLY files.
#pragma once

#include "io/file_bytes.h"
#include "io/mesh_data.h"

namespace flg::io {

MeshData read_ply(Bytes file);

}  // namespace flg::io
