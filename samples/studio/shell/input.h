// SPDX-License-Identifier: MIT
// Mouse and keys: events come from a window or from a script, by the same way, and become what a frame sees of them. A button
// that goes down and up between two frames is seen down in one and up in the next.
#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "shell/workspace.h"

struct GLFWwindow;

namespace flg::studio {

enum Button { kLeft = 0, kRight = 1, kMiddle = 2, kButtons = 3 };

struct InputEvent {
    enum class Kind { move, press, release, scroll, key_press, key_release, text, drop } kind = Kind::move;
    glm::vec2 px{0.0f};    // of move, pixels of the window; of scroll, notches
    int code = 0;          // a Button; GLFW's key; of text, the character
    double seconds = 0.0;  // when
    std::string path{};    // of drop
};

class Input {
public:
    void push(InputEvent event) { events_.push_back(std::move(event)); }
    // Takes events up to the next frame, which shall not see a button change twice.
    void begin_frame();
    bool pending() const { return !events_.empty(); }

    // In this frame.
    glm::vec2 px{-1.0f}, moved{0.0f}, scrolled{0.0f};
    bool down[kButtons] = {}, pressed[kButtons] = {}, released[kButtons] = {};
    bool keys[512] = {};  // by GLFW's codes
    std::vector<int> pressed_keys;
    std::u32string text;
    std::vector<std::string> dropped;
    std::vector<MouseSample> path;

    bool control() const;
    bool shift() const;
    bool alt() const;

private:
    std::deque<InputEvent> events_;
};

// The window's events from now on go to `input`, which must outlive it; `now` gives their time.
void listen(GLFWwindow* window, Input& input, double (*now)());

}  // namespace flg::studio
