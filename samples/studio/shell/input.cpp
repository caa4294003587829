// SPDX-License-Identifier: MIT
#include "shell/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

namespace flg::studio {
namespace {

using Kind = InputEvent::Kind;

Listener& current() {
    static Listener one{};
    return one;
}

void push(InputEvent event) {
    const Listener& listener = current();
    if (listener.input == nullptr) return;
    event.seconds = listener.now();
    if (listener.pressure) event.pressure = listener.pressure();
    listener.input->push(std::move(event));
}

// GLFW's places are in its own units, which need not be pixels.
glm::vec2 pixels(GLFWwindow* window, double x, double y) {
    int units_wide = 0, units_high = 0, wide = 0, high = 0;
    if (window != nullptr) {
        glfwGetWindowSize(window, &units_wide, &units_high);
        glfwGetFramebufferSize(window, &wide, &high);
    }
    const double sx = units_wide > 0 ? static_cast<double>(wide) / units_wide : 1.0;
    const double sy = units_high > 0 ? static_cast<double>(high) / units_high : 1.0;
    return {static_cast<float>(x * sx), static_cast<float>(y * sy)};
}

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

int held(const bool (&keys)[512]) {
    const auto either = [&](int left, int right, int bit) { return keys[left] || keys[right] ? bit : 0; };
    return either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
           either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
           either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT);
}

}  // namespace

void Input::came_between(double from_s, double to_s) {
    const size_t first = events_.size() - fresh_;
    for (size_t i = 0; i < fresh_; ++i)
        events_[first + i].seconds =
            from_s + (to_s - from_s) * static_cast<double>(i + 1) / static_cast<double>(fresh_);
    fresh_ = 0;
}

void Input::begin_frame(bool waits) {
    const glm::vec2 before = px;
    scrolled = {};
    for (int b = 0; b < kButtons; ++b) pressed[b] = released[b] = false;
    pressed_key.reset();
    text.clear();
    dropped.clear();
    exposed = false;
    path.clear();
    pointed_ = typed_ = false;
    let_go_ = -1;
    while (!waits && !events_.empty() && take(events_.front())) events_.pop_front();
    if (!pointed_ && !typed_) modifiers = held(keys);
    // The way to where a button went down is no part of a drag.
    const bool begins = pressed[kLeft] || pressed[kRight] || pressed[kMiddle];
    moved = before.x < 0.0f || begins ? glm::vec2(0.0f) : px - before;
}

// False if it is the next frame's.
bool Input::take(const InputEvent& event) {
    switch (event.kind) {
        case Kind::move:
            // Once a button has changed, where it did counts.
            if (pointed_) return false;
            px = event.px;
            path.push_back({event.px, event.seconds, event.pressure});
            return true;
        case Kind::press:
        case Kind::release: {
            if (event.code < 0 || event.code >= kButtons) return true;
            if (pointed_ || typed_) return false;
            pointed_ = true;
            modifiers = event.modifiers;
            const bool goes_down = event.kind == Kind::press;
            down[event.code] = goes_down;
            (goes_down ? pressed : released)[event.code] = true;
            if (!goes_down) ++taken.buttons;
            // The way there is no part of what begins.
            if (goes_down && event.code == kLeft) path = {{px, event.seconds, event.pressure}};
            return true;
        }
        case Kind::scroll:
            if (typed_ || (pointed_ && scrolled == glm::vec2(0.0f))) return false;
            if (!pointed_) modifiers = held(keys);
            pointed_ = true;
            scrolled += event.px;
            taken.notches += static_cast<uint64_t>(std::lround(std::abs(event.px.x) + std::abs(event.px.y)));
            return true;
        case Kind::key_press:
        case Kind::key_release: return take_key(event);
        case Kind::text:
            if (pointed_) return false;
            text.push_back(static_cast<char32_t>(event.code));
            return true;
        case Kind::drop:
            dropped.push_back(event.path);
            ++taken.drops;
            return true;
        case Kind::expose: exposed = true; return true;
    }
    return true;
}

bool Input::take_key(const InputEvent& event) {
    if (event.code < 0 || event.code >= 512) return true;
    if (event.kind == Kind::key_release) {
        if (pressed_key && pressed_key->key == event.code) return false;
        keys[event.code] = false;
        ++taken.keys;
        let_go_ = event.code;
        return true;
    }
    if (pointed_ || typed_ || event.code == let_go_) return false;
    keys[event.code] = true;
    if (is_modifier(event.code)) return true;
    typed_ = true;
    modifiers = event.modifiers;
    pressed_key = {event.code, event.modifiers, event.repeated};
    return true;
}

bool Input::control() const {
    return (modifiers & GLFW_MOD_CONTROL) != 0;
}
bool Input::shift() const {
    return (modifiers & GLFW_MOD_SHIFT) != 0;
}
bool Input::alt() const {
    return (modifiers & GLFW_MOD_ALT) != 0;
}

bool Input::changed() const {
    return pointed_ || typed_ || !path.empty() || !text.empty() || !dropped.empty();
}

void listen(GLFWwindow* window, Listener listener) {
    current() = std::move(listener);
    if (window == nullptr) return;
    glfwSetCursorPosCallback(window, heard::cursor);
    glfwSetMouseButtonCallback(window, heard::button);
    glfwSetScrollCallback(window, heard::scroll);
    glfwSetKeyCallback(window, heard::key);
    glfwSetCharCallback(window, heard::character);
    glfwSetDropCallback(window, heard::drop);
    glfwSetWindowRefreshCallback(window, heard::refresh);
}

void heard::cursor(GLFWwindow* window, double x, double y) {
    push({.kind = Kind::move, .px = pixels(window, x, y)});
}

void heard::button(GLFWwindow*, int button, int action, int modifiers) {
    push({.kind = action == GLFW_PRESS ? Kind::press : Kind::release, .code = button, .modifiers = modifiers});
}

void heard::scroll(GLFWwindow*, double x, double y) {
    push({.kind = Kind::scroll, .px = {static_cast<float>(x), static_cast<float>(y)}});
}

void heard::key(GLFWwindow*, int key, int, int action, int modifiers) {
    push({.kind = action == GLFW_RELEASE ? Kind::key_release : Kind::key_press,
          .code = key,
          .modifiers = modifiers,
          .repeated = action == GLFW_REPEAT});
}

void heard::character(GLFWwindow*, unsigned code) {
    push({.kind = Kind::text, .code = static_cast<int>(code)});
}

void heard::drop(GLFWwindow*, int count, const char** paths) {
    for (int i = 0; i < count; ++i) push({.kind = Kind::drop, .path = paths[i]});
}

void heard::refresh(GLFWwindow*) {
    push({.kind = Kind::expose});
}

}  // namespace flg::studio
