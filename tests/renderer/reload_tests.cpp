// SPDX-License-Identifier: MIT
// Shaders compiled while the program runs: the same pictures as those built in, others once a file changes, and the old
// ones while it can't be compiled.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "meshes.h"

namespace flg::render::test {
namespace {

#ifdef FLG_SHADERS

class ReloadTest : public RendererTest {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("flg_shaders_" + std::to_string(getpid()));
        std::filesystem::remove_all(folder_);
        std::filesystem::copy(FLG_SHADERS, folder_);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }
    // Replaces the last occurrence.
    void edit(const char* file, const std::string& from, const std::string& to) const {
        std::ifstream in(folder_ / file);
        std::string text(std::istreambuf_iterator<char>(in), {});
        const size_t at = text.rfind(from);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, from.size(), to);
        std::ofstream(folder_ / file) << text;
    }
    Options live() const {
        Options o = options();
        o.shader_folder = folder_.string();
        return o;
    }
    std::filesystem::path folder_;
};

TEST_F(ReloadTest, CompiledShadersShowWhatBuiltInOnesShow) {
    Renderer compiled(live());
    Mesh ball = sphere(0.5f, 20);
    Curves knot = trefoil(300);
    Target target(renderer, 96, 96), same(compiled, 96, 96);
    for (Renderer* r : {&renderer, &compiled}) {
        r->upload(ball.view());
        r->upload(knot.view(), {.shape = Shape::tube, .radius = 0.1f});
    }
    compiled.draw(same, front_camera());
    EXPECT_EQ(compiled.capture(same).pixels, picture(target).pixels);
    EXPECT_FALSE(compiled.reload_shaders()) << "nothing has changed";
    EXPECT_FALSE(renderer.reload_shaders()) << "no folder";
    expect_silence(compiled);
}

TEST_F(ReloadTest, WhatIsEditedIsShownAndWhatIsBrokenIsNot) {
    Renderer compiled(live());
    Target target(compiled, 64, 64);
    Mesh ball = sphere(0.5f, 20);
    compiled.upload(ball.view());
    const auto shown = [&] {
        compiled.draw(target, front_camera());
        return compiled.capture(target);
    };
    const Image before = shown();
    edit("surface.frag", "out_color = shown(sunlit, around);", "out_color = vec4(0.0, 1.0, 0.0, 1.0);");
    EXPECT_EQ(shown().pixels, before.pixels) << "not before it is asked for";
    EXPECT_TRUE(compiled.reload_shaders());
    const Image green = shown();
    EXPECT_EQ(green.at(32, 32)[0], 0);
    EXPECT_EQ(green.at(32, 32)[1], 255);

    edit("surface.frag", "vec4(0.0, 1.0, 0.0, 1.0)", "vec4(0.0, colour, 0.0, 1.0)");
    expect_error([&] { compiled.reload_shaders(); }, "'colour' : undeclared identifier");
    expect_error([&] { compiled.reload_shaders(); }, "surface.frag");
    EXPECT_EQ(shown().pixels, green.pixels);
    edit("surface.frag", "out_color = vec4(0.0, colour, 0.0, 1.0);", "out_color = shown(sunlit, around);");
    EXPECT_TRUE(compiled.reload_shaders());
    EXPECT_EQ(shown().pixels, before.pixels);

    edit("lighting.glsl", "const float inverse_pi = 0.3183;", "const float inverse_pi = ;");
    expect_error([&] { compiled.reload_shaders(); }, "does not compile");
    std::filesystem::remove(folder_ / "ui.frag");
    std::filesystem::copy_file(std::filesystem::path(FLG_SHADERS) / "lighting.glsl", folder_ / "lighting.glsl",
                               std::filesystem::copy_options::overwrite_existing);
    expect_error([&] { compiled.reload_shaders(); }, "ui.frag\" can't be read");
    EXPECT_EQ(shown().pixels, before.pixels);
    expect_silence(compiled);
}

#endif

}  // namespace
}  // namespace flg::render::test
