// SPDX-License-Identifier: MIT
#include "shell/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace flg::studio::ui {
namespace {

// Of this frame, and of the last one that was drawn whole.
std::map<std::string, Rect>& current() {
    static std::map<std::string, Rect> widgets;
    return widgets;
}
std::map<std::string, Rect>& drawn() {
    static std::map<std::string, Rect> widgets;
    return widgets;
}

void register_last(const char* label) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 pane = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    current()[label] = {{low.x, low.y}, {high.x, high.y}, {pane.x, pane.y}, {pane.x + size.x, pane.y + size.y}};
}

void end_widget(const char* label, const char* said) {
    register_last(label);
    if (said != nullptr && said[0] != '\0') tip(said);
}

// The label on a line of its own above, so that the widget has the panel's width.
void title(const char* label) {
    const std::string text(label, std::min(std::string(label).find("##"), std::string(label).size()));
    if (!text.empty()) ImGui::TextDisabled("%s", text.c_str());
    ImGui::SetNextItemWidth(-1.0f);
}

std::string hidden(const char* label) {
    return "##" + std::string(label);
}

float to_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
float to_linear(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

class Enabled {
public:
    explicit Enabled(bool enabled) : enabled_(enabled) {
        if (!enabled_) ImGui::BeginDisabled();
    }
    ~Enabled() {
        if (!enabled_) ImGui::EndDisabled();
    }
    Enabled(const Enabled&) = delete;
    Enabled& operator=(const Enabled&) = delete;

private:
    bool enabled_;
};

bool sized_button(const char* label, float width, const char* said, const State& state) {
    const Enabled enabled(state.enabled);
    if (state.pressed) {
        const ImVec4 chosen = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
        ImGui::PushStyleColor(ImGuiCol_Button, chosen);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen);
    }
    const bool clicked = ImGui::Button(label, {width, 0.0f});
    if (state.pressed) ImGui::PopStyleColor(2);
    end_widget(label, said);
    return clicked;
}

}  // namespace

const Rect* find_widget(const std::string& label) {
    const auto found = drawn().find(label);
    return found == drawn().end() ? nullptr : &found->second;
}

std::string widget_labels() {
    std::string labels;
    for (const auto& [label, rect] : drawn()) labels += (labels.empty() ? "" : ", ") + label;
    return labels;
}

void begin_widgets() {
    drawn().swap(current());
    current().clear();
}

void mark(const std::string& label, const Rect& rect) {
    current()[label] = rect;
}

void heading(const char* text) {
    ImGui::Dummy({0.0f, 0.25f * ImGui::GetFontSize()});
    ImGui::TextColored({0.98f, 0.76f, 0.42f, 1.0f}, "%s", text);
    ImGui::Separator();
}

void hint(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

bool button(const char* label, const char* said, const State& state) {
    return sized_button(label, 0.0f, said, state);
}

void same_row() {
    ImGui::SameLine();
}

bool row_button(const char* label, int across, const char* said, const State& state) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float whole = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const float count = static_cast<float>(std::max(across, 1));
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, padding.y});
    const bool clicked = sized_button(label, std::floor((whole - gap * (count - 1.0f)) / count), said, state);
    ImGui::PopStyleVar();
    return clicked;
}

bool toggle(const char* label, bool* value, const char* said, bool is_enabled) {
    const Enabled enabled(is_enabled);
    const bool changed = ImGui::Checkbox(label, value);
    end_widget(label, said);
    return changed;
}

bool slider(const char* label, float* value, float low, float high, const char* format, const char* said,
            bool logarithmic, bool is_enabled) {
    const Enabled enabled(is_enabled);
    title(label);
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const bool changed = ImGui::SliderFloat(hidden(label).c_str(), value, low, high, format, flags);
    end_widget(label, said);
    return changed;
}

bool slider(const char* label, int* value, int low, int high, const char* format, const char* said, bool is_enabled) {
    const Enabled enabled(is_enabled);
    title(label);
    const bool changed =
        ImGui::SliderInt(hidden(label).c_str(), value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
    end_widget(label, said);
    return changed;
}

bool choice(const char* label, int* index, std::span<const char* const> names, const char* said, bool is_enabled) {
    const Enabled enabled(is_enabled);
    title(label);
    bool changed = false;
    const bool known = *index >= 0 && static_cast<size_t>(*index) < names.size();
    const bool open = ImGui::BeginCombo(hidden(label).c_str(), known ? names[static_cast<size_t>(*index)] : "");
    end_widget(label, said);
    if (!open) return false;
    for (size_t i = 0; i < names.size(); ++i) {
        if (ImGui::Selectable(names[i], static_cast<size_t>(*index) == i)) {
            *index = static_cast<int>(i);
            changed = true;
        }
        register_last((std::string(label) + ": " + names[i]).c_str());
    }
    ImGui::EndCombo();
    return changed;
}

bool color(const char* label, glm::vec3* value, const char* said) {
    glm::vec3 shown(to_srgb(value->x), to_srgb(value->y), to_srgb(value->z));
    const bool changed = ImGui::ColorEdit3(label, &shown.x, ImGuiColorEditFlags_NoInputs);
    end_widget(label, said);
    if (changed) *value = {to_linear(shown.x), to_linear(shown.y), to_linear(shown.z)};
    return changed;
}

bool text(const char* label, std::string* value, const char* said) {
    title(label);
    const bool changed = ImGui::InputText(hidden(label).c_str(), value);
    end_widget(label, said);
    return changed;
}

bool selectable(const char* label, bool selected, const char* said) {
    const bool clicked = ImGui::Selectable(label, selected);
    end_widget(label, said);
    return clicked;
}

bool released() {
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool active() {
    return ImGui::IsItemActive();
}

void tip(const char* said) {
    constexpr float kDelay_s = 0.4f;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (ImGui::GetCurrentContext() == nullptr || ImGui::GetIO().MouseDownDuration[0] > 0.0f) return;
    // ImGui 1.86 has no delay of its own: counted while the mouse stays over one widget.
    static ImGuiID last = 0;
    static float since = 0.0f;
    static int frame = 0;
    const ImGuiID id = ImGui::GetID(said);
    if (id != last || ImGui::GetFrameCount() > frame + 1) since = 0.0f;
    last = id;
    frame = ImGui::GetFrameCount();
    since += ImGui::GetIO().DeltaTime;
    if (since < kDelay_s) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(said);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace flg::studio::ui
