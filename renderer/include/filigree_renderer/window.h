// SPDX-License-Identifier: MIT
// A window to draw into, using GLFW. Use it only from the main thread, and destroy it before its Renderer.
#pragma once

#include "filigree_renderer/renderer.h"

struct GLFWwindow;

namespace flg::render {

class Window : public Target {
public:
    // Whether a display is available for a window.
    static bool available();

    // Opens a window of this size in pixels. Throws Error if there is no display, or the device cannot draw to it.
    Window(Renderer& renderer, uint32_t width, uint32_t height, const std::string& title);
    ~Window() override;

    // Handles window events since the last call: closing, resizing, the mouse (drag = turn, right drag or shift + drag
    // = pan, wheel = zoom; Escape closes). False once the window should close.
    bool poll();
    // For programs that handle input themselves: handles only closing and resizing, and uses none of GLFW's callbacks.
    // False once the window should close.
    bool poll_events();
    void set_size(uint32_t width, uint32_t height);

    // For callbacks, cursors, the clipboard and other GLFW features. poll() installs a scroll callback and the user
    // pointer on its first call; otherwise all of them belong to the program.
    GLFWwindow* handle() const;
    // Display pixels per system point: 1, or 2 on a display of twice the usual density.
    float content_scale() const;

    // The orbit that poll() moves with the mouse; set its camera first.
    Orbit orbit;

private:
    bool begin_frame(uint32_t slot) override;
    void end_frame(FrameSubmission& submission) override;
    void present(FrameSubmission& submission) override;
    void abandon_frame() noexcept override;
    void leave_device() noexcept override;
    // Makes images for the window's current size if needed; false: it has no area.
    bool fit();

    struct State;
    std::unique_ptr<State> window_;
};

}  // namespace flg::render
