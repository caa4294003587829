// SPDX-License-Identifier: MIT
// What can't be used is refused with a sentence, and leaves the renderer as it was.
#include <filesystem>
#include <limits>

#include "curves.h"

namespace flg::render::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class RendererErrors : public RendererTest {
protected:
    void expect_refused(const FlgCurveSetView& view, const char* part, const CurveLook& look = {}) {
        expect_error([&] { renderer.upload(view, look); }, part);
    }
};

TEST_F(RendererErrors, ImageSizes) {
    expect_error([&] { Target(renderer, 0, 10); }, "0 x 10");
    expect_error([&] { Target(renderer, 10, 0); }, "10 x 0");
    expect_error([&] { Target(renderer, 1000000, 10); }, "1000000");
    Target target(renderer, 10, 10);
    expect_error([&] { target.resize(0, 0); }, "0 x 0");
    EXPECT_EQ(picture(target).width, 10u);
}

TEST_F(RendererErrors, RendererOptions) {
    Options samples = options();
    samples.samples = 3;
    expect_error([&] { Renderer r(samples); }, "samples is 3");
    Options shadow = options();
    shadow.shadow_size = 10;
    expect_error([&] { Renderer r(shadow); }, "shadow_size is 10");
    Options device = options();
    device.device = "no such device";
    expect_error([&] { Renderer r(device); }, "no such device");
}

TEST_F(RendererErrors, Views) {
    Curves curves = straight(1, 10, {0, 1, 0});
    FlgCurveSetView view = curves.view();
    view.column_count = 0;
    expect_refused(view, "no columns");
    view = curves.view();
    curves.columns[0].attribute = FLG_ATTRIBUTE_TANGENT;
    expect_refused(view, "no POSITION");
    view = curves.view();
    curves.columns[0].components = 2;
    expect_refused(view, "2 floats");
    view = curves.view();
    curves.columns[0].data = nullptr;
    expect_refused(view, "no data");
    view = curves.view();
    curves.columns[0].stride = 13;
    expect_refused(view, "13 bytes");
    view = curves.view();
    view.curve_offsets = nullptr;
    expect_refused(view, "curve_offsets");
    const uint32_t late[] = {1, 10}, falling[] = {0, 10, 5};
    view = curves.view();
    view.curve_offsets = late;
    expect_refused(view, "begins with 1");
    view = curves.view();
    view.curve_offsets = falling;
    view.curve_flags = nullptr;
    view.curve_count = 2;
    expect_refused(view, "falls from 10 to 5");
}

TEST_F(RendererErrors, Values) {
    for (const float bad : {nan, infinity, 1e31f}) {
        Curves curves = straight(1, 10, {0, 1, 0});
        curves.positions[4] = bad;
        expect_refused(curves.view(), "Point 1");
    }
    Curves curves = straight(1, 10, {0, 1, 0});
    curves.normals[6] = nan;
    expect_refused(curves.view(), "normal");
    for (const float bad : {nan, -1.0f, infinity}) {
        Curves thick = straight(1, 10, {0, 1, 0});
        thick.radii.assign(10, 0.1f);
        thick.radii[3] = bad;
        expect_refused(thick.view(), "Point 3");
    }
}

TEST_F(RendererErrors, Looks) {
    Curves curves = straight(1, 10, {0, 1, 0});
    const FlgCurveSetView view = curves.view();
    expect_refused(view, "radius", {.radius = -1});
    expect_refused(view, "radius_scale", {.radius_scale = nan});
    expect_refused(view, "sides", {.sides = 2});
    expect_refused(view, "sides", {.sides = 33});
    expect_refused(view, "line_width_px", {.line_width_px = 0});
    expect_refused(view, "gloss", {.gloss = 2});
    expect_refused(view, "color", {.color = {nan, 0, 0}});
}

TEST_F(RendererErrors, Cameras) {
    Target target(renderer, 16, 16);
    Camera camera = front_camera();
    camera.target = camera.eye;
    expect_error([&] { renderer.draw(target, camera); }, "apart");
    camera = front_camera();
    camera.eye.x = nan;
    expect_error([&] { renderer.draw(target, camera); }, "finite");
    camera = front_camera();
    camera.fov_y_rad = 0;
    expect_error([&] { renderer.draw(target, camera); }, "fov_y_rad");
    Scene scene;
    scene.sun_direction = {0, 0, 0};
    renderer.set_scene(scene);
    expect_error([&] { renderer.draw(target, front_camera()); }, "sun_direction");
    expect_error([&] { frame_box({}, {0, 0, 0}, 1); }, "direction");
    expect_error([&] { frame_box({}, {0, 0, -1}, 0); }, "aspect");
}

TEST_F(RendererErrors, Files) {
    expect_error([&] { write_png({}, "x.png"); }, "no pixels");
    const Image image{1, 1, {1, 2, 3, 4}};
    expect_error([&] { write_png(image, "/nonexistent/x.png"); }, "/nonexistent/x.png");
}

// Not errors: drawn as far as there is something to draw.
TEST_F(RendererErrors, DegenerateCurvesAreDrawnAsFarAsTheyGo) {
    Target target(renderer, 64, 64);
    const Image empty = picture(target);
    Curves nothing;
    nothing.add({0, 0, 0});
    nothing.end();
    for (int i = 0; i < 5; ++i) nothing.add({0.1f, 0.1f, 0.1f});
    nothing.end(true);
    nothing.end();
    for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line})
        renderer.upload(nothing.view(), {.shape = shape});
    EXPECT_EQ(differing_pixels(picture(target), empty), 0u);
    EXPECT_TRUE(renderer.bounds().empty());
    EXPECT_NO_THROW(renderer.upload(FlgCurveSetView{}));

    Curves odd;
    for (const float x : {0.0f, 0.5f, 0.5f, 0.0f, 0.5f}) odd.add({x, 0, 0});  // there and back, with a repeated point
    odd.end();
    odd.add({0, 0.1f, 0});
    odd.add({0.5f, 0.1f, 0});
    odd.end(true);  // closed with two points: a line
    for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line})
        renderer.upload(odd.view(), {.shape = shape, .radius = 0.05f});
    EXPECT_GT(differing_pixels(picture(target), empty), 20u);
}

TEST_F(RendererErrors, HugeCoordinatesDoNotCrash) {
    Target target(renderer, 32, 32);
    Curves curves;
    for (int i = 0; i < 100; ++i) curves.add({1e12f * static_cast<float>(i), 1e12f, std::sin(static_cast<float>(i))});
    curves.end();
    renderer.upload(curves.view(), {.shape = Shape::tube});
    picture(target, frame_box(renderer.bounds(), {0, 0, -1}, 1));
}

}  // namespace
}  // namespace flg::render::test
