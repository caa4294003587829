// SPDX-License-Identifier: MIT
// Geomview's object file format.
#pragma once

#include <string_view>

#include "core/origin.h"
#include "io/base/checked_views.h"
#include "io/base/files.h"
#include "io/base/memory.h"
#include "io/base/mesh_data.h"

namespace flg::io {

MeshData read_off(std::string_view text, const Origin& origin);
void write_off(const CheckedMesh& mesh, FileWriter& file);

}  // namespace flg::io
