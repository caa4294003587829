// SPDX-License-Identifier: MIT
// What a file holds: a mesh, curves, or both, as some formats may.
#pragma once

#include <optional>

#include "mesh_file.h"
#include "support/curve_source.h"

namespace flg::cli {

// One of them is there, or both.
struct FileContents {
    std::optional<MeshFile> mesh;
    std::optional<samples::CurveSource> curves;
};

// Reads a file or makes what is built in, `builtin:NAME`. Throws InputError, SourceError.
FileContents read_contents(const std::string& name);

}  // namespace flg::cli
