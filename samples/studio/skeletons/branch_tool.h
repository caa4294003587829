// SPDX-License-Identifier: MIT
// Selects a part, and of the selected one a branch of its axis, to be refined by itself.
#pragma once

#include <optional>

#include "skeletons/part_picking.h"

struct ImDrawList;

namespace flg::studio {

class BranchTool {
public:
    explicit BranchTool(Editor& editor) : editor_(editor) {}

    void pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    // Of the selected part.
    std::optional<uint32_t> branch() const;
    void leave() { branch_.reset(), hovered_.reset(); }

private:
    std::vector<glm::vec2> branch_in_window(const DrawnPart& part, const FlgPartView& axis, uint32_t branch) const;
    std::optional<uint32_t> branch_at(glm::vec2 px) const;

    Editor& editor_;
    std::optional<uint32_t> branch_, hovered_;
    std::weak_ptr<const Contour> contour_;  // that branch_ is of
};

}  // namespace flg::studio
