// SPDX-License-Identifier: MIT
#include "gallery/ornament.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>
#include <stdexcept>

#include "support/curve_source.h"

namespace flg::gallery {

FlgTangleSeeds Seeds::view() const {
    FlgTangleSeeds seeds{};
    seeds.borders = borders;
    seeds.stretches = stretches.data();
    seeds.stretch_count = static_cast<uint32_t>(stretches.size());
    seeds.points = points.data();
    seeds.point_count = static_cast<uint32_t>(points.size());
    seeds.sample_radius = samples;
    seeds.sample_count = sample_count;
    seeds.border_spacing = border_spacing;
    seeds.regions = of.empty() ? nullptr : of.data();
    seeds.region_count = static_cast<uint32_t>(of.size());
    return seeds;
}

Moment::Moment(const FlgMeshView& mesh, std::vector<uint32_t> labels, render::SurfaceLook look)
    : triangles_(mesh.triangles, mesh.triangles + size_t{3} * mesh.triangle_count),
      labels_(std::move(labels)),
      look_(std::move(look)) {
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
        const float* const p = samples::value_at(mesh.columns[0], v);
        positions_.insert(positions_.end(), p, p + 3);
    }
    for (uint32_t c = 0; c < mesh.column_count; ++c) {
        if (mesh.columns[c].attribute != FLG_ATTRIBUTE_USER) continue;
        for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
            positions_[3 * size_t{v} + 1] += *samples::value_at(mesh.columns[c], v);
        }
    }
    column_ = {FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0};
}

SurfaceLayer Moment::layer() const {
    SurfaceLayer layer{flgMeshViewDefaults(), look_};
    layer.mesh.vertex_count = static_cast<uint32_t>(positions_.size() / 3);
    layer.mesh.triangle_count = static_cast<uint32_t>(labels_.size());
    layer.mesh.columns = &column_;
    layer.mesh.column_count = 1;
    layer.mesh.triangles = triangles_.data();
    layer.mesh.regions = labels_.data();
    return layer;
}

Ornament::Ornament(Workshop& workshop, filigree::Surface surface, const render::Material& ground)
    : workshop_(workshop), surface_(std::move(surface)), tangle_(workshop.context().tangle(surface_)) {
    workshop_.context().finish();
    paint(root(), ground);
}

void Ornament::finish(const filigree::Job& job) {
    workshop_.context().finish();
    const FlgJobStatus status = job.status();
    if (status.result != FLG_OK) throw std::runtime_error(status.error);
}

Regions Ornament::divide(FlgTangleDivideDesc desc, const Regions& regions, const Seeds& a, const Seeds& b) {
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    desc.a = a.view();
    desc.b = b.view();
    Regions made;
    const uint32_t before = tangle_.info().region_count;
    finish(tangle_.divide(desc));
    for (uint32_t r = before; r < tangle_.info().region_count; ++r) made.push_back(r);
    return made;
}

Regions Ornament::divide_each(const FlgTangleDivideDesc& desc, const Regions& regions, const Seeds& a, const Seeds& b) {
    Regions made;
    for (const uint32_t region : regions) {
        const Regions some = divide(desc, {region}, a, b);
        made.insert(made.end(), some.begin(), some.end());
    }
    return made;
}

void Ornament::displace(FlgTangleDisplaceDesc desc, const Regions& regions) {
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    finish(tangle_.displace(desc));
}

Regions Ornament::part(const Regions& regions, uint32_t part) const {
    Regions some;
    std::copy_if(regions.begin(), regions.end(), std::back_inserter(some),
                 [&](uint32_t r) { return tangle_.region(r).part == part; });
    return some;
}

Regions Ornament::even(const Regions& regions) const {
    Regions some;
    std::copy_if(regions.begin(), regions.end(), std::back_inserter(some),
                 [&](uint32_t r) { return tangle_.region(r).part % 2 == 0; });
    return some;
}

Regions Ornament::odd(const Regions& regions) const {
    Regions some;
    std::copy_if(regions.begin(), regions.end(), std::back_inserter(some),
                 [&](uint32_t r) { return tangle_.region(r).part % 2 == 1; });
    return some;
}

void Ornament::paint(const Regions& regions, const render::Material& material) {
    for (const uint32_t region : regions) paints_.insert_or_assign(region, material);
}

FlgSurfacePoint Ornament::near(const glm::vec3& place) const {
    const FlgMeshView mesh = surface_.view().mesh;
    FlgSurfacePoint nearest{};
    float least = std::numeric_limits<float>::max();
    for (uint32_t t = 0; t < 3 * mesh.triangle_count; ++t) {
        const float* const p = samples::value_at(mesh.columns[0], mesh.triangles[t]);
        const float distance = glm::distance(glm::vec3(p[0], p[1], p[2]), place);
        if (distance >= least) continue;
        least = distance;
        nearest = {t / 3, t % 3 == 1 ? 1.0f : 0.0f, t % 3 == 2 ? 1.0f : 0.0f};
    }
    return nearest;
}

Moment Ornament::moment(float border_width_px, bool with_scaffolds) const {
    const FlgMeshView mesh = surface_.view().mesh;
    const uint32_t count = tangle_.info().region_count;
    render::SurfaceLook look;
    look.border_width_px = border_width_px;
    look.border_color = {0.02f, 0.025f, 0.04f};
    look.regions.resize(count);
    std::map<uint32_t, uint32_t> number_of;  // looks, one after the other
    std::vector<uint32_t> label_of(count), labels(mesh.regions, mesh.regions + mesh.triangle_count);
    for (uint32_t r = 0; r < count; ++r) {
        label_of[r] =
            with_scaffolds
                ? r
                : number_of.try_emplace(tangle_.region(r).look, static_cast<uint32_t>(number_of.size())).first->second;
        uint32_t painted = r;
        while (!paints_.contains(painted) || (!with_scaffolds && tangle_.region(painted).scaffold != 0)) {
            painted = tangle_.region(painted).parent;
        }
        look.regions[label_of[r]] = paints_.at(painted);
    }
    for (uint32_t& label : labels) label = label_of[label];
    return {mesh, std::move(labels), std::move(look)};
}

FlgTangleDivideDesc contour(float delta, uint32_t count) {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.delta = delta;
    desc.count = count;
    return desc;
}

FlgTangleDivideDesc stream(float delta) {
    FlgTangleDivideDesc desc = contour(delta);
    desc.kind = FLG_TANGLE_STREAM;
    return desc;
}

FlgTangleDivideDesc voronoi() {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.kind = FLG_TANGLE_VORONOI;
    return desc;
}

FlgTangleDivideDesc polyline(bool closed) {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.kind = FLG_TANGLE_POLYLINE;
    desc.closed = closed ? 1 : 0;
    return desc;
}

}  // namespace flg::gallery
