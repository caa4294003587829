// SPDX-License-Identifier: MIT
// Draws contours with the mouse: of parts, and with Shift of holes.
#pragma once

#include "skeletons/editor.h"

struct ImDrawList;

namespace flg::studio {

class DrawTool {
public:
    explicit DrawTool(Editor& editor) : editor_(editor) {}

    void pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    void drop() { path_.clear(); }
    bool is_drawing() const { return !path_.empty(); }
    float depth = 0.0f;  // of the next part's plane, metres

private:
    void finish(bool hole);
    void make_part();
    void make_hole();
    std::vector<glm::dvec2> path_on_plane(double z) const;
    double spacing_at(const glm::vec3& place) const;

    Editor& editor_;
    std::vector<glm::vec2> path_;  // pixels
    bool is_hole_ = false;
    glm::vec2 hover_{0.0f};
    bool is_inside_ = false;
};

}  // namespace flg::studio
