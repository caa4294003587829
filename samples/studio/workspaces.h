// SPDX-License-Identifier: MIT
// The four workspaces, in the order of their buttons.
#pragma once

#include <memory>
#include <vector>

#include "shell/workspace.h"

namespace flg::studio {

std::unique_ptr<Workspace> make_strokes(AppContext& app);
std::unique_ptr<Workspace> make_tangles(AppContext& app);
std::unique_ptr<Workspace> make_skeletons(AppContext& app);
std::unique_ptr<Workspace> make_splines(AppContext& app);

std::vector<std::unique_ptr<Workspace>> make_workspaces(AppContext& app);

}  // namespace flg::studio
