// SPDX-License-Identifier: MIT
#include "windows.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <chrono>
#include <thread>

#include "curves.h"

namespace flg::render::test {
namespace {

TEST_F(RendererTest, WindowOpensDrawsResizesAndIsCaptured) {
    ASSERT_EQ(Window::available(), has_display());
    if (!has_display()) return expect_no_window(renderer);
    Curves knot = trefoil(300);
    renderer.upload(knot.view(), {.shape = Shape::tube, .radius = 0.3f});
    Window window(renderer, 320, 200, "Filigree");
    window.orbit.camera = frame_box(renderer.bounds(), {-1, -0.5f, -1}, window.aspect());
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(window.poll());
        renderer.draw(window, window.orbit.camera);
    }
    const Image shown = renderer.capture(window);
    EXPECT_EQ(shown.width, window.width());
    Target target(renderer, window.width(), window.height());
    EXPECT_EQ(picture(target, window.orbit.camera).pixels, shown.pixels) << "a window shows what a target gets";

    window.set_size(400, 300);
    // The window's manager takes its time on a busy machine.
    for (int i = 0; i < 500 && window.width() != 400; ++i) {
        ASSERT_TRUE(window.poll());
        renderer.draw(window, window.orbit.camera);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(window.width(), 400u);
    EXPECT_EQ(window.height(), 300u);
    EXPECT_EQ(renderer.capture(window).pixels.size(), 4u * 400 * 300);
}

TEST_F(RendererTest, WindowLeavesItsInputToTheProgram) {
    if (!has_display()) return expect_no_window(renderer);
    static int scrolls, sizes;
    scrolls = sizes = 0;
    Window window(renderer, 320, 200, "Filigree");
    const auto on_scroll = [](GLFWwindow*, double, double) { ++scrolls; };
    const auto on_size = [](GLFWwindow*, int, int) { ++sizes; };
    EXPECT_EQ(glfwSetScrollCallback(window.handle(), on_scroll), nullptr);
    EXPECT_EQ(glfwSetFramebufferSizeCallback(window.handle(), on_size), nullptr);
    EXPECT_EQ(glfwGetWindowUserPointer(window.handle()), nullptr);
    EXPECT_GT(window.content_scale(), 0.0f);
    window.set_size(400, 300);
    // The event may come after the size is known.
    for (int i = 0; i < 500 && (window.width() != 400 || sizes == 0); ++i) {
        ASSERT_TRUE(window.poll_events());
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(window.width(), 400u) << "the size is known before the next frame";
    EXPECT_GT(sizes, 0);
    renderer.draw(window, front_camera(), {.viewport = {100, 0, 300, 300}});
    EXPECT_EQ(glfwSetScrollCallback(window.handle(), nullptr), on_scroll);
    glfwSetWindowShouldClose(window.handle(), GLFW_TRUE);
    EXPECT_FALSE(window.poll_events());
}

TEST(Orbit, TurnsAroundItsTargetAtTheSameDistance) {
    Orbit orbit;
    orbit.camera = test::front_camera();
    orbit.turn(0.5f * pi, 0);
    EXPECT_NEAR(orbit.camera.eye.x, camera_distance, 1e-5f);
    EXPECT_NEAR(orbit.camera.eye.z, 0, 1e-5f);
    orbit.turn(0, 10);  // past the pole: stops short of it
    EXPECT_NEAR(glm::length(orbit.camera.eye), camera_distance, 1e-5f);
    EXPECT_LT(orbit.camera.eye.y, camera_distance);
    orbit.zoom(0.5f);
    EXPECT_NEAR(glm::distance(orbit.camera.eye, orbit.camera.target), 0.5f * camera_distance, 1e-5f);
    const float before = glm::distance(orbit.camera.eye, orbit.camera.target);
    orbit.pan(0.3f, 0.2f);
    EXPECT_NEAR(glm::distance(orbit.camera.eye, orbit.camera.target), before, 1e-5f);
    EXPECT_GT(glm::length(orbit.camera.target), 0.1f);
}

TEST(Camera, FramesTheWholeBoxTightly) {
    const Box box{{-1, -2, -3}, {4, 1, 2}};
    for (const glm::vec3 direction : {glm::vec3(0, 0, -1), glm::vec3(-1, -0.4f, -1), glm::vec3(0, -1, 0)}) {
        for (const float aspect : {0.5f, 1.0f, 2.0f}) {
            const Camera camera = frame_box(box, direction, aspect);
            const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
            const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
            const glm::vec3 up = glm::cross(right, forward);
            const float tan_y = std::tan(0.5f * camera.fov_y_rad);
            float most = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 p{corner & 1 ? 4 : -1, corner & 2 ? 1 : -2, corner & 4 ? 2 : -3};
                const float depth = glm::dot(p - camera.eye, forward);
                ASSERT_GT(depth, 0);
                most = std::max({most, std::abs(glm::dot(p - camera.eye, right)) / (depth * tan_y * aspect),
                                 std::abs(glm::dot(p - camera.eye, up)) / (depth * tan_y)});
            }
            EXPECT_LE(most, 1.0f);
            EXPECT_GE(most, 0.9f);
        }
    }
}

TEST(Camera, FramesPointsByTheMarginAskedFor) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 200; ++i) {
        const float t = 0.1f * static_cast<float>(i);
        points.emplace_back(2 + t * std::cos(t), 3 * std::sin(2 * t), 0.3f * t);
    }
    constexpr float margin = 1.25f;
    for (const glm::vec3 direction : {glm::vec3(0, 0, -1), glm::vec3(-1, -0.4f, -1)}) {
        for (const float aspect : {0.5f, 1.0f, 2.0f}) {
            const Camera camera = frame_points(points, direction, aspect, margin);
            const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
            const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
            const glm::vec3 up = glm::cross(right, forward);
            const float tan_y = std::tan(0.5f * camera.fov_y_rad);
            glm::vec2 low(2), high(-2);  // in the picture, -1 to 1
            for (const glm::vec3& p : points) {
                const glm::vec3 arm = p - camera.eye;
                const glm::vec2 seen =
                    glm::vec2(glm::dot(arm, right) / aspect, glm::dot(arm, up)) / (glm::dot(arm, forward) * tan_y);
                low = glm::min(low, seen);
                high = glm::max(high, seen);
            }
            const glm::vec2 size = high - low;
            EXPECT_NEAR(std::max(size.x, size.y), 2 / margin, 1e-4f);
            for (int i = 0; i < 2; ++i) {
                EXPECT_GE(low[i], -1 / margin - 1e-4f);
                EXPECT_LE(high[i], 1 / margin + 1e-4f);
            }
        }
    }
}

}  // namespace
}  // namespace flg::render::test
