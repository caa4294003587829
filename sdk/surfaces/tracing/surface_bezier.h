// SPDX-License-Identifier: MIT
// Curves of Bezier segments on a mesh, through given points (Mancinelli, Nazzaro, Pellacini, Puppo: b/Surf: Interactive
// Bezier Splines on Surface Meshes, 2022): de Casteljau's construction, halving with shortest paths in place of lines.
// Handles are those of Catmull and Rom's spline with chordal knots, along straightest geodesics from each point; the
// ends of open curves are natural; two points are joined by their shortest path.
//
// Shortest paths after the first are found from the paths that they shorten, so a curve stays on one side of whatever
// it passes, and is continuous whatever the mesh.
//
// Invariants
// - There is a curve wherever triangles join the points across edges. It has a tangent at each of its nodes, but for
//   what rounding and vertices turn.
// - Nodes lie on triangles. Every segment has 2^halvings intervals.
// - A segment depends on four points: those of its ends, and of the next ones.
#pragma once

#include <span>
#include <vector>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

struct SurfaceBezier {
    explicit SurfaceBezier(Memory* memory) : given(memory), nodes(memory) {}

    uint32_t segments() const { return static_cast<uint32_t>(given.size()) - (closed ? 0 : 1); }

    bool closed = false;
    uint32_t halvings = 0;
    std::pmr::vector<SurfacePoint> given;
    std::pmr::vector<SurfacePoint> nodes;  // segments() << halvings, and one more of open curves
};

constexpr uint32_t max_bezier_halvings = 8;

struct BezierResult {
    bool found = false;
    uint32_t without_way = 0;  // a segment between whose ends there is none, where not found
};

// `out` has the given points, at least 2, closed 3, and how it is to be made; gets its nodes. Segments that do not
// differ are copied from `before`, unless null. About 3 us a node, and 150 ns a triangle that shortest paths look at.
Task<BezierResult> make_surface_bezier(Pace& pace, const Mesh& mesh, const SurfaceBezier* before, SurfaceBezier& out);

}  // namespace flg
