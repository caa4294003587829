// SPDX-License-Identifier: MIT
// The Splines workspace: what the shell asks of it, handed on to the editor, the mouse tool, the panels and the files.
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

constexpr Workspace::Shortcut kShortcuts[] = {{"N", "Start another curve or motion"},
                                              {"Enter", "End the curve"},
                                              {"Escape", "Cancel the drag, or end the curve"},
                                              {"C", "Close or open the curve"},
                                              {"Delete", "Remove the selected point, key, obstacle or curve"},
                                              {"Space", "Play or pause the motion"},
                                              {"Home", "Return to the start of the motion"}};

constexpr Workspace::Export kExports[] = {{"Spline curves", ".glb"}, {"Spline curves", ".xyz"}, {"Motion", ".glb"}};

class Splines final : public Workspace {
public:
    explicit Splines(AppContext& app) : Workspace(app), editor_(app) {
        editor_.did = [this] { app_.timeline.push(*this); };
    }

    const char* title() const override { return "Splines"; }
    std::string help() const override;
    void enter() override { editor_.in_front = true; }
    void leave() override;
    void update() override { editor_.update(); }
    void panel() override;
    void pointer(const Pointer& mouse) override { mouse_tool_.pointer(mouse); }
    void overlay(ImDrawList& list) override { draw_overlay(list, editor_, mouse_tool_); }
    bool shortcut(const Chord& chord) override;
    std::span<const Shortcut> shortcuts() const override { return kShortcuts; }

    bool can_undo() const override { return editor_.history.can_undo(); }
    bool can_redo() const override { return editor_.history.can_redo(); }
    void undo() override { editor_.undo(); }
    void redo() override { editor_.redo(); }
    void forget_undone() override { editor_.history.forget_undone(); }
    bool give_up() override { return editor_.dragging && editor_.give_up(); }
    void settle() override { editor_.settle(); }
    bool is_settled() const override { return !editor_.dragging && !editor_.history.has_news(); }

    bool open(const std::string& path) override { return read_file(editor_, path); }
    nlohmann::json save() const override { return to_json(editor_.document, mesh_ids()); }
    void load(const nlohmann::json& part) override { editor_.replace(from_json(part, mesh_ids())); }
    std::span<const Export> exports() const override { return kExports; }
    void write(const Export& what, const std::string& path) override;

    bool busy() const override { return editor_.busy(); }
    bool moving() const override { return editor_.playing; }
    void device_lost() override { editor_.device_lost(); }
    double count(const std::string& name) const override;

private:
    std::vector<uint32_t> mesh_ids() const;
    void remove_chosen();
    void choose(Tool tool);

    SplineEditor editor_;
    MouseTool mouse_tool_{editor_};
};

std::string Splines::help() const {
    if (editor_.tool == Tool::obstacles) return "Click to add an obstacle. Drag it: curves and motions go around it.";
    if (editor_.tool == Tool::motions)
        return "Click to add a key. Press and drag to set where the nose points. Space plays.";
    if (editor_.document.curve(editor_.drawing) != nullptr)
        return "Click to add points. Click the first point to close the curve; Enter or a double-click ends "
               "it.";
    if (!editor_.document.curves.empty())
        return "Drag points. Press on the curve to insert one. Click elsewhere to start another curve.";
    return "Click points on the surface. A smooth curve passes through them.";
}

void Splines::leave() {
    editor_.in_front = editor_.dragging = editor_.editing = false;
    editor_.end_drawing();
}

void Splines::choose(Tool tool) {
    if (editor_.tool == tool) return;
    editor_.end_drawing();
    editor_.tool = tool;
}

void Splines::panel() {
    constexpr struct {
        Tool tool;
        const char *label, *tip;
    } kTools[] = {{Tool::curves, "Curves", "Lay smooth curves through points on a surface or in space."},
                  {Tool::obstacles, "Obstacles", "Add solids that curves and motions go around."},
                  {Tool::motions, "Motions", "Move bodies smoothly from key to key."}};
    for (const auto& tool : kTools) {
        if (tool.tool != Tool::curves) ui::same_row();
        if (ui::row_button(tool.label, 3, tool.tip, {.enabled = true, .pressed = editor_.tool == tool.tool}))
            choose(tool.tool);
    }
    if (editor_.tool == Tool::curves) curves_panel(editor_);
    if (editor_.tool == Tool::obstacles) obstacles_panel(editor_);
    if (editor_.tool == Tool::motions) motions_panel(editor_);
    editor_.editing = ImGui::IsAnyItemActive();
}

