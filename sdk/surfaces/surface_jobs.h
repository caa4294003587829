// SPDX-License-Identifier: MIT
// The jobs that make surfaces.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/repair/mesh_refine.h"
#include "surfaces/surface.h"

namespace flg {

// A host's arrays, copied and packed.
struct MeshInput {
    explicit MeshInput(Memory* memory) : columns(memory), values(memory) {}

    FlgMeshView view{};  // of the arrays below
    std::pmr::vector<FlgColumn> columns;
    std::pmr::vector<Buffer<float>> values;
    Buffer<uint32_t> triangles;
    Buffer<uint32_t> regions;
};

// The whole of flgSurfaceCreate. A weld distance below 0: none are joined.
// `with_provenance`: what it is made of can be asked ever after.
Task<void> make_surface(Pace& pace, std::shared_ptr<Surface> surface, std::shared_ptr<MeshInput> input,
                        float weld_distance, bool with_provenance);

// The whole of flgSurfaceRefine.
Task<void> refine_surface(Pace& pace, std::shared_ptr<const Surface> coarse, std::shared_ptr<Surface> fine,
                          RefineRule rule, uint32_t levels);

}  // namespace flg
