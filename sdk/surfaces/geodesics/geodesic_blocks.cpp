// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/geodesic_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "runtime/each.h"
#include "surfaces/mesh/fan_walk.h"
#include "surfaces/mesh/region_cursor.h"
#include "surfaces/mesh/spatial_order.h"

namespace flg {

namespace {

constexpr double tangent_max = 1e6;  // of angles near a half turn

// Room for cuts to come, so that not every one has to move the arrays.
uint32_t with_slack(uint32_t size) {
    return size + size / 16 + 256;
}

template <class T>
GrowingBuffer<T> growing_buffer(uint32_t size, Memory* memory) {
    GrowingBuffer<T> buffer(with_slack(size), memory);
    buffer.resize(size);
    return buffer;
}

// Angles below a half turn added up without their values: as a point on the unit circle, and how often it has passed
// half a turn.
class AngleSum {
public:
    void add(double cosine, double sine) {
        const double next = sine_ * cosine + cosine_ * sine;
        cosine_ = cosine_ * cosine - sine_ * sine;
        half_turns_ += (next < 0) != (sine_ < 0);
        sine_ = next;
    }
    double value() const {
        const double side = half_turns_ % 2 == 0 ? 1 : -1;
        return std::numbers::pi * half_turns_ + std::atan2(side * sine_, side * cosine_);
    }

private:
    double cosine_ = 1, sine_ = 0;
    uint32_t half_turns_ = 0;
};

// Makes the blocks of one vertex after the other.
class FanBuilder {
public:
    FanBuilder(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks)
        : mesh_(mesh), positions_(positions), blocks_(blocks) {}

