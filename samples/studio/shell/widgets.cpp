// SPDX-License-Identifier: MIT
#include "shell/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <type_traits>

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

double& wanted() {
    static double seconds = 0.0;
    return seconds;
}

void register_last(const char* label) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 pane = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    current()[label] = {{low.x, low.y}, {high.x, high.y}, {pane.x, pane.y}, {pane.x + size.x, pane.y + size.y}};
}

// What active() and released() say: of the widget made last, which may be several of ImGui's.
struct Last {
    bool active = false, released = false;
};
Last& last() {
    static Last one;
    return one;
}

void end_widget(const char* label, const char* said) {
    register_last(label);
    last() = {ImGui::IsItemActive(), ImGui::IsItemDeactivatedAfterEdit()};
    if (said != nullptr && said[0] != '\0') tip(said);
}

// The label at the left of the line, so that the widget has the rest of it.
void title(const char* label) {
    constexpr float kShare = 0.34f;
    const std::string text(label, std::min(std::string(label).find("##"), std::string(label).size()));
    if (!text.empty()) {
        const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(text.c_str());
        ImGui::SameLine();
        ImGui::SetCursorPosX(std::max(left + std::floor(kShare * width), ImGui::GetCursorPosX()));
    }
    ImGui::SetNextItemWidth(-1.0f);
}

// The number's own part of a format: "%.2f" of "below %.2f m"; empty where there is none.
std::string number_format(const char* format) {
    const std::string text(format);
    for (size_t at = text.find('%'); at != std::string::npos && at + 1 < text.size(); at = text.find('%', at + 2)) {
        if (text[at + 1] == '%') continue;
        const size_t end = text.find_first_of("dfg", at);
        return end == std::string::npos ? std::string() : text.substr(at, end + 1 - at);
    }
    return {};
}

// A value that is being typed, in place of one that is shown.
struct Typing {
    ImGuiID id = 0;  // 0: none
    int frames_to_focus = 0, frame = 0;
    std::string text;
};
Typing& typing() {
    static Typing one;
    return one;
}

// The value to the right of its slider: a double click makes it a field. True when a number was typed.
bool value_field(const char* label, const char* shown, const std::string& offered, bool opens, double* typed) {
    constexpr int kFramesToFocus = 8;  // at most: ImGui takes two or three
    Typing& field = typing();
    const ImGuiID id = ImGui::GetID("##typed");
    // A field that was out of sight meanwhile is none.
    if (field.id == id && ImGui::GetFrameCount() > field.frame + 1) field.id = 0;
    field.frame = field.id == id ? ImGui::GetFrameCount() : field.frame;
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string name = std::string(label) + " value";
    if (field.id != id) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("##value", {width, ImGui::GetFrameHeight()});
        register_last(name.c_str());
        const bool hovered = ImGui::IsItemHovered();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 high = {at.x + width, at.y + ImGui::GetFrameHeight()};
        const ImGuiStyle& style = ImGui::GetStyle();
        if (hovered) list.AddRectFilled(at, high, ImGui::GetColorU32(ImGuiCol_FrameBg), style.FrameRounding);
        list.PushClipRect(at, high, true);
        list.AddText({at.x + 0.5f * style.FramePadding.x, at.y + style.FramePadding.y},
                     ImGui::GetColorU32(ImGuiCol_Text), shown);
        list.PopClipRect();
        tip("Double-click to type a value.");
        if (opens || (hovered && ImGui::IsMouseDoubleClicked(0)))
            field = {id, kFramesToFocus, ImGui::GetFrameCount(), offered};
        return false;
    }
    if (field.frames_to_focus > 0) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(width);
    ImGui::InputText("##typed", &field.text, ImGuiInputTextFlags_AutoSelectAll);
    register_last(name.c_str());
    if (ImGui::IsItemActive()) {
        field.frames_to_focus = 0;
        return false;
    }
    if (field.frames_to_focus > 0 && --field.frames_to_focus > 0) return false;
    field.id = 0;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) return false;
    char* end = nullptr;
    *typed = std::strtod(field.text.c_str(), &end);
    return end != field.text.c_str() && std::isfinite(*typed);
}

std::string hidden(const char* label) {
    return "##" + std::string(label);
}

struct LengthUnit {
    double per_metre;
    const char* format;
};

