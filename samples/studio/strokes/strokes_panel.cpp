// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <array>

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

}  // namespace

void StrokesWorkspace::take(const StrokeSettings& changed, bool is_changed) {
    if (is_changed) {
        if (!slider_remembered_) remember();
        slider_remembered_ = true;
        document_.active_layer().settings = changed;
    }
    if (!ui::active()) return;
    slider_remembered_ = slider_remembered_ || is_changed;
}

void StrokesWorkspace::panel() {
    if (!ImGui::IsMouseDown(0)) slider_remembered_ = false;
    draw_tools();
    draw_styles();
    draw_sliders();
    draw_layers();
}

void StrokesWorkspace::draw_tools() {
    ui::heading("Tool");
    if (ui::row_button("Draw", 3, "Draws strokes that take on the style at once. B.", {.pressed = tool_ == Tool::draw}))
        set_tool(Tool::draw);
    ui::same_row();
    if (ui::row_button("Draw a style", 3, "The next stroke is learned as a style of its own. S.",
                       {.pressed = tool_ == Tool::draw_style}))
        set_tool(Tool::draw_style);
    ui::same_row();
    if (ui::row_button("Erase", 3, "Takes away the stroke that is clicked. E.", {.pressed = tool_ == Tool::erase}))
        set_tool(Tool::erase);
    constexpr const char* kGrounds[] = {"On the mesh", "Facing plane", "Floor"};
    constexpr const char* kSaid[] = {
        "Strokes lie on the mesh under the mouse; beside it they go on at the same depth. G.",
        "Strokes lie on a plane that faces the camera, through what it turns about. G.",
        "Strokes lie on the floor. G."};
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ui::same_row();
        if (ui::row_button(kGrounds[i], 3, kSaid[i], {.pressed = static_cast<int>(ground_) == i}))
            ground_ = static_cast<Ground>(i);
    }
    ui::slider("Height", &height_mm_, 0.0f, 40.0f, "%.1f mm",
               "How far above the mesh or floor strokes are drawn. More lets styles swing freely, less lies closer.");
}

void StrokesWorkspace::style_button(const std::string& name, const char* said) {
    StrokeLayer& layer = document_.active_layer();
    const bool chosen = layer.settings.style == name;
    const std::string label = "##style " + name;
    ImGui::PushID(name.c_str());
    const bool clicked = ui::row_button(label.c_str(), kStylesInARow, nullptr, {.pressed = chosen});
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::mark("style " + name, {{low.x, low.y},
                               {high.x, high.y},
                               {low.x, ImGui::GetWindowPos().y},
                               {high.x, ImGui::GetWindowPos().y + ImGui::GetWindowSize().y}});
    ui::tip(said);
    ImGui::PopID();
    // Its curve, as wide as the button.
    const float margin = 4.0f * desk_.scale, size = std::min(high.x - low.x, 3.0f * (high.y - low.y)) - 2.0f * margin;
    std::vector<ImVec2> line;
    for (const glm::vec2& p : shelf_.preview(document_, name))
        line.push_back({0.5f * (low.x + high.x) + (p.x - 0.5f) * size, 0.5f * (low.y + high.y) + (p.y - 0.5f) * size});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    list.AddPolyline(line.data(), static_cast<int>(line.size()),
                     chosen ? IM_COL32(255, 240, 220, 255) : IM_COL32(205, 195, 180, 255), 0, 1.3f * desk_.scale);
    list.PopClipRect();
    if (!clicked || chosen) return;
    remember();
    layer.settings.style = name;
}

void StrokesWorkspace::draw_styles() {
    ui::heading("Style");
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4.0f * desk_.scale, 11.0f * desk_.scale});
    int number = 0;
    for (const std::string& name : scenes::style_names()) {
        if (number++ % kStylesInARow != 0) ui::same_row();
        style_button(name, (name + ": built in.").c_str());
    }
    for (const DrawnStyle& style : document_.styles) {
        if (number++ % kStylesInARow != 0) ui::same_row();
        style_button(style.name, (style.name + ": drawn by you.").c_str());
    }
    ImGui::PopStyleVar();
}

