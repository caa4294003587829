// SPDX-License-Identifier: MIT
// The Splines workspace: what the shell asks of it, handed on to the stage, the hand, the panels and the files.
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "shell/widgets.h"
#include "splines/files.h"
#include "splines/overlay.h"
#include "splines/panel.h"
#include "workspaces.h"

namespace flg::studio {
namespace {

using namespace splines;

constexpr Workspace::Shortcut kShortcuts[] = {{"N", "Begin another curve or motion"},
                                              {"Enter", "End the curve that is being drawn"},
                                              {"Escape", "Give up what is dragged; end the curve"},
                                              {"C", "Close or open the curve"},
                                              {"Delete", "Remove the chosen point, key, obstacle or curve"},
                                              {"Space", "Play or pause the motion"},
                                              {"Home", "Back to the motion's start"}};

constexpr Workspace::Export kExports[] = {{"Spline curves", ".glb"}, {"Spline curves", ".xyz"}, {"Motion", ".glb"}};

class Splines final : public Workspace {
public:
    explicit Splines(Desk& desk) : Workspace(desk), stage_(desk) {}

    const char* title() const override { return "Splines"; }
    std::string help() const override;
    void enter() override { stage_.in_front = true; }
    void leave() override;
    void update() override { stage_.update(); }
    void panel() override;
    void pointer(const Pointer& mouse) override { hand_.pointer(mouse); }
    void overlay(ImDrawList& list) override { draw_overlay(list, stage_, hand_); }
    bool shortcut(const Chord& chord) override;
    std::span<const Shortcut> shortcuts() const override { return kShortcuts; }

    bool can_undo() const override { return stage_.history.can_undo() || stage_.history.has_news(); }
    bool can_redo() const override { return stage_.history.can_redo(); }
    void undo() override { stage_.undo(); }
    void redo() override { stage_.redo(); }

    bool open(const std::string& path) override { return read_file(stage_, path); }
    nlohmann::json save() const override { return to_json(stage_.document, mesh_ids()); }
    void load(const nlohmann::json& part) override { stage_.replace(from_json(part, mesh_ids())); }
    std::span<const Export> exports() const override { return kExports; }
    void write(const Export& what, const std::string& path) override;

    bool busy() const override { return stage_.busy(); }
    bool moving() const override { return stage_.playing; }
    void device_lost() override { stage_.device_lost(); }
    double count(const std::string& name) const override;

private:
    std::vector<uint32_t> mesh_ids() const;
    void remove_chosen();
    void choose(Tool tool);

