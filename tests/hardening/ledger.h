// SPDX-License-Identifier: MIT
// An allocator hook that keeps a note with each block: whose it is, how large and how aligned. It counts, fails when
// asked to, and knows when it is given back something else than it gave.
#pragma once

#include <atomic>
#include <cstdlib>
#include <limits>

#include "filigree/filigree.h"
#include "hardening/heap.h"

namespace flg::test {

class Ledger {
public:
    const FlgAllocator* hook() const { return &hook_; }

    const FlgAllocator hook_{
        sizeof(FlgAllocator), this,
        [](void* self, size_t size, size_t alignment) { return static_cast<Ledger*>(self)->allocate(size, alignment); },
        [](void* self, void* memory, size_t size, size_t alignment) {
            static_cast<Ledger*>(self)->free(memory, size, alignment);
        }};
    // The allocation number `at` from now on (counted from 0) fails, and all later ones if `from_then_on`.
    void fail(int64_t at, bool from_then_on = false) {
        calls = 0;
        first_failing_ = at;
        last_failing_ = from_then_on ? std::numeric_limits<int64_t>::max() : at;
    }
    void never_fail() { fail(std::numeric_limits<int64_t>::max()); }

    std::atomic<int64_t> calls{0};
    std::atomic<int64_t> live_bytes{0};
    std::atomic<int64_t> live_blocks{0};
    std::atomic<int64_t> max_live_bytes{0};
    std::atomic<int64_t> wrong_frees{0};  // not ours, twice, or of another size or alignment

private:
    struct Note {
        const Ledger* owner;
        size_t size, alignment;
    };
    static size_t room_before(size_t alignment) { return (sizeof(Note) + alignment - 1) / alignment * alignment; }
    void* allocate(size_t size, size_t alignment) {
        const OutsideSdk outside;
        const int64_t number = calls.fetch_add(1);
        if (number >= first_failing_ && number <= last_failing_) return nullptr;
        const size_t before = room_before(alignment);
        const size_t whole = (before + size + alignment - 1) / alignment * alignment;
        void* const block =
            alignment <= alignof(std::max_align_t) ? std::malloc(whole) : std::aligned_alloc(alignment, whole);
        if (!block) return nullptr;
        char* const memory = static_cast<char*>(block) + before;
        *reinterpret_cast<Note*>(memory - sizeof(Note)) = {this, size, alignment};
        ++live_blocks;
        const int64_t live = live_bytes.fetch_add(static_cast<int64_t>(size)) + static_cast<int64_t>(size);
        int64_t most = max_live_bytes;
        while (live > most && !max_live_bytes.compare_exchange_weak(most, live)) {}
        return memory;
    }
    void free(void* memory, size_t size, size_t alignment) {
        const OutsideSdk outside;
        Note& note = *reinterpret_cast<Note*>(static_cast<char*>(memory) - sizeof(Note));
        if (note.owner != this || note.size != size || note.alignment != alignment) {
            ++wrong_frees;
            return;
        }
        note = {};
        --live_blocks;
        live_bytes -= static_cast<int64_t>(size);
        std::free(static_cast<char*>(memory) - room_before(alignment));
    }

    std::atomic<int64_t> first_failing_{std::numeric_limits<int64_t>::max()};
    std::atomic<int64_t> last_failing_{std::numeric_limits<int64_t>::max()};
};

}  // namespace flg::test
