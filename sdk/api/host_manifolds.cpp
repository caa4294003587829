// SPDX-License-Identifier: MIT
// Manifolds of the host's own: structs of functions, checked as far as one point tells.
#include "api/manifolds.h"

#include <cmath>

#include "api/descriptors.h"
#include "splines/manifolds/host_manifold.h"

namespace flg {

namespace {

FlgManifoldFunctions default_functions() {
    auto functions = sized<FlgManifoldFunctions>();
    functions.ambient = 3;
    functions.dimension = 2;
    functions.size = 1;
    return functions;
}

FlgPatchFunctions default_patch() {
    auto functions = sized<FlgPatchFunctions>();
    functions.high[0] = functions.high[1] = 1;
    functions.margin = 0.05;
    functions.size = 1;
    return functions;
}

void check_patch(const FlgPatchFunctions& functions) {
    if (!functions.evaluate) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.evaluate is null");
    check_length(functions.size, "functions.size");
    check_range(functions.margin >= 0 && functions.margin <= 1, "functions.margin", functions.margin, "0 to 1");
    for (int p = 0; p < 2; ++p) {
        const double low = functions.low[p], high = functions.high[p];
        check_range(std::abs(low) <= 1e30, "functions.low", low, "finite and at most 1e30 in size");
        check_range(high > low && high <= 1e30, "functions.high", high, "above functions.low, at most 1e30");
    }
}

// The middle of the domain stands for all of it.
void try_patch(const HostPatch& patch) {
    const PatchDomain& domain = patch.domain();
    const PatchPoint at =
        patch.evaluate(0.5 * (domain.low[0] + domain.high[0]), 0.5 * (domain.low[1] + domain.high[1]));
    for (const Vec3& part : {at.at, at.u, at.v, at.uu, at.uv, at.vv}) {
        if (!part.allFinite())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.evaluate gives numbers that are not finite");
    }
    if (!(at.u.cross(at.v).norm() > 1e-9 * at.u.norm() * at.v.norm())) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.evaluate gives derivatives u and v that are parallel");
    }
}

// What the functions say at a point must hold together; else optimization would go astray without a word.
void try_functions(const HostManifold& manifold, const double* point_near) {
    const uint32_t n = manifold.ambient(), k = manifold.dimension();
    double x[Manifold::max_ambient], basis[Manifold::max_ambient * Manifold::max_dimension] = {},
                                                                   memory[Manifold::max_hint] = {};
    std::copy_n(point_near, n, x);
    for (uint32_t c = 0; c < n; ++c) check_range(std::isfinite(x[c]), "point_near", x[c], "finite");
    if (!manifold.project(x, memory))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.project finds no point near point_near");
    for (uint32_t c = 0; c < n; ++c) check_range(std::isfinite(x[c]), "what functions.project gives", x[c], "finite");
    manifold.tangent_basis(x, memory, basis);
    for (uint32_t a = 0; a < k; ++a) {
        for (uint32_t b = 0; b <= a; ++b) {
            double product = 0;
            for (uint32_t c = 0; c < n; ++c) product += basis[a * n + c] * basis[b * n + c];
            if (std::abs(product - (a == b ? 1 : 0)) < 1e-8) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "functions.tangent_basis: the inner product of its rows %u and %u is %s, must be %d", b, a,
                          NumberText(product).c_str(), a == b);
        }
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint32_t struct_size) {
    return init(functions, struct_size, default_functions(), "functions");
}

FlgResult flgManifoldCreateHost(FlgContext context, const FlgManifoldFunctions* functions, const double* point_near,
                                FlgManifold* out_manifold) {
    return guarded([&] {
        Context& self = clear_output(context, out_manifold, "out_manifold");
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgManifoldFunctions read = read_struct(functions, default_functions(), "functions");
        require(point_near, "point_near");
        check_range(read.ambient >= 2 && read.ambient <= Manifold::max_ambient, "functions.ambient", read.ambient,
                    "2 to 12");
        check_range(read.dimension >= 1 && read.dimension <= read.ambient, "functions.dimension", read.dimension,
                    "1 to functions.ambient");
        check_range(read.memory_size <= Manifold::max_hint, "functions.memory_size", read.memory_size, "at most 256");
        check_length(read.size, "functions.size");
        if (!read.project) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.project is null");
        if (!read.tangent_basis) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.tangent_basis is null");
        const auto manifold = make_object<HostManifold>(memory, read);
        try_functions(*manifold, point_near);
        const auto held = self.make(self.manifolds);
        held->manifold = manifold;
        held->origin = read_origin_in(read.ambient, read.origin, "functions.origin");
        *out_manifold = publish_at_once(self, held);
    });
}

FlgResult flgPatchFunctionsInit(FlgPatchFunctions* functions, uint32_t struct_size) {
    return init(functions, struct_size, default_patch(), "functions");
}

FlgResult flgManifoldCreatePatch(FlgContext context, const FlgPatchFunctions* functions, FlgManifold* out_manifold) {
    return guarded([&] {
        Context& self = clear_output(context, out_manifold, "out_manifold");
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgPatchFunctions read = read_struct(functions, default_patch(), "functions");
        check_patch(read);
        const auto patch = make_object<HostPatch>(memory, read, memory);
        try_patch(*patch);
        const auto held = self.make(self.manifolds);
        held->manifold = patch;
        held->origin = read_origin(read.origin, "functions.origin");
        *out_manifold = publish_at_once(self, held);
    });
}

}  // extern "C"
