// SPDX-License-Identifier: MIT
// A list that grows at its end without moving what is there: no call takes longer the larger it is. Its elements lie in
// blocks, each twice as large as the one before: at most 26, which are taken and given back at once.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

#include "core/memory.h"

namespace flg {

template <class T>
class GrowingList {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    explicit GrowingList(Memory* memory) : memory_(memory) {}
    GrowingList(const GrowingList&) = delete;
    GrowingList& operator=(const GrowingList&) = delete;
    ~GrowingList() {
        for (uint32_t b = 0; b < block_count && blocks_[b]; ++b)
            memory_->deallocate(blocks_[b], size_of(b) * sizeof(T), alignof(T));
    }
    void swap(GrowingList& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(blocks_, other.blocks_);
        std::swap(size_, other.size_);
    }

    uint32_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](uint32_t i) { return *place(i); }
    const T& operator[](uint32_t i) const { return *place(i); }
    T& back() { return *place(size_ - 1); }
    const T& back() const { return *place(size_ - 1); }

    void push_back(const T& value) {
        const uint32_t block = block_of(size_);
        if (!blocks_[block])
            blocks_[block] = static_cast<T*>(memory_->allocate(size_of(block) * sizeof(T), alignof(T)));
        std::construct_at(place(size_), value);
        ++size_;
    }
    void pop_back() { --size_; }
    // To fewer; the memory stays.
    void shrink(uint32_t size) { size_ = size; }
    void clear() { size_ = 0; }

private:
    static constexpr uint32_t first_log2 = 6, block_count = 26;

    static size_t size_of(uint32_t block) { return size_t{1} << (first_log2 + block); }
    static uint32_t block_of(uint32_t i) {
        return static_cast<uint32_t>(std::bit_width(i + (uint64_t{1} << first_log2))) - 1 - first_log2;
    }
    T* place(uint32_t i) const {
        const uint64_t shifted = i + (uint64_t{1} << first_log2);
        const auto block = static_cast<uint32_t>(std::bit_width(shifted)) - 1 - first_log2;
        return blocks_[block] + (shifted - size_of(block));
    }

    Memory* memory_;
    std::array<T*, block_count> blocks_{};
    uint32_t size_ = 0;
};

}  // namespace flg
