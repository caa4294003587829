// SPDX-License-Identifier: MIT
// What waits for a geodesic solver, in buckets by distance: a bucket holds distances of one width, first come first
// served. Buckets stand in a ring; those in use span less than its size.
#pragma once

#include <bit>
#include <deque>
#include <vector>

#include "core/memory.h"

namespace flg {

// Entries are in chunks, chunks in slabs: nothing is moved or cleared when the queue grows.
template <class Entry>
class BucketQueue {
public:
    static constexpr uint32_t chunk_size = 1016 / sizeof(Entry);  // of a kB

    explicit BucketQueue(Memory* memory) : memory_(memory), buckets_(memory), slabs_(memory) {}

    // Empties the queue.
    void clear() {
        for (Bucket& bucket : buckets_) {
            while (bucket.first != nullptr) remove_chunk(bucket);
        }
        size_ = 0;
    }
    // Empties the queue and takes a ring of at least `span` buckets.
    void reset(uint32_t span) {
        clear();
        const uint32_t count = std::bit_ceil(span);
        if (count > buckets_.size()) buckets_.resize(count);
        mask_ = static_cast<uint32_t>(buckets_.size()) - 1;
    }
    uint32_t span() const { return static_cast<uint32_t>(buckets_.size()); }
    size_t size() const { return size_; }
    size_t bytes() const { return slabs_.size() * slab_size * sizeof(Chunk); }
    // Gives a part of an empty queue's memory back; false if there is none.
    bool give_back() {
        unused_ = nullptr;
        fresh_ = 0;
        if (slabs_.empty()) return false;
        slabs_.pop_back();
        return !slabs_.empty();
    }

    void push(uint32_t bucket, const Entry& entry) {
        Bucket& to = buckets_[bucket & mask_];
        if (to.last == nullptr || to.last_size == chunk_size) add_chunk(to);
        to.last->entries[to.last_size++] = entry;
        ++size_;
    }
    // The bucket's first entry, or false.
    bool pop(uint32_t bucket, Entry& entry) {
        Bucket& from = buckets_[bucket & mask_];
        if (from.first == nullptr) return false;
        entry = from.first->entries[from.taken++];
        --size_;
        if (from.taken == (from.first == from.last ? from.last_size : chunk_size)) remove_chunk(from);
        return true;
    }

private:
    struct Chunk {
        Chunk* next;
        Entry entries[chunk_size];
    };
    struct Bucket {
        Chunk* first = nullptr;
        Chunk* last = nullptr;
        uint32_t taken = 0;      // of the first chunk
        uint32_t last_size = 0;  // of the last chunk
    };
    static constexpr uint32_t slab_size = 64;  // chunks: 64 kB

    [[gnu::noinline]] void add_chunk(Bucket& bucket) {
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
    void remove_chunk(Bucket& bucket) {
        Chunk* chunk = bucket.first;
        bucket.first = chunk->next;
        bucket.taken = 0;
        if (bucket.first == nullptr) bucket.last = nullptr;
        chunk->next = unused_;
        unused_ = chunk;
    }

    Memory* memory_;
    std::pmr::vector<Bucket> buckets_;
    std::pmr::deque<Buffer<Chunk>> slabs_;  // grows without moving
    Chunk* unused_ = nullptr;
    uint32_t fresh_ = 0;  // chunks of the last slab that have not been used
    uint32_t mask_ = 0;
    size_t size_ = 0;
};

}  // namespace flg
