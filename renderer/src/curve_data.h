// SPDX-License-Identifier: MIT
// Curves as the device wants them: compact points, and chunks of up to chunk_segments segments that are culled and
// given their level of detail one by one. Host only; no Vulkan here.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "displaced_box.h"
#include "filigree_renderer/renderer.h"

namespace flg::render {

constexpr uint32_t chunk_segments = 64;

// Mirrors shaders/curve.vert.
struct Chunk {
    uint32_t first_point;
    uint32_t segments_and_flags;  // closed curves repeat their first point as their last
    uint32_t curve_first;
    uint32_t curve_last;

    static constexpr uint32_t closed = 1u << 16;
    static constexpr uint32_t begins = 1u << 17;  // holds the first point of an open curve
    static constexpr uint32_t ends = 1u << 18;
    uint32_t segments() const { return segments_and_flags & 0xffffu; }
};

struct ChunkBounds {
    glm::vec3 center;
    float extent;     // radius of a ball around all of it, metres
    float thickness;  // largest radius of the curve, metres
    float segment;    // mean length of a segment, metres
    // Largest second differences of neighbouring points: across the curve, with that of a tube's radius, metres; and of
    // a ribbon's normals. Where every s-th point is drawn, what is drawn strays from the curve by less than s * s / 8
    // of them.
    float bend;
    float turn;
};

// What of a chunk grows with the size of the magnitude offset; per offset of 1.
struct ChunkGrowth {
    float extent;   // largest displacement, metres
    float segment;  // mean difference of neighbouring displacements, metres
    float bend;     // largest second difference of neighbouring displacements, metres
};

struct PackedLook {
    uint32_t normal;  // octahedral, 2 x snorm16
    uint32_t color;   // sRGB, 4 x unorm8
};

struct PackedDisplacement {
    glm::vec3 displacement;  // metres
    uint32_t normal;         // of ribbons as given, not followed; octahedral
};

struct CurveData {
    std::vector<glm::vec4> centers;  // position, radius
    std::vector<PackedLook> looks;
    std::vector<Chunk> chunks;
    std::vector<ChunkBounds> bounds;
    Box box;
    bool has_displacements = false;
    // With those; else empty.
    std::vector<PackedDisplacement> displacements;
    std::vector<ChunkGrowth> growths;
    DisplacedBox displaced_box;

    Box box_at(float magnitude_offset) const { return has_displacements ? displaced_box.at(magnitude_offset) : box; }
};

// Of the chunk whose first point this is; the box grows by it. Normals matter for ribbons alone.
ChunkBounds bounds_of(const glm::vec4* centers, const glm::vec3* normals, uint32_t segments, Shape shape,
                      Box& in_out_box);

// In parts of at most `max_points` points, at least 128: each a device buffer's. Long curves are divided between chunks
// and drawn as if they were not. Throws Error for a view or a look that can't be used.
std::vector<CurveData> prepare_curves(const FlgCurveSetView& view, const CurveLook& look, uint32_t max_points);

}  // namespace flg::render
