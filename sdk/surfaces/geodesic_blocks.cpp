// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr uint32_t digit_bits = 10;
constexpr uint32_t digit_mask = (1u << digit_bits) - 1;

// Every third bit of the result is a bit of x < 1024.
uint32_t spread_bits(uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

float length_between(const RankedPosition& a, const RankedPosition& b) {
    const float x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
    return std::sqrt(x * x + y * y + z * z);
}

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

GeodesicBlocksKernel::GeodesicBlocksKernel(const Mesh& mesh, const GrowingBuffer<Position>& positions,
                                           GeodesicBlocks& blocks, Memory* memory)
    : mesh_(mesh),
      positions_(positions),
      blocks_(blocks),
      keys_(mesh.vertex_count(), memory),
      sorted_(mesh.vertex_count(), memory) {
    const uint32_t vertices = mesh.vertex_count();
    blocks.blocks = growing_buffer<GeodesicBlock>(vertices + 1, memory);
    blocks.overflow_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.positions = growing_buffer<RankedPosition>(vertices + 1, memory);
    blocks.vertex_of_rank = growing_buffer<uint32_t>(vertices + 1, memory);
    blocks.rank_of_vertex = growing_buffer<uint32_t>(vertices, memory);
    blocks.overflow.clear();
    blocks.edges = {};
    const float none = std::numeric_limits<float>::quiet_NaN();
    blocks.blocks[nowhere].lanes.fill(nowhere);
    blocks.positions[nowhere] = {none, none, none, none};
    blocks.vertex_of_rank[nowhere] = no_index;
    low_.fill(std::numeric_limits<float>::max());
    high_.fill(std::numeric_limits<float>::lowest());
    if (vertices == 0) pass_ = Pass::done;
}

void GeodesicBlocksKernel::extend_bounds(uint32_t vertex) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], positions_[vertex][axis]);
        high_[axis] = std::max(high_[axis], positions_[vertex][axis]);
    }
}

void GeodesicBlocksKernel::make_key(uint32_t vertex) {
    if (vertex == 0) {
        double extent = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) extent = std::max(extent, double{high_[axis]} - low_[axis]);
        cells_per_metre_ = extent > 0 ? static_cast<float>(digit_mask / extent) : 0.0f;
    }
    uint32_t code = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const float cell = (positions_[vertex][axis] - low_[axis]) * cells_per_metre_;
        code |= spread_bits(static_cast<uint32_t>(std::clamp(cell, 0.0f, float{digit_mask}))) << axis;
    }
    keys_[vertex] = {code, vertex};
    for (uint32_t digit = 0; digit < 3; ++digit) ++starts_[digit][(code >> (digit * digit_bits)) & digit_mask];
}

void GeodesicBlocksKernel::begin_sort() {
    for (auto& counts : starts_) {
        uint32_t start = 0;
        for (uint32_t& count : counts) start += std::exchange(count, start);
    }
}

void GeodesicBlocksKernel::sort(uint32_t pass, uint32_t i) {
    const Buffer<Key>& from = pass == 1 ? sorted_ : keys_;
    Buffer<Key>& to = pass == 1 ? keys_ : sorted_;
    to[starts_[pass][(from[i].code >> (pass * digit_bits)) & digit_mask]++] = from[i];
}

void GeodesicBlocksKernel::place(uint32_t i) {
    const uint32_t vertex = sorted_[i].vertex, rank = i + 1;
    const Position& p = positions_[vertex];
    blocks_.vertex_of_rank[rank] = vertex;
    blocks_.rank_of_vertex[vertex] = rank;
    blocks_.positions[rank] = {p[0], p[1], p[2], 0};
}

void GeodesicBlocksKernel::make_fan(uint32_t rank) {
    blocks_.overflow_of_rank[rank] = static_cast<uint32_t>(blocks_.overflow.size());
    FanWriter fan(blocks_.blocks[rank], blocks_.overflow);
    visit_fan(mesh_, blocks_.vertex_of_rank[rank], [&](uint32_t neighbour) {
        const uint32_t lane = blocks_.rank_of_vertex[neighbour];
        blocks_.edges.add(length_between(blocks_.positions[rank], blocks_.positions[lane]));
        fan.add(lane);
    });
    fan.finish();
}

bool GeodesicBlocksKernel::run(uint32_t count) {
    const uint32_t vertices = mesh_.vertex_count();
    for (; count > 0 && pass_ != Pass::done; --count) {
        const uint32_t i = at_++;
        switch (pass_) {
            case Pass::bounds: extend_bounds(i); break;
            case Pass::keys: make_key(i); break;
            case Pass::sort_low: sort(0, i); break;
            case Pass::sort_middle: sort(1, i); break;
            case Pass::sort_high: sort(2, i); break;
            case Pass::place: place(i); break;
            case Pass::fans: make_fan(i + 1); break;
            case Pass::done: break;
        }
        if (at_ < vertices) continue;
        if (pass_ == Pass::keys) begin_sort();
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

}  // namespace flg
