// SPDX-License-Identifier: MIT
// Embeds curves into the mesh: sec. 4.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021) (all triangles that a polyline
// crosses are split), for any number of curves at once. They may cross, touch and meet, pass through vertices, run
// along edges, begin and end within a triangle.
//
// Invariants
// - Afterwards each curve is a chain of edges. Curves share a vertex where they cross.
// - Points move by no more than cut_tolerance: of an edge's length to its ends and to each other, of a triangle's
//   height to its edges. Segments that pass a vertex so near go through it; where dozens of them crowd in one triangle,
//   a curve may stray by a few tolerances.
// - Each triangle is divided by itself (cut_triangulation.h): edges are given their points first, so neighbours agree.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/mesh_growth.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// Curve c runs through vertices offsets[c] to offsets[c + 1] - 1, joined by edges; a closed one from the last to the
// first, which is not repeated. A curve that was smaller than the tolerance may be a single vertex.
struct EmbeddedCurves {
    explicit EmbeddedCurves(Memory* memory) : vertices(memory), offsets(memory), edges(memory) { offsets.push_back(0); }

    std::pmr::deque<uint32_t> vertices;
    std::pmr::deque<uint32_t> offsets;
    std::pmr::deque<Corner> edges;  // all edges of the curves, each as one of its two corners or as both
};

// `edit` is a new one; if this throws for want of memory, it takes back what was changed. Throws before any change if
// a point is outside of its triangle, or a stretch not within one triangle. The job is committed from the first change
// on. 0.2 us for 64 triangles, a point or a cut triangle, several times, and for a segment within a triangle; where
// hundreds of segments meet in one triangle, each takes more with their number. Memory while it runs: 16 bytes for 64
// triangles, 36 bytes a point of the curves, about 300 bytes a cut triangle.
Task<void> embed_curves(Pace& pace, Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit,
                        EmbeddedCurves& out);

}  // namespace flg
