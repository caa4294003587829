// SPDX-License-Identifier: MIT
// The C++ runtime's heap, watched: what calls of the SDK take from it past the allocator hook, and what happens when it
// runs out. Without sanitizers, which have a heap of their own, malloc is seen too; else operator new alone.
#pragma once

#include <cstddef>
#include <cstdint>

namespace flg::test {

// While one lives on a thread, that thread runs the SDK's code.
class InsideSdk {
public:
    InsideSdk() : before_(is_inside) { is_inside = true; }
    ~InsideSdk() { is_inside = before_; }
    InsideSdk(const InsideSdk&) = delete;
    InsideSdk& operator=(const InsideSdk&) = delete;

    static inline thread_local bool is_inside = false;

private:
    const bool before_;
};

// While one lives on a thread, that thread runs the host's code: a hook that the SDK calls.
class OutsideSdk {
public:
    OutsideSdk() : before_(InsideSdk::is_inside) { InsideSdk::is_inside = false; }
    ~OutsideSdk() { InsideSdk::is_inside = before_; }
    OutsideSdk(const OutsideSdk&) = delete;
    OutsideSdk& operator=(const OutsideSdk&) = delete;

private:
    const bool before_;
};

// Allocations of the heap made inside the SDK so far, by all threads.
uint64_t heap_calls_inside_sdk();

// From now on operator new throws inside the SDK at its call number `at` (counted from 0), and at all later ones if
// `from_then_on`; below 0: never.
void fail_heap(int64_t at, bool from_then_on);

// Calls of operator new inside the SDK since fail_heap.
int64_t heap_calls_since();

}  // namespace flg::test
