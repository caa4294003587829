// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/geodesic_region.h"

#include <algorithm>

#include "runtime/each.h"
#include "surfaces/geodesics/intrinsic_fan.h"
#include "surfaces/mesh/fan_walk.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

class RegionBuilder {
public:
    RegionBuilder(const Mesh& mesh, const GrowingBuffer<Position>& positions, const GeodesicBlocks& blocks,
                  const RegionSet& within, Memory* memory)
        : mesh_(mesh),
          blocks_(blocks),
          ends_(memory),
          flipped_(memory),
          region_(memory),
          surface_{mesh, positions, &within, &flipped_, &blocks.flipped},
          fan_(blocks, surface_, memory),
          corners_(memory) {}

    static Task<GeodesicRegion> build(Pace& pace, RegionBuilder& builder);

private:
    void find_ends(uint32_t triangle);
    static Task<void> list_groups(Pace& pace, RegionBuilder& builder, std::pmr::deque<uint32_t>& triangles);
    static Task<void> flip_anew(Pace& pace, RegionBuilder& builder);
    void build_from_corners(uint32_t vertex);
    void close(uint32_t vertex);
    template <class Visit>
    void visit_corners(uint32_t vertex, Visit visit) const;

    const Mesh& mesh_;
    const GeodesicBlocks& blocks_;
    std::pmr::deque<uint32_t> ends_;  // vertices where the regions end, some more than once
    IntrinsicTriangles flipped_;      // within the regions, of groups that reach their ends
    GeodesicRegion region_;
    const IntrinsicSurface surface_;
    IntrinsicFan fan_;
    std::pmr::vector<Corner> corners_;  // of the vertex at hand, within the regions
};

void RegionBuilder::find_ends(uint32_t triangle) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t neighbour = mesh_.neighbours[triangle][k];
        if (neighbour == no_index || surface_.contains(neighbour)) continue;
        ends_.push_back(mesh_.triangles[triangle][k]);
        ends_.push_back(mesh_.triangles[triangle][following_corner(k)]);
    }
}

template <class Visit>
void RegionBuilder::visit_corners(uint32_t vertex, Visit visit) const {
    const Corner first = mesh_.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        visit(corner);
        corner = mesh_.turn(corner);
    } while (corner != first && corner != no_index);
}

// The triangles of the regions whose groups reach their ends.
Task<void> RegionBuilder::list_groups(Pace& pace, RegionBuilder& builder, std::pmr::deque<uint32_t>& triangles) {
    const IntrinsicTriangles& flipped = builder.blocks_.flipped;
    if (flipped.empty()) co_return;
    IndexTable listed;
    std::pmr::deque<uint32_t> found(pace.memory());
    co_await each(pace, builder.ends_.size(), Cost::microseconds, [&](uint32_t i) {
        builder.visit_corners(builder.ends_[i], [&](Corner corner) {
            if (flipped.find(triangle_of(corner))) found.push_back(triangle_of(corner));
        });
    });
    Slice slice(Cost::tens_of_ns);
    for (const uint32_t first : found) {
        for (uint32_t at = first; listed.find(at) == no_index; at = flipped.next_of_group(at)) {
            if (!listed.has_room(1)) co_await IndexTable::reserve(pace, listed, 1);
            listed.insert(at, 0);
            if (builder.surface_.contains(at)) triangles.push_back(at);
            if (slice.is_over()) co_await pace;
        }
    }
}

