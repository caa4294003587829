// SPDX-License-Identifier: MIT
// What jobs of each kind took lately: a mean that follows the last ones. Of a table of fixed size, so that a host that
// runs for days takes no more memory; of two kinds in one place the last one stays. It is made for the first job.
#pragma once

#include <coroutine>
#include <cstdint>
#include <vector>

#include "core/memory.h"

namespace flg {

// Which function a task that was just made runs: all compilers' frames begin with where it goes on.
inline const void* kind_of(std::coroutine_handle<> task) {
    return *static_cast<const void* const*>(task.address());
}

class UsualTimes {
public:
    explicit UsualTimes(Memory* memory) : entries_(memory) {}

    // Before any other call.
    void make_table() { entries_.resize(size); }
    // 0: there were none.
    uint64_t of(const void* kind) const {
        const Entry& entry = entries_[place(kind)];
        return entry.kind == kind ? entry.mean_ns : 0;
    }
    void add(const void* kind, uint64_t busy_ns) {
        Entry& entry = entries_[place(kind)];
        entry = {kind, entry.kind == kind ? (3 * entry.mean_ns + busy_ns) / 4 : busy_ns};
    }

private:
    struct Entry {
        const void* kind = nullptr;
        uint64_t mean_ns = 0;
    };
    static constexpr size_t size = 256;
    // Functions are aligned to 16.
    static size_t place(const void* kind) { return reinterpret_cast<uintptr_t>(kind) / 16 % size; }

    std::pmr::vector<Entry> entries_;
};

}  // namespace flg
