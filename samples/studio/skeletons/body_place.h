// SPDX-License-Identifier: MIT
// Places on a body, kept by the part they lie on: they stay where they are on it while bodies are made again, and move
// with it.
#pragma once

#include <optional>

#include "skeletons/live_model.h"

namespace flg::studio {

struct FoundPlace {
    uint32_t vertex;  // the nearest on the part
    glm::dvec3 at;    // metres
    double scale;     // of the part
};

// `part`: of the skin. An empty name if it is drawn no more.
BodyPlace place_on(const Drawing& drawing, const LiveModel::Skinned& skin, uint32_t part, const glm::vec3& at);
// Metres; none if the part is drawn no more.
std::optional<glm::dvec3> position_of(const Drawing& drawing, const BodyPlace& place);
// None while the body has no such part. Cost: 2 ns a vertex.
std::optional<FoundPlace> find_place(const Drawing& drawing, const LiveModel::Skinned& skin, const BodyPlace& place);
// At rest; of a part, or of all with FLG_NO_INDEX. FLG_NO_INDEX: there is none.
uint32_t nearest_vertex(const FlgSkinView& skin, uint32_t part, const glm::vec3& at);

}  // namespace flg::studio
