// SPDX-License-Identifier: MIT
#include "reference/literal_synthesis.h"

#include <Eigen/Geometry>

namespace flg::literal {

std::vector<int> style_indices(const Graph& graph, const Walk& walk, int samples) {
    const int count = static_cast<int>(walk.destinations.size());
    const Graph into = reversed(graph);
    int draws = 0;
    int k = walk.from_start ? count - 1 : walk.draw(draws++, count);
    int node = walk.from_start ? 0 : walk.destinations[k];
    std::vector<int> indices{node};
    PathTree tree;
    if (walk.from_start) tree = shortest_paths(into, walk.destinations[k]);
    while (static_cast<int>(indices.size()) < samples) {
        if (node == walk.destinations[k]) {
            const int wanted = samples - static_cast<int>(indices.size());
            const int left = walk.node_count - 1 - node;
            if (left == walk.patch && wanted <= left) {
                for (int i = 1; i <= wanted; ++i) indices.push_back(node + i);
                return indices;
            }
            if (count == 1) {
                node = 0;
            } else {
                const int drawn = walk.draw(draws++, count - 1);
                k = drawn < k ? drawn : drawn + 1;
            }
            tree = shortest_paths(into, walk.destinations[k]);
        }
        node = tree.next_hop[node];
        indices.push_back(node);
    }
    return indices;
}

std::vector<Vec3> copied_displacement(const std::vector<Vec3>& displacement, const std::vector<int>& indices,
                                      int patch) {
    const size_t count = indices.size();
    std::vector<Vec3> offsets(count + static_cast<size_t>(patch), Vec3(0, 0, 0));
    std::vector<Vec3> out;
    for (size_t i = 0; i < count; ++i) {
        if (i > 0 && indices[i] != indices[i - 1] + 1) {
            const int from = indices[i - 1], to = indices[i];
            const Vec3 followed = displacement[from + 1] + offsets[i];
            const Vec3 gap = followed - displacement[to];
            const Vec3 step_gap = (followed - out.back()) - (displacement[to + 1] - displacement[to]);
            for (int k = 0; k < patch; ++k) {
                const double t = static_cast<double>(k) / patch;
                offsets[i + static_cast<size_t>(k)] =
                    (1 + 2 * t) * (1 - t) * (1 - t) * gap + patch * t * (1 - t) * (1 - t) * step_gap;
            }
        }
        out.push_back(displacement[indices[i]] + offsets[i]);
    }
    return out;
}

std::vector<Vec3> displace(const std::vector<FramedPoint>& target, const std::vector<Vec3>& displacement,
                           double factor) {
    std::vector<Vec3> out;
    for (size_t i = 0; i < target.size(); ++i) {
        const Vec3& d = displacement[i];
        const Vec3 binormal = target[i].tangent.cross(target[i].normal);
        out.push_back(target[i].position +
                      factor * (d.x() * target[i].tangent + d.y() * target[i].normal + d.z() * binormal));
    }
    return out;
}

}  // namespace flg::literal
