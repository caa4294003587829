// SPDX-License-Identifier: MIT
// A host's allocator that gives blocks out again, as engines' pools do: in steady state no page is touched for the
// first time. (First touches cost what the operating system makes of them; under a hypervisor up to half a
// millisecond.) For contexts without workers: it does not lock.
#pragma once

#include <map>
#include <new>

#include "filigree/filigree.h"

namespace flg::bench {

class Pool {
public:
    Pool() = default;
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    ~Pool() {
        for (const auto& [kind, memory] : free_) ::operator delete(memory, std::align_val_t(kind.second));
    }

    FlgAllocator hooks() { return {sizeof(FlgAllocator), this, allocate, release}; }

private:
    using Kind = std::pair<size_t, size_t>;  // size, alignment

    static void* allocate(void* self, size_t size, size_t alignment) {
        auto& blocks = static_cast<Pool*>(self)->free_;
        const auto found = blocks.find({size, alignment});
        if (found == blocks.end()) return ::operator new(size, std::align_val_t(alignment), std::nothrow);
        void* memory = found->second;
        blocks.erase(found);
        return memory;
    }
    static void release(void* self, void* memory, size_t size, size_t alignment) {
        static_cast<Pool*>(self)->free_.emplace(Kind{size, alignment}, memory);
    }

    std::multimap<Kind, void*> free_;
};

}  // namespace flg::bench
