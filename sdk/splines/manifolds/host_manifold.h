// SPDX-License-Identifier: MIT
// Manifolds of the host's own, through structs of functions. What these give must be finite: else the job fails, and
// says where.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "filigree/filigree_spline.h"
#include "splines/manifolds/parametric_patch.h"

namespace flg {

class HostManifold final : public Manifold {
public:
    explicit HostManifold(const FlgManifoldFunctions& functions)
        : Manifold(functions.ambient, functions.dimension, functions.memory_size, functions.size),
          functions_(functions) {}

    bool project(double* x, double* hint) const override {
        double from[max_ambient];
        std::copy_n(x, ambient(), from);
        const bool found = functions_.project(functions_.user_data, x, hint) != 0;
        if (found) require_finite("project", x, ambient(), from);
        return found;
    }
    void tangent_basis(const double* x, double* hint, double* basis) const override {
        functions_.tangent_basis(functions_.user_data, x, hint, basis);
        require_finite("tangent_basis", basis, ambient() * dimension(), x);
    }
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override {
        if (!functions_.second_form) return Manifold::second_form(x, hint, basis, force, form);
        functions_.second_form(functions_.user_data, x, hint, basis, force, form);
        require_finite("second_form", form, dimension() * dimension(), x);
    }

private:
    void require_finite(const char* function, const double* values, uint32_t count, const double* at) const {
        const double* const bad = std::find_if(values, values + count, [](double v) { return !std::isfinite(v); });
        if (bad == values + count) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.%s gives %g near the point (%.9g, %.9g%s", function, *bad,
                      at[0], at[1], ambient() == 2 ? ")" : ", ...)");
    }

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
        for (const double value : out) {
            if (std::isfinite(value)) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.evaluate gives %g at u = %.9g, v = %.9g", value, u, v);
        }
        return {load(out), load(out + 3), load(out + 6), load(out + 9), load(out + 12), load(out + 15)};
    }

private:
    static Vec3 load(const double* p) { return {p[0], p[1], p[2]}; }

    FlgPatchFunctions functions_;
};

}  // namespace flg
