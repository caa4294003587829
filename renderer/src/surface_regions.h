// SPDX-License-Identifier: MIT
// Where regions meet: vertices split so that each has one label, and the edges between different labels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace flg::render {

struct SplitVertices {
    std::vector<uint32_t> indices;   // of triangles, now also into the copies
    std::vector<uint32_t> copied;    // copy i, which is vertex vertex_count + i, is of this vertex
    std::vector<uint32_t> label_of;  // of every vertex and copy; 0 for those without a triangle
};

// `labels`: one a triangle. The copies are in order of vertex, then label; the least label stays with the vertex
// itself.
SplitVertices split_vertices(std::span<const uint32_t> triangles, std::span<const uint32_t> labels,
                             uint32_t vertex_count);

struct LabelledEdge {
    uint32_t low, high;  // vertices
    uint32_t label;      // the largest of the triangles around
};

// Each edge between triangles of different labels once, in order.
std::vector<LabelledEdge> border_edges(std::span<const uint32_t> triangles, std::span<const uint32_t> labels,
                                       uint32_t vertex_count);

}  // namespace flg::render
