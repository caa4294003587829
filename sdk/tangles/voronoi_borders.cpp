// SPDX-License-Identifier: MIT
#include "tangles/voronoi_borders.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>

#include "core/random.h"
#include "tangles/room_work.h"

namespace flg {

namespace {

constexpr uint32_t carry_rounds = 3;  // in each, distances go one triangle further

// The distance at the apex of a triangle whose other corners, so far from it and from each other, are at distances db
// and dc from a source beyond them: unfolded, the straight line from the source, if it enters between the two.
double unfold(double db, double dc, double ab, double ac, double bc) {
    const double along_edges = std::min(db + ab, dc + ac);
    if (!(bc > 0)) return along_edges;
    // b at 0, c at bc on the first axis; the apex above it, the source below.
    const double apex_x = (ab * ab - ac * ac + bc * bc) / (2 * bc), apex_y2 = ab * ab - apex_x * apex_x;
    const double source_x = (db * db - dc * dc + bc * bc) / (2 * bc), source_y2 = db * db - source_x * source_x;
    if (apex_y2 < 0 || source_y2 < 0) return along_edges;
    const double apex_y = std::sqrt(apex_y2), source_y = std::sqrt(source_y2);
    const double height = apex_y + source_y;
    if (!(height > 0)) return along_edges;
    const double enters = source_x + (apex_x - source_x) * source_y / height;
    if (enters < 0 || enters > bc) return along_edges;
    return std::min(along_edges, std::hypot(apex_x - source_x, height));
}

// The distance from a vertex to a generator other than its own.
struct Far {
    uint32_t vertex, label;
    float distance;
};

// Triangles with corners of different cells.
struct Crossings {
    Crossings(const Mesh& of_mesh, const DistanceField& of_cells, const CellsApart& which, Memory* memory)
        : mesh(of_mesh), cells(of_cells), apart(which), triangles(memory), curves(memory) {}

    void look_at(uint32_t triangle) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        const Buffer<uint32_t>& labels = cells.labels;
        if (labels[a] == labels[b] && labels[b] == labels[c]) return;
        if (labels[a] == no_index || labels[b] == no_index || labels[c] == no_index) return;
        if (crossed_edges(triangle).count > 1) triangles.push_back(triangle);
    }

    struct CrossedEdges {
        std::array<bool, 3> is_crossed;  // by the corner that the edge begins at
        uint32_t count;                  // one alone: a border that ends
    };
    CrossedEdges crossed_edges(uint32_t triangle) const {
        const Triple& corners = mesh.triangles[triangle];
        CrossedEdges edges{};
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t from = corners[k], to = corners[(k + 1) % 3];
            edges.is_crossed[k] = cells.labels[from] != cells.labels[to] && (!apart || apart(from, to));
            if (edges.is_crossed[k]) ++edges.count;
        }
        return edges;
    }

    // The entry of a vertex and a label, or the empty one where it belongs.
    Far& find(uint32_t vertex, uint32_t label) {
        const size_t mask = table.size() - 1;
        size_t slot = mix64(uint64_t{vertex} << 32 | label) & mask;
        while (table[slot].vertex != no_index && (table[slot].vertex != vertex || table[slot].label != label)) {
            slot = (slot + 1) & mask;
        }
        return table[slot];
    }

    float distance(uint32_t vertex, uint32_t label) {
        return cells.labels[vertex] == label ? cells.distances[vertex] : find(vertex, label).distance;
    }
    // Where cells without a border between them go on as one.
    float distance_with(uint32_t vertex, uint32_t label, uint32_t beside) {
        return apart && !apart(vertex, beside) ? cells.distances[vertex] : distance(vertex, label);
    }

    void list(uint32_t triangle) {
        for (const uint32_t vertex : mesh.triangles[triangle]) {
            for (const uint32_t other : mesh.triangles[triangle]) {
                const uint32_t label = cells.labels[other];
                if (label != cells.labels[vertex]) find(vertex, label) = {vertex, label, unreachable};
            }
        }
    }

