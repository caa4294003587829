// SPDX-License-Identifier: MIT
// What a file holds: a mesh, curves, or both, as some formats may.
#pragma once

#include <optional>

#include "documents/mesh_file.h"
#include "skin_file.h"
#include "support/curve_source.h"

namespace flg::cli {

// Mesh or curves are there, or both; with a skin also its mesh.
struct FileContents {
    std::optional<MeshFile> mesh;
    std::optional<SkinFile> skin;
    std::string why_no_skin;  // of a file with a skin that can't be read: its mesh is there nevertheless
    std::optional<samples::CurveSource> curves;
};

// Reads a file or makes what is built in, `builtin:NAME`. Throws InputError, SourceError.
FileContents read_contents(const std::string& name);

}  // namespace flg::cli
