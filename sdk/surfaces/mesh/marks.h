// SPDX-License-Identifier: MIT
// A bit for each of many things: vertices, edges, corners that were visited.
#pragma once

#include "runtime/each.h"

namespace flg {

class Marks {
public:
    // Not cleared: no_marks() makes them.
    Marks(size_t size, Memory* memory) : words_((size + 63) / 64, memory) {}

    bool has(uint32_t i) const { return (words_[i / 64] >> i % 64 & 1) != 0; }
    // True if it was not set before.
    bool set(uint32_t i) {
        uint64_t& word = words_[i / 64];
        const uint64_t bit = uint64_t{1} << i % 64;
        const bool is_new = (word & bit) == 0;
        word |= bit;
        return is_new;
    }

    Buffer<uint64_t>& words() { return words_; }

private:
    Buffer<uint64_t> words_;
};

inline Task<Marks> no_marks(Pace& pace, size_t size) {
    Marks marks(size, pace.memory());
    uint64_t* const words = marks.words().data();
    co_await each(pace, marks.words().size(), Cost::some_ns, [=](uint32_t w) { words[w] = 0; });
    co_return marks;
}

}  // namespace flg
