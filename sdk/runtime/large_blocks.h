// SPDX-License-Identifier: MIT
// Blocks of 64 KB and more, for contexts whose host has no allocator of its own.
//
// `free` returns megabytes to the system at once, which takes longer than a slice may. Here a block that is given back
// waits, with its pages, for the next one of its size. The oldest are unmapped in pieces of 256 KB by whoever has time:
// those that waited for 32 frames, or that make more than 32 MB wait.
//
// All functions may run on any thread; the mutex is held for some tens of instructions and never during a system call.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace flg {

class LargeBlocks {
public:
    static constexpr size_t least = size_t{1} << 16, piece = size_t{1} << 18, most_waiting = size_t{32} << 20;
    static constexpr uint32_t frames_waited = 32;

    LargeBlocks() = default;
    LargeBlocks(const LargeBlocks&) = delete;
    LargeBlocks& operator=(const LargeBlocks&) = delete;
    ~LargeBlocks();

    // At least `least` bytes, aligned to a page; std::bad_alloc if the system has no more, and beyond 256 GB.
    void* take(size_t size);
    // Constant time. `size` as it was asked for.
    void give_back(void* block, size_t size) noexcept;
    // Whether a block waited long enough.
    bool has_unwanted() const { return has_unwanted_.load(std::memory_order_relaxed); }
    // Unmaps one piece of such a block; false if there is none.
    bool unmap_piece() noexcept;
    void begin_frame() noexcept;

private:
    // At the beginning of a block that waits.
    struct Waiting {
        Waiting *newer, *older;          // by age
        Waiting *next_same, *last_same;  // of the same size, newest first
        size_t size;
        uint32_t frame;
    };
    static constexpr uint32_t steps = 4, least_log2 = 16, most_log2 = 38;  // sizes
    static constexpr uint32_t class_count = (most_log2 + 1 - least_log2) * steps;

    struct SizeClass {
        uint32_t index;
        size_t size;
    };
    static SizeClass class_of(size_t size);
    Waiting* pop_unwanted() noexcept;
    // Mutex held.
    void remove(Waiting& block) noexcept;
    void look_for_unwanted() noexcept;

    std::mutex mutex_;
    std::array<Waiting*, class_count> newest_of_{};
    Waiting *newest_ = nullptr, *oldest_ = nullptr;
    Waiting* shrinking_ = nullptr;  // by next_same: blocks that are partly unmapped
    size_t waiting_bytes_ = 0;
    uint32_t frame_ = 0;
    std::atomic<bool> has_unwanted_{false};
};

}  // namespace flg
