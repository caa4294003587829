// SPDX-License-Identifier: MIT
// The triangles a cut changes, found by their index in constant time without a hash map: a bit a triangle, and for each
// 64 of them how many were set before. Slots are numbered by rising triangle.
#pragma once

#include <bit>

#include "core/memory.h"
#include "surfaces/mesh.h"

namespace flg {

class TriangleSet {
public:
    TriangleSet(uint32_t triangle_count, Memory* memory) : words_((size_t{triangle_count} + 63) / 64, memory) {}

    uint32_t word_count() const { return static_cast<uint32_t>(words_.size()); }
    uint32_t size() const { return size_; }

    // Every word must be cleared before any is filled; words before sums.
    void clear_word(uint32_t word) { words_[word].bits = 0; }
    void insert(uint32_t triangle) { words_[triangle / 64].bits |= uint64_t{1} << triangle % 64; }
    // In rising order.
    void sum_word(uint32_t word) {
        words_[word].before = size_;
        size_ += static_cast<uint32_t>(std::popcount(words_[word].bits));
    }
    uint64_t bits(uint32_t word) const { return words_[word].bits; }

    // no_index if it is not one of them.
    uint32_t slot_of(uint32_t triangle) const {
        const Word& word = words_[triangle / 64];
        const uint64_t bit = uint64_t{1} << triangle % 64;
        if ((word.bits & bit) == 0) return no_index;
        return word.before + static_cast<uint32_t>(std::popcount(word.bits & (bit - 1)));
    }

private:
    struct Word {
        uint64_t bits;
        uint32_t before;
    };
    Buffer<Word> words_;
    uint32_t size_ = 0;
};

// Points closer to a vertex than this fraction of an edge become that vertex: nearer ones would make slivers, which are
// hard on everything that comes after, and at a hundredth of an edge no eye and no distance notices the move.
constexpr double cut_tolerance = 0.01;

// A triangle that gets new points on its edges. Both triangles of an edge know its points; the one of lower index owns
// them.
struct CutTriangle {
    struct Edge {
        uint32_t points;        // 0: not split
        uint32_t first_vertex;  // of the points, numbered one after the other
        uint32_t twin;          // 3 * slot + edge of the owner across; no_index if this is the owner
        Corner start;           // once written: the piece at the edge's start
    };
    uint32_t triangle;
    uint32_t first_added;  // where its pieces but the first go
    std::array<Edge, 3> edges;
};

}  // namespace flg
