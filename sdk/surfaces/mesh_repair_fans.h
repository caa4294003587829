// SPDX-License-Identifier: MIT
// Gives each fan of triangles a vertex of its own: the first one keeps the vertex, the others (bow-ties, edges that were
// left open) get copies of it.
#pragma once

#include <deque>

#include "surfaces/mesh_repair_mates.h"

namespace flg {

// A bit each, cleared in slices.
class Marks {
public:
    Marks(size_t size, Memory* memory) : words_((size + 63) / 64, memory) {}
    size_t word_count() const { return words_.size(); }
    void clear_word(size_t word) { words_[word] = 0; }
    bool has(size_t i) const { return words_[i / 64] >> (i % 64) & 1; }
    void set(size_t i) { words_[i / 64] |= uint64_t{1} << (i % 64); }

private:
    Buffer<uint64_t> words_;
};

// A unit is a corner: about 10 ns. Memory: a bit a corner and vertex.
class FansKernel {
public:
    // Windings agree wherever triangles are joined. Vertices from `vertex_count` on are copies: `copies` says of which
    // vertices below it, and grows. All outlive the kernel; triangles are changed.
    FansKernel(GrowingBuffer<Triple>& triangles, const Mates& mates, uint32_t vertex_count,
               std::pmr::deque<uint32_t>& copies, Memory* memory);
    bool run(uint32_t count);

    // After run() returned true.
    bool is_used(uint32_t vertex) const { return used_.has(vertex); }
    // Of the vertices that are no copies.
    uint32_t used_count() const { return used_count_; }

private:
    void begin_fan(Corner corner);
    void visit(Corner corner);

    GrowingBuffer<Triple>& triangles_;
    const Mates& mates_;
    uint32_t vertex_count_;
    std::pmr::deque<uint32_t>& copies_;
    Marks visited_;  // corners
    Marks used_;     // vertices, copies that there were before too
    uint32_t used_count_ = 0;
    size_t cleared_ = 0;
    Corner at_ = 0;  // where the next fan may begin
    Corner walker_ = no_index;
    bool back_ = false;    // the walker came to the end of an open fan, and goes on from its beginning the other way
    uint32_t vertex_ = 0;  // of the fan
};

}  // namespace flg
