// SPDX-License-Identifier: MIT
// Lines and colours of what lies over the 3D picture.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>
#include <span>

namespace flg::studio::ink {

constexpr ImU32 kLine = IM_COL32(24, 32, 54, 200), kFaint = IM_COL32(24, 32, 54, 90),
                kShade = IM_COL32(255, 255, 255, 190), kChosen = IM_COL32(255, 170, 30, 255),
                kHover = IM_COL32(255, 205, 90, 235), kGuide = IM_COL32(40, 110, 130, 150),
                kHole = IM_COL32(30, 120, 140, 255), kWrong = IM_COL32(220, 30, 20, 255),
                kAxis = IM_COL32(20, 105, 115, 220);

// Of a linear colour.
ImU32 solid(const glm::vec3& linear);
void line(ImDrawList& list, std::span<const glm::vec2> points, ImU32 color, float width, bool closed);
void dashes(ImDrawList& list, glm::vec2 from, glm::vec2 to, ImU32 color, float width, float dash);
// A disc with a rim, larger while the mouse is over it.
void knob(ImDrawList& list, glm::vec2 at, float radius, ImU32 color, bool hovered, float unit);
void label(ImDrawList& list, glm::vec2 at, const char* text, float unit);

}  // namespace flg::studio::ink
