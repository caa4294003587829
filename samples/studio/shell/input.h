// SPDX-License-Identifier: MIT
// Mouse and keys. One way in: the functions that GLFW calls, which scripts call too. Events wait in a queue, and each
// frame takes as many as it can see in their order: a button or a key that goes down and up between two frames is seen
// down in one and up in the next.
#pragma once

#include <deque>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shell/workspace.h"

struct GLFWwindow;

namespace flg::studio {

enum Button { kLeft = 0, kRight = 1, kMiddle = 2, kButtons = 3 };

struct InputEvent {
    enum class Kind { move, press, release, scroll, key_press, key_release, text, drop, expose } kind = Kind::move;
    glm::vec2 px{0.0f};     // of move, pixels of the window; of scroll, notches
    int code = 0;           // a Button; GLFW's key; of text, the character
    int modifiers = 0;      // GLFW's bits, of press, release and key_press: as they were when it happened
    bool repeated = false;  // of key_press: it is held
    double seconds = 0.0;   // when
    float pressure = 1.0f;  // of move and press: of a pen, 0 to 1
    std::string path{};     // of drop
};

struct KeyPress {
    int key = 0;        // GLFW's
    int modifiers = 0;  // GLFW's bits
    bool repeated = false;
};

class Input {
public:
    void push(InputEvent event) {
        events_.push_back(std::move(event));
        ++fresh_;
    }
    // Those pushed since the last call came one after the other between these times, in which nobody listened. A slow
    // frame's would else all come at its end, and a hand be where it was never seen.
    void came_between(double from_s, double to_s);
    // Those pushed since the last call came when they were pushed.
    void came_at_once() { fresh_ = 0; }
    // Takes events up to the next frame: at most one button's change, or one key's press with its text. `waits`: none,
    // as while a dialog opens that they are meant for.
    void begin_frame(bool waits = false);
    bool pending() const { return !events_.empty(); }

    // In this frame.
    glm::vec2 px{-1.0f}, moved{0.0f}, scrolled{0.0f};
    bool down[kButtons] = {}, pressed[kButtons] = {}, released[kButtons] = {};
    bool keys[512] = {};  // by GLFW's codes
    std::optional<KeyPress> pressed_key;
    int modifiers = 0;  // GLFW's bits: those of what was pressed or let go, else those held
    std::u32string text;
    std::vector<std::string> dropped;
    bool exposed = false;           // the window's picture is lost
    std::vector<MouseSample> path;  // begins where the left button went down, if it did

    bool control() const;
    bool shift() const;
    bool alt() const;
    bool changed() const;  // anything at all

    // Since the start.
    struct Taken {
        uint64_t buttons = 0, keys = 0;  // let go
        uint64_t notches = 0, drops = 0;
    } taken;

private:
    bool take(const InputEvent& event);
    bool take_key(const InputEvent& event);

    std::deque<InputEvent> events_;
    size_t fresh_ = 0;
    bool pointed_ = false, typed_ = false;  // in this frame
    int let_go_ = -1;                       // the key that was last, in this frame
};

// What events from now on are told: they go to `input`. All must outlive them.
struct Listener {
    Input* input = nullptr;
    std::function<double()> now;      // seconds
    std::function<float()> pressure;  // of a pen, 0 to 1; none: 1
};
// Without a window, those of scripts only.
void listen(GLFWwindow* window, Listener listener);

// What GLFW calls. Without a window places are pixels.
namespace heard {

void cursor(GLFWwindow* window, double x, double y);
void button(GLFWwindow* window, int button, int action, int modifiers);
void scroll(GLFWwindow* window, double x, double y);
void key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
void character(GLFWwindow* window, unsigned code);
void drop(GLFWwindow* window, int count, const char** paths);
void refresh(GLFWwindow* window);

}  // namespace heard

}  // namespace flg::studio
