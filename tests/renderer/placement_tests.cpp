// SPDX-License-Identifier: MIT
// A surface that is placed looks like one whose vertices were moved there.
#include "meshes.h"

namespace flg::render::test {
namespace {

Placement somewhere() {
    return {{0.2f, -0.15f, 0.1f}, glm::normalize(glm::quat(0.9f, 0.2f, -0.3f, 0.25f)), 0.6f};
}

// In two regions, so that there is a line between them.
Mesh striped_ball() {
    Mesh ball = sphere(0.7f, 48);
    for (size_t t = 0; t < ball.triangles.size(); t += 3) {
        const glm::vec3 &a = ball.positions[ball.triangles[t]], &b = ball.positions[ball.triangles[t + 1]],
                        &c = ball.positions[ball.triangles[t + 2]];
        ball.regions.push_back(a.x + b.x + c.x > 0.3f ? 1 : 0);
    }
    return ball;
}

SurfaceLook lined() {
    SurfaceLook look;
    look.border_width_px = 3.0f;
    look.regions = {{.color = {0.6f, 0.1f, 0.1f}}, {.color = {0.1f, 0.2f, 0.6f}}};
    return look;
}

TEST_F(RendererTest, APlacedSurfaceIsAMovedOne) {
    Target target(renderer, picture_size, picture_size);
    // Sheets behind all and behind the camera: the shadow map spans the same, whatever stands between.
    Mesh back = sheet(6, 6, 2, 2, -1.0f), behind = sheet(6, 6, 1, 1, 6.0f);
    renderer.upload(back.view(), {.casts_shadow = false});
    renderer.upload(behind.view(), {.casts_shadow = false});
    Mesh own = striped_ball();
    Mesh moved = own;
    for (glm::vec3& p : moved.positions) p = somewhere().point(p);
    const Image empty = picture(target);
    const SurfaceId other = renderer.upload(moved.view(), lined());
    const Image expected = picture(target);
    const Box box = renderer.bounds();
    renderer.remove(other);
    const SurfaceId id = renderer.upload(own.view(), lined());
    const Image before = picture(target);
    renderer.set_placement(id, somewhere());
    const auto different = [](const Image& a, const Image& b, int least) {
        uint32_t count = 0;
        for (size_t i = 0; i < a.pixels.size(); i += 4) count += max_difference(&a.pixels[i], &b.pixels[i]) > least;
        return count;
    };
    const Image placed = picture(target);
    EXPECT_GT(different(placed, empty, 8), 5000u);
    EXPECT_GT(different(placed, before, 8), 5000u);
    // Edges of pixels may fall to the other side.
    EXPECT_LT(different(placed, expected, 8), 60u);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(renderer.bounds().min[i], box.min[i] + 1e-5f);
        EXPECT_GE(renderer.bounds().max[i], box.max[i] - 1e-5f);
    }
    // It stays there when it is uploaded again.
    renderer.update(id, own.view(), lined());
    EXPECT_EQ(different(picture(target), placed, 0), 0u);
    renderer.set_placement(id, {});
    EXPECT_EQ(different(picture(target), before, 0), 0u);
}

TEST_F(RendererTest, APlacementMustBeSound) {
    Mesh ball = sphere(0.5f, 8);
    const SurfaceId id = renderer.upload(ball.view());
    const float infinite = std::numeric_limits<float>::infinity();
    EXPECT_THROW(renderer.set_placement(id, {.scale = 0.0f}), Error);
    EXPECT_THROW(renderer.set_placement(id, {.scale = -1.0f}), Error);
    EXPECT_THROW(renderer.set_placement(id, {.at = {infinite, 0, 0}}), Error);
    EXPECT_THROW(renderer.set_placement(id, {.turn = {2, 0, 0, 0}}), Error);
    EXPECT_THROW(renderer.set_placement({77}, {}), Error);
}

TEST(Placement, GoesThereAndBack) {
    const Placement p = somewhere(), q{{1, 2, 3}, glm::normalize(glm::quat(0.3f, 0.1f, 0.8f, -0.2f)), 2.5f};
    const glm::vec3 x(0.3f, -0.7f, 1.1f);
    EXPECT_LT(glm::distance(p.inverse().point(p.point(x)), x), 1e-6f);
    EXPECT_LT(glm::distance((p * q).point(x), p.point(q.point(x))), 1e-5f);
    EXPECT_TRUE(Placement{}.is_identity());
    EXPECT_EQ(Placement{}.point(x), x);
}

}  // namespace
}  // namespace flg::render::test
