// SPDX-License-Identifier: MIT
// The vertices a cut adds: their position and columns, linear in the triangle they come to lie in.
#pragma once

#include "surfaces/mesh_growth.h"

namespace flg {

// At `weights` of the corners, whose sum is 1; computed in double, rounded once. Corners of no weight have no say, be their
// values infinite.
inline void place_vertex(Mesh& mesh, MeshColumns& columns, uint32_t vertex, const Triple& corners,
                         const std::array<double, 3>& weights) {
    const auto interpolate = [&](const float* from, size_t components, float* to) {
        for (size_t c = 0; c < components; ++c) {
            double sum = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                if (weights[k] != 0) sum += weights[k] * from[components * corners[k] + c];
            }
            to[c] = static_cast<float>(sum);
        }
    };
    interpolate(mesh.positions.data()->data(), 3, mesh.positions[vertex].data());
    for (MeshColumn& column : columns) {
        const size_t n = column.components;
        interpolate(column.values.data(), n, column.values.data() + n * vertex);
    }
}

}  // namespace flg
