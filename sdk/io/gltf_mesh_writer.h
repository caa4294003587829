// SPDX-License-Identifier: MIT
// Meshes as glTF 2.0, binary.
#pragma once

#include <string>

#include "io/checked_mesh.h"

namespace flg::io {

std::string write_glb_mesh(const CheckedMesh& mesh);

}  // namespace flg::io
