// SPDX-License-Identifier: MIT
// Borders of regions as curves in space, and stylized by example.
#pragma once

#include <set>

#include "documents/mesh_surface.h"
#include "documents/space_lines.h"

namespace flg::cli {

struct RegionBorders {
    SpaceLines lines;           // the regions to the left; where the surface ends there is none
    std::set<uint32_t> around;  // regions on the other side
};

// Of regions together. `inside`: labels of the surface.
RegionBorders find_borders(const FlgSurfaceView& surface, const std::set<uint32_t>& inside);

// How an example is applied.
struct StrokeLook {
    std::string file;  // of the example
    double length;     // metres, on the surface, of the longest side of the example's box
    uint64_t seed;
};

// Sideways in the surface as the example is in its plane. The lines have normals. Throws InputError.
FlgCurveSet stylize_lines(Session& session, const SpaceLines& lines, const StrokeLook& look, const std::string& subject,
                          Report& report);

}  // namespace flg::cli
