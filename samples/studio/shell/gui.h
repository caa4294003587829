// SPDX-License-Identifier: MIT
// ImGui between the app's input and the renderer's UI pass: one context, one font, one look. What ImGui's own backends would
// do, without a second renderer in the program.
#pragma once

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

    // Whether the mouse, and the keys, are the widgets' in this frame.
    bool wants_mouse() const;
    bool wants_keys() const;
    void device_lost();

private:
    void upload_font();

    render::Renderer& renderer_;
    ImGuiContext* context_;
    render::TextureId font_{};
    std::vector<render::UiVertex> vertices_;
    std::vector<uint16_t> indices_;
    std::vector<render::UiCommand> commands_;
};

}  // namespace flg::studio
