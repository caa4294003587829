// SPDX-License-Identifier: MIT
// Materials that a script gives to regions: the list `materials`, and what it makes of each region.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "documents/json_place.h"
#include "filigree/filigree_io.h"
#include "filigree/filigree_tangle.h"

namespace flg::cli {

// Without entries where a script has no materials.
struct TangleMaterials {
    std::vector<std::string> names;
    std::vector<FlgMeshMaterial> table;  // the first is that of all that is not named; later ones' border lines win
    std::vector<uint32_t> of_region;     // places in the table; FLG_NO_INDEX: the mesh's own material
};

// An entry of the list.
struct ScriptMaterial {
    bool is_default = false;
    bool is_kept = false;           // the mesh's own
    std::vector<uint32_t> regions;  // of the selection `on`
    std::string name;
    FlgMeshMaterial look;  // without its name
};

using Selection = std::function<std::vector<uint32_t>(const JsonPlace& selection)>;

// Reads the list. `has_own`: the mesh has materials, which are its regions' where the list names no other. Throws
// InputError.
std::vector<ScriptMaterial> read_materials(const JsonPlace& list, bool has_own, const Selection& select);

// What each region looks like: the material that names it last, or else the nearest region around it that is no
// scaffold's.
TangleMaterials spread_materials(std::vector<ScriptMaterial> entries, const std::vector<FlgTangleRegion>& regions);

}  // namespace flg::cli
