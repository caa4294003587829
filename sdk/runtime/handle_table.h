// SPDX-License-Identifier: MIT
// Handles: index, generation and kind in 64 bits. A released slot's generation moves on, so old handles are found out;
// generations start from a number of the context's own, so that handles of another context are too.
//
//   bits 0-31 index + 1 (never zero) | bits 32-55 generation | bits 56-63 kind
#pragma once

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
    motion
};

const char* handle_kind_name(HandleKind kind);

template <class T>
class HandleTable {
public:
    HandleTable(HandleKind kind, uint32_t salt, Memory* memory)
        : kind_(kind), salt_(salt & generation_mask), slots_(memory), free_(memory) {}

    uint64_t add(std::shared_ptr<T> object) {
        if (free_.empty()) {
            if (free_.capacity() <= slots_.size()) free_.reserve(slots_.size() * 2 + 8);  // so that remove can't fail
            slots_.push_back({nullptr, salt_});
            free_.push_back(static_cast<uint32_t>(slots_.size() - 1));
        }
        const uint32_t index = free_.back();
        free_.pop_back();
        slots_[index].object = std::move(object);
        return encode(index, slots_[index].generation);
    }

    // The object; throws FLG_ERROR_INVALID_HANDLE, naming `argument`, if there is none.
    const std::shared_ptr<T>& get(uint64_t id, const char* argument) const {
        const uint32_t index = static_cast<uint32_t>(id) - 1;
        if (index >= slots_.size() || !slots_[index].object || encode(index, slots_[index].generation) != id) {
            if (id == 0) throw Failure(FLG_ERROR_INVALID_HANDLE, "%s is null", argument);
            throw Failure(FLG_ERROR_INVALID_HANDLE, "%s (0x%llx) is not a living %s of this context", argument,
                          static_cast<unsigned long long>(id), handle_kind_name(kind_));
        }
        return slots_[index].object;
    }

    std::shared_ptr<T> remove(uint64_t id, const char* argument) {
        get(id, argument);
        const uint32_t index = static_cast<uint32_t>(id) - 1;
        slots_[index].generation = (slots_[index].generation + 1) & generation_mask;
        free_.push_back(index);
        return std::move(slots_[index].object);
    }

    void clear() { slots_.clear(); }

private:
    static constexpr uint32_t generation_mask = 0xffffff;

    struct Slot {
        std::shared_ptr<T> object;
        uint32_t generation;
    };

    uint64_t encode(uint32_t index, uint32_t generation) const {
        return (uint64_t{index} + 1) | uint64_t{generation} << 32 | uint64_t{static_cast<uint8_t>(kind_)} << 56;
    }

    HandleKind kind_;
    uint32_t salt_;
    std::pmr::vector<Slot> slots_;
    std::pmr::vector<uint32_t> free_;
};

}  // namespace flg
