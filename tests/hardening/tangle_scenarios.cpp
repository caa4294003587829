// SPDX-License-Identifier: MIT
// Tangles: divided, edited, made again.
#include <algorithm>
#include <cmath>

#include "filigree/filigree_bake.h"
#include "filigree/filigree_tangle.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

struct Decorated {
    FlgSurface surface{};
    FlgTangle tangle{};
};

Decorated begin(Calls& calls, uint32_t provenance = 0) {
    FlgSurfaceDesc desc = FLG_INIT(calls, flgSurfaceDescInit);
    MeshArrays mesh = plane(7);
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    desc.provenance = provenance;
    Decorated made;
    FLG_CALL(calls, flgSurfaceCreate, calls.context, &desc, calls.out(made.surface), calls.job());
    FLG_CALL(calls, flgTangleCreate, calls.context, made.surface, nullptr, calls.out(made.tangle), calls.job());
    calls.surfaces.push_back(made.surface);
    calls.finish();
    calls.note(made.surface);
    return made;
}

// After each job, so that a cancelled one has left one of these states.
void finish(Calls& calls, const Decorated& decorated) {
    calls.finish();
    calls.note(decorated.surface);
    FlgTangleInfo info{};
    info.struct_size = sizeof info;
    FLG_CALL(calls, flgTangleGetInfo, calls.context, decorated.tangle, &info);
    for (uint32_t r = 0; r < info.region_count; ++r) {
        FlgTangleRegion region{};
        region.struct_size = sizeof region;
        FLG_CALL(calls, flgTangleGetRegion, calls.context, decorated.tangle, r, &region);
        calls.note(&region, sizeof region);
    }
}

void divide(Calls& calls, const Decorated& decorated, FlgTangleOperator kind, uint32_t region,
            const FlgTangleSeeds& seeds, float delta) {
    FlgTangleDivideDesc desc = FLG_INIT(calls, flgTangleDivideDescInit);
    desc.tangle = decorated.tangle;
    desc.kind = kind;
    desc.regions = &region;
    desc.region_count = 1;
    desc.a = &seeds;
    desc.delta = delta;
    FLG_CALL(calls, flgTangleDivide, calls.context, &desc, calls.job());
    finish(calls, decorated);
}

void frame(Calls& calls, const Decorated& decorated) {
    FlgTangleSeeds seeds = FLG_INIT(calls, flgTangleSeedsInit);
    seeds.borders = FLG_TANGLE_BORDERS_OUTER;
    divide(calls, decorated, FLG_TANGLE_OPERATOR_CONTOUR, 0, seeds, 0.17f);
}

}  // namespace

void divide_tangles(Calls& calls) {
    const Decorated decorated = begin(calls);
    frame(calls, decorated);
    FlgTangleSeeds samples = flgTangleSeedsDefaults();
    samples.sample_radius = 0.2f;
    divide(calls, decorated, FLG_TANGLE_OPERATOR_VORONOI, 2, samples, 0.1f);
    FlgTangleSeeds borders = flgTangleSeedsDefaults();
    borders.borders = FLG_TANGLE_BORDERS_OUTER;
    divide(calls, decorated, FLG_TANGLE_OPERATOR_STREAM, 1, borders, 0.5f);
    const FlgSurfacePoint ends[] = {{3, 0.3f, 0.3f}, {90, 0.2f, 0.3f}};
    FlgTangleSeeds points = flgTangleSeedsDefaults();
    points.points = ends;
    points.point_count = 2;
    divide(calls, decorated, FLG_TANGLE_OPERATOR_POLYLINE, 0, points, 0.1f);
    FlgSurfaceCurves seen{};
    FLG_CALL(calls, flgTangleTraceBorders, calls.context, decorated.tangle, nullptr, calls.out(seen), calls.job());
    calls.finish();
    calls.note(seen);
    FLG_DRAW(calls, flgDebugDrawTangle, decorated.tangle);
    FLG_CALL(calls, flgTangleRelease, calls.context, decorated.tangle);
}

