// SPDX-License-Identifier: MIT
#include "scene/placed_curves.h"

#include "support/curve_source.h"

namespace flg::studio {

PlacedCurves::PlacedCurves(const FlgCurveSetView& own, const render::Placement& placement) : view_(own) {
    if (placement.is_identity() || own.curve_count == 0) return;
    const uint32_t count = own.curve_offsets[own.curve_count];
    const auto take = [&](FlgAttribute attribute, uint32_t components, std::vector<float>& out, const auto& place) {
        const FlgColumn* column = samples::find_column(own, attribute);
        if (column == nullptr) return;
        out.reserve(size_t{components} * count);
        for (uint32_t i = 0; i < count; ++i) place(samples::value_at(*column, i));
        columns_.push_back({attribute, components, out.data(), 0, 0});
    };
    const auto push = [](std::vector<float>& out, const glm::vec3& v) { out.insert(out.end(), {v.x, v.y, v.z}); };
    take(FLG_ATTRIBUTE_POSITION, 3, positions_, [&](const float* p) {
        push(positions_, placement.point({p[0], p[1], p[2]}));
    });
    take(FLG_ATTRIBUTE_NORMAL, 3, normals_, [&](const float* n) {
        push(normals_, placement.direction({n[0], n[1], n[2]}));
    });
    take(FLG_ATTRIBUTE_RADIUS, 1, radii_, [&](const float* r) { radii_.push_back(placement.scale * *r); });
    view_.columns = columns_.data();
    view_.column_count = static_cast<uint32_t>(columns_.size());
}

}  // namespace flg::studio