void Splines::remove_chosen() {
    if (editor_.dragging) return;
    const Handle& hot = mouse_tool_.hot();
    if (hot.kind == HandleKind::solid) {
        editor_.remove_obstacle(hot.item);
    } else if (editor_.tool == Tool::obstacles) {
        editor_.remove_obstacle(editor_.obstacle);
    } else if (editor_.tool == Tool::motions) {
        Motion* const motion = editor_.chosen_motion();
        if (motion == nullptr) return;
        const int key = hot.kind == HandleKind::key ? hot.index : editor_.key;
        if (key >= 0)
            editor_.remove_key(*motion, key);
        else
            editor_.remove_motion(motion->id);
    } else if (Curve* const curve = editor_.chosen_curve()) {
        const int point = hot.kind == HandleKind::point ? hot.index : editor_.point;
        if (point >= 0)
            editor_.remove_point(*curve, point);
        else
            editor_.remove_curve(curve->id);
    }
}

bool Splines::shortcut(const Chord& chord) {
    if (chord.control || chord.shift) return false;
    switch (chord.key) {
        case GLFW_KEY_N:
            if (editor_.tool != Tool::motions) {
                editor_.begin_new();
            } else if (const Motion* const motion = editor_.chosen_motion();
                       motion != nullptr && !motion->keys.empty()) {
                editor_.add_motion(editor_.ground_now());
            }
            return true;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER: editor_.end_drawing(); return true;
        case GLFW_KEY_ESCAPE:
            if (editor_.dragging)
                editor_.give_up();
            else
                editor_.end_drawing();
            return true;
        case GLFW_KEY_C:
            if (Curve* const curve = editor_.chosen_curve(); curve != nullptr && curve->points.size() > 2) {
                curve->closed = !curve->closed;
                if (curve->closed) editor_.end_drawing();
            }
            return true;
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE: remove_chosen(); return true;
        case GLFW_KEY_SPACE: editor_.play(!editor_.playing); return true;
        case GLFW_KEY_HOME: editor_.seconds = 0.0; return true;
        default: return false;
    }
}

void Splines::write(const Export& what, const std::string& path) {
    if (&what == &kExports[2] || std::string(what.what) == "Motion")
        write_motion(editor_, path);
    else
        write_curves(editor_, path);
}

std::vector<uint32_t> Splines::mesh_ids() const {
    std::vector<uint32_t> ids;
    for (const auto& mesh : app_.scene.meshes()) ids.push_back(mesh->id);
    return ids;
}

double Splines::count(const std::string& name) const {
    const Curve* const curve = editor_.chosen_curve();
    const LiveCurve* const live = editor_.live_curve(editor_.curve);
    const Motion* const motion = editor_.chosen_motion();
    const LiveMotion* const flight = editor_.live_motion(editor_.motion);
    if (name == "curves") return static_cast<double>(editor_.document.curves.size());
    if (name == "obstacles") return static_cast<double>(editor_.document.obstacles.size());
    if (name == "motions") return static_cast<double>(editor_.document.motions.size());
    if (name == "points") return curve != nullptr ? static_cast<double>(curve->points.size()) : 0.0;
    if (name == "closed") return curve != nullptr && curve->closed ? 1.0 : 0.0;
    if (name == "keys") return motion != nullptr ? static_cast<double>(motion->keys.size()) : 0.0;
    if (name == "nodes") return live != nullptr ? static_cast<double>(live->found().nodes.size()) : 0.0;
    if (name == "length") return live != nullptr ? live->found().length : 0.0;
    if (name == "settled") return live != nullptr && live->found().ending == FLG_SPLINE_ENDING_CONVERGED ? 1.0 : 0.0;
    if (name == "decorated") return live != nullptr && curve != nullptr && live->decorated(*curve) ? 1.0 : 0.0;
    if (name == "positions") return flight != nullptr ? static_cast<double>(flight->found().poses.size()) : 0.0;
    if (name == "seconds") return editor_.seconds;
    if (name == "playing") return editor_.playing ? 1.0 : 0.0;
    throw StudioError("splines has no value named " + name + ".");
}

}  // namespace

std::unique_ptr<Workspace> make_splines(AppContext& app) {
    return std::make_unique<Splines>(app);
}

}  // namespace flg::studio
