// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

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

void AngleSum::add(double cosine, double sine) {
    const double next = sine_ * cosine + cosine_ * sine;
    cosine_ = cosine_ * cosine - sine_ * sine;
    half_turns_ += (next < 0) != (sine_ < 0);
    sine_ = next;
}

double AngleSum::value() const {
    const double side = half_turns_ % 2 == 0 ? 1 : -1;
    return std::numbers::pi * half_turns_ + std::atan2(side * sine_, side * cosine_);
}

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
    visit_fan(mesh_, vertex, [&](uint32_t neighbour) {
        const Vec3 edge = load_vec3(positions_[neighbour].data()) - centre;
        const double length = edge.norm();
        if (last == no_index) {
            first = neighbour;
        } else {
            const double dot = before.dot(edge), cross = before.cross(edge).norm(), product = length * length_before;
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

GeodesicBlocksKernel::GeodesicBlocksKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                           GeodesicBlocks& blocks, Memory* memory)
    : mesh_(mesh), positions_(positions), blocks_(blocks), fans_(mesh, positions, blocks), order_(positions, memory) {
    const uint32_t vertices = mesh.vertex_count();
    blocks.blocks = growing_buffer<GeodesicBlock>(vertices + 1, memory);
    blocks.overflow_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.curvatures = growing_buffer<float>(vertices + 1, memory);
    blocks.vertex_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.rank_of_vertex = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.rank_of_vertex.resize(vertices);
    blocks.overflow.clear();
    blocks.edges = {};
    blocks.blocks[nowhere] = {};
    blocks.curvatures[nowhere] = 0;
    blocks.vertex_of_rank[nowhere] = no_index;
    if (vertices == 0) pass_ = Pass::done;
}

void GeodesicBlocksKernel::place(uint32_t i) {
    const uint32_t vertex = order_.vertex_at(i), rank = i + 1;
    blocks_.vertex_of_rank[rank] = vertex;
    blocks_.rank_of_vertex[vertex] = rank;
}

// What the fans to come will read.
[[gnu::always_inline]] inline void GeodesicBlocksKernel::fetch() const {
    fetch_fans(
        mesh_, [this](uint32_t i) { return order_.vertex_at(at_ + i); }, mesh_.vertex_count() - at_,
        [this](uint32_t vertex) __attribute__((always_inline)) {
            __builtin_prefetch(&positions_[vertex]);
            __builtin_prefetch(&blocks_.rank_of_vertex[vertex]);
        });
}

bool GeodesicBlocksKernel::run(uint32_t count) {
    const uint32_t vertices = mesh_.vertex_count();
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::order:
                if (!order_.run(4)) continue;
                at_ = vertices;
                break;
            case Pass::place: place(at_++); break;
            case Pass::fans:
                if (at_ % fans_fetched == 0) fetch();
                blocks_.blocks[++at_].lanes[lane_count - 1] = nowhere;
                fans_.build(at_);
                break;
            case Pass::curvatures: fans_.finish(++at_); break;
            case Pass::done: break;
        }
        if (at_ < vertices) continue;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

}  // namespace flg
