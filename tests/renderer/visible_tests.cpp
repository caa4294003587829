// SPDX-License-Identifier: MIT
// Hiding things is like not having them, and showing them again like never having hidden them.
#include "meshes.h"

namespace flg::render::test {
namespace {

TEST_F(RendererTest, WhatIsHiddenLeavesNoTrace) {
    Target target(renderer, picture_size, picture_size);
    const Camera camera{{0, 2, 3}, {0, 0, 0}, {0, 1, 0}, default_fov_y_rad};
    Mesh ball = sphere(0.4f, 12), plate = sheet(0.5f, 0.3f, 2, 2, 0.6f);
    Curves bar = straight(1.6f, 20, {0, 1, 0});
    renderer.upload(ball.view());
    const Image alone = picture(target, camera);
    const Box box = renderer.bounds();

    const CurvesId curves = renderer.upload(bar.view(), {.shape = Shape::tube, .radius = 0.05f});
    const SurfaceId surface = renderer.upload(plate.view());
    const Image all = picture(target, camera);
    const Box whole_box = renderer.bounds();
    ASSERT_GT(differing_pixels(all, alone), 1000u);

    renderer.set_visible(curves, false);
    renderer.set_visible(surface, false);
    EXPECT_EQ(renderer.bounds().max, box.max);
    EXPECT_EQ(picture(target, camera).pixels, alone.pixels) << "neither they nor their shadows";
    renderer.update(curves, bar.view(), {.shape = Shape::ribbon});
    renderer.update(curves, bar.view(), {.shape = Shape::tube, .radius = 0.05f});
    renderer.update(surface, plate.view());
    EXPECT_EQ(picture(target, camera).pixels, alone.pixels) << "updates leave them hidden";

    renderer.set_visible(curves, true);
    renderer.set_visible(surface, true);
    EXPECT_EQ(renderer.bounds().max, whole_box.max);
    EXPECT_EQ(picture(target, camera).pixels, all.pixels);
    expect_error([&] { renderer.set_visible(CurvesId{99}, true); }, "no curves with the id 99");
    expect_error([&] { renderer.set_visible(SurfaceId{}, true); }, "no surfaces with the id 0");
}

TEST_F(RendererTest, TheFloorLiesWhereItIsAskedFor) {
    Target target(renderer, picture_size, picture_size);
    const Camera camera{{0, 2, 3}, {0, 0, 0}, {0, 1, 0}, default_fov_y_rad};
    Mesh ball = sphere(0.4f, 12);
    renderer.upload(ball.view());
    const Image lowest = picture(target, camera);
    Scene scene = renderer.scene();
    scene.ground_height = renderer.bounds().min.y;
    renderer.set_scene(scene);
    EXPECT_EQ(picture(target, camera).pixels, lowest.pixels);
    scene.ground_height = renderer.bounds().min.y - 0.3f;
    renderer.set_scene(scene);
    EXPECT_GT(differing_pixels(picture(target, camera), lowest), 1000u) << "the shadow falls farther away";
}

}  // namespace
}  // namespace flg::render::test
