// SPDX-License-Identifier: MIT
// Drops triangles and vertices, and remembers where those that stay came from.
#pragma once

#include <deque>

#include "surfaces/mesh.h"
#include "surfaces/mesh_repair_fans.h"

namespace flg {

// Of vertices or triangles, from the input to the mesh and back. Empty where both are the same.
struct IndexMap {
    Buffer<uint32_t> of_input;         // no_index: dropped; of vertices that were split the first copy
    GrowingBuffer<uint32_t> to_input;  // of vertices that were welded the first
    bool is_identity() const { return to_input.size() == 0; }
};

inline void mark_dropped(Triple& triangle) {
    triangle[0] = no_index;
}
inline bool is_dropped(const Triple& triangle) {
    return triangle[0] == no_index;
}

// Drops the triangles that are marked; those that stay keep their order. A unit is a triangle: a few nanoseconds.
class DropTrianglesKernel {
public:
    // `map` may come from dropping others before. All but `memory` outlive the kernel.
    DropTrianglesKernel(GrowingBuffer<Triple>& triangles, uint32_t input_triangle_count, IndexMap& map, Memory* memory);
    bool run(uint32_t count);

private:
    GrowingBuffer<Triple>& triangles_;
    IndexMap& map_;
    bool first_;  // to drop any
    uint32_t mapped_ = 0;
    uint32_t at_ = 0;
    uint32_t kept_ = 0;
};

// Numbers the vertices that are used anew, in their order, copies last, and puts their positions into these places.
// Triangles keep the numbers from before: `renumbered` says what they are now. A unit is a vertex: a few nanoseconds.
class NumberVerticesKernel {
public:
    // `welded` is empty if nothing is. All but `memory` outlive the kernel.
    NumberVerticesKernel(GrowingBuffer<Position>& positions, const FansKernel& fans, const Buffer<uint32_t>& welded,
                         const std::pmr::deque<uint32_t>& copies, IndexMap& map, Memory* memory);
    bool run(uint32_t count);

private:
    void number(uint32_t vertex);

    GrowingBuffer<Position>& positions_;
    const FansKernel& fans_;
    const Buffer<uint32_t>& welded_;
    const std::pmr::deque<uint32_t>& copies_;
    IndexMap& map_;
    GrowingBuffer<Position> placed_;
    uint32_t at_ = 0;
    uint32_t kept_ = 0;
};

}  // namespace flg