Task<void> RegionBuilder::flip_anew(Pace& pace, RegionBuilder& builder) {
    FlipRequest request(pace.memory());
    co_await list_groups(pace, builder, request.restored);
    if (request.restored.empty()) co_return;
    const IntrinsicSurface& surface = builder.surface_;
    const std::pmr::deque<uint32_t> changed = co_await flip_edges(pace, surface, request, builder.flipped_);
    const Buffer<CornerOfVertex> corners = co_await corners_by_vertex(pace, surface, changed);
    co_await IndexTable::reserve(pace, builder.region_.first_of_rank_, corners.size() + builder.ends_.size());
    co_await each(pace, corners.size(), Cost::microseconds, [&](uint32_t i) {
        const uint32_t vertex = corners[i].vertex;
        builder.corners_.push_back(corners[i].corner);
        if (i + 1 < corners.size() && corners[i + 1].vertex == vertex) return;
        builder.visit_corners(vertex, [&](Corner corner) {
            const uint32_t triangle = triangle_of(corner);
            if (surface.contains(triangle) && !surface.find(triangle)) builder.corners_.push_back(corner);
        });
        builder.build_from_corners(vertex);
    });
}

void RegionBuilder::build_from_corners(uint32_t vertex) {
    const uint32_t rank = blocks_.rank_of_vertex[vertex];
    fan_.gather(vertex, corners_);
    corners_.clear();
    const size_t first = region_.blocks_.size();
    FanWriter writer([&]() -> GeodesicBlock& { return region_.blocks_.emplace_back(); });
    fan_.write(writer);
    region_.first_of_rank_.insert(rank, static_cast<uint32_t>(first));
    for (size_t at = first; at < region_.blocks_.size(); ++at) {
        set_curvatures(blocks_, rank, region_.blocks_[at]);
        region_.longest_edge_ = std::max(region_.longest_edge_, region_.blocks_[at].longest_edge());
    }
}

// The triangles between lanes are in the order of the fan's corners, unless one of them is flipped: outside, since what
// was flipped within is built. Lanes of no triangle inside are closed themselves.
void RegionBuilder::close(uint32_t vertex) {
    const uint32_t rank = blocks_.rank_of_vertex[vertex];
    if (region_.find(rank) != nullptr) return;
    bool is_flipped = false;
    visit_corners(vertex, [&](Corner corner) {
        is_flipped = is_flipped || blocks_.flipped.find(triangle_of(corner)) != nullptr;
        if (surface_.contains(triangle_of(corner))) corners_.push_back(corner);
    });
    if (is_flipped) {
        build_from_corners(vertex);
        return;
    }
    corners_.clear();
    region_.first_of_rank_.insert(rank, static_cast<uint32_t>(region_.blocks_.size()));
    Corner corner = mesh_.corner_of_vertex[vertex];
    visit_blocks(blocks_, rank, [&](const GeodesicBlock& block, uint32_t) {
        GeodesicBlock& closed = region_.blocks_.emplace_back(block);
        bool before = false;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            const bool has_triangle = lane + 1 < lane_count && block.rank(lane + 1) != nowhere;
            const bool inside = has_triangle && surface_.contains(triangle_of(corner));
            if (!inside) closed.tangents[lane] = 0;
            if (!inside && !before) closed.close(lane);
            before = inside;
            if (has_triangle) corner = mesh_.turn(corner);
        }
    });
}

// A fan that is partly outside has an edge between its inner and outer triangles.
Task<GeodesicRegion> RegionBuilder::build(Pace& pace, RegionBuilder& builder) {
    RegionCursor cursor(builder.mesh_, *builder.surface_.within);
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (const uint32_t triangle = cursor.next(); triangle != no_index) builder.find_ends(triangle);
        return !cursor.at_end();
    });
    co_await flip_anew(pace, builder);
    co_await IndexTable::reserve(pace, builder.region_.first_of_rank_, builder.ends_.size());
    co_await each(pace, builder.ends_.size(), Cost::microseconds, [&](uint32_t i) { builder.close(builder.ends_[i]); });
    co_return std::move(builder.region_);
}

Task<GeodesicRegion> bound_region(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                  const GeodesicBlocks& blocks, const RegionSet& within) {
    if (within.all()) co_return GeodesicRegion(pace.memory());
    RegionBuilder builder(mesh, positions, blocks, within, pace.memory());
    co_return co_await RegionBuilder::build(pace, builder);
}

}  // namespace flg
