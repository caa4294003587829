// SPDX-License-Identifier: MIT
// A tangle as maps in the mesh's own texture coordinates: PNG files, and a JSON file that says what their numbers are.
#pragma once

#include <string>
#include <vector>

#include "documents/tangle_script.h"

namespace flg::cli {

struct BakeOptions {
    uint32_t size = 0;              // texels a side; 0: nothing is baked
    std::vector<std::string> maps;  // some of map_names()
    float border_width = 0;         // metres; 0: 1/500 of the mesh's size
    std::string prefix;             // of the files
};

const std::vector<std::string>& map_names();

// Refuses what can't be baked, before any work is done. Throws UsageError, InputError.
void require_bakeable(const BakeOptions& options, const MeshSurface& surface);

// One set of files for each material of the mesh, written once all are baked. Throws InputError.
void bake_maps(Session& session, const BakeOptions& options, const MeshSurface& surface, const TangleScript& script,
               Report& report);

}  // namespace flg::cli
