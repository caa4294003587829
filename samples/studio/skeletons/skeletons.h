// SPDX-License-Identifier: MIT
// The Skeletons workspace: contours drawn over a picture become parts with bones, moved, refined and posed.
#pragma once

#include "shell/workspace.h"
#include "skeletons/branch_tool.h"
#include "skeletons/draw_tool.h"
#include "skeletons/joint_tool.h"
#include "skeletons/model_picture.h"
#include "skeletons/move_tool.h"
#include "skeletons/paint_tool.h"
#include "skeletons/picture_layer.h"
#include "skeletons/points_tool.h"
#include "skeletons/pose_tool.h"
#include "skeletons/pull_tool.h"

namespace flg::studio {

// Documents keep their numbers.
enum class Mode { draw, move, refine, pose, points, weights, pull };

class Skeletons final : public Workspace {
public:
    explicit Skeletons(AppContext& app);

    const char* title() const override { return "Skeletons"; }
    std::string help() const override;
    void enter() override;
    void leave() override;
    void update() override;
    void panel() override;
    void pointer(const Pointer& mouse) override;
    void overlay(ImDrawList& list) override;
    bool shortcut(const Chord& chord) override;
    std::span<const Shortcut> shortcuts() const override;
    bool can_undo() const override { return editor_.can_undo(); }
    bool can_redo() const override { return editor_.can_redo(); }
    void undo() override;
    void redo() override;
    void forget_undone() override { editor_.forget_undone(); }
    bool give_up() override;
    void settle() override { editor_.commit(); }
    bool is_settled() const override;
    bool open(const std::string& path) override;
    nlohmann::json save() const override;
    void load(const nlohmann::json& part) override;
    std::span<const Export> exports() const override;
    void write(const Export& what, const std::string& path) override;
    const render::Camera* scene_camera() const override { return scene_camera_ ? &*scene_camera_ : nullptr; }
    bool shows_scene() const override { return shown_.meshes; }
    float floor() const override;
    bool busy() const override;
    void device_lost() override;
    double count(const std::string& name) const override;

private:
    // What of it all is shown.
    struct Seen {
        bool body = true, bones = true, outlines = true, meshes = false;
    };
    void set_mode(Mode mode);
    void drop_tools();
    void drop_drags();
    void frame_drawing(const glm::vec3& sight);
    void hide_meshes();
    // The body at rest becomes the scene's drawn model.
    void give_surface();
    void open_picture(const std::string& path);

    // The scene's drawn model plays its motion while another workspace is in front.
    void play_in_scene();
    std::vector<glm::quat> moved_turns(std::vector<glm::quat> turns, double seconds) const;

    // What is shown of the pose: at rest but in Pose, where the bones are those of the body.
    const Rig* shown_rig() const;
    uint64_t shown_revision() const;
    std::vector<glm::quat> shown_turns(const Rig& rig) const;
    void show_model();
    bool shows_weights() const;
    void show_weights();
    bool shows_pulled() const;
    void show_pulled();
    // The body with its bones' pose, on the CPU; empty: at rest.
    std::vector<float> posed_positions() const;
    // Whether the body is seen in its pose.
    bool is_posed() const { return mode_ == Mode::pose || mode_ == Mode::pull; }
    void play(bool on);

    void draw_panel();
    void move_panel();
    void points_panel();
    void refine_panel();
    void joint_panel();
    void pose_panel();
    void weights_panel();
    void pull_panel();
    void name_field();
    void take_name();
    void part_panel();
    void place_panel();
    void parts_panel();
    void fault_panel();
    void picture_panel();
    void shown_panel();
    // Of the whole, or of the part that is refined.
    FlgBoneThresholds thresholds() const;
    void set_thresholds(const FlgBoneThresholds& thresholds);
    void threshold_slider(const char* label, float FlgBoneThresholds::*which, float max_percent, const char* tip);
    void detail_slider();
    void branch_slider(uint32_t branch);
    // After each slider: a step of undo where it was let go of.
    void end_slider();
    void draw_outlines(ImDrawList& list) const;
    void draw_invitation(ImDrawList& list) const;

    Editor editor_;
    ModelPicture picture_;
    PictureLayer layer_;
    DrawTool draw_{editor_};
    MoveTool move_{editor_};
    PointsTool points_{editor_};
    BranchTool branch_{editor_};
    JointTool joint_{editor_};
    PoseTool pose_{editor_};
    WeightLayer weights_{editor_};
    PaintTool paint_{editor_, weights_};
    PullTool pull_{editor_};
    Mode mode_ = Mode::draw;
    Seen shown_;
    bool is_in_front_ = false;
    std::optional<render::Camera> scene_camera_, own_camera_;  // of the one of the two that is not looked through
    uint64_t given_revision_ = 0;                              // of the skin that the scene's model was made of
    uint64_t bent_revision_ = 0;                               // the same, that it is bent by
    std::vector<glm::vec3> given_colors_;
    uint64_t skin_floor_of_ = 0;  // the same, that the floor lies under
    float skin_floor_ = 0.0f;
    bool wants_frame_ = true;  // the camera is to see the drawing, or the empty paper
    bool refines_part_ = false;
    float reach_ = 1.0f;       // of sliders that move parts, metres
    bool is_sliding_ = false;  // a slider of the panel is held
    std::string name_text_;    // being typed
    uint32_t name_of_ = 0;
    std::string joint_text_, joint_of_;  // the same of a joint, by its key

    FlgSkinning skinning_ = FLG_SKINNING_DUAL_QUATERNION;
    bool is_playing_ = false, was_played_ = false;
    double play_from_ = 0.0;
    PosedJoints joints_;  // of shown_rig()
    // What the body's pose was made of, so that it is made anew only when that changes.
    std::vector<float> transforms_;
    FlgSkinning transforms_as_ = FLG_SKINNING_LINEAR;
};

}  // namespace flg::studio
