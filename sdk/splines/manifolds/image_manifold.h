// SPDX-License-Identifier: MIT
// Surfaces whose normals are part of them (Hofer, Pottmann 2004, sec. 6, Fig. 17; Kimmel, Sochen, Malladi 2000): the
// points (x, weight * normal(x)) of R^6. Where a surface bends they are far apart, so that smooth curves among them
// follow features and do not cross them.
#pragma once

#include "splines/manifolds/hypersurface.h"

namespace flg {

class ImageManifold final : public Manifold {
public:
    // The surface, of R^3, outlives this. The weight, metres, >= 0, is how far apart opposite normals are, halved.
    ImageManifold(const Hypersurface& surface, double weight);

    // The point of the manifold over a point of the surface, with whose hint it was projected.
    void lift(const double* place, double* hint, double* x) const;

    // The first three coordinates are projected to the surface, and corrected once by what the other three say: near
    // the manifold that is the nearest point up to the square of the distance. About three times what the surface
    // needs.
    bool project(double* x, double* hint) const override;
    // From the surface's shape operator.
    void tangent_basis(const double* x, double* hint, double* basis) const override;

private:
    const Hypersurface& surface_;
    double weight_;
};

}  // namespace flg
