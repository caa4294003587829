// SPDX-License-Identifier: MIT
// What `filigree info` says of what it finds: printed, and put into the report.
#pragma once

#include <string>

#include "documents/mesh_file.h"
#include "documents/report.h"
#include "skin_file.h"

namespace flg::cli {

std::string attribute_name(FlgAttribute attribute);

// A line about what positions are relative to; none for 0.
void describe_origin(const double (&origin)[3], Report& report);

void describe_mesh(const MeshFile& mesh, Report& report);

// Besides its mesh.
void describe_skin(const SkinFile& skin, Report& report);

}  // namespace flg::cli
