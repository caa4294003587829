// SPDX-License-Identifier: MIT
// What `filigree info` says of what it finds: printed, and put into the report.
#pragma once

#include <string>

#include "mesh_file.h"
#include "report.h"

namespace flg::cli {

std::string attribute_name(FlgAttribute attribute);

void describe_mesh(const MeshFile& mesh, Report& report);

}  // namespace flg::cli
