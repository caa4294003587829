// SPDX-License-Identifier: MIT
#include "tangles/action_icons.h"

#include <imgui.h>

#include <cmath>

namespace flg::studio {
namespace {

constexpr ImU32 kInk = IM_COL32(240, 225, 200, 255), kGold = IM_COL32(240, 170, 70, 255);
constexpr float kTurn = 6.2831853f;

class Icon {
public:
    Icon(ImDrawList& list, const ImVec2& center, float size) : list_(list), center_(center), half_(0.5f * size) {}
    // Places are -1 to 1, y downwards.
    ImVec2 at(float x, float y) const { return {center_.x + half_ * x, center_.y + half_ * y}; }
    void line(float x0, float y0, float x1, float y1, ImU32 color = kInk) const {
        list_.AddLine(at(x0, y0), at(x1, y1), color, 0.13f * half_);
    }
    void ring(float x, float y, float r, ImU32 color = kInk) const {
        list_.AddCircle(at(x, y), r * half_, color, 0, 0.13f * half_);
    }
    void dot(float x, float y, float r, ImU32 color = kGold) const {
        list_.AddCircleFilled(at(x, y), r * half_, color);
    }
    void box(float x0, float y0, float x1, float y1, ImU32 color = kInk) const {
        list_.AddRect(at(x0, y0), at(x1, y1), color, 0.0f, 0, 0.13f * half_);
    }
    void fill(float x0, float y0, float x1, float y1, ImU32 color = kGold) const {
        list_.AddRectFilled(at(x0, y0), at(x1, y1), color);
    }

private:
    ImDrawList& list_;
    const ImVec2 center_;
    const float half_;
};

void draw_cells(const Icon& icon) {
    icon.line(-0.1f, -0.15f, -0.35f, -0.9f);
    icon.line(-0.1f, -0.15f, 0.5f, 0.0f);
    icon.line(-0.1f, -0.15f, -0.4f, 0.3f);
    icon.line(0.5f, 0.0f, 0.9f, -0.4f);
    icon.line(0.5f, 0.0f, 0.4f, 0.9f);
    icon.line(-0.4f, 0.3f, -0.9f, 0.2f);
    icon.line(-0.4f, 0.3f, -0.2f, 0.9f);
}

}  // namespace

void draw_action_icon(ImDrawList& list, Action action, const ImVec2& center, float size) {
    const Icon icon(list, center, size);
    switch (action) {
        case Action::contour:
            icon.dot(0, 0, 0.2f);
            icon.ring(0, 0, 0.55f);
            icon.ring(0, 0, 0.92f);
            break;
        case Action::stream:
            icon.line(-0.9f, 0.9f, 0.9f, 0.9f, kGold);
            for (int i = 0; i < 4; ++i) icon.line(-0.7f + 0.47f * i, 0.8f, -0.7f + 0.47f * i, -0.9f);
            break;
        case Action::voronoi:
            draw_cells(icon);
            icon.dot(0.35f, -0.55f, 0.14f);
            icon.dot(-0.65f, -0.3f, 0.14f);
            icon.dot(0.1f, 0.45f, 0.14f);
            break;
        case Action::polyline:
            icon.line(-0.8f, 0.6f, -0.3f, -0.6f);
            icon.line(-0.3f, -0.6f, 0.3f, 0.4f);
            icon.line(0.3f, 0.4f, 0.85f, -0.5f);
            icon.dot(-0.8f, 0.6f, 0.17f);
            icon.dot(-0.3f, -0.6f, 0.17f);
            icon.dot(0.3f, 0.4f, 0.17f);
            icon.dot(0.85f, -0.5f, 0.17f);
            break;
        case Action::sunburst:
            icon.ring(0, 0, 0.3f, kGold);
            for (int i = 0; i < 10; ++i) {
                const float a = kTurn * static_cast<float>(i) / 10.0f;
                icon.line(0.4f * std::cos(a), 0.4f * std::sin(a), 0.95f * std::cos(a), 0.95f * std::sin(a));
            }
            break;
        case Action::polka_dots:
            icon.dot(-0.5f, -0.5f, 0.26f);
            icon.dot(0.35f, -0.65f, 0.26f);
            icon.dot(0.05f, 0.1f, 0.26f);
            icon.dot(-0.6f, 0.6f, 0.26f);
            icon.dot(0.65f, 0.6f, 0.26f);
            break;
        case Action::frames:
            icon.box(-0.9f, -0.9f, 0.9f, 0.9f);
            icon.box(-0.55f, -0.55f, 0.55f, 0.55f, kGold);
            icon.box(-0.2f, -0.2f, 0.2f, 0.2f);
            break;
        case Action::flower:
            for (int i = 0; i < 5; ++i) {
                const float a = kTurn * (static_cast<float>(i) / 5.0f - 0.25f);
                icon.ring(0.52f * std::cos(a), 0.52f * std::sin(a), 0.34f);
            }
            icon.dot(0, 0, 0.24f);
            break;
        case Action::grid:
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 3; ++x)
                    if ((x + y) % 2 == 0)
                        icon.fill(-0.9f + 0.6f * x, -0.9f + 0.6f * y, -0.3f + 0.6f * x, -0.3f + 0.6f * y);
            icon.box(-0.9f, -0.9f, 0.9f, 0.9f);
            break;
        case Action::outline:
            icon.ring(0, 0, 0.9f);
            icon.ring(0, 0, 0.65f, kGold);
            break;
        case Action::lace:
            icon.line(-0.95f, -0.5f, 0.95f, -0.5f, kGold);
            for (int i = 0; i < 3; ++i) {
                const float x = -0.64f + 0.64f * static_cast<float>(i);
                list.PathArcTo(icon.at(x, -0.4f), 0.16f * size, 0.0f, 0.5f * kTurn);
                list.PathStroke(kInk, 0, 0.065f * size);
            }
            for (int i = 0; i < 2; ++i) {
                const float x = -0.32f + 0.64f * static_cast<float>(i);
                list.PathArcTo(icon.at(x, 0.1f), 0.16f * size, 0.0f, 0.5f * kTurn);
                list.PathStroke(kInk, 0, 0.065f * size);
            }
            break;
        case Action::cells: draw_cells(icon); break;
        case Action::displace: break;
    }
}

}  // namespace flg::studio
