// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "scenes/scenes.h"
#include "shell/widgets.h"
#include "strokes/strokes_workspace.h"

namespace flg::studio {
namespace {

constexpr int kStylesInARow = 4;

// Two colours each that go well with porcelain.
struct Ink {
    const char* name;
    glm::vec3 color, color_end;
};
constexpr Ink kInks[] = {
    {"Ember", {0.90f, 0.13f, 0.03f}, {0.50f, 0.02f, 0.22f}}, {"Gold", {0.85f, 0.50f, 0.08f}, {0.60f, 0.22f, 0.03f}},
    {"Fern", {0.10f, 0.42f, 0.10f}, {0.02f, 0.22f, 0.20f}},  {"Lagoon", {0.02f, 0.42f, 0.55f}, {0.03f, 0.10f, 0.40f}},
    {"Plum", {0.42f, 0.05f, 0.42f}, {0.12f, 0.03f, 0.32f}},  {"Ink", {0.03f, 0.035f, 0.05f}, {0.03f, 0.035f, 0.05f}},
};

// Of a value of another unit, so many metres each.
void scaled_length(const char* label, float* value, float unit_m, float low, float high, const char* tip,
                   bool logarithmic, bool enabled) {
    constexpr double kFinest = 1e-3;  // so that what was typed stays as it was
    float metres = unit_m * *value;
    if (ui::length(label, &metres, unit_m * std::min(low, *value), unit_m * std::max(high, *value), tip, logarithmic,
                   enabled))
        *value = static_cast<float>(std::round(static_cast<double>(metres / unit_m) / kFinest) * kFinest);
}

}  // namespace

void StrokesWorkspace::panel() {
    draw_tools();
    draw_styles();
    draw_colors();
    draw_sizes();
    draw_guide();
    draw_apply();
    draw_layers();
}

void StrokesWorkspace::draw_tools() {
    if (!ui::section("Tool")) return;
    if (ui::row_button("Draw", 4, "Draws strokes in the chosen style. B.", {.pressed = tool_ == Tool::draw}))
        set_tool(Tool::draw);
    ui::same_row();
    if (ui::row_button("New style", 4, "Turns the next stroke into a new style. S.",
                       {.pressed = tool_ == Tool::draw_style}))
        set_tool(Tool::draw_style);
    ui::same_row();
    if (ui::row_button("Select", 4, "Selects the stroke you click. Shift adds. V.", {.pressed = tool_ == Tool::select}))
        set_tool(Tool::select);
    ui::same_row();
    if (ui::row_button("Erase", 4, "Erases the stroke you click. E.", {.pressed = tool_ == Tool::erase}))
        set_tool(Tool::erase);
    constexpr const char* kGrounds[] = {"On mesh", "View plane", "Floor"};
    constexpr const char* kSaid[] = {
        "Draws on the mesh or the floor under the mouse. Strokes that leave a mesh continue at the same depth. G.",
        "Draws on a plane that faces the camera. G.", "Draws on the floor. G."};
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ui::same_row();
        if (ui::row_button(kGrounds[i], 3, kSaid[i], {.pressed = static_cast<int>(ground_) == i}))
            ground_ = static_cast<Ground>(i);
    }
}

void StrokesWorkspace::style_button(const std::string& name, const char* said) {
    const float unit = app_.scale, font = 0.8f * ImGui::GetFontSize();
    const bool chosen = next_.style == name;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4.0f * unit, 13.0f * unit});
    ImGui::PushID(name.c_str());
    const bool clicked = ui::row_button(("##style " + name).c_str(), kStylesInARow, said, {.pressed = chosen});
    ImGui::PopID();
    ImGui::PopStyleVar();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::mark_last("style " + name);
    // Its curve, and its name below.
    const float margin = 4.0f * unit, bottom = high.y - font - 4.0f * unit;
    const float size = std::min(high.x - low.x, 3.5f * (bottom - low.y)) - 2.0f * margin;
    const ImU32 ink = chosen ? IM_COL32(255, 240, 220, 255) : IM_COL32(205, 195, 180, 255);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    std::vector<ImVec2> line;
    for (const glm::vec3& p : style_cache_.preview(document_, name)) {
        line.push_back({0.5f * (low.x + high.x) + (p.x - 0.5f) * size, 0.5f * (low.y + bottom) + (p.y - 0.5f) * size});
        // Where it is thick.
        if (p.z > 1.4f && line.size() > 1)
            list.AddLine(line[line.size() - 2], line.back(), ink, 1.2f * unit * std::min(p.z, 5.0f));
    }
    list.AddPolyline(line.data(), static_cast<int>(line.size()), ink, 0, 1.2f * unit);
    const float width = ImGui::CalcTextSize(name.c_str()).x * font / ImGui::GetFontSize();
    list.AddText(ImGui::GetFont(), font, {0.5f * (low.x + high.x - width), bottom + unit}, ink, name.c_str());
    list.PopClipRect();
    if (!clicked) return;
    next_.style = name;
    next_.styled = true;
}

