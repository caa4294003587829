// SPDX-License-Identifier: MIT
// Where a thing that comes into the scene is put: on the floor, beside what is there and not in it.
#pragma once

#include <span>

#include "filigree_renderer/placement.h"

namespace flg::studio {

// `own`: of the thing, in its own space; `others`: of what is there. With nothing there it stays where it was made. It
// keeps its size, unless that is absurd beside the others.
render::Placement free_place(const render::Box& own, std::span<const render::Box> others);

}  // namespace flg::studio
