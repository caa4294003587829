// SPDX-License-Identifier: MIT
#include "surfaces/bucket_queue.h"

#include <bit>

namespace flg {

namespace {
constexpr uint32_t slab_size = 64;  // chunks: 64 kB
}

void BucketQueue::reset(uint32_t span) {
    for (Bucket& bucket : buckets_) {
        while (bucket.first != nullptr) remove_chunk(bucket);
    }
    size_ = 0;
    const uint32_t count = std::bit_ceil(span);
    if (count > buckets_.size()) buckets_.resize(count);
    mask_ = static_cast<uint32_t>(buckets_.size()) - 1;
}

void BucketQueue::add_chunk(Bucket& bucket) {
    Chunk* chunk = unused_;
    if (chunk != nullptr) {
        unused_ = chunk->next;
    } else {
        if (fresh_ == 0) {
            slabs_.emplace_back(slab_size, memory_);
            fresh_ = slab_size;
        }
        chunk = slabs_.back().data() + --fresh_;
    }
    chunk->next = nullptr;
    (bucket.last == nullptr ? bucket.first : bucket.last->next) = chunk;
    if (bucket.last == nullptr) bucket.taken = 0;
    bucket.last = chunk;
    bucket.last_size = 0;
}

void BucketQueue::remove_chunk(Bucket& bucket) {
    Chunk* chunk = bucket.first;
    bucket.first = chunk->next;
    bucket.taken = 0;
    if (bucket.first == nullptr) bucket.last = nullptr;
    chunk->next = unused_;
    unused_ = chunk;
}

}  // namespace flg
