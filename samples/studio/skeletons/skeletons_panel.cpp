// SPDX-License-Identifier: MIT
// The workspace's panel.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "shell/widgets.h"
#include "skeletons/joint_edits.h"
#include "skeletons/skeletons.h"

namespace flg::studio {
namespace {

// Fig. 10 of the paper, for toys.
constexpr FlgBoneThresholds kFineBones = {.struct_size = sizeof(FlgBoneThresholds),
                                          .simplify = 0.002f,
                                          .merge = 0.008f,
                                          .prune = 0.015f,
                                          .collapse = 0.004f,
                                          .detail = 2},
                            kCoarseBones = {.struct_size = sizeof(FlgBoneThresholds),
                                            .simplify = 0.03f,
                                            .merge = 0.07f,
                                            .prune = 0.10f,
                                            .collapse = 0.06f,
                                            .detail = 0.5f};

// How far parts may be moved by sliders.
float reach_of(const Drawing& drawing) {
    const float size = std::max(drawing.box().diagonal(), 1.0f);
    return std::exp2(std::ceil(std::log2(0.5f * size)));
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
    constexpr Choice kModes[] = {{Mode::draw, "Draw", "Draw outlines. Each becomes a part with bones. Q."},
                                 {Mode::points, "Points", "Drag the points of a part's line. P."},
                                 {Mode::move, "Move", "Move, turn and resize parts. W."},
                                 {Mode::refine, "Refine", "Change the number of bones. E."},
                                 {Mode::weights, "Weights", "Paint how the body follows its joints. T."},
                                 {Mode::pose, "Pose", "Pose the body by its joints. R."},
                                 {Mode::pull, "Pull", "Pull the body at any point. Y."}};
    for (const Choice& choice : kModes) {
        if ((&choice - kModes) % 4 != 0) ui::same_row();
        if (ui::row_button(choice.label, &choice - kModes < 4 ? 4 : 3, choice.tip, {.pressed = mode_ == choice.mode}))
            set_mode(choice.mode);
    }
    fault_panel();
    switch (mode_) {
        case Mode::draw: draw_panel(); break;
        case Mode::move: move_panel(); break;
        case Mode::points: points_panel(); break;
        case Mode::refine: refine_panel(); break;
        case Mode::weights: weights_panel(); break;
        case Mode::pull: pull_panel(); break;
        default: pose_panel();
    }
    if (!is_posed() && mode_ != Mode::weights) parts_panel();
    if (mode_ == Mode::draw) picture_panel();
    shown_panel();
}

void Skeletons::fault_panel() {
    for (const DrawnPart& part : editor_.drawing().parts) {
        const LiveModel::PartState& state = editor_.live.state_of(part.contour);
        if (state.fault.empty()) continue;
        ui::heading("Repair this line");
        const bool crosses = !state.crossings.empty();
        ui::hint(crosses ? ("The line of '" + part.name + "' crosses itself at the red rings.").c_str()
                         : ("'" + part.name + "': " + state.fault + ".").c_str());
        const uint32_t id = part.id;
        if (editor_.live.keeps_line(id)) ui::hint("Until then the body keeps the line it had before.");
        if (ui::row_button("Repair", 2, "Removes the loops and keeps the outline.")) {
            editor_.select(id);
            return editor_.repair(id);
        }
        ui::same_row();
        if (ui::row_button("Discard", 2, "Deletes this line.")) {
            editor_.select(id);
            return editor_.remove_selected();
        }
        return;
    }
}

void Skeletons::draw_panel() {
    part_panel();
    if (ui::row_button("Front view", 2, "Looks at the drawing from the front.")) frame_drawing({0.0f, 0.0f, -1.0f});
    ui::same_row();
    const SceneMesh* mesh = app_.scene.active();
    if (ui::row_button("Trace mesh", 2, "Makes a part from the front silhouette of the active mesh.",
                       {.enabled = mesh != nullptr && mesh->ready}))
        editor_.trace_mesh();
}

void Skeletons::picture_panel() {
    const TracedPicture& picture = editor_.drawing().picture;
    if (!ui::section("Picture", !picture.path.empty())) return;
    if (picture.path.empty()) return ui::hint("Drop a picture here (.png, .jpg) to trace it.");
    float opacity = 100.0f * picture.opacity;
    if (ui::slider("Opacity", &opacity, 0.0f, 100.0f, "%.0f %%", "Opacity of the picture. 0 hides it."))
        editor_.change("opacity").picture.opacity = 0.01f * opacity;
    end_slider();
    auto height = static_cast<float>(picture.height);
    if (ui::length("Picture size", &height, 0.1f, 20.0f, "Height of the picture in the scene.", true))
        editor_.change("picture height").picture.height = static_cast<double>(height);
    end_slider();
    if (ui::row_button("Remove picture", 1, "Removes the picture. The drawing stays.")) {
        editor_.commit();
        editor_.change("picture").picture = {};
        editor_.commit();
    }
}

void Skeletons::points_panel() {
    ui::heading("Points");
    const DrawnPart* part = editor_.selected();
    if (part == nullptr) return ui::hint("Click a part in the view or in the list.");
    float percent = 100.0f * points_.reach;
    if (ui::slider("Soft reach", &percent, 0.0f, 50.0f, "%.0f %%",
                   "How far along the line other points follow the one you drag: a share of the part's size. 0 moves "
                   "points alone."))
        points_.reach = 0.01f * percent;
    size_t points = 0;
    for (const Ring& ring : part->contour->rings) points += ring.size();
    ui::hint((std::to_string(points) + " points").c_str());
    if (ui::row_button("Remove point", 1, "Removes the chosen point. Delete.",
                       {.enabled = points_.chosen().has_value()}))
        points_.remove_chosen();
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

void Skeletons::threshold_slider(const char* label, float FlgBoneThresholds::*which, float max_percent,
                                 const char* tip) {
    FlgBoneThresholds all = thresholds();
    float percent = 100.0f * all.*which;
    if (ui::slider(label, &percent, 0.0f, max_percent, "%.2f %%", tip)) {
        all.*which = 0.01f * percent;
        set_thresholds(all);
    }
    end_slider();
}

void Skeletons::detail_slider() {
    FlgBoneThresholds all = thresholds();
    if (ui::slider("Detail", &all.detail, 0.0f, 4.0f, "%.2f",
                   "More joints in all limbs. 0: only what the four below ask for."))
        set_thresholds(all);
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
                   "Simplify for the chosen branch only. More leaves fewer joints along it.")) {
        shares[branch] = 0.01f * percent;
        editor_.change_selected("branch").branch_simplify = shares;
    }
    end_slider();
    if (ui::row_button("Reset branch", 1, "The branch uses the settings of its part again.",
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
    if (ui::row_button("Whole model", 2, "The sliders set all parts without settings of their own.",
                       {.pressed = !of_part})) {
        editor_.commit();
        refines_part_ = false;
    }
    ui::same_row();
    if (ui::row_button("This part", 2, "The sliders set the selected part only.",
                       {.enabled = has_part, .pressed = of_part})) {
        editor_.commit();
        refines_part_ = true;
    }
    char text[96];
    const Rig* rig = editor_.live.rig();
    std::snprintf(text, sizeof text, "%zu joints, %zu bones. 100 %% is the model's size, %s.",
                  rig ? rig->count() : size_t{0}, rig ? rig->bone_count() : size_t{0},
                  ui::length_text(rig ? static_cast<double>(rig->size) : 0.0).c_str());
    ui::hint(text);
    struct Preset {
        const char* label;
        const char* tip;
        const FlgBoneThresholds* thresholds;
    };
    const Preset presets[] = {{"Fine", "Many short bones that follow every bend.", &kFineBones},
                              {"Usual", "A few bones per limb.", &kUsualBones},
                              {"Coarse", "As few bones as possible.", &kCoarseBones}};
    for (const Preset& preset : presets) {
        if (&preset != presets) ui::same_row();
        if (!ui::row_button(preset.label, 3, preset.tip)) continue;
        editor_.commit();
        set_thresholds(*preset.thresholds);
        editor_.commit();
    }
    detail_slider();
    threshold_slider("Simplify", &FlgBoneThresholds::simplify, 5.0f,
                     "How far bones may lie off the middle of a limb. More leaves fewer joints.");
    threshold_slider("Merge", &FlgBoneThresholds::merge, 15.0f,
                     "Forks closer together than this become one. More leaves fewer forks.");
    threshold_slider("Prune", &FlgBoneThresholds::prune, 20.0f,
                     "Twigs shorter than this are removed. More leaves fewer ends.");
    threshold_slider("Collapse", &FlgBoneThresholds::collapse, 10.0f,
                     "Inner bones shorter than this are removed. More leaves longer bones.");
    if (of_part && ui::row_button("Reset part", 1, "The part uses the settings of the whole model again.",
                                  {.enabled = editor_.selected()->thresholds.has_value()})) {
        editor_.commit();
        editor_.change_selected("bones").thresholds.reset();
        editor_.commit();
    }
    if (const auto branch = branch_.branch()) branch_slider(*branch);
    joint_panel();
}

void Skeletons::joint_panel() {
    const Rig* rig = shown_rig();
    const uint32_t joint = rig != nullptr ? joint_.selected(*rig).value_or(FLG_NO_INDEX) : FLG_NO_INDEX;
    const std::string key = joint != FLG_NO_INDEX ? key_of(*rig, joint) : std::string();
    const auto act = [&](const char* name, auto change) {
        editor_.commit();
        change(editor_.change(name));
        editor_.commit();
    };
    if (!editor_.drawing().joint_edits.empty() &&
        ui::row_button("Reset all joints", 1, "Forgets all that was set about joints, merged ones included."))
        act("joints", [](Drawing& drawing) { drawing.joint_edits.clear(); });
    // Another one was selected while this was typed.
    const auto take = [&] {
        const std::string of = std::exchange(joint_of_, {});
        if (!of.empty() && joint_text_ != of)
            act("joint name", [&](Drawing& drawing) { rename_joint(drawing, of, joint_text_); });
    };
    if (!joint_of_.empty() && joint_of_ != key) take();
    if (joint == FLG_NO_INDEX) return;
    ui::heading("Joint");
    const std::string& shown = rig->names[joint];
    const bool is_side = rig->keys[joint] != key;
    const std::string name = is_side ? shown.substr(0, shown.size() - 2) : shown;
    std::string text = !joint_of_.empty() ? joint_text_ : name;
    ui::text("Joint name", &text, "Name of the joint. Mirror images get .L and .R.");
    if (ui::active()) {
        joint_of_ = key;
        joint_text_ = text;
    } else if (!joint_of_.empty()) {
        joint_text_ == name ? joint_of_.clear() : take();
    }
    const bool is_root = rig->parents[joint] == FLG_NO_INDEX, is_pinned = rig->pinned[joint];
    if (ui::row_button(is_pinned ? "Unpin" : "Pin", 2,
                       "A pinned joint stays where it is, whatever the sliders say. Dragging a joint pins it.",
                       {.pressed = is_pinned}))
        act("pin", [&](Drawing& drawing) {
            is_pinned ? unpin_joint(drawing, key) : pin_joint(drawing, key, rig->places[joint]);
        });
    ui::same_row();
    if (ui::row_button("Split", 2, "Adds a joint in the middle of the bone from the joint before.",
                       {.enabled = !is_root}))
        act("split", [&](Drawing& drawing) { joint_.select(split_bone(drawing, *rig, key)); });
    if (ui::row_button("Merge into parent", 2, "Makes the joint one with the joint before.", {.enabled = !is_root}))
        act("merge", [&](Drawing& drawing) { merge_joint(drawing, key); });
    ui::same_row();
    const auto& edits = editor_.drawing().joint_edits;
    const bool is_set = std::any_of(edits.begin(), edits.end(),
                                    [&](const JointEdit& edit) { return edit.joint == key || edit.name == key; });
    if (ui::row_button("Reset joint", 2, "Forgets all that was set about this joint.", {.enabled = is_set}))
        act("joint", [&](Drawing& drawing) { reset_joint(drawing, key); });
}

void Skeletons::pose_panel() {
    ui::heading("Pose");
    const bool has_skin = editor_.live.skin() != nullptr;
    if (!has_skin) ui::hint("Draw a part first. Then pose it here.");
    if (ui::row_button(is_playing_ ? "Stop" : "Test motion", 2,
                       "Swings every joint a little to show how the body follows. Space.",
                       {.enabled = has_skin, .pressed = is_playing_}))
        play(!is_playing_);
    ui::same_row();
    if (ui::row_button("Rest pose", 2, "Returns all joints to the rest pose.",
                       {.enabled = !editor_.drawing().pose.is_rest()})) {
        editor_.commit();
        editor_.change("rest").pose = {};
        editor_.commit();
    }
    ui::heading("Skinning");
    const bool is_linear = skinning_ == FLG_SKINNING_LINEAR;
    if (ui::row_button("Soft", 2, "Blends joints softly. Thins out where bones twist.", {.pressed = is_linear}))
        skinning_ = FLG_SKINNING_LINEAR;
    ui::same_row();
    if (ui::row_button("Keeps volume", 2, "Keeps the body as thick where bones twist.", {.pressed = !is_linear}))
        skinning_ = FLG_SKINNING_DUAL_QUATERNION;
}

void Skeletons::weights_panel() {
    ui::heading("Weights");
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (skin == nullptr) return ui::hint("Draw a part first. Then paint its weights here.");
    const auto joint = paint_.chosen(skin->rig);
    ui::hint(joint ? ("How much of the body follows " + skin->rig.names[*joint] + ".").c_str()
                   : "Click a joint in the view.");
    struct Choice {
        WeightBrush brush;
        const char* label;
        const char* tip;
    };
    constexpr Choice kBrushes[] = {{WeightBrush::add, "Add", "The painted place follows the joint more."},
                                   {WeightBrush::subtract, "Subtract", "The painted place follows the joint less."},
                                   {WeightBrush::smooth, "Smooth", "Evens out how the place follows all joints."}};
    for (const Choice& choice : kBrushes) {
        if (choice.brush != WeightBrush::add) ui::same_row();
        if (ui::row_button(choice.label, 3, choice.tip, {.pressed = paint_.brush == choice.brush}))
            paint_.brush = choice.brush;
    }
    ui::slider("Brush size", &paint_.radius, 4.0f, 150.0f, "%.0f px", "Radius of the brush on the screen.", true);
    float percent = 100.0f * paint_.strength;
    if (ui::slider("Strength", &percent, 1.0f, 100.0f, "%.0f %%",
                   "How much a touch changes in the middle of the brush."))
        paint_.strength = 0.01f * percent;
    ui::toggle("Both sides", &paint_.mirrors, "Paints the mirrored joint on the other side, too.",
               paint_.is_symmetric());
    const Drawing& drawing = editor_.drawing();
    const auto act = [&](auto goes) {
        editor_.commit();
        std::erase_if(editor_.change("weights").weight_strokes, goes);
        editor_.commit();
    };
    const std::string key = joint ? skin->rig.keys[*joint] : std::string();
    const auto is_of_joint = [&](const WeightStrokePtr& stroke) {
        return stroke->joint == key || stroke->mirror_joint == key;
    };
    const bool has_own =
        joint && std::any_of(drawing.weight_strokes.begin(), drawing.weight_strokes.end(), is_of_joint);
    if (ui::row_button("Reset weights", 2,
                       "Forgets what was painted for the chosen joint, and with it for its mirrored "
                       "one.",
                       {.enabled = has_own}))
        act(is_of_joint);
    ui::same_row();
    if (ui::row_button("Reset all weights", 2, "Forgets all that was painted.",
                       {.enabled = !drawing.weight_strokes.empty()}))
        act([](const WeightStrokePtr&) { return true; });
    if (weights_.lost_count() == 0) return;
    ui::hint((std::to_string(weights_.lost_count()) +
              " strokes have no joint or place on the body now. They are kept for when they have one again.")
                 .c_str());
    if (ui::row_button("Forget lost strokes", 1, "Removes the strokes that can't be painted now."))
        weights_.forget_lost();
}

void Skeletons::pull_panel() {
    ui::heading("Pull");
    const Pulls& pulls = editor_.drawing().pulls;
    if (editor_.live.skin() == nullptr) return ui::hint("Draw a part first. Then pull it here.");
    char text[96];
    std::snprintf(text, sizeof text, "%zu pins", pulls.pins.size());
    ui::hint(text);
    if (ui::row_button("Release all pins", 1, "The body goes back to where its bones have it.",
                       {.enabled = !pulls.pins.empty()}))
        pull_.release_all();
    ui::heading("Record");
    std::snprintf(text, sizeof text, "%zu keys, %.1f s", pulls.record ? pulls.record->keys.size() : size_t{0},
                  pulls.record ? static_cast<double>(pulls.record->length()) : 0.0);
    ui::hint(text);
    if (ui::row_button("Record drags", 2, "While this is on, each drag adds to the record, one after the other.",
                       {.pressed = pull_.records}))
        pull_.records = !pull_.records;
    ui::same_row();
    if (ui::row_button(pull_.is_playing() ? "Stop" : "Play record", 2, "Plays what was recorded, over and over. Space.",
                       {.enabled = pulls.record != nullptr, .pressed = pull_.is_playing()}))
        pull_.play(!pull_.is_playing());
    if (ui::row_button("Delete record", 2, "Forgets what was recorded.", {.enabled = pulls.record != nullptr}))
        pull_.forget_record();
    ui::same_row();
    if (ui::row_button(is_playing_ ? "Stop bones" : "Move bones", 2,
                       "Swings every joint while the body is pulled, as the test motion of Pose does.",
                       {.pressed = is_playing_}))
        play(!is_playing_);
}

void Skeletons::shown_panel() {
    if (!ui::section("Display")) return;
    ui::toggle("Body", &shown_.body, "Shows the body.");
    ui::same_row();
    ui::toggle("Bones", &shown_.bones, "Shows bones and joints through the body.");
    ui::toggle("Lines", &shown_.outlines, "Shows the outlines you drew.");
    ui::same_row();
    ui::toggle("Meshes", &shown_.meshes,
               "Shows the meshes of the scene and what is on them, which are hidden here otherwise.");
}

}  // namespace flg::studio
