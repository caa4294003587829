// SPDX-License-Identifier: MIT
#include "io/base/memory.h"

#include <charconv>
#include <new>

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
    if (!current->allocate) return ::operator new (size, std::align_val_t{alignment});
    if (void* const memory = current->allocate(current->user_data, size, alignment)) return memory;
    throw std::bad_alloc();
}

void give_memory_back(void* memory, size_t size, size_t alignment) noexcept {
    if (current->free)
        current->free(current->user_data, memory, size, alignment);
    else
        ::operator delete (memory, size, std::align_val_t{alignment});
}

String to_text(uint64_t number) {
    char text[20];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace flg::io
