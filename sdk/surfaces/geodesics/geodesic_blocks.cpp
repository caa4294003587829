// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/geodesic_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "runtime/each.h"
#include "surfaces/geodesics/intrinsic_fan.h"
#include "surfaces/geodesics/local_blocks.h"
#include "surfaces/mesh/fan_walk.h"
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

template <class Take>
void visit_edges(const GeodesicBlocks& blocks, uint32_t rank, Take take) {
    visit_blocks(blocks, rank, [&](const GeodesicBlock& block, uint32_t first_lane) {
        for (uint32_t lane = first_lane; lane < lane_count; ++lane) {
            if (block.rank(lane) != nowhere) take(block.lengths[lane]);
        }
    });
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

// Takes the vertex's edges out of the scale.
void forget(GeodesicBlocks& blocks, uint32_t rank) {
    visit_edges(blocks, rank, [&](float length) { blocks.edges.remove(length); });
}

// Makes the blocks of one vertex after the other.
class FanBuilder {
public:
    FanBuilder(const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks)
        : mesh_(mesh), positions_(positions), blocks_(blocks) {}

    // All of the vertex but the triangles' curvatures, which want its neighbours'. Its block is zero, or what was built
    // before: then the overflow it has is used again. Adds the edges opposite to obtuse angles at it to `edges`.
    void build(uint32_t rank, std::pmr::deque<Corner>* edges);
    // The lanes alone, by what writes them to a FanWriter.
    template <class Write>
    void build_lanes(uint32_t rank, Write write);
    // The triangles' curvatures.
    void finish(uint32_t rank);
    // Also those of its neighbours.
    void finish_around(uint32_t rank);

private:
    GeodesicBlock& next_block();

    const Mesh& mesh_;
    const GrowingBuffer<Position>& positions_;
    GeodesicBlocks& blocks_;
    uint32_t rank_ = nowhere;  // that is being built
    bool is_first_ = true;     // no block of it is filled yet
    // The vertex's stretch of the overflow, and how many blocks of it are filled.
    size_t overflow_begin_ = 0, overflow_size_ = 0, overflow_used_ = 0;
};

template <class Write>
void FanBuilder::build_lanes(uint32_t rank, Write write) {
    const GeodesicBlock& before = blocks_.blocks[rank];
    rank_ = rank;
    is_first_ = true;
    overflow_begin_ = before.continues() ? blocks_.overflow_of_rank[rank] : blocks_.overflow.size();
    overflow_size_ = overflow_used_ = 0;
    visit_blocks(blocks_, rank, [&](const GeodesicBlock&, uint32_t first_lane) { overflow_size_ += first_lane; });
    FanWriter writer([this]() -> GeodesicBlock& { return next_block(); });
    write(writer);
    blocks_.overflow_of_rank[rank] = static_cast<uint32_t>(overflow_begin_);
    visit_edges(blocks_, rank, [this](float length) { blocks_.edges.add(length); });
}

// In double: curvature is what remains of differences of nearly equal numbers.
void FanBuilder::build(uint32_t rank, std::pmr::deque<Corner>* edges) {
    const uint32_t vertex = blocks_.vertex_of_rank[rank];
    const Vec3 centre = load_vec3(positions_[vertex].data());
    uint32_t first = no_index, last = no_index;
    Vec3 before;
    double length_before = 0, twice_area = 0;
    float tangent = 0;
    AngleSum angle;
    build_lanes(rank, [&](auto& writer) {
        visit_fan(
            mesh_, vertex, [&](uint32_t neighbour, Corner opposite) __attribute__((always_inline)) {
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
                    if (tangent > obtuse_half_tangent && edges != nullptr) edges->push_back(opposite);
                }
                writer.add(blocks_.rank_of_vertex[neighbour], static_cast<float>(length), tangent);
                last = neighbour;
                before = edge;
                length_before = length;
            });
        writer.end();
    });
    const double lacking = 2 * std::numbers::pi - angle.value();
    blocks_.curvatures[rank] = first == last && twice_area > 0 ? static_cast<float>(6 * lacking / twice_area) : 0.0f;
}

