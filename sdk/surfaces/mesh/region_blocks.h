// SPDX-License-Identifier: MIT
// Where in a mesh the triangles of a label may be: for each label the blocks of 16 triangles that have or once had it.
// So work on a small region costs that region, not the mesh.
//
// Invariants
// - A block is listed from when one of its triangles gets the label, and stays listed when none has it any more. So a
//   change that is taken back, or made again, changes nothing here.
// - A label in more than most_blocks blocks, or one that is in doubt, may be anywhere.
// - Each operation takes constant time; memory that is given back is used again.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/memory.h"
#include "runtime/pace.h"
#include "runtime/task.h"

namespace flg {

class RegionBlocks {
public:
    static constexpr uint32_t block_size = 16;  // triangles: a cache line of labels
    // Of one label; more are not worth a list: reading all labels of the mesh is cheaper than the work on them.
    static constexpr uint32_t most_blocks = 1u << 14;

    explicit RegionBlocks(Memory* memory) : page_of_(memory), pages_(memory), chunks_(memory) {}

    // From now on labels are followed; all triangles have this one.
    static Task<void> begin(Pace& pace, RegionBlocks& blocks, uint32_t label);
    // No triangle has any label from this one on, and none will be given back to one.
    static Task<void> restart(Pace& pace, RegionBlocks& blocks, uint32_t first_label);
    // Labels from this one on may be anywhere, until they are restarted.
    void doubt(uint32_t first_label) noexcept { first_doubtful_ = std::min(first_doubtful_, first_label); }

    // A triangle gets a label. Where memory runs out labels may be anywhere.
    void add(uint32_t label, uint32_t triangle) noexcept {
        const uint32_t block = triangle / block_size;
        if (!followed_ || (label == last_label_ && block == last_block_)) return;
        last_label_ = label;
        last_block_ = block;
        add_block(label, block);
    }
    // Calls visit(block) for the blocks of a label, some more than once; false if it may be anywhere.
    template <class Visit>
    bool visit(uint32_t label, Visit visit) const {
        if (!followed_ || label >= first_doubtful_) return false;
        const uint32_t place = label / page_labels;
        if (place >= page_of_.size() || page_of_[place] == none) return true;
        const List& list = pages_[page_of_[place]][label % page_labels];
        if (list.count == anywhere) return false;
        for (uint32_t at = list.first; at != none; at = chunks_[at].next)
            for (uint32_t i = 0; i < chunks_[at].count; ++i) visit(chunks_[at].blocks[i]);
        return true;
    }

    // Gives back some of the memory; false when there is no more.
    bool give_back();

private:
    static constexpr uint32_t page_labels = 64;
    static constexpr uint32_t none = UINT32_MAX, anywhere = UINT32_MAX;

    struct Chunk {
        uint32_t next, count;
        std::array<uint32_t, 14> blocks;
    };
    struct List {
        uint32_t first = none, last = none;  // chunks
        uint32_t count = 0;                  // of blocks, or anywhere
    };
    using Page = std::array<List, page_labels>;

    void add_block(uint32_t label, uint32_t block) noexcept;
    List& list_of(uint32_t label);
    void append(List& list, uint32_t block);
    void clear(List& list) noexcept;

    std::pmr::vector<uint32_t> page_of_;  // by label / page_labels
    std::pmr::deque<Page> pages_;
    std::pmr::deque<Chunk> chunks_;
    uint32_t free_ = none;  // the first of the chunks that are of no list
    bool followed_ = false;
    uint32_t first_doubtful_ = UINT32_MAX;
    uint32_t last_label_ = UINT32_MAX, last_block_ = 0;  // that were added
};

}  // namespace flg
