// SPDX-License-Identifier: MIT
#include "hardening/heap.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace flg::test {

namespace {

std::atomic<uint64_t> calls_inside{0};
std::atomic<int64_t> news_inside{0}, fail_at{-1};
std::atomic<bool> fails_on{false};

bool new_fails() {
    if (!InsideSdk::is_inside) return false;
    const int64_t number = news_inside.fetch_add(1);
    const int64_t at = fail_at.load();
    return at >= 0 && (number == at || (fails_on && number > at));
}

void* take(size_t size, size_t alignment) {
    if (new_fails()) return nullptr;
#ifdef FLG_SANITIZED
    if (InsideSdk::is_inside) ++calls_inside;
#endif
    if (alignment <= alignof(std::max_align_t)) return std::malloc(size == 0 ? 1 : size);
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void* take_or_throw(size_t size, size_t alignment) {
    void* const memory = take(size, alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

uint64_t heap_calls_inside_sdk() {
    return calls_inside;
}

void fail_heap(int64_t at, bool from_then_on) {
    fail_at = at;
    fails_on = from_then_on;
    news_inside = 0;
}

int64_t heap_calls_since() {
    return news_inside;
}

}  // namespace flg::test

using namespace flg::test;

void* operator new(size_t size) {
    return take_or_throw(size, 1);
}
void* operator new[](size_t size) {
    return take_or_throw(size, 1);
}
void* operator new(size_t size, std::align_val_t alignment) {
    return take_or_throw(size, static_cast<size_t>(alignment));
}
void* operator new[](size_t size, std::align_val_t alignment) {
    return take_or_throw(size, static_cast<size_t>(alignment));
}
void* operator new(size_t size, const std::nothrow_t&) noexcept {
    return take(size, 1);
}
void* operator new[](size_t size, const std::nothrow_t&) noexcept {
    return take(size, 1);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}

#ifndef FLG_SANITIZED
// glibc's own, by the names that it keeps for those who stand before them.
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

void* malloc(size_t size) {
    if (InsideSdk::is_inside) ++calls_inside;
    return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
    if (InsideSdk::is_inside) ++calls_inside;
    return __libc_calloc(count, size);
}
void* realloc(void* memory, size_t size) {
    if (InsideSdk::is_inside) ++calls_inside;
    return __libc_realloc(memory, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
    if (InsideSdk::is_inside) ++calls_inside;
    return __libc_memalign(alignment, size);
}
}
#endif
