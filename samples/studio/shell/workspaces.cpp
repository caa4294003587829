// SPDX-License-Identifier: MIT
#include "workspaces.h"

namespace flg::studio {

std::vector<std::unique_ptr<Workspace>> make_workspaces(AppContext& app) {
    std::vector<std::unique_ptr<Workspace>> all;
    all.push_back(make_strokes(app));
    all.push_back(make_tangles(app));
    all.push_back(make_skeletons(app));
    all.push_back(make_splines(app));
    return all;
}

}  // namespace flg::studio
