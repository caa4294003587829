// SPDX-License-Identifier: MIT
// Styles for the tests of this room: displacements, and graphs made of them.
#pragma once

#include <cmath>
#include <vector>

#include "core/random.h"
#include "reference/literal_patch_graph.h"
#include "runtime/run_now.h"
#include "stylization/patch_graph.h"

namespace flg::test {

inline Memory* memory() {
    return std::pmr::new_delete_resource();
}

// Wiggles that never repeat, with a little noise so that no two patches are equal.
inline std::vector<Vec3> wiggles(int count, uint64_t seed = 1) {
    std::vector<Vec3> out;
    for (int i = 0; i < count; ++i) {
        const double u = 0.05 * i;
        Vec3 d(0.3 * std::sin(1.7 * u) + 0.1 * std::sin(7.1 * u),
               0.4 * std::cos(2.3 * u) + 0.05 * std::sin(13.3 * u + 1), 0.2 * std::sin(3.3 * u) * std::cos(0.7 * u));
        for (int k = 0; k < 3; ++k) d[k] += 0.02 * (random_unit(seed, i, k) - 0.5);
        out.push_back(d);
    }
    return out;
}

inline Displacement displacement_of(const std::vector<Vec3>& vectors) {
    Displacement d(static_cast<uint32_t>(vectors.size()), memory());
    for (uint32_t i = 0; i < d.size(); ++i) {
        d.along_tangent[i] = vectors[i].x();
        d.along_normal[i] = vectors[i].y();
        d.along_binormal[i] = vectors[i].z();
    }
    return d;
}

inline PatchGraph graph_of(const Displacement& displacement, const std::vector<uint32_t>& boundaries, uint32_t patch,
                           bool haltingly = false) {
    const StyleScene scene{&displacement, boundaries, patch};
    return run_now(
        memory(), [&](Pace& pace) { return patch_graph(pace, scene); }, haltingly);
}

inline PatchGraph graph_of(const Displacement& displacement, uint32_t patch) {
    return graph_of(displacement, {0, displacement.size()}, patch);
}

// The jumps out of each node, by rising target.
inline literal::Graph jumps_of(const PatchGraph& graph) {
    literal::Graph out(graph.node_count);
    for (uint32_t j = 0; j < graph.node_count; ++j) {
        for (uint32_t k = graph.in_begin[j]; k < graph.in_begin[j + 1]; ++k) {
            out[graph.in_source[k]].push_back({static_cast<int>(j), graph.in_cost[k]});
        }
    }
    return out;
}

// With the consecutive edges.
inline literal::Graph edges_of(const PatchGraph& graph, float temperature) {
    literal::Graph out = jumps_of(graph);
    for (uint32_t i = 0; i < graph.node_count; ++i) {
        if (graph.curve_end[i] != i + 1) out[i].push_back({static_cast<int>(i) + 1, temperature});
    }
    return out;
}

}  // namespace flg::test
