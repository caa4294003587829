// SPDX-License-Identifier: MIT
// Meshes as binary PLY, little-endian.
#pragma once

#include <string>

#include "io/checked_mesh.h"

namespace flg::io {

std::string write_ply(const CheckedMesh& mesh);

}  // namespace flg::io
