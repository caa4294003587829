// SPDX-License-Identifier: MIT
// Obstacles from a JSON file:
//
//     {"clearance": 0.1,
//      "obstacles": [{"ball": {"centre": [0, 0, 0], "radius": 1}},
//                    {"box": {"centre": [2, 0, 0], "half": [1, 1, 1], "axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}},
//                    {"capsule": {"from": [0, 0, 0], "to": [0, 0, 2], "radius": 0.5}},
//                    {"polygon": [[0, 0], [1, 0], [0, 1]]},
//                    {"mesh": "rock.obj"}],
//      "sides": [{"obstacle": 0, "direction": [0, 1, 0]}]}
//
// Metres; of the plane two numbers a place. Clearance, axes and sides may be left out. Meshes, of space, are beside the
// file.
#pragma once

#include <string>
#include <vector>

#include "documents/session.h"
#include "filigree/filigree_spline.h"
#include "spline_manifold.h"

namespace flg::cli {

struct SplineObstacles {
    FlgObstacles handle = {};
    std::vector<FlgObstacleSide> sides;
    uint32_t count = 0;
};

// Of a file, or none, and with the border of the mesh that curves stay on, if it is given. Throws InputError, with file
// and place.
SplineObstacles read_obstacles(Session& session, const std::string& file, uint32_t dimension, Report& report,
                               const FlgObstacle* border = nullptr);

// What is beyond the borders of an open mesh: of a layer around it, so thick to either side, or, with 0, of the mesh.
// Throws UsageError where SURFACE is no mesh.
FlgObstacle border_of(const SplineManifold& manifold, double thickness);

}  // namespace flg::cli
