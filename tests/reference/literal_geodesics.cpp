// SPDX-License-Identifier: MIT
#include "reference/literal_geodesics.h"

#include <cmath>
#include <map>
#include <queue>

namespace flg::literal {

namespace {

using Edge = std::pair<uint32_t, uint32_t>;

// The third corners of the triangles at each edge.
std::map<Edge, std::vector<uint32_t>> opposite_corners(const Mesh& mesh) {
    std::map<Edge, std::vector<uint32_t>> corners;
    for (const Triple& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) corners[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
    }
    return corners;
}

// Between the third corners of two triangles unfolded along their edge a-b; infinite where the straight way leaves them.
double unfolded_distance(const Vec3& a, const Vec3& b, const Vec3& one, const Vec3& other) {
    const Vec3 edge = b - a;
    const double length = edge.norm();
    const auto unfold = [&](const Vec3& p) {
        return Eigen::Vector2d((p - a).dot(edge) / length, edge.cross(p - a).norm() / length);
    };
    const Eigen::Vector2d above = unfold(one), below = unfold(other);
    const double height = above.y() + below.y();
    const double crossing = (above.x() * below.y() + below.x() * above.y()) / height;
    if (!(crossing >= 0 && crossing <= length)) return unreachable;
    return std::hypot(above.x() - below.x(), height);
}

}  // namespace

GeodesicGraph geodesic_graph(const Mesh& mesh) {
    GeodesicGraph graph(mesh.vertex_count());
    const auto join = [&](uint32_t a, uint32_t b, double length) {
        if (!(length < unreachable)) return;
        graph[a].push_back({b, static_cast<float>(length)});
        graph[b].push_back({a, static_cast<float>(length)});
    };
    for (const auto& [edge, corners] : opposite_corners(mesh)) {
        const Vec3 a = mesh.position(edge.first), b = mesh.position(edge.second);
        join(edge.first, edge.second, (b - a).norm());
        if (corners.size() != 2) continue;
        join(corners[0], corners[1], unfolded_distance(a, b, mesh.position(corners[0]), mesh.position(corners[1])));
    }
    return graph;
}

std::vector<float> graph_distances(const GeodesicGraph& graph, const std::vector<Seed>& seeds) {
    std::vector<float> distances(graph.size(), unreachable);
    using Entry = std::pair<float, uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto reach = [&](uint32_t vertex, float distance) {
        if (distance >= distances[vertex]) return;
        distances[vertex] = distance;
        queue.push({distance, vertex});
    };
    for (const Seed& seed : seeds) reach(seed.vertex, seed.distance);
    while (!queue.empty()) {
        const auto [distance, vertex] = queue.top();
        queue.pop();
        if (distance > distances[vertex]) continue;
        for (const Arc& arc : graph[vertex]) reach(arc.target, distance + arc.length);
    }
    return distances;
}

}  // namespace flg::literal
