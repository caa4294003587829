// SPDX-License-Identifier: MIT
// What jobs of each kind took lately: a mean that follows the last ones. Of a table of fixed size, so that a host that
// runs for days takes no more memory; of two kinds in one place the last one stays.
#pragma once

#include <array>
#include <cstdint>
#include <source_location>

namespace flg {

class UsualTimes {
public:
    // 0: there were none.
    uint64_t of(const std::source_location& kind) const {
        const Entry& entry = entries_[place(kind)];
        return is_of(entry, kind) ? entry.mean_ns : 0;
    }
    void add(const std::source_location& kind, uint64_t busy_ns) {
        Entry& entry = entries_[place(kind)];
        if (is_of(entry, kind))
            entry.mean_ns = (3 * entry.mean_ns + busy_ns) / 4;
        else
            entry = {kind.file_name(), kind.line(), busy_ns};
    }

private:
    struct Entry {
        const char* file = nullptr;
        uint32_t line = 0;
        uint64_t mean_ns = 0;
    };
    static constexpr size_t size = 256;
    // File names of one file may be at several places of a program, which makes them several kinds.
    static size_t place(const std::source_location& kind) {
        return (reinterpret_cast<uintptr_t>(kind.file_name()) / 8 + 31 * size_t{kind.line()}) % size;
    }
    static bool is_of(const Entry& entry, const std::source_location& kind) {
        return entry.file == kind.file_name() && entry.line == kind.line();
    }

    std::array<Entry, size> entries_;
};

}  // namespace flg
