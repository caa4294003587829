// SPDX-License-Identifier: MIT
// The geodesic graph of Nazzaro, Puppo, Pellacini: geoTangle (2021), sec. 4.2: a node a vertex; its arcs are the edges that
// end there and, to the vertex beyond each edge opposite to it, the straight way through the two triangles.
//
// Invariants
// - Rows of arcs begin at multiples of row_step and have room up to the next one. What lies between is out of use: a row
//   that outgrows its room moves to the end.
// - Nodes are the vertices in Morton order, so that neighbours are near in memory; vertices added later are their own nodes.
// - An arc has the same length, to the bit, at both of its ends. Lengths depend on positions only, so that rows made again
//   after a change are those of a graph built anew.
//
// Departures. Across an edge where the straight way leaves the two triangles there is no arc: with the length it has in
// the plane distances could be too short. Neither is there across edges without length.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfaces/mesh.h"
#include "surfaces/spatial_order.h"

namespace flg {

struct GraphArc {
    uint32_t target;  // node
    float length;     // metres
};

struct GeodesicGraph {
    static constexpr uint32_t row_step = 4;  // 32 bytes
    struct Row {
        uint32_t first, count;  // of its arcs
    };

    explicit GeodesicGraph(Memory* memory) : rows(memory) {}

    uint32_t node_count() const { return static_cast<uint32_t>(rows.size()); }
    uint32_t node_of(uint32_t vertex) const { return vertex < nodes.size() ? nodes[vertex] : vertex; }
    uint32_t vertex_of(uint32_t node) const { return node < vertices.size() ? vertices[node] : node; }
    // What a bucket of a solver holds: little more than an arc, so that there are neither many nodes in wrong order in it
    // nor many buckets. Distances do not depend on it.
    float bucket_width() const;

    GrowingBuffer<Row> rows;  // by node
    Buffer<GraphArc> arcs;
    uint32_t arcs_end = 0;      // of those rows may use
    uint32_t arcs_in_use = 0;   // the rows' room
    Buffer<uint32_t> nodes;     // of the vertices that were there when the graph was built
    Buffer<uint32_t> vertices;  // of these nodes
    float mean_length = 0;      // of the arcs when the graph was built, metres
    float longest = 0;          // at least of all
};

// The room of a row.
constexpr uint32_t row_capacity(uint32_t arcs) {
    return (arcs + GeodesicGraph::row_step - 1) / GeodesicGraph::row_step * GeodesicGraph::row_step;
}
// The room that rows of so many corners in all may need: an arc an edge, of which an open fan has one more, and one across
// each triangle.
constexpr uint64_t row_room(uint64_t corners, uint64_t rows) {
    return 2 * corners + GeodesicGraph::row_step * rows;
}

// Length of the straight way between two vertices across the edge a-b of their triangles; negative if it leaves them. The
// same bits whichever way round the edge and the vertices are named.
inline double length_across(const Vec3& a, const Vec3& b, const Vec3& one, const Vec3& other) {
    const Vec3 edge = b - a;
    // Times the length of the edge: how far from it both are.
    const double height_one = (a - one).cross(b - one).norm(), height_other = (a - other).cross(b - other).norm();
    const double height = height_one + height_other;
    // Where the way crosses the edge, from either end, times more.
    const double from_a = edge.dot(one - a) * height_other + edge.dot(other - a) * height_one;
    const double from_b = edge.dot(b - one) * height_other + edge.dot(b - other) * height_one;
    if (!(height > 0 && from_a >= 0 && from_b >= 0)) return -1;
    const double along = edge.dot(one - other);
    return std::sqrt((along * along + height * height) / edge.squaredNorm());
}

// Takes (vertex, length) of the arcs that lead along and across the triangle of `corner` from its vertex; `next` is the
// vertex's next corner. None leads into triangles where `enters(triangle)` is false.
template <class Enters, class Take>
void visit_arcs(const Mesh& mesh, const GrowingBuffer<Position>& positions, Corner corner, Corner next, Enters enters,
                Take take) {
    const auto position = [&](uint32_t vertex) { return load_vec3(positions[vertex].data()); };
    const uint32_t a = mesh.vertex_at(next_corner(corner)), b = mesh.vertex_at(previous_corner(corner));
    const Vec3 start = position(mesh.vertex_at(corner)), at_a = position(a), at_b = position(b);
    take(a, static_cast<float>((at_a - start).norm()));
    // Of an open fan's last triangle both edges.
    if (next == no_index) take(b, static_cast<float>((at_b - start).norm()));
    const Corner across = mesh.opposite(next_corner(corner));
    if (across == no_index || !enters(triangle_of(across))) return;
    const uint32_t end = mesh.vertex_at(previous_corner(across));
    const double length = length_across(at_a, at_b, start, position(end));
    if (length >= 0) take(end, static_cast<float>(length));
}

// Writes the rows of vertices one after the other. There must be room.
class RowWriter {
public:
    RowWriter(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicGraph& graph)
        : mesh_(mesh), positions_(positions), graph_(graph) {}

    void begin(uint32_t vertex, uint32_t first_arc) {
        first_corner_ = corner_ = mesh_.corner_of_vertex[vertex];
        row_ = {first_arc, 0};
    }
    // Visits at most so many corners; true when the row is complete.
    bool run(uint32_t corners);
    const GeodesicGraph::Row& row() const { return row_; }
    // Of all arcs written.
    float mean_length() const { return arcs_ == 0 ? 0.0f : static_cast<float>(total_length_ / arcs_); }

private:
    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicGraph& graph_;
    Corner first_corner_ = no_index, corner_ = no_index;
    GeodesicGraph::Row row_{0, 0};
    double total_length_ = 0;
    uint32_t arcs_ = 0;
};

// Builds a graph in slices; the mesh has adjacency. A unit is a vertex in one of seven passes or a corner, 3 to 40 ns.
class GeodesicGraphKernel {
public:
    // `positions` in place of the mesh's make another metric on the same surface. Fails with FLG_ERROR_LIMIT if there may
    // be more than 2^32 arcs.
    GeodesicGraphKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicGraph& graph,
                        Memory* memory);

    bool run(uint32_t count);

private:
    enum class Pass { order, place, rows, done };

    void fetch() const;

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicGraph& graph_;
    SpatialOrderKernel order_;
    RowWriter writer_;
    Pass pass_ = Pass::order;
    uint32_t at_ = 0;
    bool is_in_row_ = false;
};

}  // namespace flg
