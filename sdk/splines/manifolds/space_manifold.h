// SPDX-License-Identifier: MIT
// R^n as a manifold: nothing restricts a curve. Its splines are the classical ones.
#pragma once

#include <algorithm>

#include "splines/manifolds/manifold.h"

namespace flg {

class SpaceManifold final : public Manifold {
public:
    SpaceManifold(uint32_t dimension, double size) : Manifold(dimension, dimension, 0, size) {}

    bool project(double*, double*) const override { return true; }
    void tangent_basis(const double*, double*, double* basis) const override {
        std::fill_n(basis, ambient() * ambient(), 0.0);
        for (uint32_t i = 0; i < ambient(); ++i) basis[i * ambient() + i] = 1;
    }
    void second_form(const double*, double*, const double*, const double*, double* form) const override {
        std::fill_n(form, ambient() * ambient(), 0.0);
    }
};

}  // namespace flg
