// SPDX-License-Identifier: MIT
// Vertices in Morton order: along a space-filling curve, so that what is near in space is near in memory. Sorted by
// radix, in slices; vertices of one cell keep their order.
#pragma once

#include <array>

#include "surfaces/mesh.h"

namespace flg {

// 1024 cells along the longest side of the bounding box. A unit is a vertex in one of five passes, 2 to 10 ns. Scratch: 16
// bytes a vertex.
class SpatialOrderKernel {
public:
    SpatialOrderKernel(const GrowingBuffer<Position>& positions, Memory* memory);

    bool run(uint32_t count);
    // After that: the i-th of the vertices.
    uint32_t vertex_at(uint32_t i) const { return sorted_[i].vertex; }

private:
    enum class Pass { bounds, keys, sort_low, sort_middle, sort_high, done };
    struct Key {
        uint32_t code;  // ten bits an axis, interleaved
        uint32_t vertex;
    };

    void extend_bounds(uint32_t vertex);
    void begin_keys();
    void make_key(uint32_t vertex);
    void begin_sort();
    void sort(uint32_t digit, uint32_t i);

    const GrowingBuffer<Position>& positions_;
    Buffer<Key> keys_, sorted_;
    std::array<std::array<uint32_t, 1024>, 3> starts_{};  // of each digit's values; counts while keys are made
    Position low_, high_;
    double cells_per_metre_ = 0;
    Pass pass_ = Pass::bounds;
    uint32_t at_ = 0;
};

}  // namespace flg
