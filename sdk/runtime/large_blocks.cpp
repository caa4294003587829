// SPDX-License-Identifier: MIT
#include "runtime/large_blocks.h"

#include <bit>
#include <new>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
#else
#include <sys/mman.h>
#endif

namespace flg {

namespace {

void* map_pages(size_t size) noexcept {
#ifdef _WIN32
    return VirtualAlloc(nullptr, size, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
#else
    void* const pages = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return pages == MAP_FAILED ? nullptr : pages;
#endif
}

// The pages of a block from `from` to its end.
void unmap_tail(void* block, size_t from, size_t size) noexcept {
    std::byte* const tail = static_cast<std::byte*>(block) + from;
#ifdef _WIN32
    if (from == 0) {
        VirtualFree(tail, 0, MEM_RELEASE);
    } else {
        VirtualFree(tail, size - from, MEM_DECOMMIT);
    }
#else
    munmap(tail, size - from);
#endif
}

}  // namespace

// Four sizes from each power of two to the next: what is not touched takes no memory.
LargeBlocks::SizeClass LargeBlocks::class_of(size_t size) {
    const auto log2 = static_cast<uint32_t>(std::bit_width(size - 1)) - 1;  // 2^log2 < size <= 2^(log2 + 1)
    const uint32_t step_log2 = log2 - static_cast<uint32_t>(std::bit_width(steps - 1));
    const size_t step = size_t{1} << step_log2, rounded = (size + step - 1) / step * step;
    const auto index = static_cast<uint32_t>((rounded >> step_log2) - steps - 1);
    return {(log2 + 1 - least_log2) * steps + index, rounded};
}

LargeBlocks::~LargeBlocks() {
    while (Waiting* const block = shrinking_) {
        shrinking_ = block->next_same;
        unmap_tail(block, 0, block->size);
    }
    while (Waiting* const block = oldest_) {
        remove(*block);
        unmap_tail(block, 0, block->size);
    }
}

void* LargeBlocks::take(size_t size) {
    if (size > size_t{1} << most_log2) throw std::bad_alloc();
    const SizeClass wanted = class_of(size);
    {
        std::lock_guard lock(mutex_);
        if (Waiting* const block = newest_of_[wanted.index]) {
            remove(*block);
            look_for_unwanted();
            return block;
        }
    }
    void* const pages = map_pages(wanted.size);
    if (!pages) throw std::bad_alloc();
    return pages;
}

void LargeBlocks::give_back(void* block, size_t size) noexcept {
    const SizeClass given = class_of(size);
    std::lock_guard lock(mutex_);
    Waiting*& same = newest_of_[given.index];
    auto* const waiting = new (block) Waiting{nullptr, newest_, same, nullptr, given.size, frame_};
    if (same) same->last_same = waiting;
    same = waiting;
    (newest_ ? newest_->newer : oldest_) = waiting;
    newest_ = waiting;
    waiting_bytes_ += given.size;
    look_for_unwanted();
}

void LargeBlocks::remove(Waiting& block) noexcept {
    (block.newer ? block.newer->older : newest_) = block.older;
    (block.older ? block.older->newer : oldest_) = block.newer;
    (block.last_same ? block.last_same->next_same : newest_of_[class_of(block.size).index]) = block.next_same;
    if (block.next_same) block.next_same->last_same = block.last_same;
    waiting_bytes_ -= block.size;
}

void LargeBlocks::look_for_unwanted() noexcept {
    const bool is_old = oldest_ && (waiting_bytes_ > most_waiting || frame_ - oldest_->frame >= frames_waited);
    has_unwanted_.store(shrinking_ || is_old, std::memory_order_relaxed);
}

LargeBlocks::Waiting* LargeBlocks::pop_unwanted() noexcept {
    std::lock_guard lock(mutex_);
    if (!has_unwanted()) return nullptr;
    Waiting* const block = shrinking_ ? shrinking_ : oldest_;
    if (shrinking_) {
        shrinking_ = block->next_same;
    } else {
        remove(*block);
    }
    look_for_unwanted();
    return block;
}

bool LargeBlocks::unmap_piece() noexcept {
    Waiting* const block = pop_unwanted();
    if (!block) return false;
    const size_t size = block->size, left = (size - 1) / piece * piece;
    unmap_tail(block, left, size);
    if (left == 0) return true;
    block->size = left;
    std::lock_guard lock(mutex_);
    block->next_same = shrinking_;
    shrinking_ = block;
    look_for_unwanted();
    return true;
}

void LargeBlocks::begin_frame() noexcept {
    std::lock_guard lock(mutex_);
    ++frame_;
    look_for_unwanted();
}

}  // namespace flg
