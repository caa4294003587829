// SPDX-License-Identifier: MIT
// Handles over the picture that move, turn and scale the active mesh: three arrows, a square for each pair of them, a
// ring about each, a dot in the middle to move it freely, a knob that scales it. One step of the history a drag.
#pragma once

#include "scene/scene_steps.h"
#include "shell/workspace.h"

struct ImDrawList;

namespace flg::studio {

class Gizmo {
public:
    Gizmo(AppContext& app, SceneSteps& steps) : app_(app), steps_(steps) {}

    void toggle() { is_on_ = !is_on_; }
    bool is_on() const { return is_on_; }
    // True if the mouse is for it, and for nothing behind it.
    bool pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    bool is_dragging() const { return grip_held_.has_value(); }
    // The mesh goes back to where it was; false if none was dragged.
    bool give_up();
    // The numbers, to be dragged or typed on double click.
    void panel();

private:
    enum class Kind { axis, plane, ring, free, scale };
    struct Grip {
        Kind kind;
        int axis;
        bool operator==(const Grip&) const = default;
    };

    SceneMesh* mesh() const;
    glm::vec3 middle(const SceneMesh& mesh) const { return mesh.placed_box().center(); }
    float size(const glm::vec3& middle) const;
    std::vector<glm::vec3> ring(const glm::vec3& middle, int axis) const;
    glm::vec2 knob(glm::vec2 middle_px) const;
    std::optional<Grip> grip_at(glm::vec2 px, float reach_units) const;
    void begin(const Grip& grip, const Pointer& mouse);
    void drag(const Pointer& mouse);
    void end();
    void edited(const SceneMesh& mesh, const render::Placement& placement);

    AppContext& app_;
    SceneSteps& steps_;
    bool is_on_ = false;
    std::optional<Grip> grip_, grip_held_;
    bool missed_ = false;  // until the button goes up
    // Of the drag.
    uint32_t mesh_ = 0;
    render::Placement before_;
    glm::vec3 middle_{0.0f}, foot_{0.0f}, grabbed_{0.0f};
    glm::vec2 grabbed_px_{0.0f};
    float angle_ = 0.0f, last_angle_ = 0.0f;
    // Of the numbers.
    std::optional<render::Placement> edited_from_;
    glm::vec3 degrees_{0.0f};
    render::Placement degrees_of_;
};

}  // namespace flg::studio
