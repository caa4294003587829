// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "shell/widgets.h"
#include "splines/panel.h"

namespace flg::studio::splines {
namespace {

constexpr const char* kEnergies[] = {"Smooth", "Shortest", "Taut"};
constexpr const char* kForms[] = {"Tube", "Ribbon", "Line"};

const char* ending_words(FlgSplineEnding ending) {
    switch (ending) {
        case FLG_SPLINE_ENDING_RUNNING: return "computing";
        case FLG_SPLINE_ENDING_CONVERGED: return "done";
        case FLG_SPLINE_ENDING_ROUNDING: return "done, at the limit of precision";
        case FLG_SPLINE_ENDING_ROUNDS: return "not finished: all iterations used";
        default: return "stuck: the surface is too sharp, or obstacles block the way";
    }
}

void status(const SplineEditor& editor, const Curve& curve) {
    const LiveCurve* const live = editor.live_curve(curve.id);
    if (!editor.surfaces.exists(curve.ground)) {
        ui::hint("The mesh of this curve was removed. Choose another surface under Stays on.");
        return;
    }
    if (live != nullptr && !live->error().empty()) {
        ui::hint(("No curve: " + live->error() + ".").c_str());
        return;
    }
    if (live == nullptr || live->found().nodes.empty()) {
        ui::hint(curve.points.size() < 2 ? "Click a second point." : "Computing.");
        return;
    }
    const FoundCurve& found = live->found();
    std::string ending = ending_words(found.ending);
    ending[0] = static_cast<char>(ending[0] - 'a' + 'A');
    ui::hint((ending + ".").c_str());
    char text[240];
    std::snprintf(text, sizeof text, "%s long, %u iterations%s, %zu nodes, energy %.3g.",
                  ui::length_text(found.length).c_str(), found.rounds,
                  in_milliseconds(editor.app, found.busy_ms).c_str(), found.nodes.size(), found.energy);
    ui::tip(text);
}

void list(SplineEditor& editor) {
    for (size_t i = 0; i < editor.document.curves.size(); ++i) {
        Curve& curve = editor.document.curves[i];
        ui::toggle(("##show curve " + std::to_string(i + 1)).c_str(), &curve.visible, "Shows or hides this curve.");
        ui::same_row();
        const uint32_t id = curve.id;
        const Row row = list_row(curve.name + (curve.closed ? " (closed)" : ""), id,
                                 id == editor.curve && !editor.begins_new, "curve");
        // Curves of one point may be gone after either.
        if (row == Row::chosen) return editor.choose_curve(id);
        if (row == Row::removed) return editor.remove_curve(id);
    }
}

void shape_widgets(SplineEditor& editor, Curve& curve) {
    ui::toggle("Closed", &curve.closed, "Joins the last point to the first. Needs three points.",
               curve.points.size() > 2);
    int energy = curve.energy;
    if (ui::choice("Bends", &energy, kEnergies,
                   "Smooth curves turn evenly. Shortest curves run straight and turn at the points. Taut curves lie "
                   "between the two."))
        curve.energy = static_cast<FlgSplineEnergy>(energy);
    const double size = editor.size();
    if (curve.energy == FLG_SPLINE_ENERGY_ET) {
        auto tension = static_cast<float>(curve.tension);
        if (ui::slider("Tension", &tension, static_cast<float>(1.0 / (size * size)),
                       static_cast<float>(1e5 / (size * size)), "%.3g /m\xc2\xb2",
                       "Pull on the curve. More makes it straighter between points and sharper at them.", true))
            curve.tension = static_cast<double>(tension);
    }
    if (!ui::section("Advanced", false)) return;
    auto waves = static_cast<float>(curve.waves);
    if (ui::length("Smoothing", &waves, 0.0f, static_cast<float>(4.0 * size),
                   "Smooths out waves shorter than this; the curve then passes near its points. 0 passes through all "
                   "of them.",
                   false, !curve.avoid || editor.document.obstacles.empty(), "none"))
        curve.waves = static_cast<double>(waves);
    ui::slider("Nodes", &curve.density, 4, 128, "%d per span",
               "Resolution between two points. More is rounder in tight turns, and slower.");
    bool steered = curve.begin_slope.has_value() || curve.end_slope.has_value();
    if (ui::toggle("Steer the ends", &steered,
                   "Adds an arrow at each end for the direction of the curve. Drag its tip; a longer arrow keeps the "
                   "direction longer.",
                   !curve.closed && curve.points.size() > 1)) {
        curve.begin_slope.reset();
        curve.end_slope.reset();
        const LiveCurve* const live = editor.live_curve(curve.id);
        if (steered && live != nullptr && live->found().nodes.size() > 1) {
            const std::vector<glm::vec3>& nodes = live->found().nodes;
            curve.begin_slope = glm::normalize(glm::dvec3(nodes[1] - nodes[0]));
            curve.end_slope = glm::normalize(glm::dvec3(nodes[nodes.size() - 1] - nodes[nodes.size() - 2]));
        }
    }
    ui::toggle("Avoid obstacles", &curve.avoid, "Leads the curve around all obstacles.");
    const SceneMesh* const mesh = editor.app.scene.find(curve.ground.mesh);
    if (curve.ground.kind == "mesh" && mesh != nullptr && mesh->ready && mesh->surface.report().border_count > 0)
        ui::toggle("Keep inside the borders", &curve.inside, "Keeps the curve from crossing the mesh's open borders.");
    ui::text("Name", &curve.name, "Name of the curve in the list and in files.");
}

void look_widgets(SplineEditor& editor, Curve& curve) {
    if (!ui::section("Look")) return;
    int form = static_cast<int>(curve.look.form);
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ui::same_row();
        constexpr const char* kTips[] = {"Draws a round tube.", "Draws a flat band that lies on the surface.",
                                         "Draws a line three pixels wide at any distance."};
        if (ui::row_button(kForms[i], 3, kTips[i], {.enabled = true, .pressed = i == form}))
            curve.look.form = static_cast<Form>(i);
    }
    ui::color("Colour", &curve.look.color, "Colour of the curve.");
    const auto size = static_cast<float>(editor.size());
    if (curve.look.form != Form::line)
        ui::length("Radius", &curve.look.radius, 0.001f * size, 0.06f * size,
                   "Half the thickness of the curve. More also keeps it farther from obstacles.", true);
    Ornament& ornament = curve.ornament;
    ui::toggle("Stylize", &ornament.on, "Applies a hand-drawn style to the curve.");
    if (!ornament.on) return;
    const auto names = style_names();
    auto style = static_cast<int>(std::find(names.begin(), names.end(), ornament.style) - names.begin());
    if (ui::choice("Style", &style, names, "Hand-drawn example to follow."))
        ornament.style = names[static_cast<size_t>(style)];
    ui::toggle("Flat on the surface", &ornament.flat, "The style lies on the surface. Off: it stands upright.");
    ui::slider("Magnitude", &ornament.magnitude, 0.0f, 3.0f, "%.2f",
               "Strength of the style. 0 is the plain curve, 1 matches the example, more exaggerates it.");
    ui::length("Style size", &ornament.size, 0.004f * size, 0.15f * size,
               "How far the style swings off the curve. More makes wider and fewer turns.", true);
}

}  // namespace

