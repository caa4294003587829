// SPDX-License-Identifier: MIT
#include "shell/notices.h"

#include <imgui.h>

#include <algorithm>

#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr float kShown_s = 6.0f, kErrorShown_s = 12.0f, kFading_s = 0.6f;
constexpr float kFadingFrame_s = 1.0f / 30.0f;
constexpr size_t kKept = 100;
constexpr int kMaxAtOnce = 5;

ImVec4 color_of(Weight weight) {
    switch (weight) {
        case Weight::info: return {0.62f, 0.80f, 0.95f, 1.0f};
        case Weight::warning: return {0.98f, 0.80f, 0.36f, 1.0f};
        case Weight::error: return {1.00f, 0.46f, 0.40f, 1.0f};
    }
    return {};
}

}  // namespace

void Notices::add(Weight weight, std::string sentence) {
    const float shown = weight == Weight::error ? kErrorShown_s : kShown_s;
    if (!log_.empty() && log_.back().sentence == sentence && log_.back().left_s > 0.0f) {
        log_.back().left_s = shown;
        return;
    }
    log_.push_back({weight, std::move(sentence), shown});
    if (log_.size() > kKept) log_.pop_front();
}

void Notices::draw(float seconds) {
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const float unit = ImGui::GetFontSize();
    float bottom = window.Pos.y + window.Size.y - 2.6f * unit;
    int drawn = 0;
    for (auto it = log_.rbegin(); it != log_.rend(); ++it) {
        if (it->left_s <= 0.0f) continue;
        it->left_s -= seconds;
        ui::frame_in(std::max(it->left_s - kFading_s, kFadingFrame_s));
        if (drawn == kMaxAtOnce) continue;
        ImGui::SetNextWindowPos({window.Pos.x + 0.5f * window.Size.x, bottom}, ImGuiCond_Always, {0.5f, 1.0f});
        ImGui::SetNextWindowBgAlpha(0.92f * std::clamp(it->left_s / kFading_s, 0.0f, 1.0f));
        const std::string name = "##notice" + std::to_string(drawn++);
        ImGui::Begin(name.c_str(), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
        ImGui::PushTextWrapPos(36.0f * unit);
        ImGui::TextColored(color_of(it->weight), "%s", it->sentence.c_str());
        ImGui::PopTextWrapPos();
        bottom -= ImGui::GetWindowHeight() + 0.4f * unit;
        ImGui::End();
    }
}

}  // namespace flg::studio
