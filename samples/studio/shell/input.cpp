// SPDX-License-Identifier: MIT
#include "shell/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace flg::studio {
namespace {

struct Listener {
    Input* input;
    double (*now)();
};

Listener& listener() {
    static Listener one{};
    return one;
}

void push(InputEvent event) {
    event.seconds = listener().now();
    listener().input->push(std::move(event));
}

// GLFW's places are in its own units, which need not be pixels.
glm::vec2 pixels(GLFWwindow* window, double x, double y) {
    int units_wide = 0, units_high = 0, wide = 0, high = 0;
    glfwGetWindowSize(window, &units_wide, &units_high);
    glfwGetFramebufferSize(window, &wide, &high);
    const double sx = units_wide > 0 ? static_cast<double>(wide) / units_wide : 1.0;
    const double sy = units_high > 0 ? static_cast<double>(high) / units_high : 1.0;
    return {static_cast<float>(x * sx), static_cast<float>(y * sy)};
}

}  // namespace

void Input::begin_frame() {
    const glm::vec2 before = px;
    scrolled = {};
    for (int b = 0; b < kButtons; ++b) pressed[b] = released[b] = false;
    pressed_keys.clear();
    text.clear();
    dropped.clear();
    path.clear();
    while (!events_.empty()) {
        const InputEvent& event = events_.front();
        using Kind = InputEvent::Kind;
        if (event.kind == Kind::press || event.kind == Kind::release) {
            if (event.code < 0 || event.code >= kButtons) {
                events_.pop_front();
                continue;
            }
            const int b = event.code;
            if (pressed[b] || released[b]) break;  // the next frame's
            down[b] = event.kind == Kind::press;
            (down[b] ? pressed : released)[b] = true;
        } else if (event.kind == Kind::move) {
            // Once a button has changed, where it did counts.
            if (pressed[kLeft] || released[kLeft] || pressed[kRight] || released[kRight]) break;
            px = event.px;
            path.push_back({event.px, event.seconds});
        } else if (event.kind == Kind::scroll) {
            scrolled += event.px;
        } else if (event.kind == Kind::key_press || event.kind == Kind::key_release) {
            if (event.code >= 0 && event.code < 512) keys[event.code] = event.kind == Kind::key_press;
            if (event.kind == Kind::key_press) pressed_keys.push_back(event.code);
        } else if (event.kind == Kind::text) {
            text.push_back(static_cast<char32_t>(event.code));
        } else {
            dropped.push_back(event.path);
        }
        events_.pop_front();
    }
    moved = before.x < 0.0f ? glm::vec2(0.0f) : px - before;
}

bool Input::control() const {
    return keys[GLFW_KEY_LEFT_CONTROL] || keys[GLFW_KEY_RIGHT_CONTROL];
}
bool Input::shift() const {
    return keys[GLFW_KEY_LEFT_SHIFT] || keys[GLFW_KEY_RIGHT_SHIFT];
}
bool Input::alt() const {
    return keys[GLFW_KEY_LEFT_ALT] || keys[GLFW_KEY_RIGHT_ALT];
}

void listen(GLFWwindow* window, Input& input, double (*now)()) {
    using Kind = InputEvent::Kind;
    listener() = {&input, now};
    glfwSetCursorPosCallback(
        window, [](GLFWwindow* from, double x, double y) { push({.kind = Kind::move, .px = pixels(from, x, y)}); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow*, int button, int action, int) {
        push({.kind = action == GLFW_PRESS ? Kind::press : Kind::release, .code = button});
    });
    glfwSetScrollCallback(window, [](GLFWwindow*, double x, double y) {
        push({.kind = Kind::scroll, .px = {static_cast<float>(x), static_cast<float>(y)}});
    });
    glfwSetKeyCallback(window, [](GLFWwindow*, int key, int, int action, int) {
        push({.kind = action == GLFW_RELEASE ? Kind::key_release : Kind::key_press, .code = key});
    });
    glfwSetCharCallback(window, [](GLFWwindow*, unsigned character) {
        push({.kind = Kind::text, .code = static_cast<int>(character)});
    });
    glfwSetDropCallback(window, [](GLFWwindow*, int count, const char** paths) {
        for (int i = 0; i < count; ++i) push({.kind = Kind::drop, .path = paths[i]});
    });
    // Keys that go up elsewhere are not heard of.
    glfwSetWindowFocusCallback(window, [](GLFWwindow*, int focused) {
        if (focused == GLFW_TRUE) return;
        for (int key = 0; key < 512; ++key)
            if (listener().input->keys[key]) push({.kind = Kind::key_release, .code = key});
        for (int b = 0; b < kButtons; ++b)
            if (listener().input->down[b]) push({.kind = Kind::release, .code = b});
    });
}

}  // namespace flg::studio
