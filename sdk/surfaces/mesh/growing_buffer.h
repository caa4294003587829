// SPDX-License-Identifier: MIT
// An array that grows at its end while most of it stays as it is: the arrays of a mesh that is being cut. Memory is not
// initialized when taken, and grown in slices: no call moves more than it is told to.
#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/memory.h"

namespace flg {

template <class T>
class GrowingBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    GrowingBuffer() = default;
    explicit GrowingBuffer(Memory* memory) : memory_(memory) {}
    // With room for an eighth more, so that the first cuts need not move what is there. (Memory that isn't touched
    // costs address space only.)
    GrowingBuffer(size_t size, Memory* memory) : memory_(memory), values_(size + size / 8, memory), size_(size) {}

    size_t size() const { return size_; }
    size_t capacity() const { return values_.size(); }
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    T& operator[](size_t i) { return values_[i]; }
    const T& operator[](size_t i) const { return values_[i]; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

    // Takes memory for `capacity` elements beside what there is. Values keep their place until the growth is over.
    void begin_growth(size_t capacity) {
        grown_ = Buffer<T>(capacity, memory_);
        moved_ = 0;
    }
    // Moves at most `count` elements over; true when the larger array is in place.
    bool grow(size_t count) {
        const size_t moving = std::min(count, size_ - moved_);
        if (moving != 0) std::memcpy(grown_.data() + moved_, values_.data() + moved_, moving * sizeof(T));
        moved_ += moving;
        if (moved_ < size_) return false;
        values_ = std::move(grown_);
        grown_ = {};
        return true;
    }

    // Within the capacity; added elements are not initialized.
    void resize(size_t size) { size_ = size; }
    void push_back(const T& value) { values_[size_++] = value; }

private:
    Memory* memory_ = nullptr;
    Buffer<T> values_;
    Buffer<T> grown_;
    size_t size_ = 0;
    size_t moved_ = 0;
};

}  // namespace flg
