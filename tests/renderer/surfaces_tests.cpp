// SPDX-License-Identifier: MIT
// Shape, light and life of surfaces.
#include <optional>
#include <thread>

#include "meshes.h"

namespace flg::render::test {
namespace {

class SurfacesTest : public RendererTest {
protected:
    void SetUp() override {
        without_ground();
        empty_ = picture(target_);
    }
    Image seen(Mesh mesh, const SurfaceLook& look = {}, const Camera& camera = front_camera()) {
        const SurfaceId id = renderer.upload(mesh.view(), look);
        const Image image = picture(target_, camera);
        renderer.remove(id);
        return image;
    }
    Target target_{renderer, picture_size, picture_size};
    Image empty_;
};

// A ball of radius r at the distance d reaches as far as a disc of radius d r / sqrt(d^2 - r^2) at its centre.
TEST_F(SurfacesTest, SphereCoversItsSilhouette) {
    for (const float radius : {0.3f, 0.9f}) {
        const float d = camera_distance;
        const float disc = d * radius / std::sqrt(d * d - radius * radius) * pixels_per_metre();
        EXPECT_NEAR(differing_pixels(seen(sphere(radius, 100)), empty_), pi * disc * disc, 0.01f * pi * disc * disc);
    }
}

TEST_F(SurfacesTest, BothSidesAreDrawn) {
    const float expected = 0.8f * 0.6f * pixels_per_metre() * pixels_per_metre();
    Mesh front = sheet(0.8f, 0.6f, 3, 2), back = front;
    for (size_t i = 0; i < back.triangles.size(); i += 3) std::swap(back.triangles[i], back.triangles[i + 1]);
    const Image from_front = seen(front), from_back = seen(back);
    EXPECT_NEAR(differing_pixels(from_front, empty_), expected, 0.01f * expected);
    // Turned over it has the normals of the other side, which are turned to the viewer.
    EXPECT_EQ(differing_pixels(from_front, from_back), 0u);
}

// Normals made at the upload are as good as those of the sphere itself, but for what the seam lacks.
TEST_F(SurfacesTest, SmoothNormalsAreThoseOfTheShape) {
    Mesh computed = sphere(0.9f, 64), given = computed;
    for (const glm::vec3& p : given.positions) given.normals.push_back(p);
    const Image a = seen(computed), b = seen(given);
    uint32_t different = 0;
    for (uint32_t y = 0; y < picture_size; ++y)
        for (uint32_t x = 0; x < picture_size; ++x) different += max_difference(a.at(x, y), b.at(x, y)) > 3;
    EXPECT_LT(different, 100u);
    EXPECT_GT(differing_pixels(a, seen(computed, {.smooth = false})), 10000u);
}

// The corners of a cube look along its diagonals however its faces are cut into triangles: normals weighted by area
// would not.
TEST_F(SurfacesTest, NormalsDoNotDependOnTheTriangulation) {
    Mesh computed;
    for (uint32_t corner = 0; corner < 8; ++corner)
        computed.positions.emplace_back(corner & 1 ? 0.5f : -0.5f, corner & 2 ? 0.5f : -0.5f,
                                        corner & 4 ? 0.5f : -0.5f);
    for (const auto& [a, b, c, d] :
         {std::array<uint32_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        computed.triangles.insert(computed.triangles.end(), {a, b, c, a, c, d});
    Mesh given = computed;
    given.normals = given.positions;
    const Camera camera{{2.0f, 1.5f, 3.0f}, {0, 0, 0}, {0, 1, 0}, default_fov_y_rad};
    const Image a = seen(computed, {}, camera), b = seen(given, {}, camera);
    int most = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4) most = std::max(most, max_difference(&a.pixels[i], &b.pixels[i]));
    EXPECT_LE(most, 2);
}

TEST_F(SurfacesTest, CurvesAndSurfacesHideEachOther) {
    Mesh mesh = sheet(1.0f, 1.0f, 2, 2);
    const SurfaceId surface = renderer.upload(mesh.view(), {.casts_shadow = false});
    const Image alone = picture(target_);
    const auto with_bar_at = [&](float z) {
        Curves bar;
        bar.add({-0.3f, 0, z});
        bar.add({0.3f, 0, z});
        bar.end();
        const CurvesId id = renderer.upload(bar.view(), {.shape = Shape::tube, .radius = 0.05f, .casts_shadow = false});
        const Image image = picture(target_);
        renderer.remove(id);
        return differing_pixels(image, alone);
    };
    EXPECT_EQ(with_bar_at(-0.2f), 0u);
    EXPECT_GT(with_bar_at(0.2f), 2000u);
    renderer.remove(surface);
}

TEST_F(SurfacesTest, CurvesCastShadowsOnSurfaces) {
    Scene scene;
    scene.ground = false;
    scene.sun_direction = {0, 0.6f, 1};
    renderer.set_scene(scene);
    Mesh mesh = sheet(1.6f, 1.6f, 4, 4);
    renderer.upload(mesh.view());
    Curves bar;
    bar.add({-0.4f, 0, 0.5f});
    bar.add({0.4f, 0, 0.5f});
    bar.end();
    CurveLook look{.shape = Shape::tube, .radius = 0.08f, .casts_shadow = false};
    const CurvesId id = renderer.upload(bar.view(), look);
    const Image without = picture(target_);
    look.casts_shadow = true;
    renderer.update(id, bar.view(), look);
    const Image with = picture(target_);
    // The shadow lies 0.5 m * 0.6 further down, where the bar does not hide it.
    const glm::ivec2 shadow = pixel_of(0, -0.3f), beside = pixel_of(0, -0.6f);
    EXPECT_LT(brightness(with.at(shadow.x, shadow.y)) + 60, brightness(without.at(shadow.x, shadow.y)));
    EXPECT_EQ(max_difference(with.at(beside.x, beside.y), without.at(beside.x, beside.y)), 0);
}

TEST_F(SurfacesTest, SurfacesCastShadowsOnCurves) {
    Scene scene;
    scene.ground = false;
    scene.sun_direction = {0, 1, 0.2f};
    renderer.set_scene(scene);
    Mesh roof = sheet(0.6f, 0.6f, 1, 1);
    for (glm::vec3& p : roof.positions) p = {p.x, 0.5f, -p.y};
    Curves bar;
    bar.add({-0.8f, 0, 0});
    bar.add({0.8f, 0, 0});
    bar.end();
    renderer.upload(bar.view(), {.shape = Shape::tube, .color_end = CurveLook{}.color, .radius = 0.1f});
    const SurfaceId id = renderer.upload(roof.view());
    const Image with = picture(target_);
    renderer.update(id, roof.view(), {.casts_shadow = false});
    const Image without = picture(target_);
    const glm::ivec2 below = pixel_of(0, 0.05f), beside = pixel_of(0.7f, 0.05f);
    EXPECT_LT(brightness(with.at(below.x, below.y)) + 60, brightness(without.at(below.x, below.y)));
    EXPECT_EQ(max_difference(with.at(beside.x, beside.y), without.at(beside.x, beside.y)), 0);
}

TEST_F(SurfacesTest, UpdateAndRemove) {
    Mesh small = sphere(0.3f, 20), large = sphere(0.6f, 40);
    const SurfaceId id = renderer.upload(small.view());
    EXPECT_NEAR(renderer.bounds().max.x, 0.3f, 1e-6f);
    const Image first = picture(target_);
    EXPECT_GT(renderer.stats().uploaded_bytes, 1000u);
    renderer.update(id, large.view());
    EXPECT_NEAR(renderer.bounds().max.x, 0.6f, 1e-6f);
    EXPECT_GT(differing_pixels(picture(target_), first), 1000u);
    EXPECT_EQ(renderer.stats().triangles, large.triangles.size() / 3);
    renderer.update(id, small.view());
    EXPECT_EQ(differing_pixels(picture(target_), first), 0u);
    renderer.remove(id);
    EXPECT_EQ(differing_pixels(picture(target_), empty_), 0u);
    EXPECT_THROW(renderer.remove(id), Error);
    EXPECT_THROW(renderer.update(id, small.view()), Error);
    EXPECT_NO_THROW(renderer.remove(SurfaceId{}));
    renderer.upload(small.view());
    renderer.clear();
    EXPECT_TRUE(renderer.bounds().empty());
}

TEST_F(SurfacesTest, WhatAThreadPreparedIsDrawnAlike) {
    Mesh mesh = sphere(0.6f, 40);
    for (uint32_t t = 0; t < mesh.triangles.size() / 3; ++t) mesh.regions.push_back(t % 2);
    SurfaceLook look;
    look.regions = {{.color = {0.5f, 0.1f, 0.1f}}, {.color = {0.1f, 0.1f, 0.5f}}};
    std::optional<PreparedSurface> prepared;
    std::thread([&] { prepared.emplace(mesh.view(), look); }).join();
    const Image expected = seen(mesh, look);
    mesh = {};  // it holds all that it needs
    const SurfaceId first = renderer.upload(*prepared);
    EXPECT_EQ(differing_pixels(picture(target_), expected), 0u);
    renderer.remove(first);
    // It can be uploaded again, and moved.
    const PreparedSurface moved = std::move(*prepared);
    renderer.upload(moved);
    EXPECT_EQ(differing_pixels(picture(target_), expected), 0u);
}

TEST_F(SurfacesTest, PreparingRefusesWhatUploadingRefuses) {
    Mesh mesh = sheet(1, 1, 2, 2);
    mesh.triangles[7] = 9;
    expect_error([&] { PreparedSurface{mesh.view()}; }, "Triangle 2 names vertex 9; the mesh has 9 vertices");
}

TEST_F(SurfacesTest, FramesFollowEachOtherWithChangesInBetween) {
    Mesh mesh = sphere(0.5f, 30);
    const SurfaceId id = renderer.upload(mesh.view());
    renderer.update(id, mesh.view());  // not yet drawn
    for (int i = 0; i < 8; ++i) {
        renderer.draw(target_, front_camera());
        renderer.update(id, mesh.view(), {.smooth = i % 2 == 0});
    }
    renderer.wait_idle();
}

TEST_F(SurfacesTest, TrianglesWithoutAnAreaAreHarmless) {
    Mesh mesh = sheet(0.8f, 0.8f, 2, 2);
    const Image plain = seen(mesh);
    mesh.triangles.insert(mesh.triangles.end(), {0, 0, 1, 4, 4, 4, 0, 1, 2});
    EXPECT_EQ(differing_pixels(seen(mesh), plain), 0u);
    Mesh point;
    point.positions.assign(3, {0.1f, 0.1f, 0.1f});
    point.triangles = {0, 1, 2};
    EXPECT_EQ(differing_pixels(seen(point), empty_), 0u);
}

// A square kilometre and a square micrometre have the normals of a square metre.
TEST_F(SurfacesTest, NormalsDoNotDependOnTheSize) {
    const Image plain = seen(sheet(0.8f, 0.8f, 2, 2));
    for (const float scale : {1e-12f, 1e12f}) {
        Mesh mesh = sheet(0.8f * scale, 0.8f * scale, 2, 2);
        Camera camera = front_camera();
        camera.eye *= scale;
        const Image image = seen(mesh, {}, camera);
        const glm::ivec2 middle = pixel_of(0.1f, 0.1f);
        EXPECT_LE(max_difference(image.at(middle.x, middle.y), plain.at(middle.x, middle.y)), 2) << scale;
    }
}

}  // namespace
}  // namespace flg::render::test
