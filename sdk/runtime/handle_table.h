// SPDX-License-Identifier: MIT
// Handles: index, generation and kind in 64 bits. A released slot's generation moves on, so old handles are found out;
// generations start from a number of the context's own, so that handles of another context are too.
//
//   bits 0-31 index + 1 (never zero) | bits 32-55 generation | bits 56-63 kind
//
// get() may run on any thread while others add and remove: live strokes are pushed to beside the host's other calls.
// Only the object asked for must stay; add() and remove() do not overlap. It waits for nobody, by this argument:
// - Slots lie in blocks that never move. add() stores a block's address with release before it stores an id of the
//   block, and get() loads both with acquire: who finds a block finds its slots constructed.
// - A slot's id says whose object it holds, 0: none. add() stores it with release behind the object, so get() reads the
//   object only if it found the id, and then all of it. remove() takes the id away before the object.
// - A handle of an object that is gone fits no id (but after 2^24 generations): get() never reads a slot that add() is
//   filling again.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <memory>
#include <vector>

#include "core/failure.h"
#include "core/memory.h"

namespace flg {

enum class HandleKind : uint8_t {
    job = 1,
    curve_set,
    style,
    live_stroke,
    surface,
    field,
    surface_curves,
    tangle,
    straight_skeleton,
    outline,
    part,
    part_mesh,
    model,
    skin,
    manifold,
    obstacles,
    spline,
    motion,
    pull,
    pulled
};

const char* handle_kind_name(HandleKind kind);

template <class T>
class HandleTable {
public:
    HandleTable(HandleKind kind, uint32_t salt, Memory* memory)
        : kind_(kind), salt_(salt & generation_mask), memory_(memory), free_(memory) {}
    HandleTable(const HandleTable&) = delete;
    HandleTable& operator=(const HandleTable&) = delete;
    ~HandleTable() {
        for (uint32_t b = 0; b < block_count; ++b) {
            Slot* block = blocks_[b].load(std::memory_order_relaxed);
            if (!block) break;
            std::destroy_n(block, block_size(b));
            memory_->deallocate(block, block_size(b) * sizeof(Slot), alignof(Slot));
        }
    }

    HandleKind kind() const { return kind_; }

    uint64_t add(std::shared_ptr<T> object) {
        if (free_.empty()) {
            if (free_.capacity() <= slot_count_) free_.reserve(slot_count_ * 2 + 8);  // so that remove can't fail
            add_slot();
        }
        const uint32_t index = free_.back();
        free_.pop_back();
        Slot& slot = *find_slot(index);
        slot.object = std::move(object);
        const uint64_t id = encode(index, slot.generation);
        slot.id.store(id, std::memory_order_release);
        return id;
    }

    // [any thread] The object; throws FLG_ERROR_INVALID_HANDLE, naming `argument`, if there is none.
    const std::shared_ptr<T>& get(uint64_t id, const char* argument) const {
        const Slot* slot = find_slot(static_cast<uint32_t>(id) - 1);
        if (id == 0 || !slot || slot->id.load(std::memory_order_acquire) != id) {
            if (id == 0) throw Failure(FLG_ERROR_INVALID_HANDLE, "%s is null", argument);
            throw Failure(FLG_ERROR_INVALID_HANDLE, "%s (0x%llx) is not a living %s of this context", argument,
                          static_cast<unsigned long long>(id), handle_kind_name(kind_));
        }
        return slot->object;
    }

    std::shared_ptr<T> remove(uint64_t id, const char* argument) {
        get(id, argument);
        const uint32_t index = static_cast<uint32_t>(id) - 1;
        Slot& slot = *find_slot(index);
        slot.id.store(0, std::memory_order_relaxed);
        slot.generation = (slot.generation + 1) & generation_mask;
        free_.push_back(index);
        return std::move(slot.object);
    }

private:
    static constexpr uint32_t generation_mask = 0xffffff;
    static constexpr uint32_t first_block_size = 8;  // each block after it is twice the one before
    static constexpr uint32_t block_count = 30;      // every index of 32 bits has its place

    struct Slot {
        std::atomic<uint64_t> id{0};
        std::shared_ptr<T> object;
        uint32_t generation = 0;
    };

    static constexpr uint64_t block_size(uint32_t block) { return uint64_t{first_block_size} << block; }
    static uint32_t block_of(uint32_t index) {
        return static_cast<uint32_t>(std::bit_width(index / first_block_size + 1)) - 1;
    }

    // Null if its block was never made.
    Slot* find_slot(uint32_t index) const {
        const uint32_t b = block_of(index);
        Slot* block = blocks_[b].load(std::memory_order_acquire);
        return block ? block + (index - (block_size(b) - first_block_size)) : nullptr;
    }

    void add_slot() {
        const auto index = static_cast<uint32_t>(slot_count_);
        const uint32_t b = block_of(index);
        if (!blocks_[b].load(std::memory_order_relaxed)) {
            void* place = memory_->allocate(block_size(b) * sizeof(Slot), alignof(Slot));
            auto* block = static_cast<Slot*>(place);
            std::uninitialized_value_construct_n(block, block_size(b));
            blocks_[b].store(block, std::memory_order_release);
        }
        find_slot(index)->generation = salt_;
        free_.push_back(index);
        ++slot_count_;
    }

    uint64_t encode(uint32_t index, uint32_t generation) const {
        return (uint64_t{index} + 1) | uint64_t{generation} << 32 | uint64_t{static_cast<uint8_t>(kind_)} << 56;
    }

    HandleKind kind_;
    uint32_t salt_;
    Memory* memory_;
    std::array<std::atomic<Slot*>, block_count> blocks_{};
    size_t slot_count_ = 0;
    std::pmr::vector<uint32_t> free_;
};

}  // namespace flg
