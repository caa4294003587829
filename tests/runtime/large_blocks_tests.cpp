// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <thread>
#include <vector>

#include "runtime/busy.h"
#include "runtime/context_memory.h"

namespace flg::test {
namespace {

constexpr size_t mega = size_t{1} << 20;

// Every page is touched, as by a result.
std::byte* take_filled(LargeBlocks& blocks, size_t size, int value) {
    auto* const block = static_cast<std::byte*>(blocks.take(size));
    std::memset(block, value, size);
    return block;
}

TEST(LargeBlocks, HoldWhatWasAskedForAtEverySize) {
    LargeBlocks blocks;
    std::vector<std::pair<std::byte*, size_t>> taken;
    for (size_t size = LargeBlocks::least; size < 40 * mega; size += size / 7 + 1)
        taken.push_back({take_filled(blocks, size, static_cast<int>(taken.size() % 251)), size});
    for (size_t i = 0; i < taken.size(); ++i) {
        const auto [block, size] = taken[i];
        EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % 4096, 0u);
        for (const size_t at : {size_t{0}, size / 2, size - 1}) EXPECT_EQ(block[at], std::byte(i % 251)) << size;
        blocks.give_back(block, size);
    }
    EXPECT_TRUE(blocks.has_unwanted());
}

TEST(LargeBlocks, RefuseWhatNoSystemHas) {
    LargeBlocks blocks;
    EXPECT_THROW(static_cast<void>(blocks.take((size_t{1} << 38) + 1)), std::bad_alloc);
    EXPECT_THROW(static_cast<void>(blocks.take(SIZE_MAX - 4)), std::bad_alloc);
}

TEST(LargeBlocks, AreUsedAgainNewestFirst) {
    LargeBlocks blocks;
    void* const first = blocks.take(mega);
    void* const second = blocks.take(mega);
    void* const smaller = blocks.take(mega / 2);
    blocks.give_back(first, mega);
    blocks.give_back(second, mega);
    blocks.give_back(smaller, mega / 2);
    EXPECT_FALSE(blocks.has_unwanted());
    EXPECT_FALSE(blocks.unmap_piece());
    EXPECT_EQ(blocks.take(mega - 5), second);  // of one size with it
    EXPECT_EQ(blocks.take(mega), first);
    EXPECT_EQ(blocks.take(mega / 2), smaller);
    for (void* block : {first, second}) blocks.give_back(block, mega);
    blocks.give_back(smaller, mega / 2);
}

TEST(LargeBlocks, AreUnmappedInPiecesAfterSomeFrames) {
    LargeBlocks blocks;
    blocks.give_back(take_filled(blocks, mega, 1), mega);
    for (uint32_t frame = 0; frame < LargeBlocks::frames_waited; ++frame) {
        EXPECT_FALSE(blocks.unmap_piece());
        blocks.begin_frame();
    }
    for (size_t left = mega; left > 0; left -= LargeBlocks::piece) {
        EXPECT_TRUE(blocks.has_unwanted());
        EXPECT_TRUE(blocks.unmap_piece());
    }
    EXPECT_FALSE(blocks.has_unwanted());
    EXPECT_FALSE(blocks.unmap_piece());
}

TEST(LargeBlocks, AreUnmappedAtOnceWhenTooManyWait) {
    LargeBlocks blocks;
    const size_t size = LargeBlocks::most_waiting / 4;
    std::vector<std::byte*> taken;
    for (int i = 0; i < 6; ++i) taken.push_back(take_filled(blocks, size, i));
    for (std::byte* block : taken) blocks.give_back(block, size);
    size_t pieces = 0;
    while (blocks.unmap_piece()) ++pieces;
    EXPECT_EQ(pieces, 2 * size / LargeBlocks::piece);  // the two oldest
    for (int i = 5; i > 1; --i) EXPECT_EQ(blocks.take(size), taken[static_cast<size_t>(i)]);
    for (size_t i = 2; i < 6; ++i) blocks.give_back(taken[i], size);
}

// A block that is being unmapped belongs to one thread alone.
TEST(LargeBlocks, ServeManyThreads) {
    LargeBlocks blocks;
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (uint32_t t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            for (uint32_t i = 0; i < 400; ++i) {
                const size_t size = LargeBlocks::least + random_below(1, t, i, mega);
                auto* const block = static_cast<uint32_t*>(blocks.take(size));
                block[0] = t;
                block[size / sizeof(uint32_t) - 1] = i;
                if (i % 16 == 0) blocks.begin_frame();
                blocks.unmap_piece();
                if (block[0] != t || block[size / sizeof(uint32_t) - 1] != i) ++wrong;
                blocks.give_back(block, size);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST(LargeBlocks, AreUnmappedByTicks) {
    CountingMemory memory;
    for (uint32_t workers : {0u, 1u}) {
        FlgContextDesc desc{};
        desc.worker_count = workers;
        Runtime runtime(desc, &memory, memory.large_blocks);
        memory.large_blocks.give_back(take_filled(memory.large_blocks, 8 * mega, 1), 8 * mega);
        for (uint32_t frame = 0; frame <= LargeBlocks::frames_waited; ++frame) runtime.tick(1000);
        while (memory.large_blocks.has_unwanted()) runtime.tick(1000);
    }
}

TEST(LargeBlocks, CountAsTheirKindUntilTheyAreGivenBack) {
    ContextMemory memory(HostMemory(FlgAllocator{}), 64 * mega, 0);
    Memory* const surfaces = memory[MemoryKind::surfaces];
    for (const size_t size : {LargeBlocks::least - 9, LargeBlocks::least, 3 * mega}) {
        void* const block = surfaces->allocate(size, 64);
        std::memset(block, 1, size);
        EXPECT_GE(memory.use(FLG_MEMORY_KIND_SURFACES).bytes, size);
        EXPECT_LE(memory.use(FLG_MEMORY_KIND_SURFACES).bytes, size + 16);
        surfaces->deallocate(block, size, 64);
        EXPECT_EQ(memory.use(FLG_MEMORY_KIND_TOTAL).bytes, 0u);
    }
    EXPECT_THROW(static_cast<void>(surfaces->allocate(65 * mega, 64)), MemoryLimitReached);
}

}  // namespace
}  // namespace flg::test
