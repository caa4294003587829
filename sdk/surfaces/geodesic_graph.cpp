// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_graph.h"

#include <algorithm>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t corners_at_a_time = 16;
constexpr uint32_t fetch_ahead = 16;  // vertices

}  // namespace

float GeodesicGraph::bucket_width() const {
    // A few long arcs do not ask for a ring without end.
    const float width = std::max(2 * mean_length, longest / 4000);
    return width > 1e-30f ? width : 1;
}

bool RowWriter::run(uint32_t corners) {
    const uint32_t first = row_.first + row_.count;
    GraphArc* end = graph_.arcs.data() + first;
    for (; corners > 0 && corner_ != no_index; --corners) {
        const Corner next = mesh_.turn(corner_);
        visit_arcs(
            mesh_, positions_, corner_, next, [](uint32_t) { return true; },
            [&](uint32_t vertex, float length) {
                *end++ = {graph_.node_of(vertex), length};
            });
        corner_ = next == first_corner_ ? no_index : next;
    }
    const uint32_t count = static_cast<uint32_t>(end - graph_.arcs.data()) - first;
    for (uint32_t i = first; i < first + count; ++i) {
        const float length = graph_.arcs[i].length;
        if (length == std::numeric_limits<float>::infinity()) continue;  // no path can take it
        graph_.longest = std::max(graph_.longest, length);
        total_length_ += length;
    }
    arcs_ += count;
    row_.count += count;
    return corner_ == no_index;
}

GeodesicGraphKernel::GeodesicGraphKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                         GeodesicGraph& graph, Memory* memory)
    : mesh_(mesh), positions_(positions), graph_(graph), order_(positions, memory), writer_(mesh, positions, graph) {
    const uint32_t vertices = mesh.vertex_count();
    const uint64_t room = row_room(3ull * mesh.triangle_count(), vertices);
    if (room > UINT32_MAX) {
        throw Failure(FLG_ERROR_LIMIT, "the surface has %u triangles: its geodesic graph may have more than 2^32 arcs",
                      mesh.triangle_count());
    }
    graph.rows = GrowingBuffer<GeodesicGraph::Row>(vertices, memory);
    graph.arcs = Buffer<GraphArc>(room, memory);
    graph.nodes = Buffer<uint32_t>(vertices, memory);
    graph.vertices = Buffer<uint32_t>(vertices, memory);
    graph.arcs_end = graph.arcs_in_use = 0;
    graph.longest = graph.mean_length = 0;
    if (vertices == 0) pass_ = Pass::done;
}

// What the rows to come begin with.
void GeodesicGraphKernel::fetch() const {
    if (graph_.node_count() - at_ <= fetch_ahead) return;
    const uint32_t vertex = graph_.vertices[at_ + fetch_ahead], sooner = graph_.vertices[at_ + fetch_ahead / 2];
    __builtin_prefetch(&mesh_.corner_of_vertex[vertex]);
    __builtin_prefetch(&positions_[vertex]);
    const uint32_t triangle = triangle_of(mesh_.corner_of_vertex[sooner]);
    __builtin_prefetch(&mesh_.triangles[triangle]);
    __builtin_prefetch(&mesh_.neighbours[triangle]);
}

bool GeodesicGraphKernel::run(uint32_t count) {
    const uint32_t vertices = graph_.node_count();
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::order:
                if (!order_.run(4)) continue;
                at_ = vertices;
                break;
            case Pass::place:
                graph_.vertices[at_] = order_.vertex_at(at_);
                graph_.nodes[order_.vertex_at(at_)] = at_;
                ++at_;
                break;
            case Pass::rows:
                fetch();
                if (!is_in_row_) writer_.begin(graph_.vertices[at_], graph_.arcs_end);
                is_in_row_ = !writer_.run(corners_at_a_time);
                if (is_in_row_) continue;
                graph_.rows[at_++] = writer_.row();
                graph_.arcs_end += row_capacity(writer_.row().count);
                break;
            case Pass::done: break;
        }
        if (at_ < vertices) continue;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    if (pass_ == Pass::done) {
        graph_.arcs_in_use = graph_.arcs_end;
        graph_.mean_length = writer_.mean_length();
    }
    return pass_ == Pass::done;
}

}  // namespace flg
