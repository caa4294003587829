// SPDX-License-Identifier: MIT
#include <algorithm>

#include "curves.h"

namespace flg::render::test {
namespace {

TEST_F(RendererTest, EmptySceneIsAGradient) {
    Target target(renderer, 64, 64);
    const Image image = picture(target);
    // Left and right alike, but for the dither's step; each row brighter in red than the one 16 rows higher.
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            ASSERT_NEAR(image.at(x, y)[0], image.at(63 - x, y)[0], 2);
            if (y < 16 || y >= 48) continue;
            ASSERT_GT(image.at(x, y)[0], image.at(x, y - 16)[0]);
        }
    EXPECT_TRUE(renderer.bounds().empty());
}

TEST_F(RendererTest, CaptureBeforeTheFirstFrameIsBlack) {
    Target target(renderer, 8, 8);
    const Image image = renderer.capture(target);
    for (uint32_t i = 0; i < 64; ++i) {
        EXPECT_EQ(image.pixels[4 * i], 0);
        EXPECT_EQ(image.pixels[4 * i + 3], 255);
    }
}

TEST_F(RendererTest, UpdateAndRemove) {
    Target target(renderer, picture_size, picture_size);
    Curves knot = trefoil(300), spring = helix(300);
    const CurveLook tube{.shape = Shape::tube, .radius = 0.05f};
    const Image empty = picture(target);
    const CurvesId id = renderer.upload(spring.view(), tube);
    const Image first = picture(target);
    EXPECT_GT(differing_pixels(first, empty), 500u);
    renderer.update(id, knot.view(), tube);
    const Image second = picture(target);
    EXPECT_GT(differing_pixels(first, second), 500u);
    renderer.update(id, spring.view(), tube);
    EXPECT_EQ(differing_pixels(picture(target), first), 0u);
    renderer.remove(id);
    EXPECT_EQ(differing_pixels(picture(target), empty), 0u);
    EXPECT_THROW(renderer.remove(id), Error);
    EXPECT_THROW(renderer.update(id, knot.view(), tube), Error);
    EXPECT_NO_THROW(renderer.remove(CurvesId{}));
}

TEST_F(RendererTest, ReplacingWithoutDrawingIsHarmless) {
    Target target(renderer, 64, 64);
    Curves knot = trefoil(3000);
    const CurvesId id = renderer.upload(knot.view());
    for (int i = 0; i < 5; ++i) renderer.update(id, knot.view());
    renderer.clear();
    renderer.upload(knot.view());
    picture(target);
    EXPECT_FALSE(renderer.bounds().empty());
}

TEST_F(RendererTest, FramesFollowEachOtherWithChangesInBetween) {
    Target target(renderer, 64, 64);
    Curves knot = trefoil(500);
    CurvesId id = renderer.upload(knot.view());
    for (int i = 0; i < 12; ++i) {
        renderer.draw(target, front_camera());
        renderer.update(id, knot.view(), {.shape = i % 2 ? Shape::tube : Shape::line});
    }
    renderer.wait_idle();
    EXPECT_GE(renderer.stats().cpu_ms, 0.0);
    EXPECT_GT(renderer.stats().draw_calls, 0u);
}

TEST_F(RendererTest, SameInputSameBits) {
    Renderer other(options());
    Curves knot = trefoil(1000);
    const CurveLook look{.shape = Shape::tube, .radius = 0.2f};
    renderer.upload(knot.view(), look);
    other.upload(knot.view(), look);
    const Camera camera = frame_box(renderer.bounds(), {-1, -0.5f, -1}, 1.0f);
    Target target(renderer, 200, 200), other_target(other, 200, 200);
    const Image first = picture(target, camera);
    EXPECT_EQ(picture(target, camera).pixels, first.pixels) << "the next frame";
    other.draw(other_target, camera);
    EXPECT_EQ(other.capture(other_target).pixels, first.pixels) << "another renderer";
    EXPECT_THROW(renderer.draw(other_target, camera), Error);
    expect_silence(other);
}

TEST_F(RendererTest, TargetsCanBeResized) {
    Curves knot = trefoil(300);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    Target target(renderer, 64, 64);
    const Image before = picture(target);
    target.resize(100, 30);
    const Image wide = picture(target);
    EXPECT_EQ(wide.width, 100u);
    EXPECT_EQ(wide.height, 30u);
    target.resize(64, 64);
    EXPECT_EQ(picture(target).pixels, before.pixels);
}

TEST_F(RendererTest, SunCastsAShadowOnTheGround) {
    Target target(renderer, picture_size, picture_size);
    Curves bar = straight(1.0f, 20, {0, 1, 0});
    bar.add({0, -0.5f, 0});
    bar.add({0, -0.49f, 0});
    bar.normals.insert(bar.normals.end(), {0, 0, 1, 0, 0, 1});
    bar.end();
    CurveLook look{.shape = Shape::tube, .radius = 0.05f};
    const Camera camera{{0, 2, 3}, {0, -0.3f, 0}, {0, 1, 0}, default_fov_y_rad};
    const CurvesId id = renderer.upload(bar.view(), look);
    const Image with = picture(target, camera);
    look.casts_shadow = false;
    renderer.update(id, bar.view(), look);
    const Image without = picture(target, camera);
    uint32_t darker = 0;
    for (size_t i = 0; i < with.pixels.size(); i += 4) darker += with.pixels[i] + 10 < without.pixels[i];
    EXPECT_GT(darker, 300u);
}

// A strand covers little of the lamp from far away; a wide band covers it all.
TEST_F(RendererTest, StrandsThrowNoFlecksOnTubesFarBelow) {
    Scene scene;
    scene.ground = false;
    scene.sun_direction = {0, 0, 1};
    renderer.set_scene(scene);
    Target target(renderer, picture_size, picture_size);
    const auto brightness_below = [&](float gap, float radius, bool casts) {
        Curves below = straight(1.0f, 20, {0, 0, 1}), above;
        above.add({0, -0.5f, gap});
        above.add({0, 0.5f, gap});
        above.end();
        const CurvesId tube = renderer.upload(below.view(), {.shape = Shape::tube, .radius = 0.04f});
        const CurvesId strand =
            renderer.upload(above.view(), {.shape = Shape::tube, .radius = radius, .casts_shadow = casts});
        // Past the strand, from the side.
        const Camera camera{{2, 0, 2}, {0, 0, 0.04f}, {0, 1, 0}, default_fov_y_rad};
        const Image image = picture(target, camera);
        renderer.remove(tube);
        renderer.remove(strand);
        const auto pixel = image.at(picture_size / 2, picture_size / 2);
        return pixel[0] + pixel[1] + pixel[2];
    };
    EXPECT_LE(brightness_below(0.6f, 0.012f, false) - brightness_below(0.6f, 0.012f, true), 12) << "a fleck";
    EXPECT_GE(brightness_below(0.6f, 0.2f, false) - brightness_below(0.6f, 0.2f, true), 60) << "a band far away";
    EXPECT_GE(brightness_below(0.06f, 0.012f, false) - brightness_below(0.06f, 0.012f, true), 40) << "a strand near by";
}

TEST_F(RendererTest, RibbonsLookTheSameFromBothSides) {
    Target target(renderer, picture_size, picture_size);
    const auto seen = [&](float side) {
        Curves bar = straight(1.0f, 20, {0, 0, side});
        const CurvesId id = renderer.upload(bar.view(), {.shape = Shape::ribbon, .radius = 0.2f});
        const Image image = picture(target);
        renderer.remove(id);
        return image;
    };
    const Image front = seen(1), back = seen(-1);
    int most = 0;
    for (size_t i = 0; i < front.pixels.size(); ++i) most = std::max(most, std::abs(front.pixels[i] - back.pixels[i]));
    EXPECT_LE(most, 2) << "but for rounding";
}

TEST_F(RendererTest, MultisamplingSoftensEdges) {
    Renderer smooth(options(4));
    if (smooth.samples() == 1) GTEST_FAIL() << "every Vulkan device has 4 samples";
    Curves bar = straight(1.0f, 2, {0.1f, 0.3f, 1});
    const CurveLook look{
        .shape = Shape::ribbon, .color = {0, 0, 0}, .color_end = {0, 0, 0}, .radius = 0.1f, .gloss = 0};
    smooth.upload(bar.view(), look);
    renderer.upload(bar.view(), look);
    Camera camera = front_camera();
    camera.up = {0.3f, 1, 0};
    Target target(smooth, 128, 128), hard_target(renderer, 128, 128);
    smooth.draw(target, camera);
    const Image soft = smooth.capture(target), hard = picture(hard_target, camera);
    EXPECT_GT(differing_pixels(soft, hard), 20u);
    EXPECT_LT(differing_pixels(soft, hard), 1500u);
    expect_silence(smooth);
}

TEST_F(RendererTest, ManyCurvesTakeFewDrawCalls) {
    Curves strokes;
    for (int stroke = 0; stroke < 3000; ++stroke) {
        for (int i = 0; i < 20; ++i)
            strokes.add({0.02f * static_cast<float>(i) + 0.001f * static_cast<float>(stroke % 60),
                         0.02f * static_cast<float>(stroke / 60), std::sin(0.1f * static_cast<float>(stroke))});
        strokes.end();
    }
    renderer.upload(strokes.view(), {.radius = 0.004f});
    Target target(renderer, 128, 128);
    renderer.draw(target, frame_box(renderer.bounds(), {0, -0.3f, -1}, 1.0f));
    EXPECT_LT(renderer.stats().draw_calls, 20u);
    EXPECT_GT(renderer.stats().triangles, 3000u);
}

}  // namespace
}  // namespace flg::render::test
