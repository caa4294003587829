// SPDX-License-Identifier: MIT
// What a user interface draws over the picture: triangles with textures, in pixels of the target. The layout is that of
// Dear ImGui's draw lists, which can be handed over as they are; nothing here depends on it.
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

// A texture that is uploaded; zero is white.
struct TextureId {
    uint64_t value = 0;
    bool operator==(const TextureId&) const = default;
};

// Triangles of one texture within one rectangle.
struct UiCommand {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    uint32_t first_vertex = 0;  // is added to each index
    TextureId texture{};
    glm::ivec4 clip{0};  // x, y, width, height in pixels: nothing is drawn outside; may reach over the target's edges
};

// Commands are drawn in their order, each over those before. Colours are blended as their sRGB values are, as ImGui expects.
// Read by draw() only.
struct UiFrame {
    std::span<const UiVertex> vertices{};
    std::span<const uint16_t> indices{};
    std::span<const UiCommand> commands{};
};

}  // namespace flg::render
