// SPDX-License-Identifier: MIT
// Manifolds: made, shown, projected onto, released.
#include <cmath>
#include <vector>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "api/products.h"
#include "api/surface_inputs.h"
#include "splines/host_manifold.h"
#include "splines/image_manifold.h"
#include "splines/implicit_surfaces.h"
#include "splines/manifold_jobs.h"
#include "splines/space_manifold.h"

namespace flg {

namespace {

constexpr uint32_t most_projected = 64;
constexpr uint32_t most_memory = 256;
constexpr double smallest_length = 1e-6, largest_length = 1e6;  // m

void check_length(double value, const char* argument) {
    check_range(value >= smallest_length && value <= largest_length, argument, value, "1e-6 to 1e6");
}

FlgShapeDesc default_shape_desc() {
    FlgShapeDesc desc{};
    desc.struct_size = sizeof desc;
    desc.ambient = 3;
    desc.radius = 1;
    desc.tube_radius = 0.25;
    desc.size = 1;
    return desc;
}

FlgMeshManifoldDesc default_mesh_desc() {
    FlgMeshManifoldDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    return desc;
}

FlgCloudManifoldDesc default_cloud_desc() {
    FlgCloudManifoldDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.neighbours = 16;
    return desc;
}

FlgGridManifoldDesc default_grid_desc() {
    FlgGridManifoldDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.spacing = 1;
    return desc;
}

Buffer<Position> read_positions(const float* from, uint32_t count, const char* argument, Memory* memory) {
    Buffer<Position> out(count, memory);
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t c = 0; c < 3; ++c) {
            const float value = from[size_t{3} * i + c];
            if (is_coordinate(value)) continue;
            char name[48];
            std::snprintf(name, sizeof name, "%s[%u]", argument, 3 * i + c);
            check_range(false, name, value, "finite and at most 1e30 in size");
        }
        out[i] = {from[size_t{3} * i], from[size_t{3} * i + 1], from[size_t{3} * i + 2]};
    }
    return out;
}

GridInput read_grid(const FlgGridManifoldDesc& desc) {
    GridInput input;
    uint64_t all = 1;
    for (uint32_t c = 0; c < 3; ++c) {
        check_range(desc.counts[c] >= 2 && desc.counts[c] <= 65536, "desc.counts", desc.counts[c], "2 to 65536 each");
        check_range(std::abs(desc.origin[c]) <= 1e30, "desc.origin", desc.origin[c], "finite and at most 1e30 in size");
        input.counts[c] = desc.counts[c];
        input.origin[c] = desc.origin[c];
        all = std::min(all * desc.counts[c], uint64_t{1} << 40);
    }
    check_range(all <= uint64_t{1} << 31, "the product of desc.counts", static_cast<double>(all), "at most 2^31");
    check_length(desc.spacing, "desc.spacing");
    input.spacing = desc.spacing;
    return input;
}

FlgManifoldFunctions default_functions() {
    FlgManifoldFunctions functions{};
    functions.struct_size = sizeof functions;
    functions.ambient = 3;
    functions.dimension = 2;
    functions.size = 1;
    return functions;
}

template <class T, class... Arguments>
std::shared_ptr<const Manifold> make_manifold(Context& context, Arguments&&... arguments) {
    return make_object<T>(context, std::forward<Arguments>(arguments)...);
}

std::shared_ptr<const Manifold> make_shape(Context& context, const FlgShapeDesc& desc) {
    check_enum(desc.shape, FLG_SHAPE_SPACE, FLG_SHAPE_FORMULA, "desc.shape", "FLG_SHAPE_");
    if (desc.shape == FLG_SHAPE_SPACE) {
        check_range(desc.ambient >= 2 && desc.ambient <= Manifold::max_ambient, "desc.ambient", desc.ambient,
                    "2 to 12");
        check_length(desc.size, "desc.size");
        return make_manifold<SpaceManifold>(context, desc.ambient, desc.size);
    }
    if (desc.shape == FLG_SHAPE_PLANE) {
        check_length(desc.size, "desc.size");
        return make_manifold<PlaneSurface>(context, desc.size);
    }
    if (desc.shape == FLG_SHAPE_FORMULA) {
        const ImplicitFormula* const formula = find_implicit_formula(&require(desc.name, "desc.name"));
        if (!formula)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.name is \"%.60s\", which is no formula's name", desc.name);
        return make_manifold<NamedSurface>(context, *formula);
    }
    check_length(desc.radius, "desc.radius");
    if (desc.shape == FLG_SHAPE_SPHERE) return make_manifold<SphereSurface>(context, desc.radius);
    check_range(desc.tube_radius >= smallest_length && desc.tube_radius < desc.radius, "desc.tube_radius",
                desc.tube_radius, "1e-6 to below desc.radius");
    return make_manifold<TorusSurface>(context, desc.radius, desc.tube_radius);
}

