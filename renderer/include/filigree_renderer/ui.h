// SPDX-License-Identifier: MIT
// A user interface over the picture: textured triangles, in pixels of the target. The layout matches Dear ImGui's draw
// lists, which can be passed unchanged; nothing here depends on ImGui.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace flg::render {

// The layout of ImDrawVert.
struct UiVertex {
    glm::vec2 position_px;  // from the target's upper left corner
    glm::vec2 uv;           // of the texture, 0 to 1 from its upper left corner
    uint32_t color;         // RGBA, a byte each in this order in memory; sRGB, straight alpha; multiplies the texture
};
static_assert(sizeof(UiVertex) == 20);

// An uploaded texture; zero is white.
struct TextureId {
    uint64_t value = 0;
    bool operator==(const TextureId&) const = default;
};

// Triangles with one texture, clipped to one rectangle.
struct UiCommand {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    uint32_t first_vertex = 0;  // added to each index
    TextureId texture{};
    glm::ivec4 clip{0};  // x, y, width, height in pixels: clips drawing; may extend beyond the target's edges
};

// Commands are drawn in order, each over the previous ones. Colours are blended as sRGB values, as ImGui expects. Read
// only by draw().
struct UiFrame {
    std::span<const UiVertex> vertices{};
    std::span<const uint16_t> indices{};
    std::span<const UiCommand> commands{};
};

}  // namespace flg::render
