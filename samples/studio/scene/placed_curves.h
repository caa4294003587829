// SPDX-License-Identifier: MIT
// Curves of a mesh's own space, as the mesh's placement puts them into the world.
#pragma once

#include <vector>

#include "filigree/filigree.h"
#include "filigree_renderer/placement.h"

namespace flg::studio {

class PlacedCurves {
public:
    // The curves outlive it.
    PlacedCurves(const FlgCurveSetView& own, const render::Placement& placement);
    PlacedCurves(const PlacedCurves&) = delete;
    PlacedCurves& operator=(const PlacedCurves&) = delete;
    // POSITION, and NORMAL, RADIUS where there are; all columns, if they stay where they are.
    const FlgCurveSetView& view() const { return view_; }

private:
    FlgCurveSetView view_;
    std::vector<float> positions_, normals_, radii_;
    std::vector<FlgColumn> columns_;
};

}  // namespace flg::studio
