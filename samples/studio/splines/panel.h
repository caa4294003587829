// SPDX-License-Identifier: MIT
// The workspace's widgets.
#pragma once

#include "splines/stage.h"

namespace flg::studio::splines {

void curves_panel(Stage& stage);
void obstacles_panel(Stage& stage);
void motions_panel(Stage& stage);
// The choice of what points lie on, for what is begun next and for `chosen`, if that is not null.
void ground_choice(Stage& stage, Ground* chosen);

}  // namespace flg::studio::splines
