// SPDX-License-Identifier: MIT
#include "strokes/standing_strokes.h"

#include "support/curve_source.h"

namespace flg::studio {

bool has_own_color(const Stroke& stroke) {
    return stroke.own_color && stroke.drawn->color.has_value();
}

bool is_there(const Scene& scene, const DrawnStroke& stroke) {
    return stroke.on == 0 || scene.find(stroke.on) != nullptr;
}

bool is_seen(const Scene& scene, const DrawnStroke& stroke) {
    if (stroke.on == 0) return true;
    const SceneMesh* mesh = scene.find(stroke.on);
    return mesh != nullptr && mesh->visible;
}

bool is_bent(const Scene& scene, const DrawnStroke& stroke) {
    const SceneMesh* mesh = stroke.on == 0 ? nullptr : scene.find(stroke.on);
    return mesh != nullptr && mesh->bent() != nullptr;
}

render::Placement moved(const Scene& scene, const DrawnStroke& stroke) {
    const SceneMesh* mesh = stroke.on == 0 ? nullptr : scene.find(stroke.on);
    // As long as the mesh stays where it was, to the bit.
    if (mesh == nullptr || mesh->placement == stroke.stood) return {};
    return mesh->placement * stroke.stood.inverse();
}

const SkinWeights& StrokeSkinWeights::of(uint32_t curve, const std::shared_ptr<const SkinCopy>& skin,
                                         std::span<const glm::vec3> own) {
    Held& held = held_[curve];
    if (held.skin != skin) held = {skin, skin->hold(own)};
    return held.hold;
}

void StandingCurves::add(const FlgCurveSetView& curves, std::span<const Stroke> strokes, StrokeSkinWeights* holds) {
    using samples::find_column;
    using samples::value_at;
    const FlgColumn& positions = *find_column(curves, FLG_ATTRIBUTE_POSITION);
    const FlgColumn& normals = *find_column(curves, FLG_ATTRIBUTE_NORMAL);
    const FlgColumn& radii = *find_column(curves, FLG_ATTRIBUTE_RADIUS);
    for (uint32_t c = 0; c < curves.curve_count; ++c) {
        const Stroke& stroke = strokes[c];
        if (!is_seen(scene_, *stroke.drawn)) continue;
        const render::Placement move = moved(scene_, *stroke.drawn);
        const glm::vec3 shown = has_own_color(stroke) ? *stroke.drawn->color : stroke.settings->color;
        const uint32_t first = curves.curve_offsets[c], end = curves.curve_offsets[c + 1];
        std::vector<glm::vec3> at, normal;
        for (uint32_t i = first; i < end; ++i) {
            const float *p = value_at(positions, i), *n = value_at(normals, i);
            at.push_back(move.point({p[0], p[1], p[2]}));
            normal.push_back(move.direction({n[0], n[1], n[2]}));
        }
        const SceneMesh* mesh = stroke.drawn->on == 0 ? nullptr : scene_.find(stroke.drawn->on);
        if (holds != nullptr && mesh != nullptr && mesh->bent() != nullptr && first < end) {
            const render::Placement into = mesh->placement.inverse();
            for (glm::vec3& place : at) place = into.point(place);
            for (glm::vec3& way : normal) way = into.direction(way);
            const Bend& bend = *mesh->bent();
            bend.move(holds->of(c, bend.skin(), at), at, normal);
            for (glm::vec3& place : at) place = mesh->placement.point(place);
            for (glm::vec3& way : normal) way = mesh->placement.direction(way);
        }
        for (uint32_t i = first; i < end; ++i) {
            const glm::vec3 &place = at[i - first], &way = normal[i - first];
            positions_.insert(positions_.end(), {place.x, place.y, place.z});
            normals_.insert(normals_.end(), {way.x, way.y, way.z});
            radii_.push_back(move.scale * *value_at(radii, i));
            colors_.insert(colors_.end(), {shown.x, shown.y, shown.z, 1.0f});
        }
        offsets_.push_back(static_cast<uint32_t>(radii_.size()));
    }
}

FlgCurveSetView StandingCurves::view(bool with_colors) {
    columns_ = {{FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0},
                {FLG_ATTRIBUTE_NORMAL, 3, normals_.data(), 0, 0},
                {FLG_ATTRIBUTE_RADIUS, 1, radii_.data(), 0, 0}};
    if (with_colors) columns_.push_back({FLG_ATTRIBUTE_COLOR, 4, colors_.data(), 0, 0});
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(offsets_.size() - 1);
    view.curve_offsets = offsets_.data();
    view.columns = columns_.data();
    view.column_count = static_cast<uint32_t>(columns_.size());
    return view;
}

}  // namespace flg::studio
