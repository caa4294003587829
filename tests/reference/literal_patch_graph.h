// SPDX-License-Identifier: MIT
// The patch matrix and graph of Minarcik, Fiser, Sykora, sec. 4.4, as the paper writes them: every entry its own sum,
// the whole matrix kept. Oracle of sdk/stylization/patch_graph.h and baseline of the benchmarks.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flg::literal {

using Vec3 = Eigen::Vector3d;

// rho_p(i, c)^2, row by row; infinite where i or c is not the centre of a patch within one style curve. `boundaries`:
// where each curve begins, and at last the number of points.
std::vector<double> patch_distances_sq(const std::vector<Vec3>& displacement, const std::vector<int>& boundaries,
                                       int patch);

// An attribute of one number a point (sec. 5): distances are weight times those on a line, or on a circle of that
// period.
struct Channel {
    std::vector<double> values;
    double weight = 1;
    double period = 0;
};

// Several patch sizes (sec. 4.5.4).
struct PatchSize {
    int patch = 0;
    double weight = 1;
};

// (sum over the sizes of weight * rho_p(i, c))^2, with the attributes' distances in the sums of rho_p; infinite where i
// or c is not the centre of a patch of the largest size.
std::vector<double> patch_costs_sq(const std::vector<Vec3>& displacement, const std::vector<int>& boundaries,
                                   const std::vector<PatchSize>& sizes, const std::vector<Channel>& channels);

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
