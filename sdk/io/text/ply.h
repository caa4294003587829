// SPDX-License-Identifier: MIT
// Meshes of PLY files. They are written as little-endian binary.
#pragma once

#include "core/origin.h"
#include "io/base/checked_views.h"
#include "io/base/files.h"
#include "io/base/memory.h"
#include "io/base/mesh_data.h"

namespace flg::io {

// `path`: where the file is from; textures lie beside it.
MeshData read_ply(Bytes file, const Path& path, const Origin& origin);

String write_ply(const CheckedMesh& mesh);

}  // namespace flg::io