void bake_tangles(Calls& calls) {
    const Decorated made = begin(calls, 1);
    frame(calls, made);
    MeshArrays mesh = plane(7);
    const FlgMeshView input = mesh.view();
    std::vector<float> uvs;
    float low = INFINITY, high = -INFINITY;
    for (const float value : mesh.positions) low = std::min(low, value), high = std::max(high, value);
    for (const uint32_t v : mesh.triangles)
        for (uint32_t c = 0; c < 2; ++c)
            uvs.push_back(std::clamp((mesh.positions[3 * v + c] - low) / (high - low), 0.0f, 1.0f));
    constexpr uint32_t size = 16;
    // Of a thread, so longer than its contexts: where a scenario ends early, a job may still write.
    static thread_local std::array<uint32_t, size * size> ids;
    static thread_local std::array<float, size * size> distances;
    ids.fill(0);
    distances.fill(0);
    FlgTangleBakeDesc bake = FLG_INIT(calls, flgTangleBakeDescInit);
    bake.size = size;
    bake.padding = 2;
    bake.tangle = made.tangle;
    bake.mesh = &input;
    bake.corner_uvs = uvs.data();
    bake.ids = ids.data();
    bake.distances = distances.data();
    FLG_CALL(calls, flgTangleBake, calls.context, &bake, calls.job());
    calls.finish();
    calls.note(&ids, sizeof ids);
    calls.note(&distances, sizeof distances);
    FLG_CALL(calls, flgTangleRelease, calls.context, made.tangle);
}

void edit_tangles(Calls& calls) {
    const Decorated decorated = begin(calls);
    frame(calls, decorated);
    const uint32_t inner = 2;
    FlgTangleApplyMacroDesc macro = FLG_INIT(calls, flgTangleApplyMacroDescInit);
    macro.tangle = decorated.tangle;
    macro.kind = FLG_TANGLE_MACRO_POLKA_DOTS;
    macro.regions = &inner;
    macro.region_count = 1;
    macro.size = 0.08f;
    macro.spacing = 0.3f;
    FLG_CALL(calls, flgTangleApplyMacro, calls.context, &macro, calls.job());
    finish(calls, decorated);
    FlgTangleDisplaceDesc displace = FLG_INIT(calls, flgTangleDisplaceDescInit);
    displace.tangle = decorated.tangle;
    displace.regions = &inner;
    displace.region_count = 1;
    displace.amount = 0.02f;
    FLG_CALL(calls, flgTangleDisplace, calls.context, &displace, calls.job());
    finish(calls, decorated);
    const uint32_t both[] = {1, 2};
    FLG_CALL(calls, flgTangleGroup, calls.context, decorated.tangle, both, 2u, nullptr, calls.job());
    finish(calls, decorated);
    FlgTangleRegion region{};
    region.struct_size = sizeof region;
    FLG_CALL(calls, flgTangleGetRegion, calls.context, decorated.tangle, 1u, &region);
    FLG_CALL(calls, flgTangleUngroup, calls.context, decorated.tangle, region.group, nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleJoin, calls.context, decorated.tangle, both, 2u, nullptr, calls.job());
    finish(calls, decorated);
    for (int i = 0; i < 3; ++i) {
        FLG_CALL(calls, flgTangleUndo, calls.context, decorated.tangle, nullptr, calls.job());
        finish(calls, decorated);
    }
    FLG_CALL(calls, flgTangleRedo, calls.context, decorated.tangle, nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleMuteStep, calls.context, decorated.tangle, 1u, 1u, nullptr, calls.job());
    finish(calls, decorated);
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    FLG_CALL(calls, flgTangleGetHistory, calls.context, decorated.tangle, &history);
    FlgTangleStep step = *history.steps[0];
    FlgTangleDivideDesc narrower = *step.divide;
    narrower.delta = 0.12f;
    step.divide = &narrower;
    FLG_CALL(calls, flgTangleEditStep, calls.context, decorated.tangle, 0u, &step, nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleGetHistory, calls.context, decorated.tangle, &history);
    FLG_CALL(calls, flgTangleInsertStep, calls.context, decorated.tangle, 2u, history.steps[0], nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleMoveStep, calls.context, decorated.tangle, 2u, 1u, nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleRemoveStep, calls.context, decorated.tangle, 1u, nullptr, calls.job());
    finish(calls, decorated);
    FLG_CALL(calls, flgTangleUndo, calls.context, decorated.tangle, nullptr, calls.job());
    finish(calls, decorated);
}

void replay_tangles(Calls& calls) {
    const Decorated first = begin(calls);
    frame(calls, first);
    FlgTangleSeeds samples = flgTangleSeedsDefaults();
    samples.sample_radius = 0.25f;
    divide(calls, first, FLG_TANGLE_OPERATOR_CONTOUR, 2, samples, 0.08f);
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    FLG_CALL(calls, flgTangleGetHistory, calls.context, first.tangle, &history);
    EXPECT_EQ(history.step_count, 2u);
    calls.surfaces.clear();  // in between, the second surface has states of its own
    const Decorated second = begin(calls);
    FLG_CALL(calls, flgTangleReplay, calls.context, second.tangle, &history, nullptr, calls.job());
    finish(calls, second);
}

}  // namespace flg::test