Row list_row(const std::string& name, uint32_t id, bool chosen, const char* what) {
    const std::string number = "##" + std::to_string(id);
    const float height = ImGui::GetFrameHeight();
    const float width = ImGui::GetContentRegionAvail().x - height - ImGui::GetStyle().ItemSpacing.x;
    ImGui::BeginChild(("##row" + number).c_str(), {width, height}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::AlignTextToFramePadding();
    const bool clicked = ui::selectable((name + number).c_str(), chosen, "Click to select it and show its handles.");
    ImGui::EndChild();
    ImGui::SameLine();
    const bool removed = ui::button(("x##remove " + name).c_str(), (std::string("Removes this ") + what + ".").c_str());
    return removed ? Row::removed : clicked ? Row::chosen : Row::none;
}

void ground_choice(SplineEditor& editor, SurfaceRef* chosen) {
    std::vector<SurfaceRef> surfaces;
    std::vector<std::string> titles;
    for (const auto& mesh : editor.app.scene.meshes()) {
        surfaces.push_back({"mesh", mesh->id});
        titles.push_back("Mesh " + mesh->name);
    }
    if (surfaces.empty()) {
        surfaces.push_back({"mesh", 0});
        titles.emplace_back("The first mesh you add");
    }
    surfaces.push_back({"space", 0});
    titles.emplace_back("Space, on a plane that faces you");
    for (const Shape& shape : shapes()) {
        surfaces.push_back({shape.name, 0});
        titles.emplace_back(shape.title);
    }
    const SurfaceRef now = chosen != nullptr ? *chosen
                           : editor.ground.kind == "mesh"
                               ? SurfaceRef{"mesh", editor.app.scene.active() ? editor.app.scene.active()->id : 0}
                               : editor.ground;
    int index = -1;
    std::vector<const char*> names;
    for (size_t i = 0; i < surfaces.size(); ++i) {
        names.push_back(titles[i].c_str());
        if (surfaces[i] == now) index = static_cast<int>(i);
    }
    if (!ui::choice("Stays on", &index, names,
                    "Surface that points lie on: a mesh, space, or a mathematical surface.") ||
        index < 0)
        return;
    const SurfaceRef& taken = surfaces[static_cast<size_t>(index)];
    editor.ground = {taken.kind, 0};
    if (taken.kind == "mesh" && taken.mesh != 0) editor.app.scene.set_active(taken.mesh);
    if (chosen != nullptr) *chosen = taken;
}

void curves_panel(SplineEditor& editor) {
    Curve* curve = editor.chosen_curve();
    const bool drawing = editor.drawing != 0 && editor.document.curve(editor.drawing) != nullptr;
    const SurfaceRef before = curve != nullptr ? curve->ground : SurfaceRef{};
    ground_choice(editor, curve != nullptr && !editor.begins_new ? &curve->ground : nullptr);
    if (curve != nullptr && !(curve->ground == before)) {
        for (glm::dvec3& point : curve->points)
            point = editor.surfaces.to_own(curve->ground, editor.surfaces.to_world(before, point));
    }
    if (ui::row_button("New curve", 2, "The next click starts another curve. N.")) editor.begin_new();
    ui::same_row();
    if (ui::row_button("Done", 2, "Ends this curve. Enter or a double-click.", {.enabled = drawing}))
        editor.end_drawing();
    list(editor);
    curve = editor.chosen_curve();
    if (curve != nullptr &&
        ui::row_button("Remove point", 1, "Removes the ringed point. Delete.", {.enabled = editor.point >= 0})) {
        editor.remove_point(*curve, editor.point);
        curve = editor.chosen_curve();
    }
    if (curve == nullptr) {
        ui::hint("Click points on the surface. A smooth curve passes through them. Drag points to change it.");
        return;
    }
    look_widgets(editor, *curve);
    if (ui::section("Shape")) shape_widgets(editor, *curve);
    status(editor, *curve);
}

}  // namespace flg::studio::splines
