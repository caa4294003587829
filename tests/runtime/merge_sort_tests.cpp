// SPDX-License-Identifier: MIT
#include "runtime/merge_sort.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/growing_list.h"
#include "core/random.h"
#include "runtime/run_now.h"

namespace flg::test {
namespace {

struct Item {
    uint32_t key, place;
    bool operator==(const Item&) const = default;
};

TEST(MergeSort, SortsAndKeepsTheOrderOfEquals) {
    Memory* const memory = std::pmr::new_delete_resource();
    for (const uint32_t count : {0u, 1u, 2u, 15u, 16u, 17u, 33u, 1000u, 12345u}) {
        for (const uint32_t keys : {1u, 7u, 1u << 20}) {
            std::vector<Item> items, scratch(count);
            for (uint32_t i = 0; i < count; ++i) items.push_back({static_cast<uint32_t>(mix64(i)) % keys, i});
            std::vector<Item> expected = items;
            const auto less = [](const Item& a, const Item& b) { return a.key < b.key; };
            std::sort(expected.begin(), expected.end(),
                      [](const Item& a, const Item& b) { return a.key != b.key ? a.key < b.key : a.place < b.place; });
            run_haltingly(memory,
                          [&](Pace& pace) { return merge_sort(pace, std::span(items), std::span(scratch), less); });
            EXPECT_EQ(items, expected) << count << " of " << keys;
        }
    }
}

TEST(GrowingList, KeepsWhatItGotAndWhereThatIs) {
    GrowingList<uint64_t> list(std::pmr::new_delete_resource()), other(std::pmr::new_delete_resource());
    std::vector<const uint64_t*> places;
    constexpr uint32_t count = 100'000;
    for (uint32_t i = 0; i < count; ++i) {
        list.push_back(mix64(i));
        places.push_back(&list[i]);
    }
    EXPECT_EQ(list.size(), count);
    EXPECT_EQ(list.back(), mix64(count - 1));
    list.swap(other);
    EXPECT_TRUE(list.empty());
    for (uint32_t i = 0; i < count; ++i) {
        ASSERT_EQ(&other[i], places[i]);
        ASSERT_EQ(other[i], mix64(i));
    }
    other.pop_back();
    EXPECT_EQ(other.size(), count - 1);
    other.shrink(65);
    EXPECT_EQ(other.back(), mix64(64));
    other.clear();
    other.push_back(3);
    EXPECT_EQ(&other[0], places[0]);
}

}  // namespace
}  // namespace flg::test
