// SPDX-License-Identifier: MIT
// Meshes for measurements: made here, so that no file is needed.
#pragma once

#include <cstdint>
#include <vector>

#include "filigree/filigree_surface.h"

namespace flg::bench {

struct MeshArrays {
    std::vector<float> positions;
    std::vector<uint32_t> triangles;

    // Of the arrays and of `column`, which must outlive it.
    FlgMeshView view(FlgColumn& column) const;
};

// A torus with bumps, of about so many triangles, numbered as scanners do: coherent, not sorted.
MeshArrays bumpy_torus(uint32_t triangle_count);

// The torus of radii 1 and 0.4, with waves of this height (metres), in rows.
MeshArrays wavy_torus(uint32_t triangle_count, double height);

// A square metre of ground: heights of 15 cm at the largest, halved with each octave down to single cells.
MeshArrays rough_ground(uint32_t triangle_count);

// Moves each coordinate by up to half of `share` of the mean edge, to either side.
void add_noise(MeshArrays& mesh, double share);

}  // namespace flg::bench
