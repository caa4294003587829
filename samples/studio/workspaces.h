// SPDX-License-Identifier: MIT
// The four workspaces, in the order of their buttons.
#pragma once

#include <memory>
#include <vector>

#include "shell/workspace.h"

namespace flg::studio {

std::unique_ptr<Workspace> make_strokes(Desk& desk);
std::unique_ptr<Workspace> make_tangles(Desk& desk);
std::unique_ptr<Workspace> make_skeletons(Desk& desk);
std::unique_ptr<Workspace> make_splines(Desk& desk);

std::vector<std::unique_ptr<Workspace>> make_workspaces(Desk& desk);

}  // namespace flg::studio
