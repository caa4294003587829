// SPDX-License-Identifier: MIT
// The user interface over the picture: blending, clipping, textures, order; and the viewport that leaves room for it.
#include <algorithm>

#include "curves.h"

namespace flg::render::test {
namespace {

constexpr uint32_t white = 0xffffffffu;

constexpr uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) {
    return r | g << 8 | b << 16 | a << 24;
}

// Rectangles of one colour each.
struct Interface {
    std::vector<UiVertex> vertices;
    std::vector<uint16_t> indices;
    std::vector<UiCommand> commands;

    void rectangle(glm::vec2 from, glm::vec2 to, uint32_t color, TextureId texture = {},
                   glm::ivec4 clip = {0, 0, 4096, 4096}) {
        const auto first_vertex = static_cast<uint32_t>(vertices.size());
        const auto first_index = static_cast<uint32_t>(indices.size());
        vertices.push_back({from, {0, 0}, color});
        vertices.push_back({{to.x, from.y}, {1, 0}, color});
        vertices.push_back({to, {1, 1}, color});
        vertices.push_back({{from.x, to.y}, {0, 1}, color});
        for (const uint16_t i : {0, 1, 2, 0, 2, 3}) indices.push_back(i);
        commands.push_back({first_index, 6, first_vertex, texture, clip});
    }
    DrawOptions options() const { return {.ui = {vertices, indices, commands}}; }
};

class UiTest : public RendererTest {
protected:
    Image picture_with(const DrawOptions& options) {
        renderer.draw(target_, front_camera(), options);
        return renderer.capture(target_);
    }
    Target target_{renderer, 64, 48};
};

TEST_F(UiTest, HalfTransparentRectangleIsBlendedInSrgb) {
    const Image before = picture(target_);
    Interface ui;
    ui.rectangle({8, 4}, {40, 30}, rgba(255, 0, 100, 128));
    const Image after = picture_with(ui.options());
    const float alpha = 128.0f / 255.0f, source[3] = {255, 0, 100};
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const bool inside = x >= 8 && x < 40 && y >= 4 && y < 30;
            for (int c = 0; c < 3; ++c) {
                const auto below = static_cast<float>(before.at(x, y)[c]);
                const float expected = inside ? alpha * source[c] + (1 - alpha) * below : below;
                ASSERT_NEAR(after.at(x, y)[c], expected, inside ? 1.0f : 0.0f) << x << ", " << y << ", " << c;
            }
            ASSERT_EQ(after.at(x, y)[3], 255);
        }
    EXPECT_EQ(picture(target_).pixels, before.pixels) << "the next frame without it";
}

TEST_F(UiTest, CoversMultisampledPicturesTheSame) {
    Renderer smooth(options(4));
    Target target(smooth, 64, 48);
    smooth.draw(target, front_camera());
    const Image before = smooth.capture(target);
    Interface ui;
    ui.rectangle({0, 0}, {64, 24}, rgba(10, 200, 30, 255));
    smooth.draw(target, front_camera(), ui.options());
    const Image after = smooth.capture(target);
    for (uint32_t x = 0; x < 64; ++x) {
        EXPECT_EQ(after.at(x, 23)[1], 200);
        EXPECT_EQ(after.at(x, 24)[1], before.at(x, 24)[1]);
    }
    expect_silence(smooth);
}

TEST_F(UiTest, ClipCutsAndMayReachOverTheEdges) {
    const Image before = picture(target_);
    Interface ui;
    ui.rectangle({0, 0}, {64, 48}, rgba(1, 2, 3, 255), {}, {-10, 20, 30, 1000});
    ui.rectangle({0, 0}, {64, 48}, white, {}, {64, 0, 10, 10});
    ui.rectangle({0, 0}, {64, 48}, white, {}, {-10, -10, 10, 10});
    const Image after = picture_with(ui.options());
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const bool inside = x < 20 && y >= 20;
            for (int c = 0; c < 3; ++c) ASSERT_EQ(after.at(x, y)[c], inside ? c + 1 : before.at(x, y)[c]);
        }
}