    // All of the vertex but the triangles' curvatures, which want its neighbours'. Its block is zero, or what was built
    // before: then the overflow it has is used again.
    void build(uint32_t rank);
    // The triangles' curvatures.
    void finish(uint32_t rank);
    // Also those of its neighbours.
    void finish_around(uint32_t rank);

private:
    void add(uint32_t neighbour, float length, float tangent);
    GeodesicBlock& next_block();
    void finish(float own, GeodesicBlock& block);

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicBlocks& blocks_;
    GeodesicBlock* block_ = nullptr;  // that is being filled
    uint32_t used_ = 0;               // lanes of it
    // The vertex's stretch of the overflow, and how many blocks of it are filled.
    size_t overflow_begin_ = 0, overflow_size_ = 0, overflow_used_ = 0;
};

// In double: curvature is what remains of differences of nearly equal numbers.
void FanBuilder::build(uint32_t rank) {
    block_ = &blocks_.blocks[rank];
    overflow_begin_ = block_->continues() ? blocks_.overflow_of_rank[rank] : blocks_.overflow.size();
    overflow_size_ = overflow_used_ = 0;
    visit_blocks(blocks_, rank, [&](const GeodesicBlock&, uint32_t first_lane) { overflow_size_ += first_lane; });
    used_ = 0;
    const uint32_t vertex = blocks_.vertex_of_rank[rank];
    const Vec3 centre = load_vec3(positions_[vertex].data());
    uint32_t first = no_index, last = no_index;
    Vec3 before;
    double length_before = 0, twice_area = 0;
    float tangent = 0;
    AngleSum angle;
    visit_fan(
        mesh_, vertex, [&](uint32_t neighbour) __attribute__((always_inline)) {
            const Vec3 edge = load_vec3(positions_[neighbour].data()) - centre;
            const double length = edge.norm();
            if (last == no_index) {
                first = neighbour;
            } else {
                const double dot = before.dot(edge), cross = before.cross(edge).norm(),
                             product = length * length_before;
                if (product > 0) angle.add(dot / product, cross / product);
                twice_area += cross;
                tangent = cross > 0 ? static_cast<float>(std::min(cross / (product + dot), tangent_max)) : 0.0f;
            }
            add(blocks_.rank_of_vertex[neighbour], static_cast<float>(length), tangent);
            last = neighbour;
            before = edge;
            length_before = length;
        });
    for (uint32_t lane = used_; lane < lane_count; ++lane) {
        block_->lanes[lane] = nowhere;
        block_->lengths[lane] = no_length;
    }
    std::fill(block_->tangents.begin() + used_ - 1, block_->tangents.end(), 0.0f);
    blocks_.overflow_of_rank[rank] = static_cast<uint32_t>(overflow_begin_);
    const double lacking = 2 * std::numbers::pi - angle.value();
    blocks_.curvatures[rank] = first == last && twice_area > 0 ? static_cast<float>(6 * lacking / twice_area) : 0.0f;
}

// The stretch grows at the overflow's end: if it lies elsewhere, it moves there.
GeodesicBlock& FanBuilder::next_block() {
    auto& overflow = blocks_.overflow;
    if (overflow_used_ == overflow_size_) {
        if (overflow_begin_ + overflow_size_ != overflow.size()) {
            const size_t begin = overflow.size();
            for (size_t i = 0; i < overflow_used_; ++i) overflow.push_back(overflow[overflow_begin_ + i]);
            overflow_begin_ = begin;
        }
        overflow.emplace_back();
        ++overflow_size_;
    }
    return overflow[overflow_begin_ + overflow_used_++];
}

// `tangent` is that of the triangle before the neighbour.
void FanBuilder::add(uint32_t neighbour, float length, float tangent) {
    if (used_ == lane_count) {
        const uint32_t shared = block_->lanes[lane_count - 1];
        const float shared_length = block_->lengths[lane_count - 1];
        block_->lanes[lane_count - 1] |= block_continues;
        block_->tangents[lane_count - 1] = 0;
        block_ = &next_block();
        block_->lanes[0] = shared;
        block_->lengths[0] = shared_length;
        used_ = 1;
    }
    if (used_ > 0) block_->tangents[used_ - 1] = tangent;
    block_->lanes[used_] = neighbour;
    block_->lengths[used_++] = length;
    blocks_.edges.add(length);
}

void FanBuilder::finish(uint32_t rank) {
    const float own = blocks_.curvatures[rank];
    finish(own, blocks_.blocks[rank]);
    if (!blocks_.blocks[rank].continues()) return;
    for (size_t i = blocks_.overflow_of_rank[rank];; ++i) {
        finish(own, blocks_.overflow[i]);
        if (!blocks_.overflow[i].continues()) return;
    }
}

// Where there is no triangle, the edge's.
void FanBuilder::finish(float own, GeodesicBlock& block) {
    float at_lane = blocks_.curvatures[block.rank(0)];
    for (uint32_t lane = 0; lane < lane_count; ++lane) {
        const float at_next = lane + 1 < lane_count ? blocks_.curvatures[block.rank(lane + 1)] : 0.0f;
        block.curvatures[lane] = block.tangents[lane] > 0 ? (own + at_lane + at_next) / 3 : (own + at_lane) / 2;
        at_lane = at_next;
    }
}

void FanBuilder::finish_around(uint32_t rank) {
    finish(rank);
    visit_blocks(blocks_, rank, [&](const GeodesicBlock& block, uint32_t) {
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            if (block.rank(lane) != nowhere) finish(block.rank(lane));
        }
    });
}

// Takes the vertex's edges out of the scale.
void forget(GeodesicBlocks& blocks, uint32_t rank) {
    visit_blocks(blocks, rank, [&](const GeodesicBlock& block, uint32_t first_lane) {
        for (uint32_t lane = first_lane; lane < lane_count; ++lane) {
            if (block.rank(lane) != nowhere) blocks.edges.remove(block.lengths[lane]);
        }
    });
}

// What the fans to come will read.
template <class VertexAt>
[[gnu::always_inline]] inline void fetch(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                         const GeodesicBlocks& blocks, VertexAt vertex_at, uint32_t count) {
    fetch_fans(
        mesh, vertex_at, count, [&](uint32_t vertex) __attribute__((always_inline)) {
            __builtin_prefetch(&positions[vertex]);
            __builtin_prefetch(&blocks.rank_of_vertex[vertex]);
        });
}

template <class T>
Task<void> move_over(Pace& pace, GrowingBuffer<T>& array) {
    constexpr size_t moved = 16'384 / sizeof(T);  // a few us
    while (!array.grow(moved)) co_await pace;
}

// All of the larger arrays, or none: then there is no memory.
Task<void> make_room(Pace& pace, GeodesicBlocks& blocks, size_t ranks) {
    if (ranks <= blocks.blocks.capacity()) co_return;
    const size_t room = ranks + ranks / 8;
    blocks.blocks.begin_growth(room);
    blocks.overflow_of_rank.begin_growth(room);
    blocks.curvatures.begin_growth(room);
    blocks.vertex_of_rank.begin_growth(room);
    blocks.rank_of_vertex.begin_growth(room);
    co_await move_over(pace, blocks.blocks);
    co_await move_over(pace, blocks.overflow_of_rank);
    co_await move_over(pace, blocks.curvatures);
    co_await move_over(pace, blocks.vertex_of_rank);
    co_await move_over(pace, blocks.rank_of_vertex);
}

}  // namespace