// The stretch grows at the overflow's end: if it lies elsewhere, it moves there.
GeodesicBlock& FanBuilder::next_block() {
    if (is_first_) {
        is_first_ = false;
        return blocks_.blocks[rank_];
    }
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

void FanBuilder::finish(uint32_t rank) {
    set_curvatures(blocks_, rank, blocks_.blocks[rank]);
    if (!blocks_.blocks[rank].continues()) return;
    for (size_t i = blocks_.overflow_of_rank[rank];; ++i) {
        set_curvatures(blocks_, rank, blocks_.overflow[i]);
        if (!blocks_.overflow[i].continues()) return;
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

void give_up_group(const IntrinsicTriangles& flipped, uint32_t triangle, FlipRequest& request) {
    if (flipped.find(triangle)) request.given_up.push_back(triangle);
}

// The groups of a vertex's triangles, and the edges of these that an obtuse angle lies across from.
void request_flips_around(const Mesh& mesh, const IntrinsicTriangles& flipped, uint32_t vertex, FlipRequest& request) {
    const auto position = [&](Corner corner) { return mesh.position(mesh.vertex_at(corner)); };
    const Corner first = mesh.corner_of_vertex[vertex];
    for (Corner corner = first;;) {
        give_up_group(flipped, triangle_of(corner), request);
        if (const Corner across = mesh.opposite(next_corner(corner)); across != no_index) {
            const Vec3 apex = position(previous_corner(across)), a = position(across) - apex,
                       b = position(next_corner(across)) - apex;
            if (a.dot(b) < 0) request.edges.push_back(across);
        }
        corner = mesh.turn(corner);
        if (corner == first || corner == no_index) return;
    }
}

// Flips edges within regions, and brings the fans of the vertices around up to date, to their triangles' curvatures.
Task<void> flip_fans(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions, const RegionSet* within,
                     FlipRequest& request, GeodesicBlocks& blocks) {
    const IntrinsicSurface surface{.mesh = mesh, .positions = positions, .within = within, .flipped = &blocks.flipped};
    const std::pmr::deque<uint32_t> changed = co_await flip_edges(pace, surface, request, blocks.flipped);
    const Buffer<CornerOfVertex> corners = co_await corners_by_vertex(pace, surface, changed);
    FanBuilder fans(mesh, positions, blocks);
    IntrinsicFan fan(blocks, surface, pace.memory());
    co_await each(pace, corners.size(), Cost::microseconds, [&](uint32_t i) {
        const auto [vertex, corner] = corners[i];
        if (i > 0 && corners[i - 1].vertex == vertex) return;
        const uint32_t rank = blocks.rank_of_vertex[vertex];
        forget(blocks, rank);
        if (fan.gather(vertex, {&corner, 1})) {
            fans.build_lanes(rank, [&](auto& writer) { fan.write(writer); });
        } else {
            fans.build(rank, nullptr);
        }
        fans.finish(rank);
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

// Where there is no triangle, the edge's.
void set_curvatures(const GeodesicBlocks& blocks, uint32_t rank, GeodesicBlock& block) {
    const float own = blocks.curvatures[rank];
    float at_lane = blocks.curvatures[block.rank(0)];
    for (uint32_t lane = 0; lane < lane_count; ++lane) {
        const float at_next = lane + 1 < lane_count ? blocks.curvatures[block.rank(lane + 1)] : 0.0f;
        block.curvatures[lane] = block.tangents[lane] > 0 ? (own + at_lane + at_next) / 3 : (own + at_lane) / 2;
        at_lane = at_next;
    }
}

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
    if (fixed_mean_ > 0) return fixed_mean_;
    const float mean = count_ == 0 ? 0.0f : std::bit_cast<float>(static_cast<uint32_t>(sum_ / count_));
    return mean > 0 ? mean : 1.0f;
}

namespace {

// Without ranks so far.
GeodesicBlocks room_for_blocks(const Mesh& mesh, size_t count, Memory* memory) {
    const auto ranks = static_cast<uint32_t>(count + 1);
    GeodesicBlocks blocks(memory);
    blocks.blocks = growing_buffer<GeodesicBlock>(ranks, memory);
    blocks.overflow_of_rank = growing_buffer<uint32_t>(ranks, memory);
    blocks.curvatures = growing_buffer<float>(ranks, memory);
    blocks.vertex_of_rank = growing_buffer<uint32_t>(ranks, memory);
    blocks.rank_of_vertex = growing_buffer<uint32_t>(mesh.vertex_count() + 1, memory);
    blocks.rank_of_vertex.resize(mesh.vertex_count());
    blocks.blocks[nowhere] = {};
    blocks.curvatures[nowhere] = 0;
    blocks.vertex_of_rank[nowhere] = no_index;
    blocks.triangle_count = mesh.triangle_count();
    return blocks;
}

// The blocks of those of `count` ranks that have a fan.
template <class HasFan>
Task<void> build_fans(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions, const RegionSet* within,
                      uint32_t count, HasFan has_fan, GeodesicBlocks& blocks) {
    FanBuilder fans(mesh, positions, blocks);
    FlipRequest request(pace.memory());
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        if (i % fans_fetched == 0) {
            const uint32_t* vertex_of_rank = &blocks.vertex_of_rank[i + 1];
            fetch(
                mesh, positions, blocks, [=](uint32_t k) { return vertex_of_rank[k]; }, count - i);
        }
        if (has_fan(i)) {
            blocks.blocks[i + 1].lanes[lane_count - 1] = nowhere;
            fans.build(i + 1, &request.edges);
        } else {
            blocks.blocks[i + 1] = {};
            blocks.curvatures[i + 1] = 0;
        }
    });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (has_fan(i)) fans.finish(i + 1);
    });
    co_await flip_fans(pace, mesh, positions, within, request, blocks);
}

}  // namespace

Task<GeodesicBlocks> make_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions) {
    const uint32_t vertices = mesh.vertex_count();
    GeodesicBlocks blocks = room_for_blocks(mesh, vertices, pace.memory());
    {
        const SpatialOrder order = co_await spatial_order(pace, positions);
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t i) {
            blocks.vertex_of_rank[i + 1] = order.vertex_at(i);
            blocks.rank_of_vertex[order.vertex_at(i)] = i + 1;
        });
    }
    co_await build_fans(
        pace, mesh, positions, nullptr, vertices, [](uint32_t) { return true; }, blocks);
    co_return blocks;
}

