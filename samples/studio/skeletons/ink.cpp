// SPDX-License-Identifier: MIT
#include "skeletons/ink.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flg::studio::ink {
namespace {

int byte_of(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float srgb = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
    return static_cast<int>(255.0f * srgb + 0.5f);
}

ImVec2 vec(glm::vec2 v) {
    return {v.x, v.y};
}

}  // namespace

ImU32 solid(const glm::vec3& linear) {
    return IM_COL32(byte_of(linear.x), byte_of(linear.y), byte_of(linear.z), 255);
}

void line(ImDrawList& list, std::span<const glm::vec2> points, ImU32 color, float width, bool closed) {
    std::vector<ImVec2> path;
    for (const glm::vec2& p : points) path.push_back(vec(p));
    list.AddPolyline(path.data(), static_cast<int>(path.size()), color, closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                     width);
}

void dashes(ImDrawList& list, glm::vec2 from, glm::vec2 to, ImU32 color, float width, float dash) {
    constexpr int kMost = 2000;
    const float length = glm::distance(from, to);
    const int count = std::min(static_cast<int>(length / (2.0f * dash)) + 1, kMost);
    const glm::vec2 step = (to - from) / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        const glm::vec2 at = from + static_cast<float>(i) * step;
        list.AddLine(vec(at), vec(at + 0.5f * step), color, width);
    }
}

void knob(ImDrawList& list, glm::vec2 at, float radius, ImU32 color, bool hovered, float unit) {
    const float size = (hovered ? 1.35f : 1.0f) * radius * unit;
    list.AddCircleFilled(vec(at), size, hovered ? kHover : color);
    list.AddCircle(vec(at), size, kShade, 0, 2.0f * unit);
}

void label(ImDrawList& list, glm::vec2 at, const char* text, float unit) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float pad = 4.0f * unit;
    list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad}, IM_COL32(20, 24, 34, 200),
                       4.0f * unit);
    list.AddText(vec(at), IM_COL32(245, 245, 240, 255), text);
}

}  // namespace flg::studio::ink
