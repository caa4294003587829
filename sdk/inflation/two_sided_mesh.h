// SPDX-License-Identifier: MIT
// The surface of a part: its triangulation twice, lifted to both sides of its plane, with the border in common. Closed, and a
// manifold because the triangulation has no chords; outside is where triangles turn counter-clockwise. A part with h holes
// has genus h.
#pragma once

#include <memory>

#include "core/vec.h"
#include "inflation/inflated_part.h"

namespace flg {

struct PartSurface {
    Buffer<Vec3>
        positions;  // in the part's plane, z = height; first the vertices of the part, then those inside once more
    Buffer<TriangleVertices> triangles;
};

class TwoSidedMesh {
public:
    // Of a part with heights. Both outlive the kernel.
    TwoSidedMesh(const InflatedPart& part, PartSurface& out, Memory* memory);

    // A unit is about 0.1 us: 16 vertices or triangles.
    bool run(uint32_t count);

private:
    enum class Pass { number, place, join, done };

    const InflatedPart& part_;
    PartSurface& out_;
    Memory* memory_;
    Buffer<uint32_t> below_;  // by vertex, that of the other side
    uint32_t count_ = 0;
    Pass pass_ = Pass::number;
    uint32_t at_ = 0;
};

}  // namespace flg
