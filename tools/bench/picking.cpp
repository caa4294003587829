// SPDX-License-Identifier: MIT
// Picking on a mesh of 2 million triangles, and after a cut all across it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "bench/cut_mesh.h"
#include "bench/groups.h"
#include "filigree/filigree_pick.h"

namespace flg::bench {
namespace {

constexpr double kFrameMs = 1000.0 / 90, kRaysPerSecond = 1e6;
constexpr uint32_t kTriangles = 2'000'000, kRays = 200'000;

void check_pick(FlgResult result) {
    if (result != FLG_OK) throw std::runtime_error(flgPickErrorGetMessage());
}

// From points around the torus towards points near its ring.
std::vector<FlgRay> rays_at_torus() {
    std::vector<FlgRay> rays(kRays);
    for (uint32_t i = 0; i < kRays; ++i) {
        const double u = 2.399963 * i, v = 0.7548777 * i;  // spread evenly
        const float around[3] = {static_cast<float>(std::cos(u)), static_cast<float>(std::sin(u)), 0};
        FlgRay& ray = rays[i];
        ray = {{3 * around[0], 3 * around[1], static_cast<float>(2 * std::sin(v))}, 0, {}, HUGE_VALF};
        for (int k = 0; k < 3; ++k) ray.direction[k] = around[k] - ray.origin[k];
    }
    return rays;
}

}  // namespace

std::vector<Row> run_picking() {
    CutMesh cut(kTriangles);
    FlgPickScene scene = nullptr;
    check_pick(flgPickSceneCreate(nullptr, &scene));
    FlgSurfaceView view = cut.view();
    const double build_ms = time_ms([&] {
        check_pick(flgPickSceneSetSurface(scene, 0, &view, nullptr, 0));
        check_pick(flgPickSceneCommit(scene));
    });
    const std::vector<FlgRay> rays = rays_at_torus();
    std::vector<FlgHit> hits(kRays);
    const double before_ms = time_ms([&] { check_pick(flgPickSceneCastRays(scene, rays.data(), kRays, hits.data())); });

    cut.cut_isolines(1);
    view = cut.view();
    const std::vector<uint32_t> changes = cut.changes();
    const double update_ms = time_ms([&] {
        const auto count = static_cast<uint32_t>(changes.size());
        check_pick(flgPickSceneSetSurface(scene, 0, &view, changes.data(), count));
        check_pick(flgPickSceneCommit(scene));
        check_pick(flgPickSceneCastRays(scene, rays.data(), 1, hits.data()));
    });
    const double after_ms = time_ms([&] { check_pick(flgPickSceneCastRays(scene, rays.data(), kRays, hits.data())); });
    flgPickSceneDestroy(scene);

    char note[64];
    std::snprintf(note, sizeof note, "%zu triangles changed; first build %.0f ms", changes.size(), build_ms);
    return {below("2 M triangles: first pick after a cut", update_ms, "ms", kFrameMs, note),
            at_least("2 M triangles: rays a second", kRays / before_ms * 1e3, "", kRaysPerSecond),
            at_least("2 M triangles: rays a second after the cut", kRays / after_ms * 1e3, "", kRaysPerSecond)};
}

}  // namespace flg::bench