LengthUnit unit_of(double metres) {
    const double size = std::abs(metres);
    if (size > 0.0 && size < 0.001) return {1000.0, "%.2f mm"};
    if (size < 0.1) return {1000.0, "%.1f mm"};
    return size < 1.0 ? LengthUnit{100.0, "%.1f cm"} : LengthUnit{1.0, "%.2f m"};
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

double printable(float value) {
    return static_cast<double>(value);
}
int printable(int value) {
    return value;
}

// `drag` is ImGui's slider; it rounds what was dragged to the digits that are shown.
template <typename Value, typename Drag>
bool any_slider(const char* label, Value* value, Value low, Value high, const char* format, const char* said,
                bool is_enabled, Drag&& drag) {
    constexpr float kValueShare = 0.27f;
    const float whole = ImGui::GetContentRegionAvail().x;
    const Enabled enabled(is_enabled);
    title(label);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    char shown[64];
    std::snprintf(shown, sizeof shown, format, printable(*value));
    const float room = std::max(std::floor(kValueShare * whole), ImGui::CalcTextSize(shown).x + gap);
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - room - gap, 2.0f * ImGui::GetFontSize()));
    bool changed = drag();
    end_widget(label, said);
    const bool opens = ImGui::IsItemHovered() &&
                       (ImGui::IsMouseDoubleClicked(0) || (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0)));
    ImGui::SameLine(0.0f, gap);
    ImGui::PushID(label);
    const std::string digits = number_format(format);
    char offered[48] = "";
    if (!digits.empty()) std::snprintf(offered, sizeof offered, digits.c_str(), printable(*value));
    double typed = 0.0;
    if (value_field(label, shown, offered, opens, &typed)) {
        if constexpr (std::is_integral_v<Value>) typed = std::round(typed);
        const auto taken = static_cast<Value>(std::clamp(typed, static_cast<double>(low), static_cast<double>(high)));
        changed = last().released = taken != *value;
        *value = taken;
    }
    ImGui::PopID();
    return changed;
}

bool sized_button(const char* label, float width, const char* said, const State& state) {
    const Enabled enabled(state.enabled);
    if (state.pressed) {
        const ImVec4 chosen = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
        ImGui::PushStyleColor(ImGuiCol_Button, chosen);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, chosen);
    }
    // What has no room is written smaller, not cut off.
    const float room = width - 2.0f * ImGui::GetStyle().FramePadding.x;
    const float text = ImGui::CalcTextSize(label, nullptr, true).x, height = ImGui::GetFrameHeight();
    const bool shrinks = width > 0.0f && text > room;
    if (shrinks) ImGui::SetWindowFontScale(std::max(room / text, 0.5f));
    const bool clicked = ImGui::Button(label, {width, height});
    if (shrinks) ImGui::SetWindowFontScale(1.0f);
    if (state.pressed) ImGui::PopStyleColor(2);
    end_widget(label, said);
    return clicked;
}

}  // namespace

const Rect* find_widget(const std::string& label) {
    const auto found = drawn().find(label);
    return found == drawn().end() ? nullptr : &found->second;
}

const std::map<std::string, Rect>& widgets() {
    return current();
}

std::string widget_labels() {
    std::string labels;
    for (const auto& [label, rect] : drawn()) labels += (labels.empty() ? "" : ", ") + label;
    return labels;
}

void begin_widgets() {
    drawn().swap(current());
    current().clear();
    wanted() = std::numeric_limits<double>::infinity();
}

void frame_in(double seconds) {
    wanted() = std::min(wanted(), seconds);
}

double next_frame_in() {
    return wanted();
}

void mark(const std::string& label, const Rect& rect) {
    current()[label] = rect;
}

void mark_last(const std::string& label) {
    register_last(label.c_str());
}

uint32_t shown_color(const glm::vec3& linear) {
    return ImGui::ColorConvertFloat4ToU32({to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z), 1.0f});
}

void heading(const char* text) {
    ImGui::Dummy({0.0f, 0.25f * ImGui::GetFontSize()});
    ImGui::TextColored({0.98f, 0.76f, 0.42f, 1.0f}, "%s", text);
    ImGui::Separator();
}

