// SPDX-License-Identifier: MIT
#include "splines/manifold_jobs.h"

#include "core/failure.h"
#include "splines/cloud_samples.h"
#include "splines/mesh_samples.h"
#include "surfaces/mesh_measures_components.h"

namespace flg {

namespace {

// About 10 us each.
constexpr uint32_t sample_chunk = 50;
constexpr uint32_t component_chunk = 1000;
constexpr uint32_t cloud_chunk = 4;
constexpr uint32_t grid_chunk = 150;

template <class T>
std::shared_ptr<const Manifold> keep(T manifold, Memory* memory) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(memory), std::move(manifold));
}

}  // namespace

Task<void> make_mesh_manifold(Pace& pace, std::shared_ptr<HeldManifold> out) {
    pace.stage("samples");
    if (out->surface->mesh().triangles.size() == 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.surface has no triangles");
    ComponentsKernel components(out->surface->mesh(), pace.memory());
    while (!components.run(component_chunk)) co_await pace;
    if (components.component_count() > 1) out->components = components.take();
    MeshSamplesKernel kernel(out->surface->mesh(), pace.memory());
    while (!kernel.run(sample_chunk)) co_await pace;
    out->largest_deviation = kernel.deviation().largest;
    out->mean_deviation = kernel.deviation().mean;
    out->manifold = keep(kernel.take(), pace.memory());
}

Task<void> make_cloud_manifold(Pace& pace, Buffer<Position> points, Buffer<Position> normals, uint32_t neighbours,
                               std::shared_ptr<HeldManifold> out) {
    pace.stage("samples");
    const CloudInput input{.points = points.data(),
                           .normals = normals.data(),
                           .count = static_cast<uint32_t>(points.size()),
                           .neighbours = neighbours};
    CloudSamplesKernel kernel(input, pace.memory());
    while (!kernel.run(cloud_chunk)) co_await pace;
    out->largest_deviation = kernel.deviation().largest;
    out->mean_deviation = kernel.deviation().mean;
    out->manifold = keep(kernel.take(), pace.memory());
}

Task<void> make_grid_manifold(Pace& pace, Buffer<float> values, GridInput input, std::shared_ptr<HeldManifold> out) {
    pace.stage("filter");
    input.values = values.data();
    DistanceGridKernel kernel(input, pace.memory());
    while (!kernel.run(grid_chunk)) co_await pace;
    out->manifold = keep(kernel.take(), pace.memory());
}

}  // namespace flg
