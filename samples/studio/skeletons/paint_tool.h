// SPDX-License-Identifier: MIT
// Paints the weights of a joint onto the body at rest. A click on a joint chooses it.
#pragma once

#include <optional>

#include "skeletons/joint_symmetry.h"
#include "skeletons/part_picking.h"
#include "skeletons/weight_layer.h"

struct ImDrawList;

namespace flg::studio {

class PaintTool {
public:
    PaintTool(Editor& editor, WeightLayer& layer) : editor_(editor), layer_(layer) {}

    WeightBrush brush = WeightBrush::add;
    float radius = 28.0f;  // units of the layout
    float strength = 0.3f;
    bool mirrors = false;

    // `rig`: the skin's, `joints`: as they are shown.
    void pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints);
    void overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const;
    // The stroke under way has not been.
    void drop();
    void leave() { drop(), hovered_.reset(), on_body_ = false; }
    bool is_painting() const { return stroke_.has_value(); }

    std::optional<uint32_t> chosen(const Rig& rig) const;
    void choose(const std::string& key) { joint_ = key; }
    std::vector<uint32_t> bright(const Rig& rig) const;
    bool is_symmetric() const { return symmetry_.has_value(); }

private:
    void look_at(const Rig& rig);
    void begin_stroke(const Rig& rig, uint32_t joint, bool inverts);
    void paint_to(glm::vec2 px);
    void paint_at(glm::vec2 px);

    Editor& editor_;
    WeightLayer& layer_;
    std::string joint_;  // key, with its side
    std::optional<uint32_t> hovered_;
    std::optional<JointSymmetry> symmetry_;
    uint64_t symmetry_of_ = 0;
    glm::vec2 hover_px_{0.0f};
    bool on_body_ = false;
    std::optional<WeightStroke> stroke_;
    // When it was pressed on a joint: chosen, unless the mouse moves on.
    std::optional<uint32_t> pressed_joint_;
    bool pressed_shift_ = false;
    glm::vec2 press_px_{0.0f}, last_px_{0.0f};
};

}  // namespace flg::studio
