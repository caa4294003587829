// SPDX-License-Identifier: MIT
#include "scene/placement_json.h"

#include <array>
#include <cmath>

#include "shell/studio_error.h"

namespace flg::studio {

nlohmann::json to_json(const render::Placement& p) {
    return {{"at", {p.at.x, p.at.y, p.at.z}}, {"turn", {p.turn.x, p.turn.y, p.turn.z, p.turn.w}}, {"scale", p.scale}};
}

render::Placement to_placement(const nlohmann::json& json) {
    const auto at = json.at("at").get<std::array<float, 3>>();
    const auto turn = json.at("turn").get<std::array<float, 4>>();
    const render::Placement p{
        {at[0], at[1], at[2]}, {turn[3], turn[0], turn[1], turn[2]}, json.at("scale").get<float>()};
    const bool is_sound = std::isfinite(glm::dot(p.at, p.at)) && std::isfinite(p.scale) && p.scale > 0.0f &&
                          std::abs(glm::length(p.turn) - 1.0f) < 1e-3f;
    if (!is_sound) throw StudioError("A placement of the document is damaged: " + json.dump() + ".");
    return p;
}

}  // namespace flg::studio
