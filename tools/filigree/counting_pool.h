// SPDX-License-Identifier: MIT
// An allocator as engines have one: blocks that came back are given out again, and new ones are touched once, so that
// nothing is touched for the first time while strokes are drawn. Counts its calls, thread by thread: what workers do
// meanwhile is not what a call on the host's thread does.
#pragma once

#include <cstring>
#include <map>
#include <mutex>
#include <new>
#include <thread>

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

    FlgAllocator hooks() { return {sizeof(FlgAllocator), this, allocate, release}; }
    // By the thread that asks.
    uint64_t allocations() const {
        std::lock_guard lock(mutex_);
        const auto found = allocations_.find(std::this_thread::get_id());
        return found == allocations_.end() ? 0 : found->second;
    }

private:
    using Kind = std::pair<size_t, size_t>;  // size, alignment

    static void* allocate(void* self, size_t size, size_t alignment) {
        auto& pool = *static_cast<CountingPool*>(self);
        {
            std::lock_guard lock(pool.mutex_);
            ++pool.allocations_[std::this_thread::get_id()];
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
    std::map<std::thread::id, uint64_t> allocations_;
};

}  // namespace flg::cli
