// SPDX-License-Identifier: MIT
#include "splines/manifold_jobs.h"

#include "core/failure.h"
#include "splines/manifolds/cloud_samples.h"
#include "splines/manifolds/mesh_samples.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

template <class T>
std::shared_ptr<const Manifold> keep(T manifold, Memory* memory) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(memory), std::move(manifold));
}

}  // namespace

Task<void> make_mesh_manifold(Pace& pace, double smoothing_scale, std::shared_ptr<ManifoldProduct> out) {
    pace.stage("samples");
    if (out->surface->mesh().triangles.size() == 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.surface has no triangles");
    MeshComponents components = co_await find_components(pace, out->surface->mesh());
    if (components.count > 1) out->components = std::move(components.of_vertex);
    out->nearest.emplace(out->surface->mesh());
    co_await build(pace, *out->nearest);
    out->nearest_triangles = out->surface->mesh().triangle_count();
    SampledSurface sampled = co_await sample_mesh(pace, out->surface->mesh(), smoothing_scale);
    out->largest_deviation = sampled.deviation.largest;
    out->mean_deviation = sampled.deviation.mean();
    out->border = co_await mesh_border(pace, out->surface->mesh(), out->largest_deviation);
    out->manifold = keep(std::move(sampled.surface), pace.memory());
}

Task<void> make_cloud_manifold(Pace& pace, Buffer<Position> points, Buffer<Position> normals,
                               FlgManifoldFromPointsDesc desc, std::shared_ptr<ManifoldProduct> out) {
    pace.stage("samples");
    const std::span<const Position> places(points.data(), points.size()), normal_list(normals.data(), normals.size());
    const CloudOptions options{.neighbours = desc.neighbours, .smoothing_scale = desc.smoothing_scale};
    SampledSurface sampled = co_await sample_cloud(pace, places, normal_list, options);
    out->largest_deviation = sampled.deviation.largest;
    out->mean_deviation = sampled.deviation.mean();
    out->manifold = keep(std::move(sampled.surface), pace.memory());
}

Task<void> make_grid_manifold(Pace& pace, Buffer<float> values, GridInput input, std::shared_ptr<ManifoldProduct> out) {
    pace.stage("filter");
    input.values = values.data();
    DistanceGrid grid = co_await interpolate(pace, input);
    out->manifold = keep(std::move(grid), pace.memory());
}

}  // namespace flg
