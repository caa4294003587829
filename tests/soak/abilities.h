// SPDX-License-Identifier: MIT
// All that the soak does at once.
#pragma once

#include <memory>

#include "soak/stage.h"

namespace flg::soak {

std::unique_ptr<Ability> draw_strokes(Stage& stage);
std::unique_ptr<Ability> stylize_curves(Stage& stage);
std::unique_ptr<Ability> measure_distances(Stage& stage);
std::unique_ptr<Ability> decorate_surfaces(Stage& stage);
std::unique_ptr<Ability> drag_parts(Stage& stage);
std::unique_ptr<Ability> draw_contours(Stage& stage);
std::unique_ptr<Ability> drag_splines(Stage& stage);
std::unique_ptr<Ability> move_bodies(Stage& stage);

}  // namespace flg::soak
