// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_measures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/each.h"
#include "surfaces/mesh/marks.h"

namespace flg {

// ---- Components: a union-find whose roots are the least vertices; ways to them are halved as they are walked.

namespace {

uint32_t root_of(uint32_t* parents, uint32_t vertex) {
    while (parents[vertex] != vertex) {
        parents[vertex] = parents[parents[vertex]];
        vertex = parents[vertex];
    }
    return vertex;
}

void join(uint32_t* parents, uint32_t a, uint32_t b) {
    const uint32_t root_a = root_of(parents, a), root_b = root_of(parents, b);
    parents[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace

Task<MeshComponents> find_components(Pace& pace, const Mesh& mesh) {
    MeshComponents components{.of_vertex = Buffer<uint32_t>(mesh.vertex_count(), pace.memory())};
    uint32_t* const labels = components.of_vertex.data();  // until the last pass: parents
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [=](uint32_t v) { labels[v] = v; });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [=, &mesh](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        join(labels, corners[0], corners[1]);
        join(labels, corners[1], corners[2]);
    });
    // In rising order: a lesser vertex has its label already.
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [=, &count = components.count](uint32_t v) {
        labels[v] = labels[v] == v ? count++ : labels[labels[v]];
    });
    co_return components;
}

// ---- Borders

Task<BorderLoops> find_borders(Pace& pace, const Mesh& mesh) {
    BorderLoops loops(pace.memory());
    Marks visited = co_await no_marks(pace, mesh.vertex_count());
    // True at a border vertex that was not visited before; it is then part of the loop.
    const auto visit = [&](uint32_t vertex) {
        if (mesh.neighbour_at(mesh.corner_of_vertex[vertex]) != no_index || !visited.set(vertex)) return false;
        loops.vertices.push_back(vertex);
        return true;
    };
    Slice slice(Cost::some_ns);
    for (uint32_t first = 0; first < mesh.vertex_count(); ++first) {
        if (slice.is_over()) co_await pace;
        if (!visit(first)) continue;
        uint32_t vertex = first;
        do {
            // The first corner of a border vertex is where the border edge leaves.
            vertex = mesh.vertex_at(next_corner(mesh.corner_of_vertex[vertex]));
            if (slice.is_over()) co_await pace;
        } while (visit(vertex));
        loops.offsets.push_back(loops.vertex_count());
    }
    co_return loops;
}

Task<MeshTopology> find_topology(Pace& pace, const Mesh& mesh) {
    MeshTopology topology;
    {
        const MeshComponents components = co_await find_components(pace, mesh);
        topology.components = components.count;
    }
    co_await pace;
    const BorderLoops borders = co_await find_borders(pace, mesh);
    topology.border_loops = borders.loop_count();
    topology.border_edges = borders.vertex_count();
    // Inner edges have two triangles: 2 edges = 3 triangles + border edges.
    const int64_t triangles = mesh.triangle_count();
    const int64_t edges = (3 * triangles + topology.border_edges) / 2;
    topology.euler_number = int64_t{mesh.vertex_count()} - edges + triangles;
    // Of an orientable component: Euler number = 2 - 2 genus - loops.
    topology.genus =
        static_cast<uint32_t>((2 * int64_t{topology.components} - topology.border_loops - topology.euler_number) / 2);
    co_return topology;
}

// ---- Extent and fingerprint

Task<MeshExtent> measure_extent(Pace& pace, const Mesh& mesh) {
    MeshExtent extent{.lower = mesh.position(0), .upper = mesh.position(0)};
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        const Vec3 position = mesh.position(v);
        extent.lower = extent.lower.cwiseMin(position);
        extent.upper = extent.upper.cwiseMax(position);
    });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns,
                  [&](uint32_t t) { extent.area += vector_area(mesh, t).norm(); });
    co_return extent;
}

namespace {

// Odd, with bits all over: 2^64 over the golden ratio, and the multiplier of splitmix64.
constexpr uint64_t golden = 0x9e3779b97f4a7c15, spread = 0xbf58476d1ce4e5b9;

void mix(const void* three_words, uint64_t& number) {
    uint32_t words[3];
    std::memcpy(words, three_words, sizeof words);
    number = (number ^ (uint64_t{words[0]} << 32 | words[1])) * spread;
    number = (number ^ number >> 29 ^ words[2]) * golden;
    number ^= number >> 32;
}

}  // namespace

Task<MeshFingerprint> take_fingerprint(Pace& pace, const Mesh& mesh) {
    MeshFingerprint fingerprint{
        .number = golden * (mesh.vertex_count() + uint64_t{1}), .lower = mesh.positions[0], .upper = mesh.positions[0]};
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        const Position& position = mesh.positions[v];
        mix(position.data(), fingerprint.number);
        for (size_t k = 0; k < 3; ++k) {
            fingerprint.lower[k] = std::min(fingerprint.lower[k], position[k]);
            fingerprint.upper[k] = std::max(fingerprint.upper[k], position[k]);
        }
    });
    co_await each(pace, mesh.triangle_count(), Cost::some_ns,
                  [&](uint32_t t) { mix(mesh.triangles[t].data(), fingerprint.number); });
    co_return fingerprint;
}

// ---- Normals

namespace {

// The normal of the corner's triangle, as long as the angle of the corner (radians).
Vec3 angle_normal(const Mesh& mesh, Corner corner) {
    const Vec3 origin = mesh.position(mesh.vertex_at(corner));
    const Vec3 a = mesh.position(mesh.vertex_at(next_corner(corner))) - origin;
    const Vec3 b = mesh.position(mesh.vertex_at(previous_corner(corner))) - origin;
    const Vec3 across = a.cross(b);
    const double size = across.norm();
    if (!(size > 0)) return Vec3::Zero();
    return across * (std::atan2(size, a.dot(b)) / size);
}

}  // namespace

Vec3 vertex_normal(const Mesh& mesh, uint32_t vertex) {
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first;
    Vec3 sum = Vec3::Zero();
    do {
        sum += angle_normal(mesh, corner);
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    return sum.stableNormalized();
}

// The same, pausing within fans as well: they may be of any length.
Task<Buffer<Position>> find_vertex_normals(Pace& pace, const Mesh& mesh) {
    Buffer<Position> normals(mesh.vertex_count(), pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Corner first = mesh.corner_of_vertex[v];
        Corner corner = first;
        Vec3 sum = Vec3::Zero();
        do {
            sum += angle_normal(mesh, corner);
            corner = mesh.turn(corner);
            if (slice.is_over()) co_await pace;
        } while (corner != first && corner != no_index);
        store_vec3(sum.stableNormalized(), normals[v].data());
    }
    co_return normals;
}

Vec3 smooth_normal(const Mesh& mesh, const SurfacePoint& point) {
    const Triple& corners = mesh.triangles[point.triangle];
    const double weights[] = {1.0 - point.u - point.v, point.u, point.v};
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (weights[k] > 0) sum += weights[k] * vertex_normal(mesh, corners[k]);
    }
    return sum.stableNormalized();
}

}  // namespace flg
