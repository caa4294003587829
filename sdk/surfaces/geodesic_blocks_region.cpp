// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_blocks_region.h"

#include <bit>

namespace flg {

GeodesicRegionKernel::GeodesicRegionKernel(const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& within,
                                           GeodesicRegion& region, Memory* memory)
    : mesh_(mesh),
      surface_(blocks),
      within_(within),
      region_(region),
      memory_(memory),
      ends_(memory),
      cursor_(mesh, within) {}

bool GeodesicRegionKernel::at_end() const {
    switch (pass_) {
        case Pass::find: return cursor_.at_end();
        case Pass::clear: return at_ == region_.slots_.size();
        default: return at_ == ends_.size();
    }
}

bool GeodesicRegionKernel::run(uint32_t count) {
    while (pass_ != Pass::done) {
        if (at_end()) {
            at_ = 0;
            if (pass_ == Pass::find && !ends_.empty()) {
                region_.slots_ = Buffer<GeodesicRegion::Slot>(std::bit_ceil(2 * ends_.size()), memory_);
                region_.mask_ = static_cast<uint32_t>(region_.slots_.size()) - 1;
            }
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
            continue;
        }
        if (count-- == 0) return false;
        switch (pass_) {
            case Pass::find: find_ends(cursor_.next()); break;
            case Pass::clear: region_.slots_[at_++] = {nowhere, 0}; break;
            default: close(ends_[at_++]); break;
        }
    }
    return true;
}

// A fan that is partly outside has an edge between its inner and outer triangles.
void GeodesicRegionKernel::find_ends(uint32_t triangle) {
    if (triangle == no_index) return;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t neighbour = mesh_.neighbours[triangle][k];
        if (neighbour == no_index || within_.contains(mesh_.regions[neighbour])) continue;
        ends_.push_back(mesh_.triangles[triangle][k]);
        ends_.push_back(mesh_.triangles[triangle][(k + 1) % 3]);
    }
}

// The triangles between lanes are in the order of the fan's corners. Lanes of no triangle inside are closed themselves.
void GeodesicRegionKernel::close(uint32_t vertex) {
    const uint32_t rank = surface_.rank_of_vertex[vertex];
    if (region_.find(rank) != nullptr) return;
    uint32_t slot = region_.slot_of(rank);
    while (region_.slots_[slot & region_.mask_].rank != nowhere) ++slot;
    region_.slots_[slot & region_.mask_] = {rank, static_cast<uint32_t>(region_.blocks_.size())};

    Corner corner = mesh_.corner_of_vertex[vertex];
    visit_blocks(surface_, rank, [&](const GeodesicBlock& block, uint32_t) {
        GeodesicBlock& closed = region_.blocks_.emplace_back(block);
        bool before = false;
        for (uint32_t lane = 0; lane < lane_count; ++lane) {
            const bool has_triangle = lane + 1 < lane_count && block.rank(lane + 1) != nowhere;
            const bool inside = has_triangle && within_.contains(mesh_.regions[triangle_of(corner)]);
            if (!inside) closed.tangents[lane] = 0;
            if (!inside && !before) closed.close(lane);
            before = inside;
            if (has_triangle) corner = mesh_.turn(corner);
        }
    });
}

}  // namespace flg