TEST_F(UiTest, LaterCommandsGoOverEarlierOnes) {
    Interface ui;
    ui.rectangle({0, 0}, {40, 48}, rgba(255, 0, 0, 255));
    ui.rectangle({20, 0}, {64, 48}, rgba(0, 255, 0, 255));
    const Image image = picture_with(ui.options());
    EXPECT_EQ(image.at(10, 10)[0], 255);
    EXPECT_EQ(image.at(30, 10)[0], 0);
    EXPECT_EQ(image.at(30, 10)[1], 255);
    std::swap(ui.commands[0], ui.commands[1]);
    EXPECT_EQ(picture_with(ui.options()).at(30, 10)[0], 255);
}

TEST_F(UiTest, TexturesAreShownAsTheyAre) {
    Image checks{32, 16, {}};
    for (uint32_t i = 0; i < 32 * 16; ++i)
        for (const uint32_t value : {i * 7 % 256, i * 13 % 256, i * 29 % 256, 255u})
            checks.pixels.push_back(static_cast<uint8_t>(value));
    const TextureId id = renderer.upload(checks);
    Interface ui;
    ui.rectangle({10, 20}, {42, 36}, white, id);
    const Image image = picture_with(ui.options());
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 32; ++x)
            for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(10 + x, 20 + y)[c], checks.at(x, y)[c]);

    // Between the centres of two texels their mean, outside the outer ones' centres those.
    renderer.update(id, {2, 1, {0, 0, 0, 255, 200, 100, 50, 255}});
    Interface wide;
    wide.rectangle({0, 0}, {64, 48}, rgba(255, 255, 128, 255), id);
    const Image blurred = picture_with(wide.options());
    for (uint32_t x = 0; x < 64; ++x) {
        const float share = std::clamp((static_cast<float>(x) + 0.5f) / 32.0f - 0.5f, 0.0f, 1.0f);
        ASSERT_NEAR(blurred.at(x, 5)[0], 200 * share, 1.0f);
        ASSERT_NEAR(blurred.at(x, 5)[2], 50 * share * 128 / 255, 1.0f) << "the vertices' colour multiplies it";
    }
    renderer.remove(id);
    expect_error([&] { picture_with(wide.options()); }, "no textures with the id");
    expect_error([&] { renderer.update(id, checks); }, "no textures with the id");
    EXPECT_NO_THROW(renderer.remove(TextureId{}));
}

TEST_F(UiTest, LargeTexturesGoThroughSeveralStagingBlocks) {
    constexpr uint32_t edge = 1500;  // 9 MB
    Image image{edge, edge, std::vector<uint8_t>(size_t{4} * edge * edge, 255)};
    for (uint32_t y = 0; y < edge; ++y)
        for (uint32_t x = 0; x < edge; ++x) image.pixels[4 * (size_t{y} * edge + x)] = static_cast<uint8_t>(x + 3 * y);
    const TextureId id = renderer.upload(image);
    Target large(renderer, edge, edge);
    Interface ui;
    ui.rectangle({0, 0}, {edge, edge}, white, id);
    renderer.draw(large, front_camera(), ui.options());
    EXPECT_EQ(renderer.capture(large).pixels, image.pixels);
}

TEST_F(UiTest, FramesOfAllSizesFollowEachOther) {
    const Image before = picture(target_);
    for (const int count : {1, 4000, 3, 9000, 0, 12000}) {
        Interface ui;
        for (int i = 0; i < count; ++i) {
            const glm::vec2 at(i % 64, i / 64 % 48);
            ui.rectangle(at, at + 1.0f, rgba(static_cast<uint32_t>(i) % 256, 0, 0, 255));
        }
        // All in one command, for speed.
        for (size_t i = 0; i < ui.indices.size(); ++i)
            ui.indices[i] = static_cast<uint16_t>(ui.indices[i] + 4 * (i / 6));
        ui.commands = {{0, static_cast<uint32_t>(ui.indices.size()), 0, {}, {0, 0, 64, 48}}};
        const Image after = picture_with(ui.options());
        for (int pixel = 0; pixel < 64 * 48; ++pixel) {
            int last = -1;  // the last rectangle over this pixel
            for (int i = pixel; i < count; i += 64 * 48) last = i;
            ASSERT_EQ(after.pixels[4 * static_cast<size_t>(pixel)],
                      last < 0 ? before.pixels[4 * static_cast<size_t>(pixel)] : last % 256)
                << count << ", " << pixel;
        }
    }
}