void StrokesWorkspace::draw_sliders() {
    StrokeSettings s = document_.active_layer().settings;
    const bool raw = s.shape == StrokeShape::raw;
    const auto shape = [&](const char* label, StrokeShape which, const char* said) {
        if (!ui::row_button(label, 3, said, {.pressed = s.shape == which}) || s.shape == which) return;
        remember();
        document_.active_layer().settings.shape = s.shape = which;
    };
    shape("Tube", StrokeShape::tube, "Strokes are round.");
    ui::same_row();
    shape("Ribbon", StrokeShape::ribbon, "Strokes are flat bands that lie on what they are drawn on.");
    ui::same_row();
    shape("Raw", StrokeShape::raw, "Strokes as they were drawn, without the style.");

    take(s, ui::slider("Magnitude", &s.magnitude, 0.0f, 3.0f, "%.2f x",
                       "How much of the style there is: 0 is the stroke alone, 1 as in the example, more exaggerates.",
                       false, !raw));
    take(s, ui::slider("Scale", &s.scale_cm, 0.1f, 10.0f, "%.2f cm",
                       "Size of the style: how far it swings off the stroke. More makes its turns wider and fewer.",
                       true, !raw));
    take(s,
         ui::slider("Temperature", &s.temperature, 0.0f, 10.0f, "%.2f",
                    "How freely the example's parts are mixed: 0 copies long runs of it, 1 a dozen points at a time, "
                    "10 jumps nearly always.",
                    false, !raw));
    take(s,
         ui::toggle("Standing", &s.standing,
                    "The style swings away from what it is drawn on, as a fence does; else along it, as an ornament.",
                    !raw));
    take(s, ui::slider("Patch", &s.patch, 1, 40, "%d points",
                       "How long the pieces are that are compared when the style jumps: more keeps longer runs alike.",
                       !raw));
    take(s,
         ui::slider("Radius", &s.radius_mm, 0.2f, 30.0f, "%.1f mm", "Half the thickness of a stroke. [ and ].", true));
    take(s,
         ui::slider("Seed", &s.seed, 1, 99, "%d", "Another one makes other choices among the example's parts.", !raw));

    ui::heading("Colour");
    int number = 0;
    for (const Ink& ink : kInks) {
        if (number++ % 3 != 0) ui::same_row();
        if (!ui::row_button(ink.name, 3, "Both colours of the layer's strokes.", {.pressed = s.color == ink.color}))
            continue;
        remember();
        document_.active_layer().settings.color = s.color = ink.color;
        document_.active_layer().settings.color_end = s.color_end = ink.color_end;
    }
    take(s, ui::color("From", &s.color, "Colour at a stroke's beginning."));
    ui::same_row();
    take(s, ui::color("To", &s.color_end, "Colour at a stroke's end."));
}

void StrokesWorkspace::draw_layers() {
    ui::heading("Layers");
    uint32_t chosen = 0, toggled = 0;
    for (const StrokeLayer& layer : document_.layers) {
        ImGui::PushID(static_cast<int>(layer.id));
        bool visible = layer.visible;
        if (ui::toggle(("##see layer " + layer.name).c_str(), &visible, "Whether this layer can be seen."))
            toggled = layer.id;
        ImGui::SameLine();
        const std::string label = layer.name + "  (" + std::to_string(layer.strokes.size()) + ")##layer";
        if (ui::selectable(label.c_str(), layer.id == document_.active,
                           "Sliders and pen are this layer's. In brackets: its strokes."))
            chosen = layer.id;
        ImGui::PopID();
    }
    if (chosen != 0) document_.active = chosen;
    if (toggled != 0) {
        remember();
        StrokeLayer& layer = *document_.find(toggled);
        layer.visible = !layer.visible;
    }
    StrokeLayer& active = document_.active_layer();
    if (ui::row_button("New layer", 2, "Strokes with settings of their own; they begin with these.")) {
        remember();
        document_.add_layer("Layer " + std::to_string(document_.last_id + 1), active.settings);
    }
    ui::same_row();
    if (ui::row_button("Delete layer", 2, "Takes the chosen layer away, with its strokes.",
                       {.enabled = document_.layers.size() > 1 || !active.strokes.empty()})) {
        remember();
        std::erase_if(document_.layers, [&](const StrokeLayer& layer) { return layer.id == document_.active; });
        document_.active_layer();
        return;
    }
    const StrokeLayer& now = document_.active_layer();
    const bool playing = replay_.layer() != 0;
    if (ui::row_button(playing ? "Stop##replay" : "Replay##replay", 2,
                       "Draws the chosen layer again, stroke by stroke, as the hand drew it, through live strokes.",
                       {.enabled = playing || !now.strokes.empty()})) {
        if (playing)
            replay_.stop();
        else
            replay_.start(now, replay_speed_);
    }
    ui::slider("Replay speed", &replay_speed_, 0.25f, 16.0f, "%.2f x", "How much faster than the hand was.", true);
}

}  // namespace flg::studio