void StrokesWorkspace::draw_styles() {
    if (!ui::section("Style")) return;
    int number = 0;
    for (const std::string& name : scenes::library_names()) {
        if (number++ % kStylesInARow != 0) ui::same_row();
        style_button(name, ("Style " + name + ", built in.").c_str());
    }
    for (const DrawnStyle& style : document_.styles) {
        if (number++ % kStylesInARow != 0) ui::same_row();
        style_button(style.name, ("Style " + style.name + ", drawn by you.").c_str());
    }
    const auto shape = [&](const char* label, StrokeShape which, const char* said) {
        if (ui::row_button(label, 3, said, {.pressed = next_.shape == which})) next_.shape = which;
    };
    shape("Tube", StrokeShape::tube, "Draws strokes as round tubes.");
    ui::same_row();
    shape("Ribbon", StrokeShape::ribbon, "Draws strokes as flat bands that lie on the surface.");
    ui::same_row();
    if (ui::row_button("Unstyled", 3, "Shows strokes as you draw them, without a style.", {.pressed = !next_.styled}))
        next_.styled = !next_.styled;
}

void StrokesWorkspace::draw_colors() {
    if (!ui::section("Colour")) return;
    int number = 0;
    const float unit = app_.scale;
    for (const Ink& ink : kInks) {
        if (number++ > 0) ui::same_row();
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, 4.0f * unit});
        const bool clicked = ui::row_button(("##ink " + std::string(ink.name)).c_str(), std::size(kInks), ink.name);
        ImGui::PopStyleVar();
        ui::mark_last(ink.name);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        const ImU32 from = ui::shown_color(ink.color), to = ui::shown_color(ink.color_end);
        const float inset = 2.0f * unit;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilledMultiColor({low.x + inset, low.y + inset}, {high.x - inset, high.y - inset}, from, to, to,
                                     from);
        if (next_.color == ink.color)
            list.AddRect(low, high, IM_COL32(255, 205, 120, 255), 3.0f * unit, 0, 2.0f * unit);
        if (!clicked) continue;
        next_.color = ink.color;
        next_.color_end = ink.color_end;
    }
    ui::color("From", &next_.color, "Colour at the start of a stroke.");
    ui::same_row();
    ui::color("To", &next_.color_end, "Colour at the end of a stroke.");
}

void StrokesWorkspace::draw_sizes() {
    if (ui::section("Size")) {
        // Of what was opened sizes may be beyond those of what is drawn here.
        scaled_length("Radius", &next_.radius_mm, 0.001f, 0.2f, 30.0f, "Half the thickness of a stroke. Keys [ and ].",
                      true, true);
        bool fits = next_.scale_cm == 0.0f;
        if (!fits) {
            scaled_length("Style size", &next_.scale_cm, 0.01f, 0.1f, 10.0f,
                          "How far the style swings off the stroke. More makes wider and fewer turns.", true,
                          next_.styled);
        }
        if (ui::toggle("Size fits radius", &fits, "The style swings so far that its turns stay apart.", next_.styled))
            next_.scale_cm = fits ? 0.0f : StrokeSettings().scale_cm;
        ui::slider("Magnitude", &next_.magnitude, 0.0f, 3.0f, "%.2f x",
                   "Strength of the style. 0 is the plain stroke, 1 matches the example, more exaggerates it.", false,
                   next_.styled);
    }
    if (!ui::section("Advanced", false)) return;
    ui::slider("Variation", &next_.temperature, 0.0f, 10.0f, "%.2f",
               "How freely pieces of the example are mixed. 0 copies long runs, 1 about a dozen points at a time, "
               "10 jumps almost everywhere.",
               false, next_.styled);
    ui::slider("Detail", &next_.patch, 1, 40, "%d points",
               "Length compared before a jump, in points. More keeps longer runs of the example together.",
               next_.styled);
    ui::slider("Seed", &next_.seed, 1, 99, "%d",
               "Number of the random choice. Each number mixes the example differently.", next_.styled);
    scaled_length(
        "Offset", &height_mm_, 0.001f, 0.0f, 40.0f,
        "Distance between new strokes and the mesh or floor, at least: a style that swings inwards gets more.", false,
        true);
    ui::toggle("Upright", &next_.upright,
               "The style stands up from the surface, like a fence. Off: it lies on the surface, like an ornament.",
               next_.styled);
}

