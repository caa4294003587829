// SPDX-License-Identifier: MIT
// Surfaces with textures: where corners see them, how they wrap and shrink, refusals.
#include <cmath>
#include <limits>

#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr float size_m = 1.6f;
constexpr uint8_t full = 255;

Image one_color(uint8_t r, uint8_t g, uint8_t b) {
    return {1, 1, {r, g, b, full}};
}

// The light of an sRGB byte.
float linear(uint8_t byte) {
    const float share = static_cast<float>(byte) / full;
    return share <= 0.04045f ? share / 12.92f : std::pow((share + 0.055f) / 1.055f, 2.4f);
}

class Textures : public RendererTest {
protected:
    void SetUp() override { without_ground(); }
    // A sheet whose texture coordinates are `times` those that cover it once.
    Image seen(const std::vector<SurfaceTexture>& textures, float times = 1, uint32_t squares = 4) {
        Mesh mesh = sheet(size_m, size_m, squares, squares);
        const std::vector<float> uvs = uvs_of(mesh, times);
        SurfaceLook look;
        look.material = {.color = {1, 1, 1}, .texture = 0};
        look.textures = textures;
        look.corner_uvs = uvs;
        return seen(mesh, look);
    }
    Image seen(Mesh& mesh, const SurfaceLook& look) {
        const SurfaceId id = renderer.upload(mesh.view(), look);
        const Image image = picture(target_);
        renderer.remove(id);
        return image;
    }
    Image plain(const glm::vec3& color) {
        Mesh mesh = sheet(size_m, size_m, 4, 4);
        SurfaceLook look;
        look.material.color = color;
        return seen(mesh, look);
    }
    static std::vector<float> uvs_of(const Mesh& mesh, float times) {
        std::vector<float> uvs;
        for (const uint32_t v : mesh.triangles) {
            uvs.push_back(times * (mesh.positions[v].x / size_m + 0.5f));
            uvs.push_back(times * (0.5f - mesh.positions[v].y / size_m));
        }
        return uvs;
    }
    static const uint8_t* at(const Image& image, float x, float y) {
        const glm::ivec2 p = pixel_of(x, y);
        return image.at(static_cast<uint32_t>(p.x), static_cast<uint32_t>(p.y));
    }
    Target target_{renderer, picture_size, picture_size};
};

TEST_F(Textures, OneColorIsThatOfAMaterial) {
    const Image textured = seen({{one_color(200, 80, 30)}});
    const Image painted = plain({linear(200), linear(80), linear(30)});
    for (const float x : {-0.5f, 0.0f, 0.4f}) EXPECT_LE(max_difference(at(textured, x, x), at(painted, x, x)), 3) << x;
}

TEST_F(Textures, TheUpperLeftIsZeroZero) {
    // Red, green; blue, white.
    SurfaceTexture four{{2, 2, {full, 0, 0, full, 0, full, 0, full, 0, 0, full, full, full, full, full, full}}};
    four.nearest = true;
    const Image image = seen({four});
    EXPECT_GT(at(image, -0.4f, 0.4f)[0], 2 * at(image, -0.4f, 0.4f)[1]);
    EXPECT_GT(at(image, 0.4f, 0.4f)[1], 2 * at(image, 0.4f, 0.4f)[0]);
    EXPECT_GT(at(image, -0.4f, -0.4f)[2], 2 * at(image, -0.4f, -0.4f)[0]);
    EXPECT_GT(at(image, 0.4f, -0.4f)[0], 150);
}

TEST_F(Textures, TheyGoOnAsTheySay) {
    // Red on the left, blue on the right; twice across, so that its second half is beyond.
    SurfaceTexture halves{{2, 1, {full, 0, 0, full, 0, 0, full, full}}};
    halves.nearest = true;
    const auto is_red = [&](Wrap wrap, float x) {
        halves.wrap_u = wrap;
        const Image image = seen({halves}, 2);
        return at(image, x, 0)[0] > at(image, x, 0)[2];
    };
    EXPECT_TRUE(is_red(Wrap::repeat, 0.2f));
    EXPECT_FALSE(is_red(Wrap::repeat, 0.6f));
    EXPECT_FALSE(is_red(Wrap::mirror, 0.2f));
    EXPECT_TRUE(is_red(Wrap::mirror, 0.6f));
    EXPECT_FALSE(is_red(Wrap::clamp, 0.2f));
    EXPECT_FALSE(is_red(Wrap::clamp, 0.6f));
}

TEST_F(Textures, FarAwayTheyAreTheMeanOfTheirLight) {
    SurfaceTexture checks{{256, 256, {}}};
    for (uint32_t i = 0; i < 256 * 256; ++i)
        checks.image.pixels.insert(checks.image.pixels.end(), 3, ((i / 256 + i) & 1) != 0 ? full : uint8_t{0}),
            checks.image.pixels.push_back(full);
    const Image image = seen({checks}, 8), grey = plain(glm::vec3(0.5f));
    for (const float x : {-0.5f, -0.11f, 0.0f, 0.37f})
        EXPECT_LE(max_difference(at(image, x, -x), at(grey, x, -x)), 10) << x;
}

// Each region has its own, and one has none; they meet at vertices that all share.
TEST_F(Textures, RegionsHaveTheirOwn) {
    Mesh mesh = sheet(size_m, size_m, 4, 4);
    for (uint32_t t = 0; t < mesh.triangles.size() / 3; ++t) mesh.regions.push_back(t / 2 % 4 < 2 ? t / 2 % 4 : 2);
    const std::vector<float> uvs = uvs_of(mesh, 1);
    SurfaceLook look;
    look.regions = {Material{.color = {1, 1, 1}, .texture = 1}, Material{.color = {0, 1, 0}},
                    Material{.color = {1, 1, 1}, .texture = 0}};
    look.textures = {{one_color(0, 0, full)}, {one_color(full, 0, 0)}};
    look.corner_uvs = uvs;
    const Image image = seen(mesh, look);
    EXPECT_GT(at(image, -0.6f, 0)[0], 2 * at(image, -0.6f, 0)[2]);
    EXPECT_GT(at(image, -0.2f, 0)[1], 2 * at(image, -0.2f, 0)[0]);
    EXPECT_GT(at(image, 0.4f, 0)[2], 2 * at(image, 0.4f, 0)[0]);
}

TEST_F(Textures, WhatDoesNotFitIsRefused) {
    Mesh mesh = sheet(size_m, size_m, 1, 1);
    std::vector<float> uvs = uvs_of(mesh, 1);
    SurfaceLook look;
    look.material.texture = 1;
    look.textures = {{one_color(1, 2, 3)}};
    look.corner_uvs = uvs;
    EXPECT_THROW(renderer.upload(mesh.view(), look), Error);
    look.material.texture = 0;
    look.corner_uvs = {uvs.data(), 6};
    EXPECT_THROW(renderer.upload(mesh.view(), look), Error);
    look.corner_uvs = uvs;
    uvs[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(renderer.upload(mesh.view(), look), Error);
    uvs[3] = 0;
    look.textures[0].image.pixels.pop_back();
    EXPECT_THROW(renderer.upload(mesh.view(), look), Error);
    look.textures[0].image = one_color(1, 2, 3);
    EXPECT_NO_THROW(renderer.upload(mesh.view(), look));
    picture(target_);
}

}  // namespace
}  // namespace flg::render::test
