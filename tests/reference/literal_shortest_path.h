// SPDX-License-Identifier: MIT
// Dijkstra's algorithm without a heap, backwards from the destination: the oracle of sdk/stylization/path_tree.h, with
// its order of additions (cost of the edge + what is left) and its ties.
#pragma once

#include <vector>

#include "reference/literal_patch_graph.h"

namespace flg::literal {

struct PathTree {
    std::vector<float> distance;  // infinite where there is no path
    std::vector<int> next_hop;    // -1 there
};

// The same edges, as edges into each node: `target` is where they come from.
Graph reversed(const Graph& graph);

// `into`: the reversed graph. Of edges that serve equally well the one to the node settled first is taken, but before
// all others that to the next node. Nodes are settled by rising (distance, index).
PathTree shortest_paths(const Graph& into, int destination);

}  // namespace flg::literal
