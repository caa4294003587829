// SPDX-License-Identifier: MIT
// Words on finished pictures, in DejaVu Sans.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "filigree_renderer/image.h"

namespace flg::panels {

enum class Align { left, center, right };

// Writes one line of UTF-8, `size` pixels high, whose capitals are centred at `at.y`. `color` is linear RGB. A light
// rim keeps the words legible over whatever is behind them. Throws std::runtime_error where the font is missing.
void write_words(render::Image& image, std::string_view text, glm::vec2 at, float size, glm::vec3 color,
                 Align align = Align::left);

// How wide that line is, pixels.
float width_of(std::string_view text, float size);

// A round dot, as keys have them.
void draw_dot(render::Image& image, glm::vec2 center, float radius, glm::vec3 color);

}  // namespace flg::panels
