// SPDX-License-Identifier: MIT
#include "surfaces/mesh/region_set.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "core/random.h"
#include "filigree/filigree_surface.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

class MeasuredMemory final : public Memory {
public:
    size_t taken = 0;

private:
    void* do_allocate(size_t size, size_t alignment) override {
        taken += size;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* data, size_t size, size_t alignment) override {
        std::pmr::new_delete_resource()->deallocate(data, size, alignment);
    }
    bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }
};

TEST(RegionSet, HasTheLabelsListedAndNoOthers) {
    for (const uint32_t spread : {1u, 100u, 5000u, FLG_REGION_MAX / 300}) {
        std::vector<uint32_t> labels;
        for (uint32_t i = 0; i < 300; ++i) {
            labels.push_back(static_cast<uint32_t>(random_bits(7, spread, i) % (uint64_t{300} * spread)));
        }
        labels.push_back(labels.front());
        const std::set<uint32_t> expected(labels.begin(), labels.end());
        const RegionSet regions(labels.data(), static_cast<uint32_t>(labels.size()), test_memory());
        EXPECT_FALSE(regions.all());
        for (const uint32_t label : labels) {
            for (uint32_t near : {label, label + 1, label - 1, label ^ 64, label ^ 4096, label ^ 0x800000u}) {
                EXPECT_EQ(regions.contains(near), expected.contains(near)) << near;
            }
        }
    }
}

TEST(RegionSet, MayHaveAllLabelsOrNone) {
    const RegionSet all(test_memory()), none(nullptr, 0, test_memory());
    EXPECT_TRUE(all.all());
    for (const uint32_t label : {0u, 4095u, FLG_REGION_MAX}) {
        EXPECT_TRUE(all.contains(label));
        EXPECT_FALSE(none.contains(label));
    }
}

TEST(RegionSet, OfOneLabelIsSmallHoweverLargeTheLabel) {
    MeasuredMemory memory;
    const uint32_t label = FLG_REGION_MAX;
    const RegionSet regions(&label, 1, &memory);
    EXPECT_TRUE(regions.contains(label));
    EXPECT_LT(memory.taken, 9000u);
}

TEST(RegionSet, CopiesTakeMemoryFromTheSamePlace) {
    MeasuredMemory memory;
    const uint32_t labels[] = {3, 70'000};
    const RegionSet regions(labels, 2, &memory);
    const size_t before = memory.taken;
    const RegionSet copy = regions;
    EXPECT_TRUE(copy.contains(3));
    EXPECT_TRUE(copy.contains(70'000));
    EXPECT_GT(memory.taken, before);
}

}  // namespace
}  // namespace flg::test
