// SPDX-License-Identifier: MIT
// Chooses what of a set of curves is drawn in a view: chunks in sight, each with the coarsest stride and the fewest sides
// that don't show. Equal choices are gathered into bins, one draw call each.
#pragma once

#include <vector>

#include "curve_data.h"
#include "view_uniforms.h"

namespace flg::render {

enum class Part : uint32_t { body = 0, begin_cap = 1, end_cap = 2 };

constexpr uint32_t cap_rings = 4;             // of a round cap, minus one
constexpr uint32_t instance_chunk_bits = 28;  // an instance: chunk, log2 of the stride above; mirrors curve.vert

struct DrawBin {
    uint32_t columns;   // vertices a ring: a tube's sides, 2 for bands
    uint32_t segments;  // drawn, all of a bin the same; shorter chunks repeat their last ring
    Part part;
    uint32_t first_instance;
    uint32_t instance_count;
};

class ChunkSelector {
public:
    explicit ChunkSelector(const ViewUniforms& view);
    // Appends to both.
    void select(const CurveData& curves, const CurveLook& look, float magnitude_offset,
                std::vector<uint32_t>& instances, std::vector<DrawBin>& bins);

private:
    bool in_sight(const ChunkBounds& bounds) const;
    float pixels_per_metre(const ChunkBounds& bounds) const;

    glm::vec4 planes_[4];  // xyz unit, inwards
    glm::vec3 eye_;
    float pixel_m_;
    bool perspective_;
    std::vector<uint64_t> keyed_;  // bin and instance, sorted: scratch
};

}  // namespace flg::render
