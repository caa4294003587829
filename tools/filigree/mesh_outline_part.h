// SPDX-License-Identifier: MIT
// Meshes as parts that nobody drew: by their silhouettes.
#pragma once

#include "documents/model_drawing.h"

namespace flg::cli {

bool is_mesh_file(const std::string& path);

// The silhouette of a mesh, as seen from this direction. Throws InputError.
DrawnPart read_mesh_part(Session& session, const std::string& path, const std::array<float, 3>& direction,
                         Report& report);

}  // namespace flg::cli
