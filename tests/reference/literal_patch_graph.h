// SPDX-License-Identifier: MIT
// The patch matrix and graph of Minarcik, Fiser, Sykora, sec. 4.4, as the paper writes them: every entry its own sum, the
// whole matrix kept. Oracle of sdk/stylization/patch_graph.h and baseline of the benchmarks.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flg::literal {

using Vec3 = Eigen::Vector3d;

// rho_p(i, c)^2, row by row; infinite where i or c is not the centre of a patch within one style curve. `boundaries`:
// where each curve begins, and at last the number of points.
std::vector<double> patch_distances_sq(const std::vector<Vec3>& displacement, const std::vector<int>& boundaries,
                                       int patch);

struct Edge {
    int target = 0;
    float cost = 0;
};
using Graph = std::vector<std::vector<Edge>>;  // the edges out of each node

// All jumps of the paper's graph, and the consecutive edges at cost tau.
Graph dense_graph(const std::vector<double>& distances_sq, const std::vector<int>& boundaries, double tau);

// Jumps only, by the rule of sdk/stylization/patch_graph.h: of the local minima of each row that lead to a node with a
// patch the `kept` cheapest, cheapest first; of the last row of each curve all.
Graph sparse_jumps(const std::vector<double>& distances_sq, const std::vector<int>& boundaries, int patch, int kept);

}  // namespace flg::literal
