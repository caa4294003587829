// SPDX-License-Identifier: MIT
// A lost device: found wherever it can be, and got over with the same pictures.
#include "meshes.h"
#include "windows.h"

namespace flg::render::test {
namespace {

class RecoveryTest : public RendererTest {
protected:
    struct Ids {
        CurvesId curves;
        SurfaceId surface;
        TextureId texture;
    };
    // Of a scene and a picture that goes over it.
    Ids upload(Renderer& to) {
        return {to.upload(knot_.view(), {.shape = Shape::tube, .radius = 0.1f}), to.upload(ball_.view()),
                to.upload(Image{1, 1, {250, 10, 20, 255}})};
    }
    static void draw(Renderer& by, Target& target, TextureId texture) {
        constexpr UiVertex vertices[] = {{{0, 0}, {0, 0}, ~0u}, {{20, 0}, {1, 0}, ~0u}, {{0, 20}, {0, 1}, ~0u}};
        constexpr uint16_t indices[] = {0, 1, 2};
        const UiCommand commands[] = {{0, 3, 0, texture, {0, 0, 64, 64}}};
        by.draw(target, front_camera(), {.ui = {vertices, indices, commands}});
    }
    Curves knot_ = trefoil(300);
    Mesh ball_ = sphere(0.5f, 12);
};

TEST_F(RecoveryTest, PicturesAreTheSameWhereverTheLossIsFound) {
    Scene scene;
    scene.exposure = 1.3f;
    renderer.set_scene(scene);
    Target target(renderer, 96, 64), other(renderer, 32, 32);
    Ids ids = upload(renderer);
    draw(renderer, target, ids.texture);
    const Image before = renderer.capture(target);
    bool lost = true;
    uint32_t calls = 0;
    for (; lost; ++calls) {
        ASSERT_LT(calls, 50u);
        renderer.simulate_device_loss(calls);
        lost = false;
        try {
            renderer.update(ids.surface, ball_.view());
            draw(renderer, target, ids.texture);
            draw(renderer, target, ids.texture);
            renderer.capture(target);
            target.resize(96, 64);
            renderer.wait_idle();
        } catch (const DeviceLost& error) {
            lost = true;
            EXPECT_NE(std::string(error.what()).find("The device was lost"), std::string::npos) << error.what();
            EXPECT_THROW(draw(renderer, target, ids.texture), DeviceLost);
            EXPECT_THROW(renderer.wait_idle(), DeviceLost);
            EXPECT_NO_THROW(renderer.remove(ids.curves));
        }
        renderer.recover();
        EXPECT_EQ(target.width(), 96u);
        EXPECT_EQ(renderer.capture(target).at(5, 5)[0], 0) << "pictures are lost";
        EXPECT_TRUE(renderer.bounds().empty());
        EXPECT_EQ(renderer.scene().exposure, 1.3f);
        expect_error([&] { renderer.remove(ids.surface); }, "no surfaces with the id");
        const Ids fresh = upload(renderer);
        EXPECT_GT(fresh.curves.value, ids.curves.value);
        EXPECT_GT(fresh.surface.value, ids.surface.value);
        EXPECT_GT(fresh.texture.value, ids.texture.value);
        ids = fresh;
        draw(renderer, target, ids.texture);
        EXPECT_EQ(renderer.capture(target).pixels, before.pixels);
        renderer.draw(other, front_camera());
    }
    EXPECT_GT(calls, 7u) << "frames, captures and waits find it, each at more than one place";
}

TEST_F(RecoveryTest, EverythingLostCanBeDestroyed) {
    for (const uint32_t calls : {0u, 1u, 2u, 3u}) {
        Renderer doomed(options());
        Target target(doomed, 64, 64);
        const Ids ids = upload(doomed);
        draw(doomed, target, ids.texture);
        doomed.simulate_device_loss(calls);
        try {
            for (int i = 0; i < 5; ++i) {
                doomed.update(ids.surface, ball_.view());
                draw(doomed, target, ids.texture);
            }
            ADD_FAILURE() << "no loss after " << calls << " calls";
        } catch (const DeviceLost&) {}
        Target another(doomed, 16, 16);
        expect_silence(doomed);
    }
}

TEST_F(RecoveryTest, WindowsGoOn) {
    if (!has_display()) return expect_no_window(renderer);
    Window window(renderer, 320, 200, "Filigree");
    Ids ids = upload(renderer);
    ASSERT_TRUE(window.poll_events());
    draw(renderer, window, ids.texture);
    const Image before = renderer.capture(window);
    bool lost = true;
    for (uint32_t calls = 0; lost; ++calls) {
        ASSERT_LT(calls, 50u);
        renderer.simulate_device_loss(calls);
        lost = false;
        try {
            for (int i = 0; i < 3; ++i) {
                window.poll_events();
                draw(renderer, window, ids.texture);
            }
        } catch (const DeviceLost&) {
            lost = true;
        }
        renderer.recover();
        ids = upload(renderer);
        ASSERT_TRUE(window.poll_events());
        draw(renderer, window, ids.texture);
        EXPECT_EQ(renderer.capture(window).pixels, before.pixels);
    }
}

TEST_F(RecoveryTest, WindowsOfANewSizeEachFrame) {
    if (!has_display()) return expect_no_window(renderer);
    Window window(renderer, 320, 200, "Filigree");
    upload(renderer);
    for (uint32_t i = 0; i < 40; ++i) {
        window.set_size(200 + 17 * (i % 7), 150 + 11 * (i % 5));
        if (i % 3 == 0) {
            ASSERT_TRUE(window.poll_events());
        }
        renderer.draw(window, front_camera());
        const Image image = renderer.capture(window);
        ASSERT_EQ(image.pixels.size(), size_t{4} * window.width() * window.height());
    }
}

}  // namespace
}  // namespace flg::render::test
