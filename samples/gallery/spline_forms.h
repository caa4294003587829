// SPDX-License-Identifier: MIT
// What splines of the gallery lie on and keep out of, as manifolds and as meshes to be seen.
#pragma once

#include <functional>

#include "gallery/forms.h"
#include "gallery/spline_stage.h"

namespace flg::gallery {

// Points over [0, 1]^2, which may come back to where they began in u. Sees outwards where u x v does.
scenes::Mesh sheet(uint32_t columns, uint32_t rows, bool around,
                   const std::function<glm::dvec3(double u, double v)>& place);

// A solid that is negative inside, sampled over a cube about the origin.
struct Solid {
    filigree::Manifold manifold;  // of the samples
    filigree::Surface surface;    // one vertex a cell that the surface goes through, on the manifold
};
Solid solid(Workshop& workshop, double half_side, uint32_t cells,
            const std::function<double(const glm::dvec3& p)>& value);

// A box and a round post, standing on y = 0, with the corners and edges that they are drawn with.
scenes::Mesh box_mesh(const glm::dvec3& centre, const glm::dvec3& half);
scenes::Mesh capsule_mesh(const glm::dvec3& from, const glm::dvec3& to, double radius);

}  // namespace flg::gallery
