// SPDX-License-Identifier: MIT
// Vertices that wait for a geodesic solver, in buckets by distance: a bucket holds distances of one width, first come
// first served. Buckets stand in a ring; those in use span less than its size.
#pragma once

#include <vector>

#include "core/memory.h"

namespace flg {

// Entries are in chunks, chunks in slabs: nothing is moved or cleared when the queue grows.
class BucketQueue {
public:
    static constexpr uint32_t chunk_size = 254;

    explicit BucketQueue(Memory* memory) : memory_(memory), buckets_(memory), slabs_(memory) {}

    // Empties the queue and takes a ring of at least `span` buckets.
    void reset(uint32_t span);
    uint32_t span() const { return static_cast<uint32_t>(buckets_.size()); }
    size_t size() const { return size_; }

    void push(uint32_t bucket, uint32_t rank) {
        Bucket& to = buckets_[bucket & mask_];
        if (to.last == nullptr || to.last_size == chunk_size) add_chunk(to);
        to.last->ranks[to.last_size++] = rank;
        ++size_;
    }
    // The bucket's first entry, or false.
    bool pop(uint32_t bucket, uint32_t& rank) {
        Bucket& from = buckets_[bucket & mask_];
        if (from.first == nullptr) return false;
        rank = from.first->ranks[from.taken++];
        --size_;
        if (from.taken == (from.first == from.last ? from.last_size : chunk_size)) remove_chunk(from);
        return true;
    }
    // The entry that will come `ahead` pops later, as far as it is at hand: else 0.
    uint32_t upcoming(uint32_t bucket, uint32_t ahead) const {
        const Bucket& from = buckets_[bucket & mask_];
        const uint32_t at = from.taken + ahead;
        if (from.first == nullptr || at >= (from.first == from.last ? from.last_size : chunk_size)) return 0;
        return from.first->ranks[at];
    }

private:
    struct Chunk {
        Chunk* next;
        uint32_t ranks[chunk_size];
    };
    struct Bucket {
        Chunk* first = nullptr;
        Chunk* last = nullptr;
        uint32_t taken = 0;      // of the first chunk
        uint32_t last_size = 0;  // of the last chunk
    };

    void add_chunk(Bucket& bucket);
    void remove_chunk(Bucket& bucket);

    Memory* memory_;
    std::pmr::vector<Bucket> buckets_;
    std::pmr::vector<Buffer<Chunk>> slabs_;
    Chunk* unused_ = nullptr;
    uint32_t fresh_ = 0;  // chunks of the last slab that have not been used
    uint32_t mask_ = 0;
    size_t size_ = 0;
};

}  // namespace flg
