// SPDX-License-Identifier: MIT
// The triangles of regions, one after the other. Of small regions it knows where they are (region_blocks.h); else what
// lies outside costs the reading of its label, about a millisecond for two million.
#pragma once

#include <algorithm>
#include <bit>

#include "surfaces/mesh/block_map.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

class RegionCursor {
public:
    // Both outlive the cursor. Labels may change behind it, to those of other regions too.
    RegionCursor(const Mesh& mesh, const RegionSet& regions)
        : mesh_(mesh), regions_(regions), map_(mesh, regions.memory()) {
        if (!regions.all()) regions.visit([this](uint32_t label) { return map_.add(label); });
        map_.close();
    }

    // It looks at a part of the mesh only.
    bool is_local() const { return !map_.everything(); }

    // The next triangle, rising; no_index if it only looked at 64 more labels, or at_end(). 5 to 50 ns.
    uint32_t next() {
        if (bits_ == 0) {
            if (!at_end()) look();
            return no_index;
        }
        const auto bit = static_cast<uint32_t>(std::countr_zero(bits_));
        bits_ &= bits_ - 1;
        return first_ + bit;
    }
    // Calls visit(triangle) for those of the next 64.
    template <class Visit>
    void next_64(Visit visit) {
        look();
        for (; bits_ != 0; bits_ &= bits_ - 1) visit(first_ + static_cast<uint32_t>(std::countr_zero(bits_)));
    }
    bool at_end() const { return bits_ == 0 && end_ >= mesh_.triangle_count(); }
    // Back to the first triangle.
    void restart() {
        end_ = 0;
        bits_ = 0;
        label_ = no_index;
    }

private:
    void look() {
        const uint32_t word = map_.next(end_ / 64);
        first_ = word == no_index || end_ >= mesh_.triangle_count() ? mesh_.triangle_count() : 64 * word;
        end_ = std::min(first_ + 64, mesh_.triangle_count());
        if (first_ == end_) return;
        uint32_t others = 0;  // labels
        for (uint32_t t = first_; t < end_; ++t) others |= mesh_.regions[t] ^ label_;
        if (others == 0) {
            if (inside_ != 0) bits_ = ~uint64_t{0} >> (64 - (end_ - first_));
            return;
        }
        for (uint32_t t = first_; t < end_; ++t) {
            const uint32_t label = mesh_.regions[t];
            if (label != label_) {
                label_ = label;
                inside_ = regions_.contains(label) ? 1 : 0;
            }
            bits_ |= inside_ << (t - first_);
        }
    }

    const Mesh& mesh_;
    const RegionSet& regions_;
    BlockMap map_;
    uint32_t first_ = 0, end_ = 0;  // of the triangles that were looked at last
    uint64_t bits_ = 0;             // those of them that are still to come
    uint32_t label_ = no_index;     // the last one looked at
    uint64_t inside_ = 0;           // 1: it is one of the regions'
};

}  // namespace flg
