// SPDX-License-Identifier: MIT
// Memory that is never 0 by chance: numbers that are read before they are written are NaN, and so is what comes of
// them.
#pragma once

#include <cstring>

#include "core/memory.h"

namespace flg::test {

class NanMemory final : public Memory {
    void* do_allocate(size_t bytes, size_t alignment) override {
        void* const block = std::pmr::new_delete_resource()->allocate(bytes, alignment);
        std::memset(block, 0xff, bytes);
        return block;
    }
    void do_deallocate(void* block, size_t bytes, size_t alignment) override {
        std::pmr::new_delete_resource()->deallocate(block, bytes, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

inline Memory* nan_memory() {
    static NanMemory memory;
    return &memory;
}

}  // namespace flg::test