FlgManifold publish_at_once(Context& context, const std::shared_ptr<HeldManifold>& held) {
    held->given_ambient = held->manifold->ambient();
    held->publish_complete();
    return {context.manifolds.add(held)};
}

// What the functions say at a point must hold together; else optimization would go astray without a word.
void try_functions(const HostManifold& manifold, const double* point_near) {
    const uint32_t n = manifold.ambient(), k = manifold.dimension();
    double x[Manifold::max_ambient], basis[Manifold::max_ambient * Manifold::max_dimension] = {},
                                                                   memory[most_memory] = {};
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

FlgResult flgShapeDescInit(FlgShapeDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_shape_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateShape(FlgContext context, const FlgShapeDesc* desc, FlgManifold* out_manifold) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        Context& self = get_context(context);
        refuse_after_destroy(self);
        const FlgShapeDesc read = read_struct(desc, default_shape_desc(), "desc");
        const auto held = make_object<HeldManifold>(self);
        held->manifold = make_shape(self, read);
        held->kind = read.shape == FLG_SHAPE_SPACE ? ManifoldKind::space : ManifoldKind::hypersurface;
        *out_manifold = publish_at_once(self, held);
        return FLG_OK;
    });
}

FlgResult flgMeshManifoldDescInit(FlgMeshManifoldDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_mesh_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateFromSurface(FlgContext context, const FlgMeshManifoldDesc* desc, FlgManifold* out_manifold,
                                       FlgJob* out_job) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgMeshManifoldDesc read = read_struct(desc, default_mesh_desc(), "desc");
        Submission submission(self, read.job);
        const auto held = make_object<HeldManifold>(self);
        held->kind = ManifoldKind::hypersurface;
        held->surface = self.surfaces.get(read.surface.id, "desc.surface");
        submission.read_surface(held->surface, "desc.surface");
        submission.job().strand.start(make_mesh_manifold(submission.pace(), held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
        return FLG_OK;
    });
}

FlgResult flgCloudManifoldDescInit(FlgCloudManifoldDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_cloud_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateFromPoints(FlgContext context, const FlgCloudManifoldDesc* desc, FlgManifold* out_manifold,
                                      FlgJob* out_job) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgCloudManifoldDesc read = read_struct(desc, default_cloud_desc(), "desc");
        check_range(read.point_count >= 4 && read.point_count <= 1u << 24, "desc.point_count", read.point_count,
                    "4 to 2^24");
        check_range(read.neighbours >= 6 && read.neighbours <= 32, "desc.neighbours", read.neighbours, "6 to 32");
        require(read.points, "desc.points");
        Submission submission(self, read.job);
        Buffer<Position> points = read_positions(read.points, read.point_count, "desc.points", &self.memory), normals;
        if (read.normals) normals = read_positions(read.normals, read.point_count, "desc.normals", &self.memory);
        const auto held = make_object<HeldManifold>(self);
        held->kind = ManifoldKind::hypersurface;
        submission.job().strand.start(
            make_cloud_manifold(submission.pace(), std::move(points), std::move(normals), read.neighbours, held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
        return FLG_OK;
    });
}

