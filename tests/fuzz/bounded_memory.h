// SPDX-License-Identifier: MIT
// An allocator hook that has no more than so many bytes to give: input that asks for any amount is refused by it.
#pragma once

#include <atomic>
#include <new>

#include "fuzz/fuzz.h"

namespace flg::fuzz {

class BoundedMemory {
public:
    explicit BoundedMemory(size_t bytes) : left_(static_cast<int64_t>(bytes)), all_(left_) {}
    ~BoundedMemory() { FLG_DEMAND(left_ == all_); }
    BoundedMemory(const BoundedMemory&) = delete;
    BoundedMemory& operator=(const BoundedMemory&) = delete;

    const FlgAllocator* hooks() const { return &hooks_; }

    const FlgAllocator hooks_{sizeof(FlgAllocator), this,
                              [](void* self, size_t size, size_t alignment) -> void* {
                                  std::atomic<int64_t>& left = static_cast<BoundedMemory*>(self)->left_;
                                  const auto wanted = static_cast<int64_t>(size);
                                  if (wanted < 0 || wanted > left) return nullptr;
                                  left -= wanted;
                                  return ::operator new(size, std::align_val_t(alignment));
                              },
                              [](void* self, void* memory, size_t size, size_t alignment) {
                                  static_cast<BoundedMemory*>(self)->left_ += static_cast<int64_t>(size);
                                  ::operator delete(memory, size, std::align_val_t(alignment));
                              }};

private:
    std::atomic<int64_t> left_;
    const int64_t all_;
};

}  // namespace flg::fuzz
