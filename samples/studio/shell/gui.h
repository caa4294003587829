// SPDX-License-Identifier: MIT
// ImGui between the app's input and the renderer's UI pass: one context, one font, one look. What ImGui's own backends
// would do, without a second renderer in the program.
#pragma once

#include <string>
#include <vector>

#include "filigree_renderer/renderer.h"
#include "shell/input.h"

struct ImGuiContext;

namespace flg::studio {

class Gui {
public:
    // `scale`: pixels to a unit of the layout.
    Gui(render::Renderer& renderer, float scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    // Between these two the frame's widgets are made. `seconds` since the last frame.
    void begin(const Input& input, uint32_t width, uint32_t height, float seconds);
    // Valid until the next begin().
    render::UiFrame end();

    // Of all that end() gave to draw, but for what tells of frames: that alone is no reason for one.
    uint64_t fingerprint() const { return fingerprint_; }

    // Whether the mouse is the widgets' in this frame.
    bool wants_mouse() const;
    // Whose the keys are: of what is in front of the others.
    enum class Keys { app, popup, text, dialog };
    Keys keys() const;
    // Closes menus and lists, not dialogs.
    void close_popups();
    // A widget is held by the mouse: it may change by itself, as what scrolls.
    bool holds_widget() const;
    // Titles of those that are to be seen.
    std::vector<std::string> windows() const;
    void device_lost();

private:
    void upload_font();

    render::Renderer& renderer_;
    ImGuiContext* context_;
    render::TextureId font_{};
    uint64_t fingerprint_ = 0;
    std::vector<render::UiVertex> vertices_;
    std::vector<uint16_t> indices_;
    std::vector<render::UiCommand> commands_;
};

}  // namespace flg::studio
