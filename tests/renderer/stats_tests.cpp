// SPDX-License-Identifier: MIT
// What a frame says of its cost.
#include "meshes.h"

namespace flg::render::test {
namespace {

TEST_F(RendererTest, PassesTakeTogetherWhatTheFrameTakes) {
    Target target(renderer, 128, 128);
    Mesh ball = sphere(0.5f, 40);
    Curves knot = trefoil(500);
    renderer.upload(ball.view());
    const CurvesId id = renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.1f});
    EXPECT_EQ(renderer.stats().gpu_ms, -1) << "before the first frame";
    for (int i = 0; i < 4; ++i) {
        const bool changed = i % 2 == 0;
        if (changed) renderer.update(id, knot.view(), {.shape = Shape::tube, .radius = 0.1f});
        renderer.draw(target, front_camera());
        renderer.wait_idle();
        const FrameStats& stats = renderer.stats();
        const double parts[] = {stats.gpu_uploads_ms,  stats.gpu_shadow_ms, stats.gpu_surfaces_ms, stats.gpu_curves_ms,
                                stats.gpu_backdrop_ms, stats.gpu_finish_ms, stats.gpu_ui_ms};
        if (stats.gpu_ms < 0) {
            for (const double part : parts) EXPECT_EQ(part, -1) << "a device without a clock knows none of them";
            continue;
        }
        double sum = 0;
        for (const double part : parts) {
            EXPECT_GE(part, 0);
            sum += part;
        }
        EXPECT_LE(sum, stats.gpu_ms + 1e-6);
        EXPECT_EQ(stats.gpu_shadow_ms > 0, changed) << "it is kept where nothing has changed";
        EXPECT_GT(stats.gpu_surfaces_ms + stats.gpu_curves_ms + stats.gpu_backdrop_ms, 0);
    }
}

}  // namespace
}  // namespace flg::render::test