bool section(const char* label, bool open) {
    ImGui::Dummy({0.0f, 0.1f * ImGui::GetFontSize()});
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(label);
    const bool was_open = storage.GetBool(id, open);
    const float font = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight() + 2.0f;
    if (ImGui::InvisibleButton(label, {width, height})) storage.SetBool(id, !was_open);
    register_last(label);
    const ImU32 ink = ImGui::IsItemHovered() ? IM_COL32(255, 222, 170, 255) : IM_COL32(250, 194, 107, 255);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 c = {at.x + 0.35f * font, at.y + 0.52f * font};
    const float r = 0.24f * font;
    if (was_open)
        list.AddTriangleFilled({c.x - r, c.y - 0.6f * r}, {c.x + r, c.y - 0.6f * r}, {c.x, c.y + r}, ink);
    else
        list.AddTriangleFilled({c.x - 0.6f * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.6f * r, c.y + r}, ink);
    const std::string text(label, std::min(std::string(label).find("##"), std::string(label).size()));
    list.AddText({at.x + 0.9f * font, at.y}, ink, text.c_str());
    tip(was_open ? "Click to fold." : "Click to unfold.");
    ImGui::Separator();
    return was_open;
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
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.0f, padding.y});
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
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput |
                                   (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const std::string digits = number_format(format);
    return any_slider(label, value, low, high, format, said, is_enabled, [&] {
        if (!ImGui::SliderFloat(hidden(label).c_str(), value, low, high, "", flags)) return false;
        char rounded[48];
        if (digits.empty()) return true;
        std::snprintf(rounded, sizeof rounded, digits.c_str(), static_cast<double>(*value));
        *value = std::clamp(std::strtof(rounded, nullptr), low, high);
        return true;
    });
}

bool slider(const char* label, int* value, int low, int high, const char* format, const char* said, bool is_enabled) {
    return any_slider(label, value, low, high, format, said, is_enabled, [&] {
        return ImGui::SliderInt(hidden(label).c_str(), value, low, high, "",
                                ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    });
}

bool length(const char* label, float* metres, float low, float high, const char* said, bool logarithmic,
            bool is_enabled, const char* at_zero) {
    const LengthUnit unit = unit_of(static_cast<double>(*metres));
    const auto per_metre = static_cast<float>(unit.per_metre);
    const char* format = at_zero != nullptr && *metres == 0.0f ? at_zero : unit.format;
    float shown = per_metre * *metres;
    if (!slider(label, &shown, per_metre * low, per_metre * high, format, said, logarithmic, is_enabled)) return false;
    *metres = std::clamp(shown / per_metre, low, high);
    return true;
}

std::string length_text(double metres) {
    const LengthUnit unit = unit_of(metres);
    char text[32];
    std::snprintf(text, sizeof text, unit.format, unit.per_metre * metres);
    return text;
}

bool numbers(const char* label, glm::vec3* value, float step, const char* format, const char* said) {
    title(label);
    const bool changed = ImGui::DragFloat3(hidden(label).c_str(), &value->x, step, 0.0f, 0.0f, format);
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

bool text(const char* label, std::string* value, const char* said, bool focus) {
    title(label);
    if (focus) ImGui::SetKeyboardFocusHere();
    const bool changed = ImGui::InputText(hidden(label).c_str(), value, ImGuiInputTextFlags_AutoSelectAll);
    end_widget(label, said);
    return changed;
}

bool selectable(const char* label, bool selected, const char* said) {
    const bool clicked = ImGui::Selectable(label, selected);
    end_widget(label, said);
    return clicked;
}

bool enter() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
}

bool escape() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
}

bool released() {
    return last().released;
}

bool active() {
    return last().active;
}

void tip(const char* said) {
    constexpr float kDelay_s = 0.4f;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (ImGui::GetCurrentContext() == nullptr || ImGui::GetIO().MouseDownDuration[0] > 0.0f) return;
    // ImGui 1.86 has no delay of its own: counted while the mouse stays over one
    // widget.
    static ImGuiID last = 0;
    static float since = 0.0f;
    static int frame = 0;
    const ImGuiID id = ImGui::GetID(said);
    const bool is_new = id != last || ImGui::GetFrameCount() > frame + 1;
    since = is_new ? 0.0f : since + ImGui::GetIO().DeltaTime;
    last = id;
    frame = ImGui::GetFrameCount();
    if (since < kDelay_s) return frame_in(static_cast<double>(kDelay_s - since));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(said);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace flg::studio::ui
