// SPDX-License-Identifier: MIT
// Both eyes in one pass: each sees what a camera of its own sees. Fields of view that are not symmetric.
#include <algorithm>

#include "curves.h"
#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr uint32_t eye_width = 200, eye_height = 160;

// Half of 64 mm to each side, turned to where headsets look: straight on, wider outwards than towards the nose.
void make_eyes(const Camera& head, Camera (&out_eyes)[2]) {
    const glm::vec3 forward = glm::normalize(head.target - head.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, head.up));
    for (int i = 0; i < 2; ++i) {
        const float side = i == 0 ? -1.0f : 1.0f;
        out_eyes[i] = head;
        out_eyes[i].eye += 0.032f * side * right;
        out_eyes[i].target += 0.032f * side * right;
        const float outwards = 0.35f, inwards = 0.28f;
        out_eyes[i].field =
            i == 0 ? FieldOfView{-outwards, inwards, 0.3f, -0.33f} : FieldOfView{-inwards, outwards, 0.3f, -0.33f};
    }
}

// Before a wall of triangles of a few pixels: where nothing is drawn, llvmpipe's pictures by multiview are empty.
void make_scene(Renderer& r) {
    Curves knot = trefoil(60), spring = helix(200);
    r.upload(knot.view(), {.shape = Shape::tube, .radius = 0.15f, .sides = 8});
    r.upload(spring.view(), {.shape = Shape::ribbon, .radius = 0.05f});
    r.upload(spring.view(), {.shape = Shape::line, .line_width_px = 3});
    Mesh ball = sphere(0.8f, 12), wall = sheet(30, 30, 100, 100, -4);
    for (uint32_t i = 0; i < ball.triangles.size() / 3; ++i) ball.regions.push_back(i / 40 % 2);
    SurfaceLook painted;
    painted.regions = {Material{}, Material{.color = {0.1f, 0.3f, 0.6f}}};
    painted.border_width_px = 3;
    r.upload(ball.view(), painted);
    r.upload(wall.view());
}

class StereoTest : public RendererTest {
protected:
    // One target for both eyes against one for each.
    static void expect_agreement(const Options& options, uint32_t times_counted) {
        Renderer r(options);
        make_scene(r);
        Camera eyes[2];
        make_eyes({{0.3f, 1.5f, 9}, {0, 0, 0}, {0, 1, 0}}, eyes);
        StereoTarget both(r, eye_width, eye_height);
        Target one(r, eye_width, eye_height);
        r.draw(one, eyes[0]);  // with the shadow map, which then stays
        r.draw(both, eyes);
        const FrameStats stereo = r.stats();
        for (uint32_t i = 0; i < 2; ++i) {
            const Image image = r.capture(both, i);
            r.draw(one, eyes[i]);
            EXPECT_EQ(r.stats().triangles * times_counted, stereo.triangles);
            EXPECT_EQ(r.stats().draw_calls * times_counted, stereo.draw_calls);
            EXPECT_EQ(image.width, eye_width);
            EXPECT_EQ(image.height, eye_height);
            const Image expected = r.capture(one);
            int most = 0;
            for (size_t k = 0; k < image.pixels.size(); ++k)
                most = std::max(most, std::abs(image.pixels[k] - expected.pixels[k]));
            EXPECT_LE(most, 1) << "eye " << i << ", " << options.samples << " samples";
        }
        expect_silence(r);
    }
};

TEST_F(StereoTest, EachEyeSeesWhatItsOwnCameraSees) {
    for (const uint32_t samples : {1u, 4u}) {
        Options wanted = options(samples);
        wanted.stereo = StereoPasses::two;
        expect_agreement(wanted, 2);
        wanted.stereo = StereoPasses::one;
        expect_agreement(wanted, 1);
    }
}

TEST_F(StereoTest, EyesSeeDifferentPictures) {
    Curves knot = trefoil(60);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.15f});
    Camera eyes[2];
    make_eyes({{0.3f, 1.5f, 9}, {0, 0, 0}, {0, 1, 0}}, eyes);
    StereoTarget both(renderer, eye_width, eye_height);
    EXPECT_EQ(renderer.capture(both, 1).pixels[3], 255) << "black before the first frame";
    renderer.draw(both, eyes);
    EXPECT_GT(differing_pixels(renderer.capture(both, 0), renderer.capture(both, 1)), 1000u);
    const Camera same[2] = {eyes[0], eyes[0]};
    renderer.draw(both, same);
    EXPECT_EQ(renderer.capture(both, 0).pixels, renderer.capture(both, 1).pixels);
    expect_error([&] { renderer.capture(both, 2); }, "The eye is 2");
    expect_error([&] { StereoTarget none(renderer, 0, 5); }, "0 x 5");
}

