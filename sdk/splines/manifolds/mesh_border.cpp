// SPDX-License-Identifier: MIT
#include "splines/manifolds/mesh_border.h"

#include <algorithm>
#include <cmath>

#include "surfaces/mesh/spatial_order.h"

namespace flg {

namespace {

constexpr double reach_in_edges = 3;      // of the longest one
constexpr double reach_in_deviation = 4;  // of the surface from the mesh
constexpr double same_place = 1e-7;       // of an edge: nearer to its end than that a point is at the vertex

double part_along(const MeshBorder::Edge& edge, const Vec3& x) {
    const Vec3 along = edge.to - edge.from;
    return std::clamp((x - edge.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

// The border edge after this corner's: the fan of its last vertex begins there.
Corner next_border(const Mesh& mesh, Corner corner) {
    return mesh.corner_of_vertex[mesh.vertex_at(next_corner(corner))];
}

MeshBorder::Edge edge_at(const Mesh& mesh, Corner corner) {
    const Vec3 a = mesh.position(mesh.vertex_at(corner)), b = mesh.position(mesh.vertex_at(next_corner(corner)));
    const Vec3 apex = mesh.position(mesh.vertex_at(previous_corner(corner))), along = b - a;
    MeshBorder::Edge edge{.from = a, .to = b, .inwards = Vec3::Zero(), .normal = Vec3::Zero(), .before = 0, .after = 0};
    const double square = along.squaredNorm();
    if (!(square > 0)) return edge;
    const Vec3 across = apex - a, inwards = across - across.dot(along) / square * along;
    if (!(inwards.norm() > 1e-9 * across.norm())) return edge;
    edge.inwards = inwards.normalized();
    edge.normal = along.cross(edge.inwards).normalized();
    return edge;
}

}  // namespace

bool MeshBorder::look(const Vec3& x, const Vec3* normal, BorderView& out) const {
    double square = reach_ * reach_, part = 0;
    uint32_t nearest = no_index;
    tree_.nearest(x.data(), square, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            const Edge& edge = edges_[i];
            if (normal && edge.normal.dot(*normal) < 0) continue;
            const double t = part_along(edge, x);
            const double away = (edge.from + t * (edge.to - edge.from) - x).squaredNorm();
            if (away >= square) continue;
            square = away;
            nearest = i;
            part = t;
        }
    });
    if (nearest == no_index) return false;
    const Edge& edge = edges_[nearest];
    out.curvature = 0;
    out.at_vertex = false;
    if (part > same_place && part < 1 - same_place) {
        out.inside = edge.inwards.dot(x - edge.from);
        out.inwards = edge.inwards;
        return true;
    }
    const Edge &before = part < 0.5 ? edges_[edge.before] : edge, &after = part < 0.5 ? edge : edges_[edge.after];
    const Vec3 vertex = after.from, up = (before.normal + after.normal).normalized(),
               between = (before.inwards + after.inwards).normalized();
    Vec3 off = x - vertex;
    off -= off.dot(up) * up;
    const double away = off.norm();
    out.points_in = before.inwards.dot(after.to - after.from) < 0;
    if (away <= same_place * (after.to - after.from).norm()) {
        out.inside = 0;
        out.inwards = between;
        out.at_vertex = true;
        out.ways[0] = (before.from - before.to).normalized();
        out.ways[1] = (after.to - after.from).normalized();
        out.inwards_of[0] = before.inwards;
        out.inwards_of[1] = after.inwards;
        return true;
    }
    const double sign = off.dot(between) < 0 ? -1 : 1;
    out.inside = sign * away;
    out.inwards = sign / away * off;
    out.curvature = -sign / away;
    return true;
}

Task<std::optional<MeshBorder>> mesh_border(Pace& pace, const Mesh& mesh, double deviation) {
    const size_t corners = size_t{3} * mesh.triangle_count();
    uint32_t count = 0;
    co_await each(pace, corners, Cost::some_ns, [&](Corner corner) {
        if (mesh.neighbour_at(corner) == no_index) ++count;
    });
    std::optional<MeshBorder> none;
    if (count == 0) co_return none;
    Buffer<Corner> firsts(count, pace.memory());  // ascending
    GrowingBuffer<Position> middles(count, pace.memory());
    count = 0;
    double longest = 0, sum = 0;
    uint32_t lengths = 0;
    co_await each(pace, corners, Cost::tens_of_ns, [&](Corner corner) {
        if (mesh.neighbour_at(corner) != no_index) return;
        const Vec3 a = mesh.position(mesh.vertex_at(corner)), b = mesh.position(mesh.vertex_at(next_corner(corner)));
        store_vec3(0.5 * (a + b), middles[count].data());
        firsts[count++] = corner;
        const double length = (b - a).norm();
        longest = std::max(longest, length);
        if (length > 0) sum += 1 / length, ++lengths;
    });
    SpatialOrder order = co_await spatial_order(pace, middles);
    Buffer<uint32_t> place(count, pace.memory());  // in the order, by number
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { place[order.vertex_at(i)] = i; });
    Buffer<MeshBorder::Edge> edges(count, pace.memory());
    co_await each(pace, count, Cost::tens_of_ns,
                  [&](uint32_t i) { std::construct_at(&edges[i], edge_at(mesh, firsts[order.vertex_at(i)])); });
    co_await each_by_work(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        const Corner next = next_border(mesh, firsts[order.vertex_at(i)]);
        const auto number = std::lower_bound(firsts.begin(), firsts.end(), next) - firsts.begin();
        edges[i].after = place[static_cast<size_t>(number)];
        edges[edges[i].after].before = i;
        return 1u;
    });
    const MeshBorder::Edge* const all = edges.data();
    const auto ball = [all](uint32_t i, double* centre, double& radius) {
        const Vec3 middle = 0.5 * (all[i].from + all[i].to);
        std::copy_n(middle.data(), 3, centre);
        radius = 0.5 * (all[i].to - all[i].from).norm();
    };
    PointTree tree = co_await point_tree(pace, count, ball);
    const double reach = std::max(reach_in_edges * longest, reach_in_deviation * deviation);
    none.emplace(std::move(edges), std::move(tree), lengths > 0 ? lengths / sum : 0, reach);
    co_return none;
}

}  // namespace flg
