// SPDX-License-Identifier: MIT
#include "reference/literal_shortest_path.h"

#include <limits>

namespace flg::literal {

Graph reversed(const Graph& graph) {
    Graph into(graph.size());
    for (size_t i = 0; i < graph.size(); ++i) {
        for (const Edge& edge : graph[i]) into[edge.target].push_back({static_cast<int>(i), edge.cost});
    }
    return into;
}

PathTree shortest_paths(const Graph& into, int destination) {
    const int n = static_cast<int>(into.size());
    const float infinity = std::numeric_limits<float>::infinity();
    PathTree tree{std::vector<float>(n, infinity), std::vector<int>(n, -1)};
    std::vector<bool> settled(n, false);
    tree.distance[destination] = 0;
    tree.next_hop[destination] = destination;
    for (;;) {
        int node = -1;
        for (int i = 0; i < n; ++i) {
            if (!settled[i] && tree.distance[i] < infinity && (node < 0 || tree.distance[i] < tree.distance[node])) {
                node = i;
            }
        }
        if (node < 0) return tree;
        settled[node] = true;
        for (const Edge& edge : into[node]) {
            const int i = edge.target;
            if (settled[i]) continue;
            const float through = edge.cost + tree.distance[node];
            const bool consecutive_tie = through == tree.distance[i] && node == i + 1;
            if (through < tree.distance[i] || consecutive_tie) {
                tree.distance[i] = through;
                tree.next_hop[i] = node;
            }
        }
    }
}

}  // namespace flg::literal
