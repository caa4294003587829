// SPDX-License-Identifier: MIT
// Manifolds of the host's own, through structs of functions.
#pragma once

#include "filigree/filigree_spline.h"
#include "splines/manifolds/parametric_patch.h"

namespace flg {

class HostManifold final : public Manifold {
public:
    explicit HostManifold(const FlgManifoldFunctions& functions)
        : Manifold(functions.ambient, functions.dimension, functions.memory_size, functions.size),
          functions_(functions) {}

    bool project(double* x, double* hint) const override {
        return functions_.project(functions_.user_data, x, hint) != 0;
    }
    void tangent_basis(const double* x, double* hint, double* basis) const override {
        functions_.tangent_basis(functions_.user_data, x, hint, basis);
    }
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override {
        if (!functions_.second_form) return Manifold::second_form(x, hint, basis, force, form);
        functions_.second_form(functions_.user_data, x, hint, basis, force, form);
    }

private:
    FlgManifoldFunctions functions_;
};

class HostPatch final : public ParametricPatch {
public:
    HostPatch(const FlgPatchFunctions& functions, Memory* memory)
        : ParametricPatch({.low = {functions.low[0], functions.low[1]},
                           .high = {functions.high[0], functions.high[1]},
                           .periodic = {functions.periodic[0] != 0, functions.periodic[1] != 0},
                           .margin = functions.margin},
                          functions.size, memory),
          functions_(functions) {
        prepare();
    }

    PatchPoint evaluate(double u, double v) const override {
        double out[18];
        functions_.evaluate(functions_.user_data, u, v, out);
        return {load(out), load(out + 3), load(out + 6), load(out + 9), load(out + 12), load(out + 15)};
    }

private:
    static Vec3 load(const double* p) { return {p[0], p[1], p[2]}; }

    FlgPatchFunctions functions_;
};

}  // namespace flg
