// SPDX-License-Identifier: MIT
// Picking on a surface and on curves.
#ifdef FLG_WITH_PICK
#include "filigree/filigree_pick.h"

#include "hardening/scenarios.h"

namespace flg::test {

void pick(Calls& calls) {
    EXPECT_NE(FLG_VALUE(calls, flgPickErrorGetMessage), nullptr);
    const FlgPickSceneDesc desc = FLG_INIT(calls, flgPickSceneDescInit);
    FlgPickScene scene = nullptr;
    FLG_CALL(calls, flgPickSceneCreate, &desc, &scene);
    struct Destroyed {
        Calls& calls;
        const FlgPickScene scene;
        ~Destroyed() { FLG_VALUE(calls, flgPickSceneDestroy, scene); }
    } const destroyed{calls, scene};
    MeshArrays mesh = plane(3);
    FlgSurfaceView surface = flgSurfaceViewDefaults();
    FlgMeshView seen = mesh.view();
    surface.mesh = &seen;
    const std::vector<uint32_t> regions(mesh.triangle_count(), 4);
    seen.regions = regions.data();
    FLG_CALL(calls, flgPickSceneSetSurface, scene, 7u, &surface, nullptr, 0u);
    Curves curves = arcs(1, 9);
    const FlgCurveSetView view = curves.view();
    FLG_CALL(calls, flgPickSceneSetCurves, scene, 8u, &view, 0.01f);
    FLG_CALL(calls, flgPickSceneCommit, scene);
    const FlgRay ray = {{0.4f, 0.6f, 2}, 0, {0, 0, -1}, HUGE_VALF};
    FlgHit hit{};
    FLG_CALL(calls, flgPickSceneCastRays, scene, &ray, 1u, &hit);
    EXPECT_EQ(hit.object, 7u);
    EXPECT_EQ(hit.region, 4u);
    calls.note(&hit, sizeof hit);
    FLG_CALL(calls, flgPickSceneFindNearest, scene, ray.origin, 9.0f, &hit);
    calls.note(&hit, sizeof hit);
    FLG_CALL(calls, flgPickSceneRemove, scene, 8u);
    FLG_CALL(calls, flgPickSceneCommit, scene);
}

}  // namespace flg::test
#endif
