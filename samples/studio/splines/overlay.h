// SPDX-License-Identifier: MIT
// Handles and highlights over the picture.
#pragma once

#include "splines/mouse_tool.h"

struct ImDrawList;

namespace flg::studio::splines {

void draw_overlay(ImDrawList& list, const SplineEditor& editor, const MouseTool& mouse_tool);

}  // namespace flg::studio::splines