void EdgeScale::add(float length) {
    sum_ += std::bit_cast<uint32_t>(length);
    ++count_;
    longest_ = std::max(longest_, length);
}

void EdgeScale::remove(float length) {
    sum_ -= std::bit_cast<uint32_t>(length);
    --count_;
}

float EdgeScale::mean() const {
    const float mean = count_ == 0 ? 0.0f : std::bit_cast<float>(static_cast<uint32_t>(sum_ / count_));
    return mean > 0 ? mean : 1.0f;
}

Task<GeodesicBlocks> make_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions) {
    const uint32_t vertices = mesh.vertex_count();
    Memory* memory = pace.memory();
    GeodesicBlocks blocks(memory);
    blocks.blocks = growing_buffer<GeodesicBlock>(vertices + 1, memory);
    blocks.overflow_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.curvatures = growing_buffer<float>(vertices + 1, memory);
    blocks.vertex_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.rank_of_vertex = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.rank_of_vertex.resize(vertices);
    blocks.blocks[nowhere] = {};
    blocks.curvatures[nowhere] = 0;
    blocks.vertex_of_rank[nowhere] = no_index;

    {
        const SpatialOrder order = co_await spatial_order(pace, positions);
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t i) {
            blocks.vertex_of_rank[i + 1] = order.vertex_at(i);
            blocks.rank_of_vertex[order.vertex_at(i)] = i + 1;
        });
    }
    FanBuilder fans(mesh, positions, blocks);
    co_await each(pace, vertices, Cost::hundreds_of_ns, [&](uint32_t i) {
        if (i % fans_fetched == 0) {
            const uint32_t* vertex_of_rank = &blocks.vertex_of_rank[i + 1];
            fetch(
                mesh, positions, blocks, [=](uint32_t k) { return vertex_of_rank[k]; }, vertices - i);
        }
        blocks.blocks[i + 1].lanes[lane_count - 1] = nowhere;
        fans.build(i + 1);
    });
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t i) { fans.finish(i + 1); });
    co_return blocks;
}

