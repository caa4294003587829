// SPDX-License-Identifier: MIT
// The host's allocator hook as a memory resource, for all libraries.
#pragma once

#include <new>

#include "core/memory.h"
#include "filigree/filigree.h"

namespace flg {

// std::bad_alloc when the hook returns null.
class HostMemory final : public std::pmr::memory_resource {
public:
    // A hook with null functions stands for aligned operator new and delete.
    explicit HostMemory(const FlgAllocator& allocator) : allocator_(allocator) {}
    bool is_hooked() const { return allocator_.allocate != nullptr; }

private:
    void* do_allocate(size_t size, size_t alignment) override {
        if (!allocator_.allocate) return ::operator new(size, std::align_val_t(alignment));
        void* memory = allocator_.allocate(allocator_.user_data, size, alignment);
        if (!memory) throw std::bad_alloc();
        return memory;
    }
    void do_deallocate(void* memory, size_t size, size_t alignment) override {
        if (!allocator_.free) {
            ::operator delete(memory, std::align_val_t(alignment));
        } else {
            allocator_.free(allocator_.user_data, memory, size, alignment);
        }
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    FlgAllocator allocator_;
};

}  // namespace flg