    void carry(uint32_t triangle) {
        const Triple& corners = mesh.triangles[triangle];
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
            const Vec3 at = mesh.position(a), to_b = mesh.position(b) - at, to_c = mesh.position(c) - at;
            for (const uint32_t label : {cells.labels[b], cells.labels[c]}) {
                if (label == cells.labels[a]) continue;
                Far& far = find(a, label);
                const double found = unfold(distance_with(b, label, c), distance_with(c, label, b), to_b.norm(),
                                            to_c.norm(), (to_c - to_b).norm());
                far.distance = std::min(far.distance, static_cast<float>(found));
            }
        }
    }

    // Where along an edge two cells are equally near, from the lower vertex.
    float place_on_edge(uint32_t from, uint32_t to) {
        const uint32_t here = cells.labels[from], there = cells.labels[to];
        const double at_from = double{distance(from, there)} - cells.distances[from];
        const double at_to = double{distance(to, here)} - cells.distances[to];
        const double sum = at_from + at_to;
        return round_on_edge(sum > 0 ? std::clamp(at_from / sum, 0.0, 1.0) : 0.5);
    }

    SurfacePoint crossing(Corner edge) {
        const uint32_t from = mesh.vertex_at(edge), to = mesh.vertex_at(next_corner(edge));
        return point_on_edge(edge, from < to ? place_on_edge(from, to) : 1 - place_on_edge(to, from));
    }

    void add_segment(const SurfacePoint& a, const SurfacePoint& b) {
        curves.points.push_back(a);
        curves.points.push_back(b);
        curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
        curves.closed.push_back(false);
        curves.values.push_back(0);
    }

    void trace(uint32_t triangle) {
        const Triple& corners = mesh.triangles[triangle];
        const std::array<uint32_t, 3> labels = {cells.labels[corners[0]], cells.labels[corners[1]],
                                                cells.labels[corners[2]]};
        const CrossedEdges edges = crossed_edges(triangle);
        for (uint32_t k = 0; k < 3; ++k) {
            // Corner k of its own: the border crosses the edges that meet there.
            if (edges.is_crossed[(k + 1) % 3]) continue;
            return add_segment(crossing(3 * triangle + k), crossing(3 * triangle + (k + 2) % 3));
        }
        std::array<SurfacePoint, 3> ends;
        for (uint32_t k = 0; k < 3; ++k) ends[k] = crossing(3 * triangle + k);
        // Where three cells are equally near: linear as distances are, weights with sum w_i (d_0 - d_g)(i) = 0 for
        // both g.
        std::array<std::array<double, 3>, 2> nearer;
        for (uint32_t i = 0; i < 3; ++i) {
            const double first = distance(corners[i], labels[0]);
            nearer[0][i] = first - distance(corners[i], labels[1]);
            nearer[1][i] = first - distance(corners[i], labels[2]);
        }
        std::array<double, 3> weights;
        double sum = 0;
        for (uint32_t i = 0; i < 3; ++i) {
            const uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
            weights[i] = nearer[0][j] * nearer[1][k] - nearer[0][k] * nearer[1][j];
            sum += weights[i];
        }
        SurfacePoint middle{triangle, (ends[0].u + ends[1].u + ends[2].u) / 3, (ends[0].v + ends[1].v + ends[2].v) / 3};
        constexpr double least = 0.02;  // nearer to an edge the middle of the crossings does better
        if (std::min({weights[0] / sum, weights[1] / sum, weights[2] / sum}) > least) {
            middle = {triangle, static_cast<float>(weights[1] / sum), static_cast<float>(weights[2] / sum)};
        }
        for (const SurfacePoint& end : ends) add_segment(middle, end);
    }

    const Mesh& mesh;
    const DistanceField& cells;
    const CellsApart& apart;
    std::pmr::deque<uint32_t> triangles;
    Buffer<Far> table;  // open addressing; a power of two
    SurfaceCurves curves;
};

}  // namespace

Task<SurfaceCurves> voronoi_borders(Pace& pace, const Mesh& mesh, const RegionSet& regions, const DistanceField& cells,
                                    CellsApart apart) {
    Crossings crossings(mesh, cells, apart, pace.memory());
    const std::pmr::deque<uint32_t>& crossed = crossings.triangles;
    co_await each_within(pace, mesh, regions, Cost::some_ns, [&](uint32_t t) { crossings.look_at(t); });
    // At most 6 entries a triangle, each shared by two triangles or more but at borders.
    crossings.table = Buffer<Far>(std::bit_ceil(12 * crossed.size() + 1), pace.memory());
    co_await each(pace, crossings.table.size(), Cost::some_ns,
                  [&](uint32_t i) { crossings.table[i].vertex = no_index; });
    co_await each(pace, crossed.size(), Cost::hundreds_of_ns, [&](uint32_t i) { crossings.list(crossed[i]); });
    for (uint32_t round = 0; round < carry_rounds; ++round)
        co_await each(pace, crossed.size(), Cost::hundreds_of_ns, [&](uint32_t i) { crossings.carry(crossed[i]); });
    co_await each(pace, crossed.size(), Cost::hundreds_of_ns, [&](uint32_t i) { crossings.trace(crossed[i]); });
    co_return std::move(crossings.curves);
}

}  // namespace flg