FlgResult flgGridManifoldDescInit(FlgGridManifoldDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_grid_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateFromGrid(FlgContext context, const FlgGridManifoldDesc* desc, FlgManifold* out_manifold,
                                    FlgJob* out_job) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgGridManifoldDesc read = read_struct(desc, default_grid_desc(), "desc");
        const GridInput input = read_grid(read);
        require(read.values, "desc.values");
        Submission submission(self, read.job);
        Buffer<float> values(size_t{input.counts[0]} * input.counts[1] * input.counts[2], &self.memory);
        for (size_t i = 0; i < values.size(); ++i) {
            check_range(is_coordinate(read.values[i]), "a value in desc.values", read.values[i],
                        "finite and at most 1e30 in size");
            values[i] = read.values[i];
        }
        const auto held = make_object<HeldManifold>(self);
        held->kind = ManifoldKind::hypersurface;
        submission.job().strand.start(make_grid_manifold(submission.pace(), std::move(values), input, held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateImage(FlgContext context, FlgManifold base, double weight, FlgManifold* out_manifold) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        Context& self = get_context(context);
        refuse_after_destroy(self);
        const auto surface = self.manifolds.get(base.id, "base");
        const FlgResult result = surface->visible_result();
        if (result != FLG_OK) return result < 0 ? set_last_error(result, surface->error()) : result;
        if (surface->kind != ManifoldKind::hypersurface)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "base is not a surface in R^3");
        check_range(weight > 0 && weight <= largest_length, "weight", weight, "above 0, at most 1e6");
        const auto held = make_object<HeldManifold>(self);
        held->base = surface;
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

const char* flgFormulaName(uint32_t number) {
    return number < implicit_formulas().size() ? implicit_formulas()[number].name : nullptr;
}

FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint32_t struct_size) {
    return guarded([&] {
        init_struct(functions, struct_size, default_functions(), "functions");
        return FLG_OK;
    });
}

FlgResult flgManifoldCreateHost(FlgContext context, const FlgManifoldFunctions* functions, const double* point_near,
                                FlgManifold* out_manifold) {
    return guarded([&] {
        require(out_manifold, "out_manifold") = {};
        Context& self = get_context(context);
        refuse_after_destroy(self);
        const FlgManifoldFunctions read = read_struct(functions, default_functions(), "functions");
        require(point_near, "point_near");
        check_range(read.ambient >= 2 && read.ambient <= Manifold::max_ambient, "functions.ambient", read.ambient,
                    "2 to 12");
        check_range(read.dimension >= 1 && read.dimension <= read.ambient, "functions.dimension", read.dimension,
                    "1 to functions.ambient");
        check_range(read.memory_size <= most_memory, "functions.memory_size", read.memory_size, "at most 256");
        check_length(read.size, "functions.size");
        if (!read.project) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.project is null");
        if (!read.tangent_basis) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "functions.tangent_basis is null");
        const auto manifold = make_object<HostManifold>(self, read);
        try_functions(*manifold, point_near);
        const auto held = make_object<HeldManifold>(self);
        held->manifold = manifold;
        *out_manifold = publish_at_once(self, held);
        return FLG_OK;
    });
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
        const HeldManifold& held = *self.manifolds.get(manifold.id, "manifold");
        const FlgResult result = held.visible_result();
        if (result != FLG_OK) return result < 0 ? set_last_error(result, held.error()) : result;
        check_range(point_count <= most_projected, "point_count", point_count, "at most 64");
        if (point_count > 0) require(points, "points");
        const uint32_t shown = held.given_ambient, n = held.manifold->ambient();
        std::pmr::vector<double> memory(held.manifold->memory_size(), 0.0, &self.memory);
        for (uint32_t i = 0; i < point_count; ++i) {
            double* const given = points + size_t{i} * shown;
            double x[Manifold::max_ambient] = {};
            for (uint32_t c = 0; c < shown; ++c) {
                check_range(std::abs(given[c]) <= 1e30, "a coordinate in points", given[c],
                            "finite and at most 1e30 in size");
                x[c] = given[c];
            }
            std::fill_n(x + shown, n - shown, 0.0);
            std::fill(memory.begin(), memory.end(), 0.0);
            double square = HUGE_VAL;
            if (held.manifold->project(x, memory.data())) {
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
    return guarded([&] {
        get_context(context).manifolds.remove(manifold.id, "manifold");
        return FLG_OK;
    });
}

}  // extern "C"
