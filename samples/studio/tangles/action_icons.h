// SPDX-License-Identifier: MIT
// Small drawings of what each operator and macro makes.
#pragma once

#include "tangles/recipe.h"

struct ImDrawList;
struct ImVec2;

namespace flg::studio {

// Within a square of this size about a centre, pixels.
void draw_action_icon(ImDrawList& list, Action action, const ImVec2& center, float size);

}  // namespace flg::studio
