// SPDX-License-Identifier: MIT
// Ornament: divided, edited, undone, made again.
#include <algorithm>
#include <cmath>

#include "filigree/filigree_bake.h"
#include "filigree/filigree_tangle.h"
#include "slices/meshes.h"
#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

struct Decorated {
    FlgSurface surface{};
    FlgTangle tangle{};
};

Decorated begin(WatchedHost& host, uint32_t size) {
    Decorated made;
    made.surface = make_surface(host, waves(size));
    host.call("flgTangleCreate", flgTangleCreate, made.surface, nullptr, &made.tangle, host.job());
    host.made("flgTangleRelease", flgTangleRelease, made.tangle);
    host.finish();
    return made;
}

void divide(WatchedHost& host, FlgTangle tangle, FlgTangleOperator kind, uint32_t region, const FlgTangleSeeds& seeds,
            float delta) {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.tangle = tangle;
    desc.kind = kind;
    desc.regions = &region;
    desc.region_count = 1;
    desc.a = &seeds;
    desc.delta = delta;
    host.call("flgTangleDivide", flgTangleDivide, &desc, host.job());
    host.finish();
}

void frame(WatchedHost& host, FlgTangle tangle) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.borders = FLG_TANGLE_BORDERS_OUTER;
    divide(host, tangle, FLG_TANGLE_OPERATOR_CONTOUR, 0, seeds, 0.17f);
}

void contour(WatchedHost& host, uint32_t size) {
    const Decorated made = begin(host, size);
    frame(host, made.tangle);
    FlgSurfaceCurves seen{};
    host.call("flgTangleTraceBorders", flgTangleTraceBorders, made.tangle, nullptr, &seen, host.job());
    host.made("flgSurfaceCurvesRelease", flgSurfaceCurvesRelease, seen);
    host.finish();
}

void cells(WatchedHost& host, uint32_t size) {
    const Decorated made = begin(host, size);
    FlgTangleSeeds samples = flgTangleSeedsDefaults();
    samples.sample_radius = 0.1f;
    divide(host, made.tangle, FLG_TANGLE_OPERATOR_VORONOI, 0, samples, 0.1f);
}

void streams(WatchedHost& host, uint32_t size) {
    const Decorated made = begin(host, size);
    FlgTangleSeeds borders = flgTangleSeedsDefaults();
    borders.borders = FLG_TANGLE_BORDERS_OUTER;
    divide(host, made.tangle, FLG_TANGLE_OPERATOR_STREAM, 0, borders, 0.1f);
}

void edits(WatchedHost& host, uint32_t size) {
    const Decorated made = begin(host, size);
    frame(host, made.tangle);
    const uint32_t inner = 2, both[] = {1, 2};
    FlgTangleApplyMacroDesc dots = flgTangleApplyMacroDefaults();
    dots.tangle = made.tangle;
    dots.kind = FLG_TANGLE_MACRO_POLKA_DOTS;
    dots.regions = &inner;
    dots.region_count = 1;
    dots.size = 0.05f;
    dots.spacing = 0.15f;
    host.call("flgTangleApplyMacro", flgTangleApplyMacro, &dots, host.job());
    host.finish();
    FlgTangleDisplaceDesc displace = flgTangleDisplaceDefaults();
    displace.tangle = made.tangle;
    displace.regions = &inner;
    displace.region_count = 1;
    displace.amount = 0.02f;
    host.call("flgTangleDisplace", flgTangleDisplace, &displace, host.job());
    host.finish();
    host.call("flgTangleGroup", flgTangleGroup, made.tangle, both, 2u, nullptr, host.job());
    host.finish();
    host.call("flgTangleJoin", flgTangleJoin, made.tangle, both, 2u, nullptr, host.job());
    host.finish();
    for (int i = 0; i < 3; ++i) {
        host.call("flgTangleUndo", flgTangleUndo, made.tangle, nullptr, host.job());
        host.finish();
    }
    host.call("flgTangleRedo", flgTangleRedo, made.tangle, nullptr, host.job());
    host.finish();
    FlgTangleHistory history = flgTangleHistoryDefaults();
    host.call("flgTangleGetHistory", flgTangleGetHistory, made.tangle, &history);
    host.call("flgTangleMuteStep", flgTangleMuteStep, made.tangle, 0u, 1u, nullptr, host.job());
    host.finish();
    host.call("flgTangleUndo", flgTangleUndo, made.tangle, nullptr, host.job());
    host.finish();
    host.call("flgTangleMoveStep", flgTangleMoveStep, made.tangle, 1u, 2u, nullptr, host.job());
    host.finish();
    host.call("flgTangleGetHistory", flgTangleGetHistory, made.tangle, &history);
    const Decorated other = begin(host, size);
    host.copy("flgTangleReplay", flgTangleReplay, other.tangle, &history, nullptr, host.job());
    host.finish();
}

// A map with a texel a triangle, or so; and one that is refused.
void bake(WatchedHost& host, uint32_t size) {
    Mesh mesh = waves(size);
    Decorated made;
    made.surface = make_surface(host, mesh, true);
    host.call("flgTangleCreate", flgTangleCreate, made.surface, nullptr, &made.tangle, host.job());
    host.made("flgTangleRelease", flgTangleRelease, made.tangle);
    host.finish();
    frame(host, made.tangle);
    std::vector<float> uvs;
    for (const uint32_t v : mesh.triangles)
        for (uint32_t c = 0; c < 2; ++c) uvs.push_back(mesh.positions[3 * v + c]);
    const FlgMeshView view = mesh.view();
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = 1 + static_cast<uint32_t>(std::sqrt(size));
    const size_t texels = size_t{desc.size} * desc.size;
    std::vector<uint32_t> ids(texels);
    std::vector<uint8_t> borders(texels);
    std::vector<float> normals(3 * texels);
    desc.tangle = made.tangle;
    desc.mesh = &view;
    desc.corner_uvs = uvs.data();
    desc.ids = ids.data();
    desc.borders = borders.data();
    desc.normals = normals.data();
    host.copy("flgTangleBake", flgTangleBake, &desc, host.job());
    host.finish();
    // One half of the mesh lies over the other: refused when all is drawn.
    std::copy_n(uvs.begin(), uvs.size() / 2, uvs.end() - static_cast<std::ptrdiff_t>(uvs.size() / 2));
    host.copy("flgTangleBake", flgTangleBake, &desc, host.job());
    host.finish(FLG_ERROR_INVALID_ARGUMENT);
}

constexpr SizedJob all[] = {
    {"tangle_contour", contour},        {"tangle_cells", cells},          {"tangle_streams", streams},
    {"tangle_edits", edits, 1'000'000}, {"tangle_bake", bake, 1'000'000},
};

}  // namespace

std::span<const SizedJob> tangle_jobs() {
    return all;
}

}  // namespace flg::slices
