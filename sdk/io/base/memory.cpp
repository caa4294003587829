// SPDX-License-Identifier: MIT
#include "io/base/memory.h"

#include <charconv>

#include "core/host_memory.h"

namespace flg::io {

namespace {

thread_local const FlgAllocator* current = &runtime_memory;

}  // namespace

MemoryScope::MemoryScope(const FlgAllocator& allocator) : outer_(std::exchange(current, &allocator)) {}

MemoryScope::~MemoryScope() {
    current = outer_;
}

const FlgAllocator& current_allocator() {
    return *current;
}

void* take_memory(size_t size, size_t alignment) {
    return HostMemory(*current).allocate(size, alignment);
}

void give_memory_back(void* memory, size_t size, size_t alignment) noexcept {
    HostMemory(*current).deallocate(memory, size, alignment);
}

String to_text(uint64_t number) {
    char text[20];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace flg::io
