// SPDX-License-Identifier: MIT
// Why ornament is made by distances on the surface: against textures and plane patterns that are laid on it, after
// Fig. 2, 3 and 6 of Nazzaro, Puppo, Pellacini: geoTangle (2021).
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/ornament.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

Panel panel_with(const Moment& moment, const glm::vec3& sight, const char* title) {
    Panel panel;
    panel.surfaces = {moment.layer()};
    panel.sight = sight;
    panel.margin = 1.05f;
    panel.title = title;
    return panel;
}

// ---- Fig. 2

constexpr glm::vec3 kFromTheSide = {-0.25f, -0.40f, -1.0f};

// The vase with a label a triangle, by a texture at the triangle's middle: `u` around, from 0 at the seam in front to
// 1; `v` up, in the same unit.
Moment textured(Workshop& workshop, bool (*is_dark)(float u, float v)) {
    const filigree::Surface form = vase(workshop, kFineVase);
    const FlgMeshView mesh = form.view().mesh;
    constexpr float kMiddleRadius = 0.25f;  // metres, where the texture has its own proportions
    std::vector<uint32_t> labels;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        glm::vec3 middle(0.0f);
        for (uint32_t c = 0; c < 3; ++c) {
            const float* const p = samples::value_at(mesh.columns[0], mesh.triangles[3 * size_t{t} + c]);
            middle += glm::vec3(p[0], p[1], p[2]) / 3.0f;
        }
        constexpr float kTurn = 2.0f * std::numbers::pi_v<float>;
        const float u = std::atan2(middle.x - 0.25f * middle.z, middle.z + 0.25f * middle.x) / kTurn;
        labels.push_back(is_dark(u < 0.0f ? u + 1.0f : u, middle.y / (kTurn * kMiddleRadius)) ? 1 : 0);
    }
    render::SurfaceLook look;
    look.regions = {kCream, kCobalt};
    return {mesh, std::move(labels), std::move(look)};
}

bool in_dots(float u, float v, float around) {
    const float row = std::floor(v * around), x = u * around + (static_cast<int>(row) % 2 == 0 ? 0.0f : 0.5f);
    return std::hypot(x - std::floor(x) - 0.5f, v * around - row - 0.5f) < 0.33f;
}

bool in_stripes(float u, float v, float around) {
    const float x = u * around + 0.8f * v * around;
    return x - std::floor(x) < 0.5f;
}

void parametrization(Workshop& workshop, Studio& studio) {
    constexpr float kStripe = 0.085f;
    std::deque<Moment> moments;
    std::vector<Panel> panels;
    const auto add = [&](Moment moment, const char* title) {
        panels.push_back(panel_with(moments.emplace_back(std::move(moment)), kFromTheSide, title));
    };
    // As many dots around as their size asks for; as many as join; and by distances.
    add(textured(workshop, [](float u, float v) { return in_dots(u, v, 11.37f); }), "A texture: cut at a seam");
    add(textured(workshop, [](float u, float v) { return in_dots(u, v, 11.0f); }), "A closed one: stretched");
    {
        Ornament ornament(workshop, vase(workshop), kCream);
        const Regions dots = ornament.divide(contour(0.048f), Ornament::root(), Seeds::sampled(0.13f));
        ornament.paint(ornament.even(dots), kCobalt);
        add(ornament.moment(), "By distance: round everywhere");
    }
    add(textured(workshop, [](float u, float v) { return in_stripes(u, v, 11.37f); }), "Stripes break at the seam");
    add(textured(workshop, [](float u, float v) { return in_stripes(u, v, 11.0f); }), "Stripes widen with the vase");
    {
        Ornament ornament(workshop, vase(workshop), kCream);
        const Seeds side = Seeds::at({ornament.near({0.35f, 0.30f, 0.20f})});
        const Regions bands = ornament.divide(contour(kStripe, 0), Ornament::root(), side);
        ornament.paint(ornament.odd(bands), kCobalt);
        add(ornament.moment(), "By distance: one width");
    }
    studio.take("tangle_parametrization", panels, 3, kWidth, 860);
}

// ---- Fig. 3

constexpr uint32_t kOuter = 0, kInner = 1;  // loops of the dish

// The dish pressed flat, or as it is.
filigree::Surface pressed(Workshop& workshop, bool flat) {
    scenes::Mesh mesh = scenes::make_dish();
    std::vector<float> heights;
    for (scenes::Point& p : mesh.vertices) {
        heights.push_back(flat ? p.y : 0.0f);
        if (flat) p.y = 0.0f;
    }
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_USER, 1, heights.data(), 0, 0}};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    desc.mesh.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    desc.mesh.columns = columns;
    desc.mesh.column_count = 2;
    desc.mesh.triangles = mesh.triangles[0].data();
    return workshop.finished(workshop.context().surface(desc));
}

