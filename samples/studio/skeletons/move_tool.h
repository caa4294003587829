// SPDX-License-Identifier: MIT
// Drags parts in the plane of the view, along their depth with Shift, and turns and sizes the selected one by knobs
// around it.
#pragma once

#include "skeletons/part_picking.h"

struct ImDrawList;

namespace flg::studio {

class MoveTool {
public:
    explicit MoveTool(Editor& editor) : editor_(editor) {}

    void pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    // Lets go of what is dragged, and leaves it where it is.
    void drop() { drag_ = Knob::none; }
    bool is_dragging() const { return drag_ != Knob::none; }
    uint32_t hovered_part() const { return hovered_part_; }

private:
    enum class Knob { none, part, depth, turn, size };
    struct Knobs {
        glm::vec2 centre, turn, size, depth;
        float radius;
    };
    std::optional<Knobs> knobs() const;
    Knob knob_at(glm::vec2 px) const;
    void grab(const Pointer& mouse);
    void drag(const Pointer& mouse);
    glm::dvec3 moved_in_view(glm::vec2 px) const;
    double moved_in_depth(glm::vec2 px) const;

    Editor& editor_;
    Knob drag_ = Knob::none, hovered_ = Knob::none;
    uint32_t hovered_part_ = 0;
    glm::vec2 hover_px_{0.0f};
    bool is_fresh_ = false;  // hovered_part_ is of hover_px_
    uint64_t hover_revision_ = 0;
    // When it was grabbed:
    DrawnPart before_;
    glm::vec2 grab_px_{0.0f}, centre_px_{0.0f};
    glm::vec3 grab_at_{0.0f};
    bool is_image_ = false;
};

}  // namespace flg::studio
