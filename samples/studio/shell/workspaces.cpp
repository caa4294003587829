// SPDX-License-Identifier: MIT
#include "workspaces.h"

namespace flg::studio {

std::vector<std::unique_ptr<Workspace>> make_workspaces(Desk& desk) {
    std::vector<std::unique_ptr<Workspace>> all;
    all.push_back(make_strokes(desk));
    all.push_back(make_tangles(desk));
    all.push_back(make_skeletons(desk));
    all.push_back(make_splines(desk));
    return all;
}

}  // namespace flg::studio