    Stage stage_;
    Hand hand_{stage_};
};

std::string Splines::help() const {
    if (stage_.tool == Tool::obstacles)
        return "Click to put an obstacle there. Drag it about: curves and motions make way.";
    if (stage_.tool == Tool::motions)
        return "Click: a key for the body. Press and drag: its nose points there. Space plays.";
    if (stage_.document.curve(stage_.drawing) != nullptr)
        return "Click on: each click is a point. A click on the first one closes the curve, a double click or Enter "
               "ends it.";
    if (!stage_.document.curves.empty())
        return "Drag points; press on the curve to put one between. Click beside it to begin another curve.";
    return "Click on the surface to drop points: a smooth curve goes through them.";
}

void Splines::leave() {
    stage_.in_front = stage_.dragging = stage_.editing = false;
    stage_.end_drawing();
}

void Splines::choose(Tool tool) {
    if (stage_.tool == tool) return;
    stage_.end_drawing();
    stage_.tool = tool;
}

void Splines::panel() {
    constexpr struct {
        Tool tool;
        const char *label, *tip;
    } kTools[] = {{Tool::curves, "Curves", "Smooth curves through points on a surface or in space."},
                  {Tool::obstacles, "Obstacles", "Solids that curves and motions go around."},
                  {Tool::motions, "Motions", "Bodies that fly smoothly from key to key."}};
    for (const auto& tool : kTools) {
        if (tool.tool != Tool::curves) ui::same_row();
        if (ui::row_button(tool.label, 3, tool.tip, {.enabled = true, .pressed = stage_.tool == tool.tool}))
            choose(tool.tool);
    }
    if (stage_.tool == Tool::curves) curves_panel(stage_);
    if (stage_.tool == Tool::obstacles) obstacles_panel(stage_);
    if (stage_.tool == Tool::motions) motions_panel(stage_);
    stage_.editing = ImGui::IsAnyItemActive();
}

void Splines::remove_chosen() {
    if (stage_.dragging) return;
    const Handle& hot = hand_.hot();
    if (hot.grip == Grip::solid) {
        stage_.remove_obstacle(hot.item);
    } else if (stage_.tool == Tool::obstacles) {
        stage_.remove_obstacle(stage_.obstacle);
    } else if (stage_.tool == Tool::motions) {
        Motion* const motion = stage_.chosen_motion();
        if (motion == nullptr) return;
        const int key = hot.grip == Grip::key ? hot.index : stage_.key;
        if (key >= 0)
            stage_.remove_key(*motion, key);
        else
            stage_.remove_motion(motion->id);
    } else if (Curve* const curve = stage_.chosen_curve()) {
        const int point = hot.grip == Grip::point ? hot.index : stage_.point;
        if (point >= 0)
            stage_.remove_point(*curve, point);
        else
            stage_.remove_curve(curve->id);
    }
}

bool Splines::shortcut(const Chord& chord) {
    if (chord.control || chord.shift) return false;
    switch (chord.key) {
        case GLFW_KEY_N:
            if (stage_.tool != Tool::motions) {
                stage_.end_drawing();
                stage_.point = -1;
            } else if (const Motion* const motion = stage_.chosen_motion();
                       motion != nullptr && !motion->keys.empty()) {
                stage_.add_motion(stage_.ground_now());
            }
            return true;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER: stage_.end_drawing(); return true;
        case GLFW_KEY_ESCAPE:
            if (stage_.dragging)
                stage_.give_up();
            else
                stage_.end_drawing();
            return true;
        case GLFW_KEY_C:
            if (Curve* const curve = stage_.chosen_curve(); curve != nullptr && curve->points.size() > 2) {
                curve->closed = !curve->closed;
                if (curve->closed) stage_.end_drawing();
            }
            return true;
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE: remove_chosen(); return true;
        case GLFW_KEY_SPACE: stage_.play(!stage_.playing); return true;
        case GLFW_KEY_HOME: stage_.seconds = 0.0; return true;
        default: return false;
    }
}

void Splines::write(const Export& what, const std::string& path) {
    if (&what == &kExports[2] || std::string(what.what) == "Motion")
        write_motion(stage_, path);
    else
        write_curves(stage_, path);
}

std::vector<uint32_t> Splines::mesh_ids() const {
    std::vector<uint32_t> ids;
    for (const auto& mesh : desk_.scene.meshes()) ids.push_back(mesh->id);
    return ids;
}

double Splines::count(const std::string& name) const {
    const Curve* const curve = stage_.chosen_curve();
    const LiveCurve* const live = stage_.live_curve(stage_.curve);
    const Motion* const motion = stage_.chosen_motion();
    const LiveMotion* const flight = stage_.live_motion(stage_.motion);
    if (name == "curves") return static_cast<double>(stage_.document.curves.size());
    if (name == "obstacles") return static_cast<double>(stage_.document.obstacles.size());
    if (name == "motions") return static_cast<double>(stage_.document.motions.size());
    if (name == "points") return curve != nullptr ? static_cast<double>(curve->points.size()) : 0.0;
    if (name == "closed") return curve != nullptr && curve->closed ? 1.0 : 0.0;
    if (name == "keys") return motion != nullptr ? static_cast<double>(motion->keys.size()) : 0.0;
    if (name == "nodes") return live != nullptr ? static_cast<double>(live->found().nodes.size()) : 0.0;
    if (name == "length") return live != nullptr ? live->found().length : 0.0;
    if (name == "settled") return live != nullptr && live->found().ending == FLG_SPLINE_CONVERGED ? 1.0 : 0.0;
    if (name == "decorated") return live != nullptr && curve != nullptr && live->decorated(*curve) ? 1.0 : 0.0;
    if (name == "positions") return flight != nullptr ? static_cast<double>(flight->found().poses.size()) : 0.0;
    if (name == "seconds") return stage_.seconds;
    if (name == "playing") return stage_.playing ? 1.0 : 0.0;
    throw StudioError("splines." + name + " is nothing that is counted.");
}

}  // namespace

std::unique_ptr<Workspace> make_splines(Desk& desk) {
    return std::make_unique<Splines>(desk);
}

}  // namespace flg::studio