Moment patterned(Workshop& workshop, bool flat) {
    Ornament ornament(workshop, pressed(workshop, flat), kCream);
    const Regions rim = ornament.divide(contour(0.03f, 3), Ornament::root(), Seeds::loop(kOuter));
    ornament.paint(ornament.even(rim), kRust);
    const Regions inside = ornament.part(rim, 3);
    ornament.paint(inside, kCream);
    const Regions dots = ornament.divide(contour(0.030f), inside, Seeds::sampled(0.085f));
    const Regions discs = ornament.even(dots);
    ornament.paint(discs, kCobalt);
    const Regions rings = ornament.divide_each(contour(0.010f), discs, Seeds::outline());
    ornament.paint(ornament.odd(rings), kSage);
    return ornament.moment(kBorder);
}

void plane_pattern(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kSight = {-0.2f, -0.38f, -1.0f};
    const Moment plane = patterned(workshop, true), own = patterned(workshop, false);
    std::vector<Panel> panels = {panel_with(plane, kSight, "Made in a plane, laid on: stretched"),
                                 panel_with(own, kSight, "Made on the surface: even")};
    studio.take("tangle_plane", panels, 2, kWidth, 330);
}

// ---- Fig. 6

filigree::Field distances(Workshop& workshop, const filigree::Surface& surface, const std::vector<uint32_t>& from) {
    FlgGeodesicDesc desc = flgGeodesicDefaults();
    desc.surface = surface.get();
    desc.vertices = from.data();
    desc.vertex_count = static_cast<uint32_t>(from.size());
    return workshop.finished(workshop.context().geodesic(desc));
}

void fields(Workshop& workshop, Studio& studio) {
    constexpr float kHoleRadius = 0.3f;  // metres: what is nearer to the middle is the hole's border
    const filigree::Surface surface = dish(workshop);
    const FlgMeshView mesh = surface.view().mesh;
    std::map<std::pair<uint32_t, uint32_t>, int> sides;
    for (size_t t = 0; t < mesh.triangle_count; ++t) {
        for (size_t c = 0; c < 3; ++c) {
            const uint32_t a = mesh.triangles[3 * t + c], b = mesh.triangles[3 * t + (c + 1) % 3];
            ++sides[{std::min(a, b), std::max(a, b)}];
        }
    }
    std::set<uint32_t> hole, rim;
    for (const auto& [ends, count] : sides) {
        if (count != 1) continue;
        for (const uint32_t v : {ends.first, ends.second}) {
            const float* const p = samples::value_at(mesh.columns[0], v);
            (std::hypot(p[0], p[2]) < kHoleRadius ? hole : rim).insert(v);
        }
    }
    const filigree::Field from_hole = distances(workshop, surface, {hole.begin(), hole.end()}),
                          from_rim = distances(workshop, surface, {rim.begin(), rim.end()});
    const float *const a = from_hole.view().values, *const b = from_rim.view().values;
    std::vector<float> blend;
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) blend.push_back(a[v] / (a[v] + b[v]));
    std::vector<Panel> panels(2);
    for (size_t i = 0; i < 2; ++i) {
        Panel& panel = panels[i];
        panel.surfaces = {{mesh, {}, i == 0 ? std::span(a, mesh.vertex_count) : std::span<const float>(blend)}};
        panel.surfaces[0].look.isoline_spacing = i == 0 ? 0.04f : 0.1f;
        panel.surfaces[0].look.isoline_width_px = 2.0f;
        panel.surfaces[0].look.isoline_color = glm::vec3(1.0f);
        panel.sight = {-0.30f, -0.85f, -1.0f};
        panel.margin = 1.05f;
        panel.title =
            i == 0 ? "Distance from the hole, a line every 4 cm" : "Blend from hole to rim: lines follow both";
    }
    studio.take("tangle_fields", panels, 2, kWidth, 360);
}

constexpr Picture kPictures[] = {
    {"tangle_parametrization", "Fig. 2: dots and stripes by textures, and by distances on the surface", true,
     parametrization},
    {"tangle_plane", "Fig. 3: a pattern made in the plane and laid on, and made on the surface", true, plane_pattern},
    {"tangle_fields", "Fig. 6: the distance from a border, and the blend between two", true, fields},
};

}  // namespace

std::span<const Picture> tangle_comparisons() {
    return kPictures;
}

}  // namespace flg::gallery
