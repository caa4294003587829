// SPDX-License-Identifier: MIT
// Where a vertex lies on the mesh that a surface was made of: the weights of at most three vertices of the input, all
// of one triangle. What the input has at its corners can so be had anywhere on the surface, however often that is cut.
//
// Invariant: all corners of a triangle lie in one triangle of the input (Mesh::source_triangles), its border included,
// so what is mixed of them has at most the three vertices of that.
#pragma once

#include <cstring>

#include "filigree/filigree_surface.h"
#include "surfaces/mesh/mesh_growth.h"

namespace flg {

struct SourceWeights {
    Triple vertices;               // of the input, rising; no_index behind the last
    std::array<float, 2> weights;  // of the second and the third; the first has the rest to 1
};

static_assert(sizeof(SourceWeights) == sizeof(FlgSourceWeights));

inline SourceWeights load_sources(const MeshColumn& column, uint32_t vertex) {
    SourceWeights sources;
    std::memcpy(&sources, column.values.data() + size_t{vertex} * column.components, sizeof sources);
    return sources;
}

inline void store(const SourceWeights& sources, MeshColumn& column, uint32_t vertex) {
    std::memcpy(column.values.data() + size_t{vertex} * column.components, &sources, sizeof sources);
}

// The vertices of one triangle, rising, and their weights.
struct SourceParts {
    Triple vertices = {no_index, no_index, no_index};
    std::array<double, 3> weights = {};
    size_t count = 0;

    void add(uint32_t vertex, double weight) {
        size_t at = 0;
        while (at < count && vertices[at] < vertex) ++at;
        if (at == count || vertices[at] != vertex) {
            if (count == 3) return;  // can't be: all are of one triangle
            for (size_t i = count++; i > at; --i) {
                vertices[i] = vertices[i - 1];
                weights[i] = weights[i - 1];
            }
            vertices[at] = vertex;
            weights[at] = 0;
        }
        weights[at] += weight;
    }
};

// At `weights` of the corners of a triangle, whose sum is 1.
inline SourceWeights mix(const MeshColumn& column, const Triple& corners, const std::array<double, 3>& weights) {
    SourceParts parts;
    for (size_t k = 0; k < 3; ++k) {
        if (weights[k] == 0) continue;
        const SourceWeights corner = load_sources(column, corners[k]);
        const double of_first = 1 - double{corner.weights[0]} - double{corner.weights[1]};
        for (size_t i = 0; i < 3 && corner.vertices[i] != no_index; ++i)
            parts.add(corner.vertices[i], weights[k] * (i == 0 ? of_first : double{corner.weights[i - 1]}));
    }
    SourceWeights mixed{{parts.vertices[0], parts.vertices[1], parts.vertices[2]}, {}};
    for (size_t i = 1; i < parts.count; ++i) mixed.weights[i - 1] = static_cast<float>(parts.weights[i]);
    return mixed;
}

}  // namespace flg
