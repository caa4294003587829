// SPDX-License-Identifier: MIT
// Handles and highlights over the picture.
#pragma once

#include "splines/hand.h"

struct ImDrawList;

namespace flg::studio::splines {

void draw_overlay(ImDrawList& list, const Stage& stage, const Hand& hand);

}  // namespace flg::studio::splines
