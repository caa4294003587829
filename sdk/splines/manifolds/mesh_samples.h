// SPDX-License-Identifier: MIT
// The smooth surface of a triangle mesh: samples at its vertices, with normals and curvatures fitted to the neighbours,
// and more samples along edges and in triangles where they are long compared to how the surface bends, or beside sharp
// edges. Creases are rounded, by about the distance of samples there: a 24th of the mesh's size, or what its edges are
// long if that is less. Open borders go on a little, about half an edge.
#pragma once

#include "splines/manifolds/sampled_surface.h"

namespace flg {

// The mesh, with one triangle at least, does not change meanwhile. A Failure says if there are not samples enough.
// `smoothing_scale`: metres, that smoothed_samples() see it through, or 0. About 2 us a vertex.
Task<SampledSurface> sample_mesh(Pace& pace, const Mesh& mesh, double smoothing_scale = 0);

}  // namespace flg