Task<GeodesicBlocks> make_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                 const Buffer<BlockVertex>& vertices, const RegionSet& regions) {
    GeodesicBlocks blocks = room_for_blocks(mesh, vertices.size(), pace.memory());
    co_await each(pace, vertices.size(), Cost::tens_of_ns, [&](uint32_t i) {
        blocks.vertex_of_rank[i + 1] = vertices[i].vertex;
        blocks.rank_of_vertex[vertices[i].vertex] = i + 1;
    });
    co_await build_fans(
        pace, mesh, positions, &regions, static_cast<uint32_t>(vertices.size()),
        [&](uint32_t i) { return vertices[i].has_fan; }, blocks);
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
    FlipRequest request(pace.memory());
    co_await each(pace, mesh.triangle_count(), std::max(blocks.triangle_count, mesh.triangle_count()), Cost::some_ns,
                  [&](uint32_t triangle) { give_up_group(blocks.flipped, triangle, request); });
    blocks.triangle_count = mesh.triangle_count();
    const auto rebuild = [&](uint32_t rank) {
        fans.build(rank, &request.edges);
        request_flips_around(mesh, blocks.flipped, blocks.vertex_of_rank[rank], request);
    };
    co_await each(pace, touched.size(), Cost::microseconds, [&](uint32_t i) {
        if (const uint32_t rank = old_rank(i); rank != nowhere) rebuild(rank);
    });
    co_await each(pace, added, Cost::microseconds, [&](uint32_t i) { rebuild(blocks.rank_of_vertex[before + i]); });
    co_await flip_fans(pace, mesh, mesh.positions, nullptr, request, blocks);
    co_await each(pace, touched.size(), Cost::microseconds, [&](uint32_t i) {
        if (const uint32_t rank = old_rank(i); rank != nowhere) fans.finish_around(rank);
    });
    co_await each(pace, added, Cost::microseconds,
                  [&](uint32_t i) { fans.finish_around(blocks.rank_of_vertex[before + i]); });
}

}  // namespace flg
