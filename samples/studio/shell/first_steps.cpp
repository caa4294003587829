// SPDX-License-Identifier: MIT
#include "shell/first_steps.h"

#include <imgui.h>

#include <filesystem>
#include <fstream>

#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr const char* kFile = "first-steps-shown";
constexpr const char* kSentences[] = {"Drag on the vase to draw a stroke.",
                                      "Right-drag to turn the view, roll the wheel to zoom.",
                                      "Switch to another workspace at the top."};
constexpr ImGuiWindowFlags kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoSavedSettings;

}  // namespace

FirstSteps::FirstSteps(const std::string& folder) {
    if (folder.empty()) return;
    const std::filesystem::path file = std::filesystem::path(folder) / kFile;
    std::error_code error;
    shown_ = !std::filesystem::exists(file, error);
    std::filesystem::create_directories(folder, error);
    if (shown_) std::ofstream(file) << "1\n";
}

void FirstSteps::draw(const glm::ivec4& viewport) {
    if (!shown_) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 corner = {static_cast<float>(viewport.x) + 0.8f * unit,
                           static_cast<float>(viewport.y + viewport.w) - 0.8f * unit};
    ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.9f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.4f * unit);
    ImGui::Begin("##first steps", nullptr, kCard | ImGuiWindowFlags_NoInputs);
    ImGui::TextColored({0.98f, 0.76f, 0.42f, 1.0f}, "First steps");
    const float wrap = std::min(20.0f * unit, static_cast<float>(viewport.z) - 5.0f * unit);
    bool all = true;
    for (int step = 0; step < kSteps; ++step) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 c = {at.x + 0.5f * unit, at.y + 0.55f * unit};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImU32 ink = IM_COL32(242, 182, 102, 255);
        list.AddCircle(c, 0.45f * unit, ink, 0, 0.08f * unit);
        if (done_[step]) {
            const ImVec2 tick[] = {{c.x - 0.22f * unit, c.y},
                                   {c.x - 0.05f * unit, c.y + 0.2f * unit},
                                   {c.x + 0.26f * unit, c.y - 0.22f * unit}};
            list.AddPolyline(tick, 3, ink, 0, 0.12f * unit);
        }
        all = all && done_[step];
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.4f * unit);
        ImGui::PushTextWrapPos(wrap);
        if (done_[step])
            ImGui::TextDisabled("%s", kSentences[step]);
        else
            ImGui::TextWrapped("%s", kSentences[step]);
        ImGui::PopTextWrapPos();
    }
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::SetNextWindowPos({low.x + size.x, low.y}, ImGuiCond_Always, {1.0f, 0.0f});
    // No margin, which would take the mouse from the picture.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::Begin("##close first steps", nullptr, kCard | ImGuiWindowFlags_NoBackground);
    ImGui::PopStyleVar();
    if (ui::button("x##first steps", "Closes the first steps.") || all) shown_ = false;
    ImGui::End();
}

}  // namespace flg::studio
