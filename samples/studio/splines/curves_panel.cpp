// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "shell/widgets.h"
#include "splines/panel.h"

namespace flg::studio::splines {
namespace {

constexpr const char* kEnergies[] = {"Smooth: bends least", "Shortest: straight on", "Taut: in between"};
constexpr const char* kForms[] = {"Tube", "Ribbon", "Line"};

const char* ending_words(FlgSplineEnding ending) {
    switch (ending) {
        case FLG_SPLINE_RUNNING: return "still moving";
        case FLG_SPLINE_CONVERGED: return "settled";
        case FLG_SPLINE_ROUNDING: return "settled as far as numbers go";
        case FLG_SPLINE_ROUNDS: return "not settled: all rounds are used up";
        default: return "stalled: the surface is too sharp there, or obstacles leave no way";
    }
}

void status(const Stage& stage, const Curve& curve) {
    const LiveCurve* const live = stage.live_curve(curve.id);
    if (!stage.grounds.exists(curve.ground)) {
        ui::hint("The mesh that it lies on is gone. It stays as it is until you choose another surface.");
        return;
    }
    if (live != nullptr && !live->error().empty()) {
        ui::hint(("It can't be: " + live->error()).c_str());
        return;
    }
    if (live == nullptr || live->found().nodes.empty()) {
        ui::hint(curve.points.size() < 2 ? "Click once more to see the curve." : "On its way.");
        return;
    }
    const FoundCurve& found = live->found();
    char text[240];
    std::snprintf(text, sizeof text, "%s, %u rounds%s. %zu nodes, %.3g m long, energy %.3g.",
                  ending_words(found.ending), found.rounds, in_milliseconds(stage.desk, found.busy_ms).c_str(),
                  found.nodes.size(), found.length, found.energy);
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
    ui::hint(text);
}

void list(Stage& stage) {
    for (size_t i = 0; i < stage.document.curves.size(); ++i) {
        Curve& curve = stage.document.curves[i];
        ui::toggle(("##show curve " + std::to_string(i + 1)).c_str(), &curve.visible, "Whether this curve is shown.");
        ui::same_row();
        const uint32_t id = curve.id;
        const Row row = list_row(curve.name + (curve.closed ? " (closed)" : ""), id, id == stage.curve, "curve");
        // Curves of one point may be gone after either.
        if (row == Row::chosen) return stage.choose_curve(id);
        if (row == Row::removed) return stage.remove_curve(id);
    }
}

void shape_widgets(Stage& stage, Curve& curve) {
    ui::toggle("Closed", &curve.closed, "The curve goes from its last point back to the first. Needs three points.",
               curve.points.size() > 2);
    int energy = curve.energy;
    if (ui::choice("Bends", &energy, kEnergies,
                   "Smooth curves make wide, even turns; the shortest ones run straight from point to point and turn "
                   "there; taut "
                   "ones lie between."))
        curve.energy = static_cast<FlgSplineEnergy>(energy);
    const double size = stage.size();
    if (curve.energy == FLG_SPLINE_ET) {
        auto tension = static_cast<float>(curve.tension);
        if (ui::slider("Tension", &tension, static_cast<float>(1.0 / (size * size)),
                       static_cast<float>(1e5 / (size * size)), "%.3g /m\xc2\xb2",
                       "How hard the curve is pulled, per square metre. More: straighter between points, sharper at "
                       "them; less: as the smooth one.",
                       true))
            curve.tension = static_cast<double>(tension);
    }
    auto waves = static_cast<float>(curve.waves);
    if (ui::slider("Smooth away", &waves, 0.0f, static_cast<float>(4.0 * size),
                   waves > 0.0f ? "waves below %.2f m" : "nothing: through the points",
                   "Waves shorter than this many metres are smoothed away, so that the curve only passes near its "
                   "points. 0: it "
                   "goes through all of them.",
                   false, !curve.avoid || stage.document.obstacles.empty()))
        curve.waves = static_cast<double>(waves);
    ui::slider("Nodes", &curve.density, 4, 128, "%d from point to point",
               "How finely the curve is computed. More nodes: rounder in tight turns, and slower.");
    bool steered = curve.begin_slope.has_value() || curve.end_slope.has_value();
    if (ui::toggle("Steer the ends", &steered,
                   "Arrows at both ends say in which direction the curve begins and ends; drag their tips. Farther "
                   "out: it keeps the "
                   "direction for longer.",
                   !curve.closed && curve.points.size() > 1)) {
        curve.begin_slope.reset();
        curve.end_slope.reset();
        const LiveCurve* const live = stage.live_curve(curve.id);
        if (steered && live != nullptr && live->found().nodes.size() > 1) {
            const std::vector<glm::vec3>& nodes = live->found().nodes;
            curve.begin_slope = glm::normalize(glm::dvec3(nodes[1] - nodes[0]));
            curve.end_slope = glm::normalize(glm::dvec3(nodes[nodes.size() - 1] - nodes[nodes.size() - 2]));
        }
    }
    ui::toggle("Avoid obstacles", &curve.avoid,
               "The curve goes around all obstacles, at the distance of its own radius.");
    const SceneMesh* const mesh = stage.desk.scene.find(curve.ground.mesh);
    if (curve.ground.kind == "mesh" && mesh != nullptr && mesh->ready && mesh->surface.report().border_count > 0)
        ui::toggle("Keep inside the borders", &curve.inside, "The mesh is open: the curve does not go over its edge.");
}

void look_widgets(Stage& stage, Curve& curve) {
    ui::heading("Look");
    int form = static_cast<int>(curve.look.form);
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ui::same_row();
        constexpr const char* kTips[] = {"A round tube, half sunk into the surface.",
                                         "A flat band that lies on the surface.",
                                         "A line of three pixels, whatever the distance."};
        if (ui::row_button(kForms[i], 3, kTips[i], {.enabled = true, .pressed = i == form}))
            curve.look.form = static_cast<Form>(i);
    }
    ui::color("Colour", &curve.look.color, "The curve's colour.");
    const auto size = static_cast<float>(stage.size());
    if (curve.look.form != Form::line)
        ui::slider(
            "Radius", &curve.look.radius, 0.001f * size, 0.06f * size, "%.4f m",
            "Of the tube, or half the width of the ribbon, in metres. More: thicker, and farther away from obstacles.",
            true);
    Ornament& ornament = curve.ornament;
    ui::toggle("Stylize", &ornament.on, "Lays a drawn style along the curve, in the directions of the surface.");
    if (!ornament.on) return;
    const auto names = style_names();
    auto style = static_cast<int>(std::find(names.begin(), names.end(), ornament.style) - names.begin());
    if (ui::choice("Style", &style, names, "Which hand-drawn example the curve takes after."))
        ornament.style = names[static_cast<size_t>(style)];
    ui::toggle("Flat on the surface", &ornament.flat,
               "The style lies down on the surface; else it stands upright on it.");
    ui::slider("Magnitude", &ornament.magnitude, 0.0f, 3.0f, "%.2f",
               "How far the style swings away from the curve, 1 is as drawn. "
               "More: wilder; 0: the curve itself.");
    ui::slider("Style size", &ornament.size, 0.004f * size, 0.15f * size, "%.3f m",
               "How large the style's strokes are, in metres that they swing away. More: larger and fewer.", true);
}

}  // namespace

