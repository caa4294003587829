// SPDX-License-Identifier: MIT
// A window to draw into, by GLFW. Use from the main thread only, and destroy before its Renderer.
#pragma once

#include "filigree_renderer/renderer.h"

struct GLFWwindow;

namespace flg::render {

class Window : public Target {
public:
    // Whether there is a display that a window could open on.
    static bool available();

    // Opens a window of so many pixels. Throws Error when there is no display, or the device can't draw to it.
    Window(Renderer& renderer, uint32_t width, uint32_t height, const std::string& title);
    ~Window() override;

    // Handles what has happened to the window since the last call: closing, resizing, the mouse (drag = turn, right drag
    // or shift + drag = pan, wheel = zoom; Escape closes). False once it is to close.
    bool poll();
    // For programs with an input of their own: handles closing and resizing and nothing else, and draws on no callback of
    // GLFW's. False once it is to close.
    bool poll_events();
    void set_size(uint32_t width, uint32_t height);

    // For callbacks, cursors, the clipboard and what else GLFW offers. poll() installs a scroll callback and the user pointer
    // when it is first called; otherwise all of them are the program's.
    GLFWwindow* handle() const;
    // Pixels of the display to a point of the system's: 1, or 2 on a display of twice the usual density.
    float content_scale() const;

    // What the mouse moves in poll(); set its camera first.
    Orbit orbit;

private:
    bool begin_frame(uint32_t slot) override;
    void end_frame(FrameSubmission& submission) override;
    void present(FrameSubmission& submission) override;
    void abandon_frame() noexcept override;
    void leave_device() noexcept override;
    // Makes images for the window's present size if they are not; false: it has no area.
    bool fit();

    struct State;
    std::unique_ptr<State> window_;
};

}  // namespace flg::render
