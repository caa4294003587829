// SPDX-License-Identifier: MIT
// Tangles as pictures need them: operators in one line, colours for what they make, and how it all looks at a moment.
#pragma once

#include <map>

#include "gallery/studio.h"
#include "gallery/workshop.h"

namespace flg::gallery {

using Regions = std::vector<uint32_t>;

constexpr float kBorder = 2.5f;  // pixels, of the larger picture it is averaged from

// A potter's glazes.
constexpr render::Material kCream = {{0.62f, 0.53f, 0.39f}, 0.0f, 0.42f},
                           kCobalt = {{0.008f, 0.028f, 0.150f}, 0.0f, 0.30f},
                           kRust = {{0.36f, 0.055f, 0.018f}, 0.0f, 0.36f}, kSage = {{0.13f, 0.20f, 0.11f}, 0.0f, 0.42f};

// What an operator begins at, see FlgTangleSeeds.
struct Seeds {
    FlgTangleBorders borders = FLG_TANGLE_BORDERS_NONE;
    std::vector<FlgBorderStretch> stretches{};
    std::vector<FlgSurfacePoint> points{};
    float samples = 0.0f;         // radius, metres
    uint32_t sample_count = 0;    // at most; 0: as many as fit
    float border_spacing = 0.0f;  // metres
    Regions of{};                 // empty: the regions of the operator

    static Seeds outline() { return {.borders = FLG_TANGLE_BORDERS_OUTER}; }
    static Seeds loop(uint32_t loop, float begin = 0.0f, float end = 1.0f) {
        return {.stretches = {{loop, begin, end}}};
    }
    static Seeds sampled(float radius, uint32_t count = 0) { return {.samples = radius, .sample_count = count}; }
    static Seeds along_borders(float spacing) { return {.border_spacing = spacing}; }
    static Seeds at(std::vector<FlgSurfacePoint> points) { return {.points = std::move(points)}; }

    FlgTangleSeeds view() const;
};

// A moment of an ornament.
class Moment {
public:
    // Triangles have the labels `labels`, whose colours are `look.regions`. A column USER is how much higher vertices
    // are shown than they were when the surface was divided.
    Moment(const FlgMeshView& mesh, std::vector<uint32_t> labels, render::SurfaceLook look);

    Moment(Moment&&) = default;

    // As long as the moment is there.
    SurfaceLayer layer() const;

private:
    std::vector<float> positions_;
    std::vector<uint32_t> triangles_, labels_;
    FlgColumn column_{};
    render::SurfaceLook look_;
};

class Ornament {
public:
    Ornament(Workshop& workshop, filigree::Surface surface, const render::Material& ground);

    // All of the surface.
    static Regions root() { return {0}; }

    // Divides regions, as one piece, by desc.kind from `a` (to `b`). What was made: its leaves.
    Regions divide(FlgTangleDivideDesc desc, const Regions& regions, const Seeds& a, const Seeds& b = {});
    // Each region by itself.
    Regions divide_each(const FlgTangleDivideDesc& desc, const Regions& regions, const Seeds& a, const Seeds& b = {});
    void displace(FlgTangleDisplaceDesc desc, const Regions& regions);

    // Those of the part of their operator, 0 the nearest to the seeds; those of even parts, and of odd ones.
    Regions part(const Regions& regions, uint32_t part) const;
    Regions even(const Regions& regions) const;
    Regions odd(const Regions& regions) const;

    // Regions and all below that isn't painted by itself.
    void paint(const Regions& regions, const render::Material& material);

    // The vertex nearest to a place.
    FlgSurfacePoint near(const glm::vec3& place) const;

    // Borders are lines where looks differ; all of them, scaffolds too, if so asked.
    Moment moment(float border_width_px = 0.0f, bool with_scaffolds = false) const;
    const filigree::Tangle& tangle() const { return tangle_; }

private:
    // Throws what it failed with.
    void finish(const filigree::Job& job);

    Workshop& workshop_;
    filigree::Surface surface_;
    filigree::Tangle tangle_;
    std::map<uint32_t, render::Material> paints_;
};

// Operators, to be changed further.
FlgTangleDivideDesc contour(float delta, uint32_t count = 1);
FlgTangleDivideDesc stream(float delta);
FlgTangleDivideDesc voronoi();
FlgTangleDivideDesc polyline(bool closed);

}  // namespace flg::gallery
