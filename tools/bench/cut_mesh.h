// SPDX-License-Identifier: MIT
// A surface of the bench's mesh that is cut along isolines of the distance from its first vertex.
#pragma once

#include <vector>

#include "bench/host.h"
#include "bench/meshes.h"
#include "bench/pool.h"

namespace flg::bench {

class CutMesh {
public:
    explicit CutMesh(uint32_t triangle_count);

    // Makes the surface anew, not cut.
    void reset();
    // At `count` levels, evenly spaced.
    struct Times {
        double cut_ms, update_ms, max_slice_us;
    };
    Times cut_isolines(uint32_t count);

    FlgSurfaceView view();
    // Triangles changed since reset.
    std::vector<uint32_t> changes();

private:
    FlgField measure();

    Pool pool_;
    Host host_;
    MeshArrays mesh_;
    FlgSurface surface_{};
};

}  // namespace flg::bench
