// SPDX-License-Identifier: MIT
// A window to draw into, by GLFW. Use from the main thread only, and destroy before its Renderer.
#pragma once

#include "filigree_renderer/renderer.h"

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
    void set_size(uint32_t width, uint32_t height);

    // What the mouse moves; set its camera first.
    Orbit orbit;

private:
    bool begin_frame(uint32_t slot) override;
    void end_frame(FrameSubmission& submission) override;
    void present(FrameSubmission& submission) override;

    struct State;
    std::unique_ptr<State> window_;
};

}  // namespace flg::render
