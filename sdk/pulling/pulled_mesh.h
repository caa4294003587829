// SPDX-License-Identifier: MIT
// What hosts hold to pull at meshes, and the jobs that make it. Vertices of one place are one here, and the host's
// again in what it is shown.
#pragma once

#include <vector>

#include "core/origin.h"
#include "filigree/filigree_pull.h"
#include "pulling/pulling.h"
#include "runtime/product.h"
#include "surfaces/surface_jobs.h"

namespace flg {

class HeldPull final : public Product {
public:
    explicit HeldPull(Memory* memory) : repaired(memory), rest(memory) {}

    Origin origin{};
    std::shared_ptr<const MeshInput> mesh;  // until the job is done its arrays are read
    RepairOptions repair;

    uint32_t vertex_count = 0;  // the host's, from the beginning
    RepairedMesh repaired;
    std::pmr::vector<float> rest;  // 3 per vertex of the host
    PullSystem system;

    size_t rest_count() const { return size_t{3} * vertex_count; }
    // The vertex of the repaired mesh; no_index: no triangle has it.
    uint32_t welded(uint32_t vertex) const {
        return repaired.vertices.of_input.empty() ? vertex : repaired.vertices.of_input[vertex];
    }
};

// The whole of flgPullCreate.
Task<void> make_pull(Pace& pace, std::shared_ptr<HeldPull> pull);

class HeldPulled final : public Product {
public:
    explicit HeldPulled(Memory* memory) : handles(memory), state(memory) {}

    std::shared_ptr<const HeldPull> pull;
    std::shared_ptr<const HeldPulled> previous;  // until the job is done
    std::pmr::vector<FlgPullHandle> handles;
    Buffer<float> pose;  // the host's; empty: at rest
    uint32_t rounds = 0;

    PulledState state;
    Buffer<float> positions;

    const FlgPulledView& view() const { return view_; }

private:
    void show() noexcept override;

    FlgPulledView view_{};
};

// The whole of flgPulledCreate.
Task<void> make_pulled(Pace& pace, std::shared_ptr<HeldPulled> pulled);

}  // namespace flg
