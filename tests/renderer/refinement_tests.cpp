// SPDX-License-Identifier: MIT
// Pictures that get better while nothing changes, frames of fewer pixels while something does, and what stands in the
// way of light from all around.
#include <algorithm>

#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr DrawOptions refining = {.refines = true};

class RefinementTest : public RendererTest {
protected:
    Image refined(Target& target, uint32_t frames, const Camera& camera = front_camera()) {
        for (uint32_t i = 0; i < frames; ++i) renderer.draw(target, camera, refining);
        return renderer.capture(target);
    }
};

// Of a black bar before a white wall: the share of a pixel that the bar covers is its darkness.
TEST_F(RefinementTest, EdgesBecomeTheMeanOfManySamples) {
    without_ground();
    Curves bar = straight(1.0f, 2, {0.0f, 0.0f, 1});
    renderer.upload(bar.view(),
                    {.shape = Shape::ribbon, .color = {0, 0, 0}, .color_end = {0, 0, 0}, .radius = 0.1f, .gloss = 0});
    Camera camera = front_camera();
    camera.up = {0.2f, 1, 0};
    Target target(renderer, 128, 128);
    const auto grey_pixels = [](const Image& image) {
        uint32_t count = 0;
        for (size_t i = 0; i < image.pixels.size(); i += 4) count += image.pixels[i] > 40 && image.pixels[i] < 120;
        return count;
    };
    const Image hard = refined(target, 1, camera);
    EXPECT_EQ(hard.pixels, picture(target, camera).pixels) << "the first frame is that of a draw that does not refine";
    EXPECT_EQ(target.refined(), 0u);
    const Image soft = refined(target, 1 + max_refined, camera);
    EXPECT_EQ(target.refined(), max_refined);
    EXPECT_LT(grey_pixels(hard), 5u);
    EXPECT_GT(grey_pixels(soft), 20u);
}

TEST_F(RefinementTest, PictureStaysOnceItIsDone) {
    Curves knot = trefoil(300);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    Target target(renderer, 96, 96);
    const Camera camera = frame_box(renderer.bounds(), {-1, -0.5f, -1}, 1.0f);
    const Image done = refined(target, 1 + max_refined, camera);
    EXPECT_GT(renderer.stats().triangles, 0u);
    EXPECT_EQ(refined(target, 1, camera).pixels, done.pixels);
    EXPECT_EQ(renderer.stats().triangles, 0u) << "it is shown again, not drawn";
    EXPECT_EQ(target.refined(), max_refined);
}

TEST_F(RefinementTest, EachChangeBeginsAnew) {
    Curves knot = trefoil(300);
    const CurvesId id = renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    Target target(renderer, 64, 64);
    Camera camera = front_camera();
    const auto expect_anew = [&](const char* what) {
        const Image first = refined(target, 1, camera);
        EXPECT_EQ(target.refined(), 0u) << what;
        EXPECT_EQ(first.pixels, picture(target, camera).pixels) << what;
        refined(target, 3, camera);
        EXPECT_EQ(target.refined(), 2u) << what;
    };
    expect_anew("the first picture");
    camera.eye.x += 0.1f;
    expect_anew("the camera");
    camera.fov_y_rad += 0.1f;
    expect_anew("the field of view");
    renderer.set_visible(id, false);
    expect_anew("what is visible");
    renderer.set_visible(id, true);
    Scene scene = renderer.scene();
    scene.exposure = 1.4f;
    renderer.set_scene(scene);
    expect_anew("the light");
    target.resize(80, 64);
    expect_anew("the size");
    renderer.simulate_device_loss();
    EXPECT_THROW(renderer.draw(target, camera, refining), DeviceLost);
    renderer.recover();
    renderer.upload(knot.view());
    expect_anew("the device");
}

