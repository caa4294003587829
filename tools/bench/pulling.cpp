// SPDX-License-Identifier: MIT
// A mesh of 10,000 vertices, pulled by one handle of four as a hand does, frame after frame.
#include <algorithm>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/meshes.h"
#include "filigree/filigree_pull.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTriangles = 20'000;
constexpr int kPulledFrames = 90;
constexpr double kPullMs = 3, kFactorMs = 100;

}  // namespace

std::vector<Row> run_pulling() {
    Host host;
    const MeshArrays torus = wavy_torus(kTriangles, 0.02);
    FlgColumn column;
    const FlgMeshView mesh = torus.view(column);
    FlgPullDesc desc = flgPullDefaults();
    desc.mesh = &mesh;
    FlgPull pull = {};
    const double factor_ms = time_ms([&] {
        check(flgPullCreate(host.context(), &desc, &pull, nullptr));
        host.run();
    });

    FlgPullHandle handles[4];
    for (uint32_t h = 0; h < 4; ++h) {
        handles[h] = flgPullHandleDefaults();
        handles[h].vertices[0] = h * mesh.vertex_count / 4;
        std::copy_n(torus.positions.data() + size_t{3} * handles[h].vertices[0], 3, handles[h].position);
    }
    FlgPulledDesc frame = flgPulledDefaults();
    frame.pull = pull;
    frame.handles = handles;
    frame.handle_count = 4;
    frame.rounds = 1;
    std::vector<double> frames_ms;
    for (int i = 0; i < kPulledFrames; ++i) {
        handles[3].position[1] += 0.01f;
        frames_ms.push_back(time_ms([&] {
            FlgPulled pulled = {};
            check(flgPulledCreate(host.context(), &frame, &pulled, nullptr));
            host.run();
            if (frame.previous.id != 0) check(flgPulledRelease(host.context(), frame.previous));
            frame.previous = pulled;
        }));
    }
    char note[128];
    std::snprintf(note, sizeof note, "%u vertices, 4 handles, one round; longest %.1f ms, the first with its handles",
                  mesh.vertex_count, *std::max_element(frames_ms.begin(), frames_ms.end()));
    return {below("a mesh of 10,000 vertices ready to be pulled", factor_ms, "ms", kFactorMs, "once"),
            below("a frame in which it is pulled", median(frames_ms), "ms", kPullMs, note)};
}

}  // namespace flg::bench
