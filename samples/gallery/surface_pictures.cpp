// SPDX-License-Identifier: MIT
// Surfaces: distances with isolines, regions cut in, geodesic paths, and isolines with a style.
#include <algorithm>
#include <limits>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

constexpr glm::vec3 kClay = {0.56f, 0.50f, 0.44f};
constexpr float kIsolineEvery = 0.05f;  // metres
constexpr glm::vec3 kNose = {0.80f, 0.55f, 0.15f}, kTail = {-0.15f, 0.70f, 0.15f};

uint32_t vertex_near(const FlgMeshView& mesh, const glm::vec3& place) {
    uint32_t nearest = 0;
    float least = std::numeric_limits<float>::max();
    for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
        const float* const p = samples::value_at(mesh.columns[0], i);
        const float distance = glm::distance(glm::vec3(p[0], p[1], p[2]), place);
        if (distance < least) least = distance, nearest = i;
    }
    return nearest;
}

filigree::Field distances(Workshop& workshop, const filigree::Surface& surface, const glm::vec3& from) {
    const uint32_t source = vertex_near(surface.view().mesh, from);
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface.get();
    desc.vertices = &source;
    desc.vertex_count = 1;
    return workshop.finished(workshop.context().field_geodesic(desc));
}

Panel panel_with(const filigree::Surface& surface, const render::SurfaceLook& look, std::span<const float> field = {}) {
    Panel panel;
    panel.surfaces = {{surface.view().mesh, look, field}};
    panel.sight = {-0.65f, -0.22f, -1.0f};
    panel.margin = 1.06f;
    return panel;
}

// Rings around the nose, each of them again by rings around the tail: every second piece is gold.
std::vector<render::Material> cut_chequered(Workshop& workshop, const filigree::Surface& surface) {
    constexpr uint32_t kRings = 11;
    FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
    cut.level_count = kRings;
    cut.level_first = 0.16f;
    cut.level_every = 0.12f;
    cut.first_label = 0;
    const filigree::Field from_nose = distances(workshop, surface, kNose);
    cut.field = from_nose.get();
    workshop.finished(workshop.context().cut_isolines(cut));
    std::vector<uint32_t> rings(kRings + 1);
    for (uint32_t i = 0; i <= kRings; ++i) rings[i] = i;
    const filigree::Field from_tail = distances(workshop, surface, kTail);
    cut.field = from_tail.get();
    cut.regions = rings.data();
    cut.region_count = kRings + 1;
    workshop.finished(workshop.context().cut_isolines(cut));
    std::vector<render::Material> materials;
    for (uint32_t label = 0; label < (kRings + 1) * (kRings + 1); ++label) {
        const bool gold = (label / (kRings + 1) + label % (kRings + 1)) % 2 == 0;
        materials.push_back(gold ? render::Material{kGold, 0.0f, 0.45f} : render::Material{kTeal, 0.0f, 0.45f});
    }
    return materials;
}

// From the tail's tip to places all over the figure.
filigree::CurveSet paths(Workshop& workshop, const filigree::Surface& surface) {
    constexpr float kApart = 0.14f;
    filigree::SurfaceSampleDesc sampling;
    sampling.radius = kApart;
    const filigree::Field ends = workshop.finished(surface.sample(sampling));
    const FlgFieldView spread = ends.view();
    const FlgMeshView& mesh = surface.view().mesh;
    std::vector<FlgSurfacePoint> at_vertex(mesh.vertex_count);
    for (uint32_t t = 0; t < 3 * mesh.triangle_count; ++t) {
        at_vertex[mesh.triangles[t]] = {t / 3, t % 3 == 1 ? 1.0f : 0.0f, t % 3 == 2 ? 1.0f : 0.0f};
    }
    const uint32_t start = vertex_near(mesh, kTail);
    std::vector<FlgSurfacePoint> points;
    std::vector<uint32_t> offsets = {0};
    for (uint32_t i = 0; i < spread.sample_count; ++i) {
        if (spread.samples[i] == start) continue;
        points.insert(points.end(), {at_vertex[start], at_vertex[spread.samples[i]]});
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
    desc.surface = surface.get();
    desc.points = points.data();
    desc.path_offsets = offsets.data();
    desc.path_count = static_cast<uint32_t>(offsets.size() - 1);
    const filigree::SurfaceCurves traced = workshop.context().trace_paths(desc);
    return workshop.finished(traced.lift());
}

// Isolines in the surface's own frame, with a style.
filigree::CurveSet stylized_rings(Workshop& workshop, const filigree::Field& field) {
    filigree::FieldTraceIsolinesDesc desc;
    desc.level_first = 2.0f * kIsolineEvery;
    desc.level_every = 2.0f * kIsolineEvery;
    const filigree::SurfaceCurves rings = field.trace_isolines(desc);
    filigree::SurfaceCurvesLiftDesc lift;
    lift.height = 0.009f;
    const filigree::CurveSet lifted = workshop.finished(rings.lift(lift));
    const filigree::Style style = workshop.style(scenes::make_style("knit"));
    FlgCurveSetStylizeDesc stylize = sized(style, 0.012f);
    stylize.frame = FLG_FRAME_METHOD_SUPPLIED;
    // The style's plane is the surface's.
    const float basis[9] = {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f, 0.0f, 1.0f, 0.0f};
    std::copy(basis, basis + 9, stylize.basis);
    return workshop.stylize(style, lifted, stylize);
}

void surface(Workshop& workshop, Studio& studio) {
    const filigree::Surface whole = cat(workshop), pieces = cat(workshop);
    const filigree::Field field = distances(workshop, whole, kTail);
    render::SurfaceLook mapped, clay, chequered;
    mapped.isoline_spacing = kIsolineEvery;
    mapped.isoline_width_px = 2.0f;
    mapped.isoline_color = {1.0f, 1.0f, 1.0f};
    clay.material = {kClay, 0.0f, 0.6f};
    chequered.regions = cut_chequered(workshop, pieces);
    chequered.border_width_px = 3.0f;
    const filigree::CurveSet geodesics = paths(workshop, whole), rings = stylized_rings(workshop, field);
    const FlgFieldView values = field.view();
    std::vector<Panel> panels = {panel_with(whole, mapped, {values.values, values.vertex_count}),
                                 panel_with(pieces, chequered), panel_with(whole, clay), panel_with(whole, clay)};
    panels[2].layers = {shape_of(geodesics.view(), tube(kRed, 0.0055f))};
    panels[3].layers = {shape_of(rings.view(), tube(kInk, 0.0040f))};
    panels[0].title = "Distance from the tail's tip, a line every 5 cm";
    panels[1].title = "Regions cut between lines of two distances";
    panels[2].title = "Shortest paths from the tail's tip";
    panels[3].title = "Lines of equal distance, in a style";
    studio.take("surface", panels, 2, kWidth, 820);
}

constexpr Picture kPictures[] = {
    {"surface", "Geodesic distances, regions cut in, geodesic paths, and isolines with a style", true, surface},
};

}  // namespace

std::span<const Picture> surface_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
