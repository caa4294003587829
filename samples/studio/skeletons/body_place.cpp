// SPDX-License-Identifier: MIT
#include "skeletons/body_place.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

namespace flg::studio {
namespace {

const DrawnPart* part_of(const Drawing& drawing, const BodyPlace& place) {
    const auto drawn = std::find_if(drawing.parts.begin(), drawing.parts.end(),
                                    [&](const DrawnPart& part) { return part.name == place.part; });
    return drawn == drawing.parts.end() ? nullptr : &*drawn;
}

}  // namespace

BodyPlace place_on(const Drawing& drawing, const LiveModel::Skinned& skin, uint32_t part, const glm::vec3& at) {
    const DrawnPart* drawn = drawing.find(skin.parts[part]);
    if (drawn == nullptr) return {};
    glm::dvec3 place(at);
    if (skin.is_image[part]) place = mirrored(drawing.mirror, place);
    return {drawn->name, skin.is_image[part], glm::dvec3(glm::inverse(drawn->matrix()) * glm::dvec4(place, 1.0))};
}

std::optional<glm::dvec3> position_of(const Drawing& drawing, const BodyPlace& place) {
    const DrawnPart* drawn = part_of(drawing, place);
    if (drawn == nullptr) return std::nullopt;
    const glm::dvec3 at(drawn->matrix() * glm::dvec4(place.at, 1.0));
    return place.is_image ? mirrored(drawing.mirror, at) : at;
}

std::optional<FoundPlace> find_place(const Drawing& drawing, const LiveModel::Skinned& skin, const BodyPlace& place) {
    const DrawnPart* drawn = part_of(drawing, place);
    if (drawn == nullptr) return std::nullopt;
    uint32_t part = 0;
    while (part < skin.parts.size() && (skin.parts[part] != drawn->id || skin.is_image[part] != place.is_image)) ++part;
    if (part == skin.parts.size()) return std::nullopt;
    const glm::dvec3 at = *position_of(drawing, place);
    const uint32_t vertex = nearest_vertex(skin.view, part, glm::vec3(at));
    if (vertex == FLG_NO_INDEX) return std::nullopt;
    return FoundPlace{vertex, at, drawn->scale};
}

uint32_t nearest_vertex(const FlgSkinView& skin, uint32_t part, const glm::vec3& at) {
    uint32_t found = FLG_NO_INDEX;
    float least = std::numeric_limits<float>::infinity();
    for (uint32_t v = 0; v < skin.vertex_count; ++v) {
        if (part != FLG_NO_INDEX && skin.vertex_parts[v] != part) continue;
        const glm::vec3 away = glm::make_vec3(skin.positions + 3 * size_t{v}) - at;
        const float distance_sq = glm::dot(away, away);
        if (distance_sq >= least) continue;
        least = distance_sq;
        found = v;
    }
    return found;
}

}  // namespace flg::studio
