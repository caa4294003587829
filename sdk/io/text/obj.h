// SPDX-License-Identifier: MIT
// Polylines and faces of Wavefront OBJ files.
#pragma once

#include <string_view>

#include "core/origin.h"
#include "io/base/checked_views.h"
#include "io/base/curve_data.h"
#include "io/base/files.h"
#include "io/base/memory.h"
#include "io/base/mesh_data.h"

namespace flg::io {

CurveData read_obj(std::string_view text, const Origin& origin);
void write_obj(const CheckedView& view, FileWriter& file);

// `path`: where the text is from; materials lie beside it.
MeshData read_obj_mesh(std::string_view text, const Path& path, const Origin& origin);
void write_obj_mesh(const CheckedMesh& mesh, FileWriter& file);

}  // namespace flg::io
