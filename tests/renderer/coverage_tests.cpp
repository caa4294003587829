// SPDX-License-Identifier: MIT
// How many pixels a shape covers, against its closed form.
#include "curves.h"

namespace flg::render::test {
namespace {

constexpr float length_m = 1.2f;
constexpr float radius_m = 0.1f;

// By how much a flat end, nearer to the camera in its middle, reaches beyond the silhouette of its plane: to first
// order in r / d the half-ellipse with the axes r and (length / 2) (r / d). In square metres, both ends.
float bulge_of_ends() {
    return 0.5f * length_m * radius_m * radius_m / camera_distance * pi;
}

class CoverageTest : public RendererTest {
protected:
    void SetUp() override {
        without_ground();
        empty_ = picture(target_);
    }
    uint32_t covered(Curves curves, const CurveLook& look) {
        const CurvesId id = renderer.upload(curves.view(), look);
        const Image image = picture(target_);
        renderer.remove(id);
        return differing_pixels(image, empty_);
    }
    Target target_{renderer, picture_size, picture_size};
    Image empty_;
};

TEST_F(CoverageTest, RibbonSeenFaceOnCoversWidthTimesLength) {
    const float expected = 2 * radius_m * length_m * pixels_per_metre() * pixels_per_metre();
    const CurveLook look{.shape = Shape::ribbon, .radius = radius_m};
    EXPECT_NEAR(covered(straight(length_m, 20, {0, 0, 1}), look), expected, 0.025f * expected);
    EXPECT_NEAR(covered(straight(length_m, 20, {0, 0, -1}), look), expected, 0.025f * expected) << "from behind";
    EXPECT_NEAR(covered(straight(length_m, 1000, {0, 0, 1}), look), expected, 0.025f * expected)
        << "with skipped points";
}

TEST_F(CoverageTest, RibbonSeenEdgeOnCoversARowOfPixels) {
    const uint32_t count = covered(straight(length_m, 20, {0, 1, 0}), {.shape = Shape::ribbon, .radius = radius_m});
    EXPECT_GE(count, static_cast<uint32_t>(0.95f * length_m * pixels_per_metre()));
    // Seen from half a radius above or below it would be a wedge; from exactly its plane it is a row of pixels.
    EXPECT_LE(count, static_cast<uint32_t>(1.2f * length_m * pixels_per_metre() / (1 - radius_m / camera_distance)));
}

// Seen from the distance d, a cylinder of radius r reaches as far as a flat band of half-width d r / sqrt(d^2 - r^2).
TEST_F(CoverageTest, TubeSeenSideOnCoversItsSilhouette) {
    const float d = camera_distance;
    const float half_width = d * radius_m / std::sqrt(d * d - radius_m * radius_m);
    const float expected = (2 * half_width * length_m + bulge_of_ends()) * pixels_per_metre() * pixels_per_metre();
    for (const Caps caps : {Caps::flat, Caps::none}) {
        const CurveLook look{.shape = Shape::tube, .radius = radius_m, .sides = 32, .caps = caps};
        EXPECT_NEAR(covered(straight(length_m, 30, {0, 1, 0}), look), expected, 0.03f * expected);
    }
}

TEST_F(CoverageTest, RoundCapsAddTwoHalfDiscs) {
    const CurveLook flat{.shape = Shape::tube, .radius = radius_m, .sides = 32, .caps = Caps::flat};
    CurveLook round = flat;
    round.caps = Caps::round;
    const float disc = (pi * radius_m * radius_m - bulge_of_ends()) * pixels_per_metre() * pixels_per_metre();
    const Curves curves = straight(length_m, 30, {0, 1, 0});
    EXPECT_NEAR(static_cast<float>(covered(curves, round)) - static_cast<float>(covered(curves, flat)), disc,
                0.12f * disc);
}

TEST_F(CoverageTest, LinesHaveTheirWidthInPixels) {
    for (const float width : {2.0f, 6.0f}) {
        const CurveLook look{.shape = Shape::line, .line_width_px = width};
        const float expected = width * length_m * pixels_per_metre();
        EXPECT_NEAR(covered(straight(length_m, 30, {0, 1, 0}), look), expected, 0.05f * expected);
    }
}

// A right angle in the plane of the ribbon: mitred, its area is its width times the length of its centre line.
TEST_F(CoverageTest, JointsKeepTheWidth) {
    Curves curves;
    for (const glm::vec3 p : {glm::vec3(-0.6f, 0, 0), glm::vec3(0, 0, 0), glm::vec3(0, 0.6f, 0)}) {
        curves.add(p);
        curves.normals.insert(curves.normals.end(), {0, 0, 1});
    }
    curves.end();
    const float expected = 2 * radius_m * 1.2f * pixels_per_metre() * pixels_per_metre();
    EXPECT_NEAR(covered(curves, {.shape = Shape::ribbon, .radius = radius_m}), expected, 0.025f * expected);
}

// An arc that comes to the camera and goes away again, its ribbon upright. In the middle the normal points along the
// curve, as a target's does on a result of flgCurveSetStylize: the ribbon must not cross over itself there.
TEST_F(CoverageTest, RibbonsStayWholeWhereTheNormalPointsAlongTheCurve) {
    Curves level, radial;
    constexpr int segments = 10;
    for (int i = 0; i <= segments; ++i) {
        const float angle = (static_cast<float>(i) / segments - 0.5f) * 0.6f * pi;
        const glm::vec3 out(std::sin(angle), 0, std::cos(angle));
        for (Curves* c : {&level, &radial}) c->add(0.6f * out - glm::vec3(0, 0, 0.4f));
        level.normals.insert(level.normals.end(), {1, 0, 0});
        radial.normals.insert(radial.normals.end(), {out.x, out.y, out.z});
    }
    level.end();
    radial.end();
    const CurveLook look{.shape = Shape::ribbon, .radius = radius_m};
    const auto expected = static_cast<float>(covered(radial, look));
    EXPECT_NEAR(covered(level, look), expected, 0.01f * expected);
}

// A torus seen from its axis, at least as far as a ring goes: closed curves have no gap and no caps.
TEST_F(CoverageTest, ClosedTubeIsARing) {
    constexpr float ring = 0.6f;
    Curves closed, open;
    for (int i = 0; i < 200; ++i)
        for (Curves* c : {&closed, &open}) c->add({ring * std::cos(i * pi / 100), ring * std::sin(i * pi / 100), 0});
    closed.end(true);
    open.end();
    const CurveLook look{.shape = Shape::tube, .radius = radius_m, .sides = 32, .caps = Caps::flat};
    const float expected = 2 * radius_m * 2 * pi * ring * pixels_per_metre() * pixels_per_metre();
    const uint32_t count = covered(closed, look);
    EXPECT_NEAR(count, expected, 0.03f * expected);
    EXPECT_GT(count, covered(open, look)) << "the last segment is missing from the open one";
}

TEST_F(CoverageTest, RestIsBackground) {
    Curves curves = straight(length_m, 20, {0, 0, 1});
    renderer.upload(curves.view(), {.shape = Shape::ribbon, .radius = radius_m});
    const Image image = picture(target_);
    const uint32_t half_height = static_cast<uint32_t>(std::ceil(radius_m * pixels_per_metre())) + 2;
    for (uint32_t y = 0; y < picture_size; ++y) {
        if (y + half_height > picture_size / 2 && y < picture_size / 2 + half_height) continue;
        for (uint32_t x = 0; x < picture_size; ++x)
            ASSERT_EQ(std::memcmp(image.at(x, y), empty_.at(x, y), 4), 0) << x << ", " << y;
    }
}

}  // namespace
}  // namespace flg::render::test