TEST_F(StereoTest, ChunksThatOneEyeSeesAreDrawn) {
    Curves bar = straight(1.0f, 20, {0, 0, 1});
    renderer.upload(bar.view(), {.shape = Shape::ribbon, .radius = 0.2f});
    StereoTarget both(renderer, 64, 64);
    const Camera at = front_camera(), away{{0, 0, 4}, {0, 0, 8}, {0, 1, 0}, default_fov_y_rad};
    const Camera left_sees[2] = {at, away}, right_sees[2] = {away, at}, none_sees[2] = {away, away};
    renderer.draw(both, left_sees);
    const Image left = renderer.capture(both, 0);
    const uint64_t triangles = renderer.stats().triangles;
    renderer.draw(both, right_sees);
    EXPECT_EQ(renderer.capture(both, 1).pixels, left.pixels);
    EXPECT_EQ(renderer.stats().triangles, triangles);
    renderer.draw(both, none_sees);
    EXPECT_EQ(renderer.stats().triangles, 0u);
}

TEST_F(StereoTest, ComesBackWithANewDevice) {
    for (const StereoPasses passes : {StereoPasses::one, StereoPasses::two}) {
        Options wanted = options();
        wanted.stereo = passes;
        Renderer r(wanted);
        Camera eyes[2];
        make_eyes({{0.3f, 1.5f, 9}, {0, 0, 0}, {0, 1, 0}}, eyes);
        StereoTarget both(r, eye_width, eye_height);
        make_scene(r);
        r.draw(both, eyes);
        const Image before = r.capture(both, 1);
        r.simulate_device_loss();
        EXPECT_THROW(r.draw(both, eyes), Error);
        r.recover();
        make_scene(r);
        r.draw(both, eyes);
        EXPECT_EQ(differing_pixels(r.capture(both, 1), before), 0u);
        expect_silence(r);
    }
}

TEST_F(StereoTest, SymmetricFieldIsTheCameraWithoutOne) {
    Curves knot = trefoil(100);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.15f});
    Camera camera{{0.3f, 1.5f, 9}, {0, 0, 0}, {0, 1, 0}, 0.8f};
    Target target(renderer, 128, 128);
    const Image plain = picture(target, camera);
    camera.field = FieldOfView{-0.4f, 0.4f, 0.4f, -0.4f};
    EXPECT_EQ(differing_pixels(picture(target, camera), plain), 0u);
}

// The middle of a picture cut out by a field is the picture of a wider one.
TEST_F(StereoTest, FieldsCutPicturesOut) {
    Curves knot = trefoil(100);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.15f, .sides = 12});
    Scene scene = renderer.scene();
    scene.ground = false;
    scene.background_top = scene.background_bottom = {0, 0, 0};  // the gradient is the picture's own
    renderer.set_scene(scene);
    Camera camera{{0.3f, 1.5f, 12}, {0, 0, 0}, {0, 1, 0}};
    const float reach = 0.4f;  // tangents; 256 pixels are 2 reach
    const auto field = [&](float left, float right, float up, float down) {
        return FieldOfView{std::atan(reach * left), std::atan(reach * right), std::atan(reach * up),
                           std::atan(reach * down)};
    };
    camera.field = field(-1, 1, 1, -1);
    Target whole(renderer, 256, 256), part(renderer, 128, 64);
    const Image wide = picture(whole, camera);
    camera.field = field(-0.25f, 0.75f, 0.5f, 0.0f);  // pixels 96 to 224 across, 64 to 128 down
    const Image cut = picture(part, camera);
    uint32_t different = 0, seen = 0;
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 128; ++x) {
            seen += cut.at(x, y)[0] > 20;
            different += std::abs(cut.at(x, y)[0] - wide.at(x + 96, y + 64)[0]) > 4;
        }
    EXPECT_GT(seen, 500u);
    EXPECT_LT(different, seen / 50) << "but for rounding at edges";
}

TEST_F(StereoTest, RefusesFieldsThatSeeNothing) {
    Target target(renderer, 16, 16);
    Camera camera = front_camera();
    camera.field = FieldOfView{-0.4f, 1.6f, 0.4f, -0.4f};
    expect_error([&] { renderer.draw(target, camera); }, "an angle of 1.6");
    camera.field = FieldOfView{0.4f, 0.4f, 0.4f, -0.4f};
    expect_error([&] { renderer.draw(target, camera); }, "must not be empty");
    camera.field = FieldOfView{-0.4f, 0.4f, std::nanf(""), -0.4f};
    expect_error([&] { renderer.draw(target, camera); }, "an angle of");
    StereoTarget both(renderer, 16, 16);
    const Camera eyes[2] = {front_camera(), camera};
    expect_error([&] { renderer.draw(both, eyes); }, "an angle of");
}

}  // namespace
}  // namespace flg::render::test
