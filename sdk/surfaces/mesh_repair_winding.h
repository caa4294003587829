// SPDX-License-Identifier: MIT
// Makes the winding of triangles that are joined consistent. Each component is flooded, first within patches whose windings
// agree, then from patch to patch. The winding of most of the component's triangles stays, on a tie that of the first.
// Where patches can't agree all around, as in a Moebius strip, the edge between them is cut open; edges within a patch
// never are.
#pragma once

#include <deque>

#include "surfaces/mesh_repair_mates.h"

namespace flg {

// A unit is a triangle or an edge between patches: about 30 ns. Memory: 5 bytes a triangle.
class WindingKernel {
public:
    // Both outlive the kernel, and are changed.
    WindingKernel(GrowingBuffer<Triple>& triangles, Mates& mates, Memory* memory);
    bool run(uint32_t count);

    // After run() returned true.
    uint32_t flipped_count() const { return flipped_count_; }
    uint32_t cut_count() const { return cut_count_; }

private:
    enum class State : uint8_t { unseen, kept, turned };
    enum class Pass { clear, flood, flip, done };
    void begin_component();
    bool agrees(Corner corner) const;
    void spread(uint32_t triangle);
    void cross(Corner corner);
    void flip(uint32_t triangle);

    GrowingBuffer<Triple>& triangles_;
    Mates& mates_;
    Buffer<State> states_;
    Buffer<uint32_t> flood_;             // triangles of the component, in the order in which they were met
    std::pmr::deque<Corner> crossings_;  // from triangles of flood_, where windings do not agree
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;  // clear: triangle; flood and flip: place in flood_
    uint32_t flood_size_ = 0;
    uint32_t turned_size_ = 0;  // of them, those turned against the first
    uint32_t first_ = 0;        // where the next component may begin
    uint32_t flipped_count_ = 0;
    uint32_t cut_count_ = 0;
};

}  // namespace flg
