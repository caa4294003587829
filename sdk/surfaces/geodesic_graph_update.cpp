// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_graph_update.h"

#include <algorithm>
#include <cstring>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t corners_at_a_time = 16;
constexpr uint32_t moved_at_a_time = 256;

}  // namespace

GeodesicGraphUpdateKernel::GeodesicGraphUpdateKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                                     const TouchedVertices& touched, GeodesicGraph& graph,
                                                     Memory* memory)
    : mesh_(mesh),
      touched_(touched),
      graph_(graph),
      memory_(memory),
      writer_(mesh, positions, graph),
      before_(graph.node_count()),
      after_(mesh.vertex_count()) {}

bool GeodesicGraphUpdateKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        bool is_over = false;
        switch (pass_) {
            // Of vertices that were taken back: their nodes are the last ones.
            case Pass::shrink:
                if (after_ + at_ < before_) graph_.arcs_in_use -= row_capacity(graph_.rows[after_ + at_++].count);
                is_over = after_ + at_ >= before_;
                break;
            case Pass::grow: is_over = grow(); break;
            case Pass::rows:
                if (row_pass_ == RowPass::begin) vertex_ = vertex_to_update();
                is_over = vertex_ == no_index;
                if (!is_over && make_row()) ++at_;
                break;
            case Pass::done: break;
        }
        if (!is_over) continue;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

// Room for the rows of added vertices, and a quarter more.
bool GeodesicGraphUpdateKernel::grow() {
    if (!growing_ && graph_.rows.capacity() < after_) {
        graph_.rows.begin_growth(size_t{after_} + after_ / 4);
        growing_ = true;
    }
    if (growing_ && !graph_.rows.grow(moved_at_a_time)) return false;
    graph_.rows.resize(after_);
    return true;
}

uint32_t GeodesicGraphUpdateKernel::vertex_to_update() const {
    size_t i = at_;
    if (i < touched_.changed.size()) return touched_.changed[i];
    i -= touched_.changed.size();
    if (i < touched_.facing.size()) return touched_.facing[i];
    i -= touched_.facing.size();
    return before_ + i < after_ ? static_cast<uint32_t>(before_ + i) : no_index;
}

// Advances the row of the vertex; true when it is in place.
bool GeodesicGraphUpdateKernel::make_row() {
    switch (row_pass_) {
        case RowPass::begin:
            corner_ = mesh_.corner_of_vertex[vertex_];
            corners_ = 0;
            row_pass_ = RowPass::count;
            [[fallthrough]];
        case RowPass::count:
            for (uint32_t i = 0; i < corners_at_a_time && row_pass_ == RowPass::count; ++i) {
                ++corners_;
                corner_ = mesh_.turn(corner_);
                if (corner_ == no_index || corner_ == mesh_.corner_of_vertex[vertex_]) row_pass_ = RowPass::make_room;
            }
            return false;
        case RowPass::make_room:
            if (!make_room()) return false;
            writer_.begin(vertex_, graph_.arcs_end);
            row_pass_ = RowPass::write;
            return false;
        case RowPass::write:
            if (!writer_.run(corners_at_a_time)) return false;
            keep_row();
            row_pass_ = RowPass::begin;
            return true;
    }
    return true;
}

// Rows are written at the end. When that has no room they all move to an array with room for as many again as a quarter.
bool GeodesicGraphUpdateKernel::make_room() {
    const uint64_t needed = row_room(corners_, 1);
    if (moved_.empty()) {
        if (graph_.arcs_end + needed <= graph_.arcs.size()) return true;
        const uint64_t room = graph_.arcs_in_use + graph_.arcs_in_use / 4 + needed;
        if (room > UINT32_MAX) {
            throw Failure(FLG_ERROR_LIMIT, "the geodesic graph of %u vertices may have more than 2^32 arcs", after_);
        }
        moved_ = Buffer<GraphArc>(room, memory_);
        moved_end_ = node_ = arc_ = 0;
    }
    // Nodes that were added have no rows yet from the one on that is made first.
    const uint32_t nodes = std::min(graph_.node_count(), std::max(before_, vertex_));
    if (node_ < nodes) {
        GeodesicGraph::Row& row = graph_.rows[node_];
        const uint32_t count = std::min(row.count - arc_, moved_at_a_time);
        const GraphArc* from = graph_.arcs.data() + row.first + arc_;
        if (count != 0) std::memcpy(moved_.data() + moved_end_ + arc_, from, count * sizeof(GraphArc));
        arc_ += count;
        if (arc_ == row.count) {
            row.first = moved_end_;
            moved_end_ += row_capacity(row.count);
            arc_ = 0;
            ++node_;
        }
        return false;
    }
    std::swap(graph_.arcs, moved_);
    moved_ = {};
    graph_.arcs_end = moved_end_;
    return true;
}

// In its old place, if it has room there; else where it was written.
void GeodesicGraphUpdateKernel::keep_row() {
    const uint32_t node = graph_.node_of(vertex_);
    GeodesicGraph::Row row = writer_.row();
    const bool is_added = vertex_ >= before_;
    const uint32_t old_room = is_added ? 0 : row_capacity(graph_.rows[node].count), room = row_capacity(row.count);
    if (room <= old_room) {
        std::memcpy(graph_.arcs.data() + graph_.rows[node].first, graph_.arcs.data() + row.first,
                    row.count * sizeof(GraphArc));
        row.first = graph_.rows[node].first;
    } else {
        graph_.arcs_end += room;
    }
    graph_.arcs_in_use += room - old_room;
    graph_.rows[node] = row;
}

}  // namespace flg