void StrokesWorkspace::draw_guide() {
    if (!ui::section("Guide", false)) return;
    StrokeSettings shown = next_;
    const auto slider = [](const char* label, float* at, float* setting, float low, float high, const char* format,
                           const char* said, bool logarithmic, bool enabled) {
        if (!ui::slider(label, at, std::min(low, *at), std::max(high, *at), format, said, logarithmic, enabled) &&
            !ui::active() && !ui::released())
            *at = *setting;  // something else changed it
        if (!ui::active()) *setting = *at;
    };
    slider("Smoothing", &smoothing_, &next_.smoothing, 0.02f, 20.0f, "%.2f x",
           "How far the example is smoothed to its guide. Less leaves large waves in the guide, more makes them style.",
           true, next_.styled);
    slider(
        "Closeness", &beta_, &next_.beta, 0.01f, 0.99f, "%.2f",
        "How guide and example are matched. More: each point of the guide takes what is nearest. Less: pieces of the "
        "guide take equal shares of the example.",
        false, next_.styled);
    shown.smoothing = smoothing_;
    shown.beta = beta_;
    guide_.update(document_, shown);
    const float unit = app_.scale, height = 5.5f * ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, height});
    const ImVec2 high = ImGui::GetItemRectMax();
    ui::mark_last("Guide picture");
    ui::tip("The example, the guide made of it, and the displacement between them, which is what a style learns.");
    guide_.draw(*ImGui::GetWindowDrawList(), {low.x, low.y}, {high.x, high.y}, unit);
    if (guide_.nothing_to_learn()) ui::hint("Nothing to learn: the example is straight, or too short.");
}

void StrokesWorkspace::draw_apply() {
    if (!ui::section("Apply")) return;
    if (document_.stroke_count() == 0) return ui::hint("These settings are for the strokes you draw next.");
    const std::string selection = "Apply to selection" +
                                  (selected_.empty() ? std::string() : " (" + std::to_string(selected_.size()) + ")") +
                                  "###Apply to selection";
    if (ui::row_button(selection.c_str(), 1, "Gives the selected strokes these settings. Select strokes with V.",
                       {.enabled = !selected_.empty()}))
        apply_to_selection();
    ui::mark_last("Apply to selection");
    if (ui::row_button("Apply to layer", 1, "Gives all strokes of the chosen layer these settings.",
                       {.enabled = !document_.active_layer().strokes.empty()}))
        apply_to_layer();
    ui::toggle("Keep colours", &keeps_colors_, "Strokes keep their own colours when you apply settings.");
    ui::same_row();
    if (ui::button("Pick up", "Takes the settings of the selected stroke for the next strokes.",
                   {.enabled = !selected_.empty()}))
        take_from_selection();
}

void StrokesWorkspace::draw_layers() {
    if (!ui::section("Layers")) return;
    uint32_t chosen = 0, toggled = 0;
    for (const StrokeLayer& layer : document_.layers) {
        ImGui::PushID(static_cast<int>(layer.id));
        bool visible = layer.visible;
        if (ui::toggle(("##see layer " + layer.name).c_str(), &visible, "Shows or hides this layer."))
            toggled = layer.id;
        ImGui::SameLine();
        const std::string label = layer.name + "  (" + std::to_string(layer.strokes.size()) + ")##layer";
        if (ui::selectable(label.c_str(), layer.id == document_.active,
                           "Makes this the layer you draw on. The number counts its strokes."))
            chosen = layer.id;
        ImGui::PopID();
    }
    if (chosen != 0) document_.active = chosen;
    if (toggled != 0) {
        remember();
        StrokeLayer& layer = *document_.find(toggled);
        layer.visible = !layer.visible;
    }
    if (ui::row_button("New layer", 2, "Adds an empty layer.")) {
        remember();
        document_.add_layer("Layer " + std::to_string(document_.last_id + 1));
    }
    ui::same_row();
    if (ui::row_button("Delete layer", 2, "Deletes the chosen layer and its strokes.",
                       {.enabled = document_.layers.size() > 1 || !document_.active_layer().strokes.empty()})) {
        remember();
        std::erase_if(document_.layers, [&](const StrokeLayer& layer) { return layer.id == document_.active; });
        document_.active_layer();
        forget_gone();
        return;
    }
    const StrokeLayer& now = document_.active_layer();
    const bool playing = replay_.layer() != 0;
    if (ui::row_button(playing ? "Stop##replay" : "Replay##replay", 1,
                       "Draws the chosen layer again, stroke by stroke, at the speed of your hand.",
                       {.enabled = playing || !now.strokes.empty()})) {
        if (playing)
            replay_.stop();
        else
            replay_.start(now, replay_speed_);
    }
    ui::slider("Replay speed", &replay_speed_, 0.25f, 16.0f, "%.2f x",
               "Speed of the replay. 1 is the speed of your hand.", true);
}

}  // namespace flg::studio