TEST_F(RefinementTest, FramesOfFewerPixelsShowTheSame) {
    without_ground();
    Target target(renderer, picture_size, picture_size);
    const Image empty = picture(target);
    Mesh ball = sphere(0.7f, 40);
    renderer.upload(ball.view());
    const Image whole = picture(target);
    for (const float scale : {0.5f, 0.7f}) {
        renderer.draw(target, front_camera(), {.changing_scale = scale});
        const Image enlarged = renderer.capture(target);
        int64_t sum = 0;
        for (size_t i = 0; i < whole.pixels.size(); ++i) sum += std::abs(whole.pixels[i] - enlarged.pixels[i]);
        EXPECT_LT(static_cast<double>(sum) / static_cast<double>(whole.pixels.size()), 1.0) << scale;
        EXPECT_GT(differing_pixels(enlarged, whole), 1000u) << scale;
    }
    refined(target, 2);
    EXPECT_EQ(target.refined(), 1u);
    expect_error([&] { renderer.draw(target, front_camera(), {.changing_scale = 0.1f}); },
                 "options.changing_scale is 0.1; it must be 0.25 to 1.");
    expect_error([&] { renderer.draw(target, front_camera(), {.changing_scale = NAN}); }, "options.changing_scale is");
}

TEST_F(RefinementTest, ViewportsRefineAndTheRestIsBlack) {
    Curves knot = trefoil(300);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    Target target(renderer, 96, 64), small(renderer, 48, 32);
    const DrawOptions part = {.viewport = {40, 20, 48, 32}, .refines = true};
    for (uint32_t i = 0; i < 5; ++i) renderer.draw(target, front_camera(), part);
    const Image image = renderer.capture(target), alone = refined(small, 5);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 96; ++x) {
            const bool inside = x >= 40 && x < 88 && y >= 20 && y < 52;
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.at(x, y)[c], inside ? alone.at(x - 40, y - 20)[c] : 0, inside ? 2 : 0)
                    << x << ", " << y;
        }
}

class OcclusionTest : public RendererTest {
protected:
    static Options unshadowed(uint32_t samples) {
        Options o = options(samples);
        o.shadow_size = 0;
        return o;
    }
};

// No shadow of the sun: it gets darker towards where the ball stands on the floor, and not far away.
TEST_F(OcclusionTest, FloorIsDarkerWhereSomethingStands) {
    for (const uint32_t samples : {1u, 4u}) {
        Renderer r(unshadowed(samples));
        Target target(r, 256, 256);
        const Camera camera{{0, 0.6f, 4}, {0, -0.3f, 0}, {0, 1, 0}, default_fov_y_rad};
        const auto seen = [&](const Mesh& mesh) {
            Mesh copy = mesh;
            const SurfaceId id = r.upload(copy.view());
            r.draw(target, camera);
            const Image image = r.capture(target);
            r.remove(id);
            return image;
        };
        // The same bounds, so that floor and light are the same: a ball, and a needle's tip and a far speck.
        Mesh speck = sphere(0.5f, 24);
        speck.triangles.resize(3);
        const Image with = seen(sphere(0.5f, 24)), without = seen(speck);
        const auto darkness = [&](int x, int y) { return brightness(without.at(x, y)) - brightness(with.at(x, y)); };
        int contact_y = 255;  // the ball's lowest pixel
        while (darkness(128, contact_y) < 60 && contact_y > 0) --contact_y;
        ASSERT_GT(contact_y, 100);
        EXPECT_GE(darkness(128, contact_y + 4), 12) << samples;
        EXPECT_GE(darkness(128, contact_y + 4), darkness(128, contact_y + 20)) << samples;
        EXPECT_LE(darkness(10, 250), 2) << "far from it, " << samples;
        expect_silence(r);
    }
}

// A ball lit from the side: its brightness changes little from pixel to pixel, across where the sun's light ends too.
TEST_F(OcclusionTest, LightEndsSoftlyOnRoundThings) {
    Scene scene;
    scene.ground = false;
    scene.sun_direction = {1, 0.4f, 0.1f};
    renderer.set_scene(scene);
    Mesh ball = sphere(0.8f, 64);
    for (const glm::vec3& position : ball.positions) ball.normals.push_back(glm::normalize(position));
    SurfaceLook look;
    look.material.roughness = 1.0f;
    renderer.upload(ball.view(), look);
    Target target(renderer, picture_size, picture_size);
    const Image image = picture(target);
    const int y = pixel_of(0, 0.05f).y;
    int most = 0;
    for (int x = pixel_of(-0.6f, 0).x; x < pixel_of(0.6f, 0).x; ++x)
        most = std::max(most, std::abs(brightness(image.at(x, y)) - brightness(image.at(x + 1, y))));
    EXPECT_LE(most, 12) << "of 765";
    EXPECT_GT(brightness(image.at(pixel_of(0.6f, 0).x, y)), brightness(image.at(pixel_of(-0.6f, 0).x, y)) + 100);
}

}  // namespace
}  // namespace flg::render::test
