// SPDX-License-Identifier: MIT
#include "splines/manifold_jobs.h"

#include "core/failure.h"
#include "splines/mesh_samples.h"

namespace flg {

namespace {

constexpr uint32_t sample_chunk = 100;  // 10 us

template <class T>
std::shared_ptr<const Manifold> keep(T&& manifold, Memory* memory) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(memory), std::move(manifold));
}

}  // namespace

Task<void> make_mesh_manifold(Pace& pace, std::shared_ptr<HeldManifold> out) {
    pace.stage("samples");
    if (out->surface->mesh().triangles.size() == 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.surface has no triangles");
    MeshSamplesKernel kernel(out->surface->mesh(), pace.memory());
    while (!kernel.run(sample_chunk)) co_await pace;
    out->largest_deviation = kernel.deviation().largest;
    out->mean_deviation = kernel.deviation().mean;
    out->manifold = keep(kernel.take(), pace.memory());
}

}  // namespace flg
