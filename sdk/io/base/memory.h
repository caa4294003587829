// SPDX-License-Identifier: MIT
// Memory of this library: all of it comes from the allocator of the call that runs.
//
// The allocator is the thread's while the call lasts, and is not handed down: nearly every function here makes a text
// or a list, and each would take it only to pass it on. What outlives a call keeps the allocator with it (HostFile).
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <memory_resource>
#include <string>
#include <utility>
#include <vector>

#include "filigree/filigree.h"

namespace flg::io {

// From here to the end of its scope this thread takes its memory from `allocator`, and gives it back there. Scopes
// nest: hooks of the host may call this library. Null functions stand for the C++ runtime's memory.
class MemoryScope {
public:
    explicit MemoryScope(const FlgAllocator& allocator);
    ~MemoryScope();
    MemoryScope(const MemoryScope&) = delete;
    MemoryScope& operator=(const MemoryScope&) = delete;

private:
    const FlgAllocator* const outer_;
};

// The C++ runtime's.
inline constexpr FlgAllocator runtime_memory = {sizeof runtime_memory, nullptr, nullptr, nullptr};

const FlgAllocator& current_allocator();

// std::bad_alloc where there is none.
void* take_memory(size_t size, size_t alignment);
void give_memory_back(void* memory, size_t size, size_t alignment) noexcept;

// NOLINTBEGIN(readability-identifier-naming, bugprone-sizeof-expression): the standard's name; T may be a pointer.
template <class T>
struct Allocator {
    using value_type = T;
    Allocator() = default;
    template <class U>
    Allocator(const Allocator<U>&) {}
    T* allocate(size_t count) {
        if (count > PTRDIFF_MAX / sizeof(T)) throw std::bad_alloc();
        return static_cast<T*>(take_memory(count * sizeof(T), alignof(T)));
    }
    void deallocate(T* memory, size_t count) noexcept { give_memory_back(memory, count * sizeof(T), alignof(T)); }
    bool operator==(const Allocator&) const = default;
};
// NOLINTEND(readability-identifier-naming, bugprone-sizeof-expression)

using String = std::basic_string<char, std::char_traits<char>, Allocator<char>>;
template <class T>
using Vector = std::vector<T, Allocator<T>>;
template <class T>
using Deque = std::deque<T, Allocator<T>>;
template <class Key, class T>
using Map = std::map<Key, T, std::less<Key>, Allocator<std::pair<const Key, T>>>;

String to_text(uint64_t number);

// The same memory, for what takes a resource.
class CurrentMemory final : public std::pmr::memory_resource {
    void* do_allocate(size_t size, size_t alignment) override { return take_memory(size, alignment); }
    void do_deallocate(void* memory, size_t size, size_t alignment) override {
        give_memory_back(memory, size, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

// What a host holds between calls, with the allocator that its memory goes back to.
struct HostFile {
    const FlgAllocator allocator = current_allocator();
};

struct Destroy {
    template <class T>
    void operator()(T* object) const noexcept {
        std::destroy_at(object);
        give_memory_back(object, sizeof(T), alignof(T));
    }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

template <class T, class... Arguments>
Owned<T> make_owned(Arguments&&... arguments) {
    Allocator<T> allocator;
    T* const memory = allocator.allocate(1);
    try {
        return Owned<T>(std::construct_at(memory, std::forward<Arguments>(arguments)...));
    } catch (...) {
        allocator.deallocate(memory, 1);
        throw;
    }
}

// Null is allowed.
template <class T>
void release(T* file) noexcept {
    if (!file) return;
    const FlgAllocator allocator = file->allocator;
    const MemoryScope scope(allocator);
    Destroy()(file);
}

}  // namespace flg::io
