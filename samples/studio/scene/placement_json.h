// SPDX-License-Identifier: MIT
// Placements in documents.
#pragma once

#include <nlohmann/json.hpp>

#include "filigree_renderer/placement.h"

namespace flg::studio {

nlohmann::json to_json(const render::Placement& placement);
// Throws nlohmann::json::exception or StudioError.
render::Placement to_placement(const nlohmann::json& json);

}  // namespace flg::studio
