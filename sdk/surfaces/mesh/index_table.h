// SPDX-License-Identifier: MIT
// A hash table from whole numbers to indices that grows in slices. Entries are not taken out.
#pragma once

#include "runtime/each.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

template <class Key>
class KeyTable {
public:
    static constexpr Key no_key = ~Key{0};

    // The value of a key; no_index if it has none.
    uint32_t find(Key key) const {
        if (slots_.empty()) return no_index;
        for (uint32_t slot = place_of(key);; ++slot) {
            const Slot& found = slots_[slot & mask_];
            if (found.key == key || found.key == no_key) return found.value;
        }
    }
    // There is room; the key, which is not no_key, has no value.
    void insert(Key key, uint32_t value) {
        uint32_t slot = place_of(key);
        while (slots_[slot & mask_].key != no_key) ++slot;
        slots_[slot & mask_] = {key, value};
        ++size_;
    }
    bool has_room(size_t more) const { return 2 * (size_ + more) <= slots_.size(); }
    // Room for that many more. It at least doubles where it has to grow.
    static Task<void> reserve(Pace& pace, KeyTable& table, size_t more) {
        if (table.has_room(more)) co_return;
        const Buffer<Slot> before = std::move(table.slots_);
        table.slots_ =
            Buffer<Slot>(std::bit_ceil(std::max(2 * (table.size_ + more), before.size() + 1)), pace.memory());
        table.mask_ = static_cast<uint32_t>(table.slots_.size()) - 1;
        table.size_ = 0;
        co_await each(pace, table.slots_.size(), Cost::some_ns, [&](uint32_t i) { table.slots_[i] = {}; });
        co_await each(pace, before.size(), Cost::tens_of_ns, [&](uint32_t i) {
            if (before[i].key != no_key) table.insert(before[i].key, before[i].value);
        });
    }

private:
    struct Slot {
        Key key = no_key;
        uint32_t value = no_index;
    };
    static uint32_t place_of(uint32_t key) { return (key * 0x9e3779b1u) >> 8; }
    static uint32_t place_of(uint64_t key) { return static_cast<uint32_t>((key * 0x9e3779b97f4a7c15u) >> 32); }

    Buffer<Slot> slots_;  // at most half full; their number is a power of two
    uint32_t mask_ = 0;
    size_t size_ = 0;
};

using IndexTable = KeyTable<uint32_t>;

}  // namespace flg
