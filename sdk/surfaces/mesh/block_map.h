// SPDX-License-Identifier: MIT
// The blocks of a mesh in which some labels may be, as a bit a block: what a pass over the triangles of regions looks
// at. Where that is not worth it the map is of everything.
#pragma once

#include <algorithm>
#include <bit>

#include "surfaces/mesh/mesh.h"

namespace flg {

// Takes some microseconds to make, and a bit for 16 triangles of the mesh.
class BlockMap {
public:
    BlockMap(const Mesh& mesh, Memory* memory)
        : blocks_(mesh.region_blocks), bits_(memory), words_((mesh.triangle_count() + 63) / 64) {}

    // False if the label may be anywhere, or labels are too many: the map is of everything then.
    bool add(uint32_t label) {
        if (bits_.empty()) bits_.resize(words_ / words_a_bit_word + 1, 0);
        const bool listed = work_ < RegionBlocks::most_blocks && blocks_.visit(label, [&](uint32_t block) {
            if (block / blocks_a_word < words_) bits_[block / 64] |= uint64_t{1} << block % 64;
            ++work_;
        });
        work_ += work_a_label;
        if (!listed) {
            bits_.clear();
            everything_ = true;
        }
        return listed;
    }
    // Labels are all there.
    void close() {
        if (bits_.empty()) everything_ = true;
    }

    bool everything() const { return everything_; }
    // The first 64 triangles from `word` on that it holds; no_index: none.
    uint32_t next(uint32_t word) const {
        if (word >= words_) return no_index;
        if (everything_) return word;
        size_t at = word / words_a_bit_word;
        uint64_t left = bits_[at] & ~uint64_t{0} << word % words_a_bit_word * blocks_a_word;
        while (left == 0) {
            if (++at == bits_.size()) return no_index;
            left = bits_[at];
        }
        return static_cast<uint32_t>(at) * words_a_bit_word +
               static_cast<uint32_t>(std::countr_zero(left)) / blocks_a_word;
    }

private:
    static constexpr uint32_t blocks_a_word = 64 / RegionBlocks::block_size, words_a_bit_word = 64 / blocks_a_word;
    static constexpr uint32_t work_a_label = 4;

    const RegionBlocks& blocks_;
    std::pmr::vector<uint64_t> bits_;  // a block each
    const uint32_t words_;             // of 64 triangles
    uint32_t work_ = 0;
    bool everything_ = false;
};

}  // namespace flg
