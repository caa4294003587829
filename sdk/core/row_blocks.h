// SPDX-License-Identifier: MIT
// Rows of equal width that together are too large for one piece of memory: it would take milliseconds to give back.
// They lie in blocks of 64 KiB, each taken when one of its rows is made; in larger ones where there would be more than
// 64, so that all together are given back within a slice. Within a block rows follow each other.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/memory.h"

namespace flg {

template <class T>
class RowBlocks {
public:
    RowBlocks() = default;
    RowBlocks(size_t rows, size_t width, Memory* memory)
        : width_(width),
          shift_(shift_of(rows, width)),
          rows_(rows),
          memory_(memory),
          blocks_(width == 0 ? 0 : (rows + (size_t{1} << shift_) - 1) >> shift_, memory) {
        std::fill(blocks_.begin(), blocks_.end(), nullptr);
    }
    RowBlocks(RowBlocks&&) noexcept = default;
    RowBlocks& operator=(RowBlocks&&) = delete;
    ~RowBlocks() {
        for (size_t b = 0; b < blocks_.size(); ++b) give_back(b);
    }

    // Its memory is taken, if need be; not cleared.
    T* make(size_t row) {
        T*& block = blocks_[row >> shift_];
        if (!block) block = static_cast<T*>(memory_->allocate(bytes(row >> shift_), alignment));
        return block + (row & mask()) * width_;
    }
    // A row that was made.
    T* operator[](size_t row) { return blocks_[row >> shift_] + (row & mask()) * width_; }
    const T* operator[](size_t row) const { return blocks_[row >> shift_] + (row & mask()) * width_; }

    size_t block_count() const { return blocks_.size(); }
    void give_back(size_t block) {
        if (T* const taken = std::exchange(blocks_[block], nullptr))
            memory_->deallocate(taken, bytes(block), alignment);
    }

private:
    static constexpr size_t block_size = size_t{64} << 10, alignment = 64;
    static constexpr size_t most_blocks = 64;
    static uint32_t shift_of(size_t rows, size_t width) {
        const size_t in_small = block_size / sizeof(T) / std::max<size_t>(width, 1);
        const size_t in_block = std::max({in_small, 2 * rows / most_blocks, size_t{1}});
        return static_cast<uint32_t>(std::bit_width(in_block)) - 1;
    }
    size_t mask() const { return (size_t{1} << shift_) - 1; }
    size_t bytes(size_t block) const {
        return std::min(size_t{1} << shift_, rows_ - (block << shift_)) * width_ * sizeof(T);
    }

    size_t width_ = 0;
    uint32_t shift_ = 0;
    size_t rows_ = 0;
    Memory* memory_ = nullptr;
    Buffer<T*> blocks_;
};

}  // namespace flg
