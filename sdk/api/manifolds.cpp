// SPDX-License-Identifier: MIT
// Manifolds: made, shown, projected onto, released.
#include "api/manifolds.h"

#include <cmath>

#include "api/descriptors.h"
#include "splines/manifolds/image_manifold.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/manifolds/space_manifold.h"

namespace flg {

namespace {

constexpr uint32_t max_projected = 64;

FlgManifoldShapeDesc default_shape_desc() {
    auto desc = sized<FlgManifoldShapeDesc>();
    desc.ambient = 3;
    desc.radius = 1;
    desc.tube_radius = 0.25;
    desc.size = 1;
    return desc;
}

template <class T, class... Arguments>
std::shared_ptr<const Manifold> make_manifold(Context& context, Arguments&&... arguments) {
    return make_object<T>(context.memory[MemoryKind::surfaces], std::forward<Arguments>(arguments)...);
}

std::shared_ptr<const Manifold> make_shape(Context& context, const FlgManifoldShapeDesc& desc) {
    check_enum(desc.shape, FLG_MANIFOLD_SHAPE_SPACE, FLG_MANIFOLD_SHAPE_FORMULA, "desc.shape", "FLG_MANIFOLD_SHAPE_");
    if (desc.shape == FLG_MANIFOLD_SHAPE_SPACE) {
        check_range(desc.ambient >= 2 && desc.ambient <= Manifold::max_ambient, "desc.ambient", desc.ambient,
                    "2 to 12");
        check_length(desc.size, "desc.size");
        return make_manifold<SpaceManifold>(context, desc.ambient, desc.size);
    }
    if (desc.shape == FLG_MANIFOLD_SHAPE_PLANE) {
        check_length(desc.size, "desc.size");
        return make_manifold<PlaneSurface>(context, desc.size);
    }
    if (desc.shape == FLG_MANIFOLD_SHAPE_FORMULA) {
        const ImplicitFormula* const formula = find_implicit_formula(&require(desc.name, "desc.name"));
        if (!formula)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.name is \"%.60s\", which is no formula's name", desc.name);
        return make_manifold<NamedSurface>(context, *formula);
    }
    check_length(desc.radius, "desc.radius");
    if (desc.shape == FLG_MANIFOLD_SHAPE_SPHERE) return make_manifold<SphereSurface>(context, desc.radius);
    check_range(desc.tube_radius >= smallest_length && desc.tube_radius < desc.radius, "desc.tube_radius",
                desc.tube_radius, "1e-6 to below desc.radius");
    return make_manifold<TorusSurface>(context, desc.radius, desc.tube_radius);
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgManifoldShapeDescInit(FlgManifoldShapeDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_shape_desc());
}

FlgResult flgManifoldCreateShape(FlgContext context, const FlgManifoldShapeDesc* desc, FlgManifold* out_manifold) {
    return guarded([&] {
        Context& self = clear_output(context, out_manifold, "out_manifold");
        const FlgManifoldShapeDesc read = read_struct(desc, default_shape_desc(), "desc");
        const auto held = self.make(self.manifolds);
        held->manifold = make_shape(self, read);
        held->origin = read_origin(read.origin, "desc.origin");
        if (read.shape == FLG_MANIFOLD_SHAPE_SPACE) {
            for (const double coordinate : held->origin) {
                check_range(coordinate == 0, "desc.origin", coordinate,
                            "0 for FLG_MANIFOLD_SHAPE_SPACE, which is everywhere");
            }
        }
        held->kind = read.shape == FLG_MANIFOLD_SHAPE_SPACE ? ManifoldKind::space : ManifoldKind::hypersurface;
        *out_manifold = publish_at_once(self, held);
    });
}

FlgResult flgManifoldCreateImage(FlgContext context, FlgManifold base, double weight, FlgManifold* out_manifold) {
    return guarded([&] {
        Context& self = clear_output(context, out_manifold, "out_manifold");
        const auto surface = self.manifolds.get(base.id, "base");
        const FlgResult result = visible_result_now(*surface);
        if (result != FLG_OK) return result;
        if (surface->kind != ManifoldKind::hypersurface)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "base is not a surface in R^3");
        check_range(weight > 0 && weight <= largest_length, "weight", weight, "above 0, at most 1e6");
        const auto held = self.make(self.manifolds);
        held->base = surface;
        held->origin = surface->origin;
        held->manifold =
            make_manifold<ImageManifold>(self, static_cast<const Hypersurface&>(*surface->manifold), weight);
        held->given_ambient = 3;
        held->largest_deviation = surface->largest_deviation;
        held->mean_deviation = surface->mean_deviation;
        held->publish_complete();
        *out_manifold = {self.manifolds.add(held)};
        return FLG_OK;
    });
}

const char* flgFormulaGetName(uint32_t number) {
    return number < implicit_formulas().size() ? implicit_formulas()[number].name : nullptr;
}

FlgResult flgManifoldViewInit(FlgManifoldView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgManifoldGetView(FlgContext context, FlgManifold manifold, FlgManifoldView* out_view) {
    return get_view(out_view, [&] { return get_context(context).manifolds.get(manifold.id, "manifold"); });
}

FlgResult flgManifoldProject(FlgContext context, FlgManifold manifold, double* points, uint32_t point_count,
                             double* out_distances) {
    return guarded([&] {
        Context& self = get_context(context);
        const ManifoldProduct& held = *self.manifolds.get(manifold.id, "manifold");
        const FlgResult result = visible_result_now(held);
        if (result != FLG_OK) return result;
        check_range(point_count <= max_projected, "point_count", point_count, "at most 64");
        if (point_count > 0) require(points, "points");
        const uint32_t shown = held.given_ambient, n = held.manifold->ambient();
        double memory[Manifold::max_hint];
        for (uint32_t i = 0; i < point_count; ++i) {
            double* const given = points + size_t{i} * shown;
            double x[Manifold::max_ambient] = {};
            for (uint32_t c = 0; c < shown; ++c) {
                check_range(std::abs(given[c]) <= 1e30, "a coordinate in points", given[c],
                            "finite and at most 1e30 in size");
                x[c] = given[c];
            }
            std::fill_n(x + shown, n - shown, 0.0);
            std::fill_n(memory, held.manifold->hint_size(), 0.0);
            double square = HUGE_VAL;
            if (held.manifold->project(x, memory)) {
                square = 0;
                for (uint32_t c = 0; c < shown; ++c) square += (x[c] - given[c]) * (x[c] - given[c]);
                std::copy_n(x, shown, given);
            }
            if (out_distances) out_distances[i] = std::sqrt(square);
        }
        return FLG_OK;
    });
}

FlgResult flgManifoldRelease(FlgContext context, FlgManifold manifold) {
    return release(context, &Context::manifolds, manifold, "manifold");
}

}  // extern "C"
