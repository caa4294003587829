// SPDX-License-Identifier: MIT
// The workspace's panel.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "shell/widgets.h"
#include "skeletons/skeletons.h"

namespace flg::studio {
namespace {

// Fig. 10 of the paper, for toys.
constexpr FlgBoneThresholds kFineBones = {.simplify = 0.002f, .merge = 0.008f, .prune = 0.015f, .collapse = 0.004f},
                            kCoarseBones = {.simplify = 0.03f, .merge = 0.07f, .prune = 0.10f, .collapse = 0.06f};

// How far parts may be moved by sliders.
float reach_of(const Drawing& drawing) {
    const float size = std::max(drawing.box().diagonal(), 1.0f);
    return std::exp2(std::ceil(std::log2(0.5f * size)));
}

double width_of(const DrawnPart& part) {
    glm::dvec2 low = part.contour->rings[0][0], high = low;
    for (const glm::dvec2& p : part.contour->rings[0]) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return std::max(glm::distance(low, high), 1e-12);
}

}  // namespace

void Skeletons::end_slider() {
    is_sliding_ = is_sliding_ || ui::active();
    if (ui::released()) editor_.commit();
}

void Skeletons::panel() {
    is_sliding_ = false;
    // A slider's range stays while it is held.
    if (!editor_.is_acting()) reach_ = reach_of(editor_.drawing());
    struct Choice {
        Mode mode;
        const char* label;
        const char* tip;
    };
    constexpr Choice kModes[] = {{Mode::draw, "Draw", "Draw contours: each becomes a part with bones. Key Q."},
                                 {Mode::move, "Move", "Put parts in their places. Key W."},
                                 {Mode::refine, "Refine", "Fewer or more bones. Key E."},
                                 {Mode::pose, "Pose", "Drag joints of the finished body. Key R."}};
    for (const Choice& choice : kModes) {
        if (choice.mode != Mode::draw) ui::same_row();
        if (ui::row_button(choice.label, 4, choice.tip, {.pressed = mode_ == choice.mode})) set_mode(choice.mode);
    }
    fault_panel();
    switch (mode_) {
        case Mode::draw: draw_panel(); break;
        case Mode::move: move_panel(); break;
        case Mode::refine: refine_panel(); break;
        default: pose_panel();
    }
    if (mode_ != Mode::pose) parts_panel();
    shown_panel();
}

void Skeletons::fault_panel() {
    for (const DrawnPart& part : editor_.drawing().parts) {
        const LiveModel::PartState& state = editor_.live.state_of(part.contour);
        if (state.fault.empty()) continue;
        ui::heading("This line can't be a part yet");
        const bool crosses = !state.crossings.empty();
        ui::hint(crosses ? ("The line of '" + part.name + "' crosses itself where the red rings are.").c_str()
                         : ("'" + part.name + "': " + state.fault + ".").c_str());
        const uint32_t id = part.id;
        if (ui::row_button("Repair", 2, "Keeps what the line goes around, without its loops.")) {
            editor_.select(id);
            return editor_.repair(id);
        }
        ui::same_row();
        if (ui::row_button("Discard", 2, "Deletes this line, so that you can draw it again.")) {
            editor_.select(id);
            return editor_.remove_selected();
        }
        return;
    }
}

void Skeletons::draw_panel() {
    part_panel();
    if (ui::row_button("Front view", 2, "Looks at the paper from the front, so that all of the drawing is seen."))
        frame_drawing({0.0f, 0.0f, -1.0f});
    ui::same_row();
    const SceneMesh* mesh = desk_.scene.active();
    if (ui::row_button("Trace mesh", 2,
                       "Makes a part of the silhouette of the scene's active mesh, seen from the front.",
                       {.enabled = mesh != nullptr && mesh->ready}))
        editor_.trace_mesh();
    picture_panel();
}

void Skeletons::take_name() {
    const DrawnPart* part = editor_.drawing().find(std::exchange(name_of_, 0));
    if (part == nullptr || part->name == name_text_) return;
    const uint32_t id = part->id;
    const std::string name = editor_.drawing().free_name(name_text_, id);
    editor_.commit();
    editor_.change("name").find(id)->name = name;
    editor_.commit();
}

void Skeletons::name_field() {
    const uint32_t id = editor_.selected_id();
    // Another one was selected while this was typed.
    if (name_of_ != 0 && name_of_ != id) take_name();
    std::string text = name_of_ != 0 ? name_text_ : id != 0 ? editor_.selected()->name : editor_.brush.name;
    ui::text("Name", &text, "What this part and its joints are called.");
    if (id == 0) {
        editor_.brush.name = text;
    } else if (ui::active()) {
        name_of_ = id;
        name_text_ = text;
    } else {
        take_name();
    }
}

void Skeletons::part_panel() {
    const bool is_next = editor_.selected() == nullptr;
    ui::heading(is_next ? "Next part" : "Selected part");
    name_field();
    const DrawnPart& part = is_next ? editor_.brush : *editor_.selected();
    const MirrorAs mirror = is_next ? editor_.brush_mirror : editor_.mirror_of(part);
    struct Choice {
        MirrorAs as;
        const char* label;
        const char* tip;
    };
    constexpr Choice kMirrors[] = {{MirrorAs::single, "Single", "There once, as it is drawn."},
                                   {MirrorAs::left_right, "Left, right",
                                    "There twice, left and right of the dashed line: arms of who looks at you."},
                                   {MirrorAs::front_back, "Near, far",
                                    "There twice, on the side of the body near to you and on the far one: legs of an "
                                    "animal drawn from its side."}};
    for (const Choice& choice : kMirrors) {
        if (choice.as != MirrorAs::single) ui::same_row();
        if (ui::row_button(choice.label, 3, choice.tip, {.pressed = mirror == choice.as}))
            editor_.set_mirror(choice.as);
    }
    float thickness = 100.0f * part.thickness;
    if (ui::slider("Thickness", &thickness, 10.0f, 200.0f, "%.0f %%",
                   "How deep the part is. 100 %: a disc becomes a ball. More is thicker, less is flatter.")) {
        editor_.brush.thickness = 0.01f * thickness;
        if (!is_next) editor_.change_selected("thickness").thickness = 0.01f * thickness;
    }
    end_slider();
    float depth = is_next ? draw_.depth : static_cast<float>(part.at.z);
    if (ui::slider("Depth", &depth, -reach_, reach_, "%.2f m",
                   "How near to you the part's plane is. More is nearer; 0 is the plane of the picture.")) {
        if (is_next)
            draw_.depth = depth;
        else
            editor_.change_selected("depth").at.z = static_cast<double>(depth);
    }
    end_slider();
    glm::vec3 color = part.color;
    if (ui::color("Colour", &color, "The colour of the part.")) {
        editor_.brush.color = color;
        if (!is_next) editor_.change_selected("colour").color = color;
    }
    end_slider();
}

void Skeletons::picture_panel() {
    const TracedPicture& picture = editor_.drawing().picture;
    ui::heading("Picture");
    if (picture.path.empty()) return ui::hint("Drop a picture here (.png, .jpg) to draw over it.");
    float opacity = 100.0f * picture.opacity;
    if (ui::slider("Opacity", &opacity, 0.0f, 100.0f, "%.0f %%",
                   "How much of the picture is seen over the body. 0 hides it."))
        editor_.change("opacity").picture.opacity = 0.01f * opacity;
    end_slider();
    auto height = static_cast<float>(picture.height);
    if (ui::slider("Picture height", &height, 0.1f, 20.0f, "%.2f m", "How large the picture is. More is larger.", true))
        editor_.change("picture height").picture.height = static_cast<double>(height);
    end_slider();
    if (ui::row_button("Remove picture", 1, "Takes the picture away; what was drawn stays.")) {
        editor_.commit();
        editor_.change("picture").picture = {};
        editor_.commit();
    }
}

void Skeletons::move_panel() {
    if (editor_.selected() == nullptr) {
        ui::heading("Selected part");
        return ui::hint("Click a part in the picture or in the list.");
    }
    part_panel();
    place_panel();
}

void Skeletons::place_panel() {
    struct Axis {
        const char* label;
        int axis;
        const char* tip;
    };
    constexpr Axis kPlaces[] = {{"Right", 0, "How far the part is moved to the right from where it was drawn."},
                                {"Up", 1, "How far the part is moved up from where it was drawn."}};
    for (const Axis& along : kPlaces) {
        auto value = static_cast<float>(editor_.selected()->at[along.axis]);
        if (ui::slider(along.label, &value, -reach_, reach_, "%.2f m", along.tip))
            editor_.change_selected(along.label).at[along.axis] = static_cast<double>(value);
        end_slider();
    }
    constexpr Axis kTurns[] = {
        {"Tilt", 0, "Turns the part about the line from left to right: more leans its top to you."},
        {"Swing", 1, "Turns the part about the upright line, as a door."},
        {"Turn", 2, "Turns the part in its own plane; more is counter-clockwise."}};
    for (const Axis& about : kTurns) {
        auto value = static_cast<float>(editor_.selected()->turn[about.axis]);
        if (ui::slider(about.label, &value, -180.0f, 180.0f, "%.0f deg", about.tip)) {
            glm::dvec3 turn = editor_.selected()->turn;
            turn[about.axis] = static_cast<double>(value);
            DrawnPart& part = editor_.change_selected(about.label);
            part.place(turn, part.scale);
        }
        end_slider();
    }
    const double drawn = width_of(*editor_.selected());
    auto size = static_cast<float>(editor_.selected()->scale * drawn);
    if (ui::slider("Size", &size, 0.05f, 20.0f, "%.2f m",
                   "How long the part is, from corner to corner. More is larger.", true)) {
        DrawnPart& part = editor_.change_selected("size");
        part.place(part.turn, static_cast<double>(size) / drawn);
    }
    end_slider();
}

FlgBoneThresholds Skeletons::thresholds() const {
    const DrawnPart* part = refines_part_ ? editor_.selected() : nullptr;
    return part != nullptr && part->thresholds ? *part->thresholds : editor_.drawing().thresholds;
}

void Skeletons::set_thresholds(const FlgBoneThresholds& thresholds) {
    if (refines_part_ && editor_.selected() != nullptr)
        editor_.change_selected("bones").thresholds = thresholds;
    else
        editor_.change("bones").thresholds = thresholds;
}

void Skeletons::threshold_slider(const char* label, float FlgBoneThresholds::*which, float most_percent,
                                 const char* tip) {
    FlgBoneThresholds all = thresholds();
    float percent = 100.0f * all.*which;
    if (ui::slider(label, &percent, 0.0f, most_percent, "%.2f %%", tip)) {
        all.*which = 0.01f * percent;
        set_thresholds(all);
    }
    end_slider();
}

void Skeletons::branch_slider(uint32_t branch) {
    const DrawnPart& part = *editor_.selected();
    const FlgPartView* axis = editor_.live.axis_of(part.contour);
    if (axis == nullptr || branch >= axis->branch_count) return;
    std::vector<float> shares = part.branch_simplify;
    shares.resize(axis->branch_count, -1.0f);
    float percent = 100.0f * (shares[branch] < 0.0f ? thresholds().simplify : shares[branch]);
    if (ui::slider("This branch", &percent, 0.0f, 5.0f, "%.2f %%",
                   "As Simplify, of the chosen branch alone: more leaves fewer joints along it.")) {
        shares[branch] = 0.01f * percent;
        editor_.change_selected("branch").branch_simplify = shares;
    }
    end_slider();
    if (ui::row_button("As its part", 1, "The branch follows Simplify of its part again.",
                       {.enabled = !part.branch_simplify.empty() && shares[branch] >= 0.0f})) {
        shares[branch] = -1.0f;
        editor_.commit();
        editor_.change_selected("branch").branch_simplify = shares;
        editor_.commit();
    }
}

void Skeletons::refine_panel() {
    ui::heading("Bones");
    const bool has_part = editor_.selected() != nullptr;
    const bool of_part = refines_part_ && has_part;
    if (ui::row_button("Whole model", 2, "The sliders are of all parts that have none of their own.",
                       {.pressed = !of_part})) {
        editor_.commit();
        refines_part_ = false;
    }
    ui::same_row();
    if (ui::row_button("This part", 2, "The sliders are of the selected part alone.",
                       {.enabled = has_part, .pressed = of_part})) {
        editor_.commit();
        refines_part_ = true;
    }
    char text[96];
    const Rig* rig = editor_.live.rig();
    std::snprintf(text, sizeof text, "%zu joints, %zu bones. Shares are of the model's size, %.1f m.",
                  rig ? rig->count() : size_t{0}, rig ? rig->bone_count() : size_t{0},
                  rig ? static_cast<double>(rig->size) : 0.0);
    ui::hint(text);
    struct Preset {
        const char* label;
        const char* tip;
        const FlgBoneThresholds* thresholds;
    };
    const Preset presets[] = {{"Fine", "Many short bones that follow every bend.", &kFineBones},
                              {"Usual", "A few bones a limb, as for toys.", &kUsualBones},
                              {"Coarse", "As few bones as can be posed.", &kCoarseBones}};
    for (const Preset& preset : presets) {
        if (&preset != presets) ui::same_row();
        if (!ui::row_button(preset.label, 3, preset.tip)) continue;
        editor_.commit();
        set_thresholds(*preset.thresholds);
        editor_.commit();
    }
    threshold_slider("Simplify", &FlgBoneThresholds::simplify, 5.0f,
                     "How far bones may be off the middle of a limb. More leaves fewer joints along it.");
    threshold_slider("Merge", &FlgBoneThresholds::merge, 15.0f,
                     "Forks nearer to each other than this become one. More leaves fewer forks.");
    threshold_slider("Prune", &FlgBoneThresholds::prune, 20.0f,
                     "Twigs shorter than this are removed. More leaves fewer ends.");
    threshold_slider("Collapse", &FlgBoneThresholds::collapse, 10.0f,
                     "Bones in between that are shorter than this vanish. More leaves longer bones.");
    if (of_part && ui::row_button("As the model", 1, "The part follows the sliders of the whole model again.",
                                  {.enabled = editor_.selected()->thresholds.has_value()})) {
        editor_.commit();
        editor_.change_selected("bones").thresholds.reset();
        editor_.commit();
    }
    if (const auto branch = branch_.branch()) branch_slider(*branch);
}

void Skeletons::pose_panel() {
    ui::heading("Pose");
    const bool has_skin = editor_.live.skin() != nullptr;
    if (!has_skin) ui::hint("Draw a part first: it becomes a body that can be posed.");
    if (ui::row_button(is_playing_ ? "Stop" : "Test motion", 2,
                       "Swings every joint a little, so that you see how the body follows. Key Space.",
                       {.enabled = has_skin, .pressed = is_playing_}))
        play(!is_playing_);
    ui::same_row();
    if (ui::row_button("Rest pose", 2, "Puts all joints back.", {.enabled = !editor_.drawing().pose.is_rest()})) {
        editor_.commit();
        editor_.change("rest").pose = {};
        editor_.commit();
    }
    ui::heading("How skin follows bones");
    const bool is_linear = skinning_ == FLG_SKINNING_LINEAR;
    if (ui::row_button("Linear", 2, "The mean of where the joints take it: gets thin where bones are twisted.",
                       {.pressed = is_linear}))
        skinning_ = FLG_SKINNING_LINEAR;
    ui::same_row();
    if (ui::row_button("Dual quaternion", 2,
                       "One rigid motion between the joints': keeps its girth where bones are twisted.",
                       {.pressed = !is_linear}))
        skinning_ = FLG_SKINNING_DUAL_QUATERNION;
}

void Skeletons::parts_panel() {
    ui::heading("Parts");
    const Drawing& drawing = editor_.drawing();
    if (drawing.parts.empty()) return ui::hint("None yet. Draw the body first, then what hangs on it.");
    uint32_t clicked = 0;
    for (const DrawnPart& part : drawing.parts) {
        const bool is_wrong = !editor_.live.state_of(part.contour).fault.empty();
        const std::string label = (is_wrong ? "! " : "") + part.name + (part.mirrored ? "  (two)" : "") +
                                  (!part.visible                    ? "  (hidden)"
                                   : editor_.live.is_loose(part.id) ? "  (loose)"
                                                                    : "") +
                                  "###" + part.name + " in list";
        if (ui::selectable(label.c_str(), part.id == editor_.selected_id(),
                           "A part: click to select it. It hangs on the part above that it meets."))
            clicked = part.id;
    }
    if (clicked != 0) editor_.select(clicked == editor_.selected_id() ? 0 : clicked);
    if (editor_.live.has_loose_parts())
        ui::hint("Loose parts meet no other: move them into the one that is to carry them.");
    const DrawnPart* part = editor_.selected();
    const ui::State state = {.enabled = part != nullptr};
    if (ui::row_button("Duplicate", 3, "A second one beside it. Ctrl+D.", state)) editor_.duplicate_selected();
    ui::same_row();
    const bool is_hidden = part != nullptr && !part->visible;
    if (ui::row_button(is_hidden ? "Show" : "Hide", 3, "Hidden parts are left out of body and bones.", state)) {
        editor_.commit();
        editor_.change_selected("hide").visible = is_hidden;
        editor_.commit();
    }
    ui::same_row();
    if (ui::row_button("Delete", 3, "Deletes the selected part. Key Delete.", state)) {
        drop_tools();
        editor_.remove_selected();
    }
    if (ui::row_button("Earlier", 2, "Moves the part up in the list: later parts may hang on it.", state))
        editor_.shift_selected(-1);
    ui::same_row();
    if (ui::row_button("Later", 2, "Moves the part down in the list: it may hang on those above.", state))
        editor_.shift_selected(1);
}

void Skeletons::shown_panel() {
    ui::heading("Show");
    ui::toggle("Body", &shown_.body, "The body that is made of the parts.");
    ui::same_row();
    ui::toggle("Bones", &shown_.bones, "Bones and joints, seen through the body.");
    ui::toggle("Lines", &shown_.outlines, "The contours as they were drawn.");
    ui::same_row();
    ui::toggle("Meshes", &shown_.meshes, "The meshes of the scene, which are put out of sight here otherwise.");
}

}  // namespace flg::studio
