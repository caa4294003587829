// SPDX-License-Identifier: MIT
// Only few vertices touch several regions: those are found first, and only what is around them is sorted.
#include "surface_regions.h"

#include <algorithm>
#include <tuple>

namespace flg::render {
namespace {

struct VertexLabels {
    std::vector<uint32_t> label;  // of one of the vertex's triangles, the first
    std::vector<uint8_t> mixed;   // whether others have another one
};

VertexLabels find_mixed(std::span<const uint32_t> triangles, std::span<const uint32_t> labels, uint32_t vertex_count) {
    VertexLabels found{std::vector<uint32_t>(vertex_count, 0), std::vector<uint8_t>(vertex_count, 0)};
    std::vector<uint8_t> seen(vertex_count, 0);
    for (size_t corner = 0; corner < triangles.size(); ++corner) {
        const uint32_t vertex = triangles[corner], label = labels[corner / 3];
        if (!seen[vertex]) found.label[vertex] = label;
        seen[vertex] = 1;
        found.mixed[vertex] |= found.label[vertex] != label;
    }
    return found;
}

struct LabelledCorner {
    uint32_t vertex, label, corner;
    auto key() const { return std::tie(vertex, label, corner); }
};

auto key_of(const LabelledEdge& edge) {
    return std::tie(edge.low, edge.high, edge.label);
}

}  // namespace

SplitVertices split_vertices(std::span<const uint32_t> triangles, std::span<const uint32_t> labels,
                             uint32_t vertex_count) {
    VertexLabels found = find_mixed(triangles, labels, vertex_count);
    SplitVertices split{{triangles.begin(), triangles.end()}, {}, std::move(found.label)};
    std::vector<LabelledCorner> corners;
    for (uint32_t corner = 0; corner < triangles.size(); ++corner)
        if (found.mixed[triangles[corner]]) corners.push_back({triangles[corner], labels[corner / 3], corner});
    std::ranges::sort(corners, {}, &LabelledCorner::key);
    for (size_t i = 0; i < corners.size(); ++i) {
        const auto [vertex, label, corner] = corners[i];
        if (i == 0 || corners[i - 1].vertex != vertex) {
            split.label_of[vertex] = label;
        } else if (corners[i - 1].label != label) {
            split.copied.push_back(vertex);
            split.label_of.push_back(label);
        }
        if (split.label_of[vertex] != label) split.indices[corner] = static_cast<uint32_t>(split.label_of.size()) - 1;
    }
    return split;
}

std::vector<LabelledEdge> border_edges(std::span<const uint32_t> triangles, std::span<const uint32_t> labels,
                                       uint32_t vertex_count) {
    const std::vector<uint8_t> mixed = find_mixed(triangles, labels, vertex_count).mixed;
    std::vector<LabelledEdge> edges;
    for (size_t corner = 0; corner < triangles.size(); ++corner) {
        const uint32_t here = triangles[corner], next = triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
        if (mixed[here] && mixed[next])
            edges.push_back({std::min(here, next), std::max(here, next), labels[corner / 3]});
    }
    std::ranges::sort(edges, {}, key_of);
    std::vector<LabelledEdge> borders;
    size_t first = 0;
    for (size_t i = 0; i < edges.size(); ++i) {
        const auto is_same = [&](const LabelledEdge& other) {
            return other.low == edges[i].low && other.high == edges[i].high;
        };
        if (!is_same(edges[first])) first = i;
        const bool is_last = i + 1 == edges.size() || !is_same(edges[i + 1]);
        if (is_last && edges[first].label != edges[i].label) borders.push_back(edges[i]);
    }
    return borders;
}

}  // namespace flg::render