TEST_F(UiTest, WhatIsOutOfRangeIsRefused) {
    const Image before = picture(target_);
    const auto refused = [&](auto&& change, const char* part) {
        Interface ui;
        ui.rectangle({0, 0}, {64, 48}, white);
        change(ui);
        expect_error([&] { picture_with(ui.options()); }, part);
    };
    refused([](Interface& ui) { ui.commands[0].index_count = 7; }, "indices 0 to 7; there are 6");
    refused([](Interface& ui) { ui.commands[0].first_index = ~0u; }, "there are 6");
    refused([](Interface& ui) { ui.indices[4] = 4; }, "vertex 0 + 4; there are 4");
    refused([](Interface& ui) { ui.commands[0].first_vertex = ~0u; }, "there are 4");
    refused([](Interface& ui) { ui.commands[0].texture = {77}; }, "id 77");
    refused([](Interface& ui) { ui.commands[0].clip.z = -1; }, "clip is -1 x 4096");
    expect_error([&] { renderer.upload(Image{}); }, "0 x 0");
    expect_error([&] { renderer.upload(Image{2, 2, std::vector<uint8_t>(15)}); }, "comes with 15 bytes");
    expect_error([&] { renderer.upload(Image{1u << 20, 1, std::vector<uint8_t>(4u << 20)}); }, "1048576 x 1");
    EXPECT_EQ(picture(target_).pixels, before.pixels);
}

TEST_F(UiTest, ViewportShowsWhatASmallerTargetShows) {
    Curves knot = trefoil(300);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    renderer.upload(knot.view(), {.shape = Shape::line, .line_width_px = 3, .in_front = true});
    for (const uint32_t samples : {1u, 4u}) {
        Renderer other(options(samples));
        other.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
        other.upload(knot.view(), {.shape = Shape::line, .line_width_px = 3, .in_front = true});
        Target small(other, 200, 120), large(other, 300, 260);
        const Camera camera = frame_box(other.bounds(), {-1, -0.5f, -1}, small.aspect());
        other.draw(small, camera);
        const Image wanted = other.capture(small);
        other.draw(large, camera, {.viewport = {70, 90, 200, 120}});
        const Image image = other.capture(large);
        uint32_t different = 0;
        for (uint32_t y = 0; y < 260; ++y)
            for (uint32_t x = 0; x < 300; ++x) {
                const uint8_t* pixel = image.at(x, y);
                ASSERT_EQ(pixel[3], 255);
                const bool inside = x >= 70 && x < 270 && y >= 90 && y < 210;
                for (int c = 0; c < 3; ++c) {
                    if (inside)
                        different += std::abs(pixel[c] - wanted.at(x - 70, y - 90)[c]) > 1;
                    else
                        ASSERT_EQ(pixel[c], 0);
                }
            }
        // Edges may fall the other way where they graze a sample.
        EXPECT_LE(different, 200u * 120u / 1000u);
        expect_error(
            [&] {
                other.draw(large, camera, {.viewport = {101, 0, 200, 120}});
            },
            "200 x 120 pixels at (101, 0)");
        expect_error([&] { other.draw(large, camera, {.viewport = {0, 0, 0, 120}}); }, "does not lie");
        expect_error([&] { other.draw(large, camera, {.viewport = {-1, 0, 10, 10}}); }, "does not lie");
        expect_silence(other);
    }
}

}  // namespace
}  // namespace flg::render::test
