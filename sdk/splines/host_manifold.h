// SPDX-License-Identifier: MIT
// A manifold whose points the host knows, through a struct of functions.
#pragma once

#include "filigree/filigree_spline.h"
#include "splines/manifold.h"

namespace flg {

class HostManifold final : public Manifold {
public:
    explicit HostManifold(const FlgManifoldFunctions& functions)
        : Manifold(functions.ambient, functions.dimension, functions.memory_size, functions.size),
          functions_(functions) {}

    bool project(double* x, double* memory) const override {
        return functions_.project(functions_.user_data, x, memory) != 0;
    }
    void tangent_basis(const double* x, double* memory, double* basis) const override {
        functions_.tangent_basis(functions_.user_data, x, memory, basis);
    }
    void second_form(const double* x, double* memory, const double* basis, const double* force,
                     double* form) const override {
        if (!functions_.second_form) return Manifold::second_form(x, memory, basis, force, form);
        functions_.second_form(functions_.user_data, x, memory, basis, force, form);
    }

private:
    FlgManifoldFunctions functions_;
};

}  // namespace flg
