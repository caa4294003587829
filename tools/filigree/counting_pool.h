// SPDX-License-Identifier: MIT
// An allocator as engines have one: blocks that came back are given out again, and new ones are touched once, so that
// nothing is touched for the first time while strokes are drawn. Counts its calls.
#pragma once

#include <cstring>
#include <map>
#include <mutex>
#include <new>

#include "filigree/filigree.h"

namespace flg::cli {

class CountingPool {
public:
    CountingPool() = default;
    CountingPool(const CountingPool&) = delete;
    CountingPool& operator=(const CountingPool&) = delete;
    ~CountingPool() {
        for (const auto& [kind, memory] : free_) ::operator delete(memory, std::align_val_t(kind.second));
    }

    FlgAllocator hooks() { return {this, allocate, release}; }
    uint64_t allocations() const {
        std::lock_guard lock(mutex_);
        return allocations_;
    }

private:
    using Kind = std::pair<size_t, size_t>;  // size, alignment

    static void* allocate(void* self, size_t size, size_t alignment) {
        auto& pool = *static_cast<CountingPool*>(self);
        {
            std::lock_guard lock(pool.mutex_);
            ++pool.allocations_;
            const auto found = pool.free_.find({size, alignment});
            if (found != pool.free_.end()) {
                void* memory = found->second;
                pool.free_.erase(found);
                return memory;
            }
        }
        void* memory = ::operator new(size, std::align_val_t(alignment), std::nothrow);
        if (memory) std::memset(memory, 0, size);
        return memory;
    }
    static void release(void* self, void* memory, size_t size, size_t alignment) {
        auto& pool = *static_cast<CountingPool*>(self);
        std::lock_guard lock(pool.mutex_);
        pool.free_.emplace(Kind{size, alignment}, memory);
    }

    mutable std::mutex mutex_;
    std::multimap<Kind, void*> free_;
    uint64_t allocations_ = 0;
};

}  // namespace flg::cli
