// SPDX-License-Identifier: MIT
// The triangulation that a part is inflated on. The contour is thinned and divided to even edges, its inside is filled
// with a lattice of equal triangles that keeps off the border, and what is then still badly shaped gets points at the
// centres of circumcircles, or on the border where those fall beyond it (Ruppert: A Delaunay refinement algorithm for
// quality 2-dimensional mesh generation, 1995; Chew: Guaranteed-quality mesh generation for curved surfaces, 1993).
//
// Invariants
// - Each side inside has an end inside (no chord): so that no piece of the part stays flat, and so that two copies with
//   a common border make a closed manifold.
// - Angles are at least 25 degrees, but at corners of the contour that are sharper, next to edges that are at the least
//   length, and where the rule above forbids a flip. On smooth contours: at least 22 degrees, in the mean of triangles
//   50.
#pragma once

#include "inflation/inflate_part.h"

namespace flg {

// Reads the part's contour, from clean_contour; fills points, on_border, triangles, spacing, area and thickness. The
// part outlives the task. Takes about 3 us and 500 bytes a vertex, and a byte a lattice place of the contour's box (at
// most a million). Throws, with a sentence, if the contour is not simple.
Task<void> part_mesh(Pace& pace, InflationOptions options, InflatedPart& part);

}  // namespace flg
