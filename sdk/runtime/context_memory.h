// SPDX-License-Identifier: MIT
// The memory of a context, counted by what it is for, and limited.
//
// Invariants
// - A block carries a tag behind its bytes: its kind, or the account of the job that took it. So a block is counted
//   where it belongs whoever frees it, and containers of one context trade blocks whatever their kinds.
// - What the slices of a job take of the kind `scratch` stands in the job's account. At the end of the job that is what
//   its result keeps: from then on it counts as the kind of the result.
// - The kinds together are what the host's allocator has handed out, to the byte. Without one, large blocks that wait
//   to be used again are not in it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "core/failure.h"
#include "core/host_memory.h"
#include "runtime/host.h"
#include "runtime/large_blocks.h"

namespace flg {

// FlgMemoryKind without the total.
enum class MemoryKind : uint8_t { styles, surfaces, curves, models, caches, scratch, runtime };

struct JobAccount;

class ContextMemory {
public:
    // `limit` in bytes, 0: none. `own_size` bytes of the host's hold the context itself.
    ContextMemory(const HostMemory& host, uint64_t limit, size_t own_size);
    ContextMemory(const ContextMemory&) = delete;
    ContextMemory& operator=(const ContextMemory&) = delete;

    // [any thread] What things of this kind are made of.
    Memory* operator[](MemoryKind kind) { return &kinds_[static_cast<size_t>(kind)]; }
    // [any thread]
    FlgMemoryUse use(FlgMemoryKind kind) const;
    // 0: none.
    void set_limit(FlgMemoryKind kind, uint64_t limit) noexcept;
    const HostMemory& host() const { return host_; }
    LargeBlocks& large_blocks() { return large_blocks_; }

private:
    friend class JobMemory;
    friend struct JobAccount;
    static constexpr size_t kind_count = static_cast<size_t>(MemoryKind::runtime) + 1;

    class Kind final : public Memory {
    public:
        Kind(ContextMemory& owner, MemoryKind kind) : owner_(owner), kind_(kind) {}

    private:
        void* do_allocate(size_t size, size_t alignment) override { return owner_.take(kind_, size, alignment); }
        void do_deallocate(void* block, size_t size, size_t alignment) override {
            owner_.give_back(block, size, alignment);
        }
        bool do_is_equal(const Memory& other) const noexcept override {
            const auto* kind = dynamic_cast<const Kind*>(&other);
            return kind && &kind->owner_ == &owner_;
        }

        ContextMemory& owner_;
        MemoryKind kind_;
    };

    struct Counter {
        void add(uint64_t size) noexcept {
            const uint64_t now = bytes.fetch_add(size, std::memory_order_relaxed) + size;
            raise_peak(now);
        }
        // Within the limit, or an exception, and nothing is added. The peak stays.
        void reserve(uint64_t size, const char* limit_name);
        void raise_peak(uint64_t now) noexcept {
            uint64_t before = peak.load(std::memory_order_relaxed);
            while (before < now && !peak.compare_exchange_weak(before, now, std::memory_order_relaxed)) {}
        }
        void subtract(uint64_t size) noexcept { bytes.fetch_sub(size, std::memory_order_relaxed); }

        std::atomic<uint64_t> bytes{0}, peak{0}, limit{0};
    };

    void* take(MemoryKind kind, size_t size, size_t alignment);
    void give_back(void* block, size_t size, size_t alignment) noexcept;
    Counter& counter(MemoryKind kind) { return counters_[static_cast<size_t>(kind)]; }
    void close(JobAccount& account) noexcept;

    bool is_large(size_t size, size_t alignment) const;
    void* take_block(size_t size, size_t alignment);
    void give_back_block(void* block, size_t size, size_t alignment) noexcept;

    HostMemory host_;
    LargeBlocks large_blocks_;
    std::array<Kind, kind_count> kinds_;
    std::array<Counter, kind_count> counters_;
    Counter total_;
};

// The account of one job. Without one, as in tests of the runtime, nothing is counted.
class JobMemory {
public:
    JobMemory() = default;
    JobMemory(const JobMemory&) = delete;
    JobMemory& operator=(const JobMemory&) = delete;
    ~JobMemory() { settle(); }

    // Once, before the job is queued.
    void open(ContextMemory& memory);
    // What the job's result counts as. Likewise.
    void set_result(MemoryKind kind);
    // The job has ended and freed what it held: what is left is its result. Returns the limit of its kind, if the
    // result passes that: the job has failed then.
    std::optional<MemoryLimitReached> settle() noexcept;

    // While it lives, scratch that this thread takes stands in the job's account.
    class Slice {
    public:
        explicit Slice(const JobMemory& job) noexcept;
        ~Slice();
        Slice(const Slice&) = delete;
        Slice& operator=(const Slice&) = delete;

    private:
        JobAccount* before_;
    };

private:
    JobAccount* account_ = nullptr;
};

}  // namespace flg
