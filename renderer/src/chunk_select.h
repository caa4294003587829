// SPDX-License-Identifier: MIT
// Chooses what of a set of curves is drawn in a view, or in several at once: chunks in sight of any, each with the
// coarsest stride and the fewest sides that show in none. Equal choices are gathered into bins, one draw call each.
#pragma once

#include <span>
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
    explicit ChunkSelector(std::span<const ViewUniforms> views);  // one or two
    // Appends to both.
    void select(const CurveData& curves, const CurveLook& look, float magnitude_offset,
                std::vector<uint32_t>& instances, std::vector<DrawBin>& bins);

private:
    struct View {
        glm::vec4 planes[4];  // xyz unit, inwards
        glm::vec3 eye;
        float pixel_m;
        bool perspective;

        bool sees(const ChunkBounds& bounds) const;
        float metres_per_pixel(const ChunkBounds& bounds) const;
    };
    // Where it is smallest; infinite: out of sight.
    float metres_per_pixel(const ChunkBounds& bounds) const;

    View views_[2];
    size_t view_count_;

    // Scratch of select(): what is drawn goes to buckets, which have numbers in the order of drawing.
    struct Choice {
        uint32_t bucket;
        uint32_t instance;
    };
    void choose(uint32_t bucket, uint32_t instance);

    std::vector<Choice> choices_;
    std::vector<uint32_t> counts_;  // by bucket; all 0 in between
    std::vector<uint32_t> used_;    // buckets with anything in them
};

}  // namespace flg::render
