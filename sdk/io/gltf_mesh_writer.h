// SPDX-License-Identifier: MIT
// Meshes as glTF 2.0, binary.
#pragma once

#include <string>

#include "io/checked_mesh.h"
#include "io/glb_builder.h"

namespace flg::io {

// Adds the mesh's vertices and primitives; returns its materials, which finish() takes.
std::string add_mesh(GlbBuilder& glb, const CheckedMesh& mesh);

std::string write_glb_mesh(const CheckedMesh& mesh);

}  // namespace flg::io