Task<void> update_blocks(Pace& pace, const Mesh& mesh, const std::pmr::deque<uint32_t>& touched,
                         GeodesicBlocks& blocks) {
    FanBuilder fans(mesh, mesh.positions, blocks);
    const uint32_t before = blocks.vertex_count(), after = mesh.vertex_count();
    const uint32_t removed = before - std::min(before, after), added = after - std::min(before, after);
    co_await make_room(pace, blocks, blocks.blocks.size() + added);
    co_await each(pace, removed, Cost::hundreds_of_ns, [&](uint32_t i) {
        const uint32_t vertex = before - 1 - i, rank = blocks.rank_of_vertex[vertex];
        forget(blocks, rank);
        blocks.blocks[rank] = {};
        blocks.vertex_of_rank[rank] = no_index;
        blocks.rank_of_vertex.resize(vertex);
    });
    co_await each(pace, added, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t rank = blocks.rank_count();
        blocks.blocks.resize(rank + 1);
        blocks.blocks[rank] = {};
        blocks.overflow_of_rank.push_back(no_index);
        blocks.curvatures.push_back(0);
        blocks.vertex_of_rank.push_back(before + i);
        blocks.rank_of_vertex.push_back(rank);
    });
    const auto old_rank = [&](uint32_t i) { return touched[i] < before ? blocks.rank_of_vertex[touched[i]] : nowhere; };
    co_await each(pace, touched.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (const uint32_t rank = old_rank(i); rank != nowhere) forget(blocks, rank);
    });
    co_await each(pace, touched.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (const uint32_t rank = old_rank(i); rank != nowhere) fans.build(rank);
    });
    co_await each(pace, added, Cost::hundreds_of_ns,
                  [&](uint32_t i) { fans.build(blocks.rank_of_vertex[before + i]); });
    co_await each(pace, touched.size(), Cost::microseconds, [&](uint32_t i) {
        if (const uint32_t rank = old_rank(i); rank != nowhere) fans.finish_around(rank);
    });
    co_await each(pace, added, Cost::microseconds,
                  [&](uint32_t i) { fans.finish_around(blocks.rank_of_vertex[before + i]); });
}

// The triangles between lanes are in the order of the fan's corners. Lanes of no triangle inside are closed themselves.
void GeodesicRegion::close(const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within, uint32_t vertex) {
    const uint32_t rank = blocks.rank_of_vertex[vertex];
    if (find(rank) != nullptr) return;
    uint32_t slot = slot_of(rank);
    while (slots_[slot & mask_].rank != nowhere) ++slot;
    slots_[slot & mask_] = {rank, static_cast<uint32_t>(blocks_.size())};

    Corner corner = mesh.corner_of_vertex[vertex];
    visit_blocks(blocks, rank, [&](const GeodesicBlock& block, uint32_t) {
        GeodesicBlock& closed = blocks_.emplace_back(block);
        bool before = false;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            const bool has_triangle = lane + 1 < lane_count && block.rank(lane + 1) != nowhere;
            const bool inside = has_triangle && within.contains(mesh.regions[triangle_of(corner)]);
            if (!inside) closed.tangents[lane] = 0;
            if (!inside && !before) closed.close(lane);
            before = inside;
            if (has_triangle) corner = mesh.turn(corner);
        }
    });
}

Task<GeodesicRegion> bound_region(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within) {
    GeodesicRegion region(pace.memory());
    if (within.all()) co_return region;
    // A fan that is partly outside has an edge between its inner and outer triangles.
    std::pmr::deque<uint32_t> ends(pace.memory());  // some more than once
    RegionCursor cursor(mesh, within);
    const auto find_ends = [&](uint32_t triangle) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t neighbour = mesh.neighbours[triangle][k];
            if (neighbour == no_index || within.contains(mesh.regions[neighbour])) continue;
            ends.push_back(mesh.triangles[triangle][k]);
            ends.push_back(mesh.triangles[triangle][(k + 1) % 3]);
        }
    };
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (const uint32_t triangle = cursor.next(); triangle != no_index) find_ends(triangle);
        return !cursor.at_end();
    });
    if (ends.empty()) co_return region;
    region.slots_ = Buffer<GeodesicRegion::Slot>(std::bit_ceil(2 * ends.size()), pace.memory());
    region.mask_ = static_cast<uint32_t>(region.slots_.size()) - 1;
    co_await each(pace, region.slots_.size(), Cost::some_ns, [&](uint32_t i) { region.slots_[i] = {nowhere, 0}; });
    co_await each(pace, ends.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { region.close(mesh, blocks, within, ends[i]); });
    co_return region;
}

}  // namespace flg
