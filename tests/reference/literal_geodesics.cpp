// SPDX-License-Identifier: MIT
#include "reference/literal_geodesics.h"

#include <cmath>
#include <deque>
#include <map>
#include <queue>
#include <tuple>

namespace flg::literal {

namespace {

using Edge = std::pair<uint32_t, uint32_t>;

// The third corners of the triangles at each edge.
std::map<Edge, std::vector<uint32_t>> opposite_corners(const Mesh& mesh, const RegionSet& within) {
    std::map<Edge, std::vector<uint32_t>> corners;
    for (uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        if (!within.contains(mesh.regions[triangle])) continue;
        const Triple& t = mesh.triangles[triangle];
        for (int k = 0; k < 3; ++k) corners[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
    }
    return corners;
}

// Between the third corners of two triangles unfolded along their edge a-b; infinite where the straight way leaves
// them.
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

GeodesicGraph geodesic_graph(const Mesh& mesh, const RegionSet& within) {
    GeodesicGraph graph(mesh.vertex_count());
    const auto join = [&](uint32_t a, uint32_t b, double length) {
        if (!(length < unreachable)) return;
        graph[a].push_back({b, static_cast<float>(length)});
        graph[b].push_back({a, static_cast<float>(length)});
    };
    for (const auto& [edge, corners] : opposite_corners(mesh, within)) {
        const Vec3 a = mesh.position(edge.first), b = mesh.position(edge.second);
        join(edge.first, edge.second, (b - a).norm());
        if (corners.size() != 2) continue;
        join(corners[0], corners[1], unfolded_distance(a, b, mesh.position(corners[0]), mesh.position(corners[1])));
    }
    return graph;
}

GraphField::GraphField(const GeodesicGraph& graph, const std::vector<Seed>& seeds)
    : distances(graph.size(), unreachable), labels(graph.size(), no_index) {
    extend(graph, seeds);
}

void GraphField::extend(const GeodesicGraph& graph, std::span<const Seed> seeds) {
    using Entry = std::tuple<float, uint32_t, uint32_t>;  // distance, label, vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto reach = [&](uint32_t vertex, float distance, uint32_t label) {
        if (std::pair(distance, label) >= std::pair(distances[vertex], labels[vertex])) return;
        distances[vertex] = distance;
        labels[vertex] = label;
        queue.push({distance, label, vertex});
    };
    for (const Seed& seed : seeds) reach(seed.vertex, seed.distance, seed.label);
    while (!queue.empty()) {
        const auto [distance, label, vertex] = queue.top();
        queue.pop();
        if (distance > distances[vertex] || label > labels[vertex]) continue;
        for (const Arc& arc : graph[vertex]) reach(arc.target, distance + arc.length, label);
    }
}

std::vector<float> visit_graph(const GeodesicGraph& graph, uint32_t source) {
    std::vector<float> distances(graph.size(), unreachable);
    std::vector<bool> waits(graph.size(), false);
    std::deque<uint32_t> queue = {source};
    double weight = 0;
    distances[source] = 0;
    waits[source] = true;
    while (!queue.empty()) {
        const double mean = weight / static_cast<double>(queue.size());
        for (size_t turns = queue.size(); distances[queue.front()] > mean && turns > 0; --turns) {
            queue.push_back(queue.front());
            queue.pop_front();
        }
        const uint32_t node = queue.front();
        queue.pop_front();
        waits[node] = false;
        weight -= distances[node];
        for (const Arc& arc : graph[node]) {
            const float found = distances[node] + arc.length, old = distances[arc.target];
            if (found >= old) continue;
            if (waits[arc.target]) {
                weight -= old;
            } else {
                waits[arc.target] = true;
                if (queue.empty() || found < distances[queue.front()]) {
                    queue.push_front(arc.target);
                } else {
                    queue.push_back(arc.target);
                }
            }
            weight += found;
            distances[arc.target] = found;
        }
    }
    return distances;
}

}  // namespace flg::literal
