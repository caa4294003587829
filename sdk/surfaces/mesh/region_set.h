// SPDX-License-Identifier: MIT
// Labels of regions that an operation keeps to: a bit a label, in pages of 4096 labels of which only those with a label
// in them are there. So memory and the time to make a set follow the number of labels, not the largest one.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/memory.h"

namespace flg {

class RegionSet {
public:
    // All of them.
    explicit RegionSet(Memory* memory) : page_of_(memory), pages_(memory) {}
    // Those listed: at most 512 bytes for each one, and two for each 4096 labels below the largest.
    RegionSet(const uint32_t* labels, uint32_t count, Memory* memory) : page_of_(memory), pages_(memory), all_(false) {
        uint16_t page_count = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t place = labels[i] / page_labels;
            if (place >= page_of_.size()) page_of_.resize(place + 1, no_page);
            if (page_of_[place] == no_page) page_of_[place] = page_count++;
        }
        pages_.resize(page_count);
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t bit = labels[i] % page_labels;
            pages_[page_of_[labels[i] / page_labels]][bit / 64] |= uint64_t{1} << bit % 64;
        }
    }
    // Copies take their memory where the first one did.
    RegionSet(const RegionSet& other)
        : page_of_(other.page_of_, other.page_of_.get_allocator()),
          pages_(other.pages_, other.pages_.get_allocator()),
          all_(other.all_) {}
    RegionSet(RegionSet&&) = default;
    RegionSet& operator=(const RegionSet&) = default;
    // Between different memories it copies, which may throw.
    RegionSet& operator=(RegionSet&&) = default;  // NOLINT(performance-noexcept-move-constructor)

    bool all() const { return all_; }
    Memory* memory() const { return page_of_.get_allocator().resource(); }
    // visit(label) for those listed, rising, until it returns false.
    template <class Visit>
    void visit(Visit visit) const {
        for (uint32_t place = 0; place < page_of_.size(); ++place) {
            if (page_of_[place] == no_page) continue;
            const Page& page = pages_[page_of_[place]];
            for (uint32_t word = 0; word < page.size(); ++word)
                for (uint64_t left = page[word]; left != 0; left &= left - 1)
                    if (!visit(place * page_labels + 64 * word + static_cast<uint32_t>(std::countr_zero(left)))) return;
        }
    }
    bool contains(uint32_t label) const {
        if (all_) return true;
        const uint32_t place = label / page_labels, bit = label % page_labels;
        if (place >= page_of_.size() || page_of_[place] == no_page) return false;
        return (pages_[page_of_[place]][bit / 64] >> bit % 64 & 1) != 0;
    }

private:
    static constexpr uint32_t page_labels = 4096;
    static constexpr uint16_t no_page = 0xffff;
    using Page = std::array<uint64_t, page_labels / 64>;

    std::pmr::vector<uint16_t> page_of_;  // by label / page_labels; at most 4096 as labels end at FLG_REGION_MAX
    std::pmr::vector<Page> pages_;
    bool all_ = true;
};

}  // namespace flg