Row list_row(const std::string& name, uint32_t id, bool chosen, const char* what) {
    const std::string number = "##" + std::to_string(id);
    const float height = ImGui::GetFrameHeight();
    const float width = ImGui::GetContentRegionAvail().x - height - ImGui::GetStyle().ItemSpacing.x;
    ImGui::BeginChild(("##row" + number).c_str(), {width, height}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::AlignTextToFramePadding();
    const bool clicked =
        ui::selectable((name + number).c_str(), chosen, "Click to choose it: its handles can be dragged then.");
    ImGui::EndChild();
    ImGui::SameLine();
    const bool removed = ui::button(("x##remove " + name).c_str(), (std::string("Removes this ") + what + ".").c_str());
    return removed ? Row::removed : clicked ? Row::chosen : Row::none;
}

void ground_choice(Stage& stage, Ground* chosen) {
    std::vector<Ground> grounds;
    std::vector<std::string> titles;
    for (const auto& mesh : stage.desk.scene.meshes()) {
        grounds.push_back({"mesh", mesh->id});
        titles.push_back("Mesh: " + mesh->name);
    }
    if (grounds.empty()) {
        grounds.push_back({"mesh", 0});
        titles.emplace_back("The first mesh that is opened");
    }
    grounds.push_back({"space", 0});
    titles.emplace_back("Space: a plane that faces you");
    for (const Shape& shape : shapes()) {
        grounds.push_back({shape.name, 0});
        titles.emplace_back(shape.title);
    }
    const Ground now = chosen != nullptr ? *chosen
                       : stage.ground.kind == "mesh"
                           ? Ground{"mesh", stage.desk.scene.active() ? stage.desk.scene.active()->id : 0}
                           : stage.ground;
    int index = -1;
    std::vector<const char*> names;
    for (size_t i = 0; i < grounds.size(); ++i) {
        names.push_back(titles[i].c_str());
        if (grounds[i] == now) index = static_cast<int>(i);
    }
    if (!ui::choice(
            "Stays on", &index, names,
            "What points lie on, of the chosen one and of those that come: a mesh of the scene, space, or a surface by "
            "formula.") ||
        index < 0)
        return;
    const Ground& taken = grounds[static_cast<size_t>(index)];
    stage.ground = {taken.kind, 0};
    if (taken.kind == "mesh" && taken.mesh != 0) stage.desk.scene.set_active(taken.mesh);
    if (chosen != nullptr) *chosen = taken;
}

void curves_panel(Stage& stage) {
    Curve* curve = stage.chosen_curve();
    const bool drawing = stage.drawing != 0 && stage.document.curve(stage.drawing) != nullptr;
    ground_choice(stage, curve != nullptr && (drawing || curve->points.empty()) ? &curve->ground : nullptr);
    if (ui::row_button("New curve", 2, "The next click begins another curve. (N)")) {
        stage.end_drawing();
        stage.point = -1;
    }
    ui::same_row();
    if (ui::row_button("Done", 2, "Ends the curve that is being drawn; a double click or Enter does it too.",
                       {.enabled = drawing}))
        stage.end_drawing();
    list(stage);
    curve = stage.chosen_curve();
    if (curve != nullptr && ui::row_button("Remove point", 1, "Removes the point with the ring around it. (Delete)",
                                           {.enabled = stage.point >= 0})) {
        stage.remove_point(*curve, stage.point);
        curve = stage.chosen_curve();
    }
    if (curve == nullptr) {
        ui::hint(
            "Click on the surface: each click is a point, and the curve goes through all of them. Drag points to "
            "change it.");
        return;
    }
    ui::heading("Shape");
    shape_widgets(stage, *curve);
    status(stage, *curve);
    look_widgets(stage, *curve);
    ui::text("Name", &curve->name, "What the curve is called in the list and in files.");
}

}  // namespace flg::studio::splines
