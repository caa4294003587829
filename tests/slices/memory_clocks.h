// SPDX-License-Identifier: MIT
// A clock of work and the allocators that slices are watched with.
#pragma once

#include <map>
#include <new>

#include "filigree/filigree.h"

namespace flg::slices {

// Goes on with what is done instead of with time, so a run gives the same figures each time. A look is 10 us, what the
// work between two looks aims at. A call of the allocator is 0.1 us, and a block that is given back right after one of
// about twice its size was taken is an array that grew: copying it takes a nanosecond for 8 bytes.
// Arithmetic that costs more than a loop's Cost says is seen by processor time alone.
class WorkClock {
public:
    FlgClock clock() { return {sizeof(FlgClock), this, look}; }
    const FlgAllocator* allocator() const { return &allocator_; }

private:
    static constexpr uint64_t look_ns = 10'000, call_ns = 100, bytes_a_ns = 8;

    static uint64_t look(void* self) {
        auto& clock = *static_cast<WorkClock*>(self);
        clock.last_taken_ = 0;
        return clock.ns_ += look_ns;
    }
    const FlgAllocator allocator_{sizeof(FlgAllocator), this,
                                  [](void* self, size_t size, size_t alignment) {
                                      auto& clock = *static_cast<WorkClock*>(self);
                                      clock.ns_ += call_ns;
                                      clock.last_taken_ = size;
                                      return ::operator new(size, std::align_val_t(alignment), std::nothrow);
                                  },
                                  [](void* self, void* memory, size_t size, size_t alignment) {
                                      auto& clock = *static_cast<WorkClock*>(self);
                                      clock.ns_ += call_ns;
                                      const bool grew = clock.last_taken_ > size && clock.last_taken_ <= 3 * size;
                                      if (grew) clock.ns_ += size / bytes_a_ns;
                                      ::operator delete(memory, std::align_val_t(alignment));
                                  }};
    uint64_t ns_ = 0;
    size_t last_taken_ = 0;  // since the last look
};

// Gives blocks out again, as engines' pools do.
class Pool {
public:
    Pool() = default;
    ~Pool() {
        for (const auto& [kind, memory] : free_) ::operator delete(memory, std::align_val_t(kind.second));
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    const FlgAllocator* allocator() const { return &allocator_; }

private:
    const FlgAllocator allocator_{sizeof(FlgAllocator), this,
                                  [](void* self, size_t size, size_t alignment) {
                                      auto& blocks = static_cast<Pool*>(self)->free_;
                                      const auto found = blocks.find({size, alignment});
                                      if (found == blocks.end())
                                          return ::operator new(size, std::align_val_t(alignment), std::nothrow);
                                      void* const memory = found->second;
                                      blocks.erase(found);
                                      return memory;
                                  },
                                  [](void* self, void* memory, size_t size, size_t alignment) {
                                      static_cast<Pool*>(self)->free_.emplace(std::pair(size, alignment), memory);
                                  }};
    std::multimap<std::pair<size_t, size_t>, void*> free_;
};

}  // namespace flg::slices
