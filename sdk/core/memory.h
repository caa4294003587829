// SPDX-License-Identifier: MIT
// Memory: everything comes from a std::pmr::memory_resource that the context hands down, so that the host's allocator
// sees all of it. Containers are std::pmr ones; big arrays that are written once are Buffers.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <type_traits>
#include <utility>

namespace flg {

using Memory = std::pmr::memory_resource;

// A fixed-size array that is not initialized when made: its pages are touched only by whoever fills it, chunk by chunk.
// (A std::vector would clear megabytes in one go, longer than any frame allows.) Elements are never destroyed; those
// that are not plain numbers are made with std::construct_at.
template <class T>
class Buffer {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    Buffer() = default;
    Buffer(size_t size, Memory* memory) : memory_(memory), size_(size) {
        if (size_ != 0) data_ = static_cast<T*>(memory_->allocate(size_ * sizeof(T), alignment));
    }
    Buffer(Buffer&& other) noexcept
        : memory_(other.memory_), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~Buffer() {
        if (data_) memory_->deallocate(data_, size_ * sizeof(T), alignment);
    }

    T* data() { return data_; }
    const T* data() const { return data_; }
    size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](size_t i) { return data_[i]; }
    const T& operator[](size_t i) const { return data_[i]; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }

private:
    static constexpr size_t alignment = 64;  // a cache line, and enough for any vector register
    Memory* memory_ = nullptr;
    T* data_ = nullptr;
    size_t size_ = 0;
};

}  // namespace flg
