// SPDX-License-Identifier: MIT
// A context's memory: counted by kind to the byte, a job's as scratch until it ends, and limited.
#include "runtime/context_memory.h"

#include <thread>
#include <vector>

#include "api/host.h"
#include "api/memory_uses.h"
#include "core/failure.h"

namespace flg::test {
namespace {

struct Counted {
    explicit Counted(uint64_t limit = 0) : memory(HostMemory(*allocator.hook()), limit, 0) {}
    ~Counted() { EXPECT_EQ(allocator.live_bytes, 0); }
    Memory* operator[](MemoryKind kind) { return memory[kind]; }
    // All that is counted is what the host gave.
    MemoryUses use() const {
        const MemoryUses use([&](FlgMemoryKind kind) { return memory.use(kind); });
        EXPECT_EQ(use.total.bytes, static_cast<uint64_t>(allocator.live_bytes.load()));
        return use;
    }

    HostAllocator allocator;
    ContextMemory memory;
};

TEST(ContextMemory, CountsABlockWhereItWasTakenWhoeverFreesIt) {
    Counted counted;
    std::pmr::vector<int> curves(1000, 1, counted[MemoryKind::curves]);
    const int* const data = curves.data();
    const uint64_t size = counted.use().curves.bytes;
    EXPECT_GE(size, 1000 * sizeof(int));
    EXPECT_LE(size, 1000 * sizeof(int) + 16);
    std::pmr::vector<int> styles(counted[MemoryKind::styles]);
    styles = std::move(curves);
    EXPECT_EQ(styles.data(), data);  // nothing is copied from kind to kind
    EXPECT_EQ(counted.use().curves.bytes, size);
    styles = std::pmr::vector<int>(counted[MemoryKind::models]);
    EXPECT_EQ(counted.use().curves.bytes, 0u);
    EXPECT_EQ(counted.use().curves.peak_bytes, size);
    EXPECT_EQ(counted.use().styles.peak_bytes, 0u);
    EXPECT_EQ(counted.use().total.peak_bytes, size);
}

TEST(ContextMemory, KeepsAlignmentAndOddSizes) {
    Counted counted;
    for (const size_t alignment : {1, 2, 8, 16, 64}) {
        for (size_t size = 1; size < 40; ++size) {
            Memory* const memory = counted[MemoryKind::models];
            void* const block = memory->allocate(size, alignment);
            EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % alignment, 0u);
            std::memset(block, 0xff, size);
            counted.use();
            memory->deallocate(block, size, alignment);
        }
    }
    EXPECT_EQ(counted.use().total.bytes, 0u);
}

TEST(ContextMemory, AJobsMemoryIsScratchUntilItEndsThenItsResult) {
    Counted counted;
    Memory* const scratch = counted[MemoryKind::scratch];
    Buffer<int> kept, later;
    {
        JobMemory job;
        job.open(counted.memory);
        job.set_result(MemoryKind::surfaces);
        {
            const JobMemory::Slice slice(job);
            kept = Buffer<int>(1000, scratch);
            later = Buffer<int>(10, scratch);
            const Buffer<int> freed(5000, scratch);
            EXPECT_EQ(counted.use().surfaces.bytes, 0u);
            EXPECT_GT(counted.use().scratch.bytes, 6010 * sizeof(int));
        }
        const uint64_t held = counted.use().scratch.bytes;
        EXPECT_LT(held, 1100 * sizeof(int));
        job.settle();
        EXPECT_EQ(counted.use().scratch.bytes, 0u);
        EXPECT_EQ(counted.use().surfaces.bytes, held);
    }
    EXPECT_GT(counted.use().runtime.bytes, 0u);  // the account lives as long as its blocks
    kept = {};
    EXPECT_GT(counted.use().surfaces.bytes, 0u);
    later = {};
    EXPECT_EQ(counted.use().total.bytes, 0u);
    // Without a job scratch stays scratch.
    const Buffer<int> none(10, scratch);
    EXPECT_GT(counted.use().scratch.bytes, 0u);
}

// Blocks are freed by other threads at the very moment in which their job ends.
TEST(ContextMemory, CountsRightWhenBlocksAreFreedWhileTheJobEnds) {
    Counted counted;
    for (int round = 0; round < 300; ++round) {
        std::vector<Buffer<int>> blocks;
        JobMemory job;
        job.open(counted.memory);
        job.set_result(MemoryKind::curves);
        {
            const JobMemory::Slice slice(job);
            for (int i = 0; i < 40; ++i) blocks.emplace_back(static_cast<size_t>(i + 1), counted[MemoryKind::scratch]);
        }
        std::atomic<bool> go{false};
        std::thread freer([&] {
            while (!go) {}
            for (Buffer<int>& block : blocks) block = {};
        });
        go = true;
        job.settle();
        freer.join();
    }
    const MemoryUses use = counted.use();
    EXPECT_EQ(use.scratch.bytes, 0u);
    EXPECT_EQ(use.curves.bytes, 0u);
    EXPECT_EQ(use.runtime.bytes, 0u);
}

TEST(ContextMemory, RefusesWhatPassesItsLimit) {
    Counted counted(10'000);
    Memory* const memory = counted[MemoryKind::caches];
    const Buffer<char> most(9000, memory);
    const MemoryUses before = counted.use();
    try {
        const Buffer<char> more(1000, memory);
        ADD_FAILURE() << "there was room";
    } catch (const std::bad_alloc& refused) {
        EXPECT_STREQ(refused.what(),
                     "memory_limit is 10000 bytes, which leaves no room for 1008 beside the 9008 in use");
    }
    EXPECT_EQ(counted.use().total.bytes, before.total.bytes);
    EXPECT_EQ(counted.use().total.peak_bytes, before.total.peak_bytes);
    const Buffer<char> last(984, memory);  // to the last byte
    EXPECT_EQ(counted.use().total.bytes, 10'000u);
}

TEST(ContextMemory, IsTheSumWhileManyThreadsTakeAndGive) {
    Counted counted;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            const auto kind = static_cast<MemoryKind>(t);
            for (int i = 0; i < 2000; ++i) {
                const std::pmr::vector<int> block(static_cast<size_t>(i % 50 + 1), counted[kind]);
                const std::pmr::vector<int> scratch(static_cast<size_t>(i % 30 + 1), counted[MemoryKind::scratch]);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(counted.use().total.bytes, 0u);
    EXPECT_EQ(counted.use().models.bytes, 0u);
    EXPECT_EQ(counted.use().scratch.bytes, 0u);
}

}  // namespace
}  // namespace flg::test
