// SPDX-License-Identifier: MIT
#include "surfaces/mesh/region_blocks.h"

#include <new>

#include "runtime/each.h"

namespace flg {

RegionBlocks::List& RegionBlocks::list_of(uint32_t label) {
    const uint32_t place = label / page_labels;
    if (place >= page_of_.size()) page_of_.resize(place + 1, none);
    if (page_of_[place] == none) {
        pages_.emplace_back();
        page_of_[place] = static_cast<uint32_t>(pages_.size() - 1);
    }
    return pages_[page_of_[place]][label % page_labels];
}

// Its chunks go back as a chain.
void RegionBlocks::clear(List& list) noexcept {
    if (list.first != none) {
        chunks_[list.last].next = free_;
        free_ = list.first;
    }
    list = {};
}

void RegionBlocks::append(List& list, uint32_t block) {
    if (list.last != none && chunks_[list.last].count < chunks_[list.last].blocks.size()) {
        Chunk& chunk = chunks_[list.last];
        if (chunk.blocks[chunk.count - 1] == block) return;
        chunk.blocks[chunk.count++] = block;
        ++list.count;
        return;
    }
    if (list.last != none && chunks_[list.last].blocks.back() == block) return;
    uint32_t added = free_;
    if (added == none) {
        added = static_cast<uint32_t>(chunks_.size());
        chunks_.emplace_back();
    } else {
        free_ = chunks_[added].next;
    }
    chunks_[added] = {none, 1, {block}};
    (list.last == none ? list.first : chunks_[list.last].next) = added;
    list.last = added;
    ++list.count;
}

void RegionBlocks::add_block(uint32_t label, uint32_t block) noexcept {
    try {
        List& list = list_of(label);
        if (list.count == anywhere) return;
        if (list.count < most_blocks) return append(list, block);
        clear(list);
        list.count = anywhere;
    } catch (const std::bad_alloc&) {
        followed_ = false;
    }
}

Task<void> RegionBlocks::restart(Pace& pace, RegionBlocks& blocks, uint32_t first_label) {
    blocks.last_label_ = UINT32_MAX;
    const auto pages = static_cast<uint32_t>(blocks.page_of_.size());
    co_await each(pace, std::min(first_label / page_labels, pages), pages, Cost::hundreds_of_ns, [&](uint32_t place) {
        if (blocks.page_of_[place] == none) return;
        Page& page = blocks.pages_[blocks.page_of_[place]];
        const uint32_t begin = place * page_labels < first_label ? first_label % page_labels : 0;
        for (uint32_t i = begin; i < page_labels; ++i) blocks.clear(page[i]);
    });
    if (first_label <= blocks.first_doubtful_) blocks.first_doubtful_ = UINT32_MAX;
}

Task<void> RegionBlocks::begin(Pace& pace, RegionBlocks& blocks, uint32_t label) {
    blocks.followed_ = false;
    co_await restart(pace, blocks, 0);
    blocks.list_of(label).count = anywhere;
    blocks.followed_ = true;
}

bool RegionBlocks::give_back() {
    constexpr uint32_t at_once = 2000;
    followed_ = false;
    for (uint32_t i = 0; i < at_once && !chunks_.empty(); ++i) chunks_.pop_back();
    return !chunks_.empty();
}

}  // namespace flg
