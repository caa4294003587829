// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_compact.h"

namespace flg {

DropTrianglesKernel::DropTrianglesKernel(GrowingBuffer<Triple>& triangles, uint32_t input_triangle_count, IndexMap& map,
                                         Memory* memory)
    : triangles_(triangles), map_(map), first_(map.is_identity()) {
    if (!first_) return;
    map.of_input = Buffer<uint32_t>(input_triangle_count, memory);
    map.to_input = GrowingBuffer<uint32_t>(input_triangle_count, memory);
}

bool DropTrianglesKernel::run(uint32_t count) {
    for (; first_ && mapped_ < map_.of_input.size(); ++mapped_, --count) {
        if (count == 0) return false;
        map_.of_input[mapped_] = map_.to_input[mapped_] = mapped_;
    }
    for (; at_ < triangles_.size(); ++at_, --count) {
        if (count == 0) return false;
        const uint32_t from = map_.to_input[at_];
        if (is_dropped(triangles_[at_])) {
            map_.of_input[from] = no_index;
        } else {
            map_.of_input[from] = kept_;
            map_.to_input[kept_] = from;
            triangles_[kept_++] = triangles_[at_];
        }
    }
    triangles_.resize(kept_);
    map_.to_input.resize(kept_);
    return true;
}

NumberVerticesKernel::NumberVerticesKernel(GrowingBuffer<Position>& positions, const FansKernel& fans,
                                           const Buffer<uint32_t>& welded, const std::pmr::deque<uint32_t>& copies,
                                           IndexMap& map, Memory* memory)
    : positions_(positions), fans_(fans), welded_(welded), copies_(copies), map_(map) {
    const size_t count = fans.used_count() + copies.size();
    placed_ = GrowingBuffer<Position>(count, memory);
    map.of_input = Buffer<uint32_t>(positions.size(), memory);
    map.to_input = GrowingBuffer<uint32_t>(count, memory);
}

// What a vertex was welded to comes before it.
void NumberVerticesKernel::number(uint32_t vertex) {
    if (!welded_.empty() && welded_[vertex] != vertex) {
        map_.of_input[vertex] = map_.of_input[welded_[vertex]];
    } else if (fans_.is_used(vertex)) {
        placed_[kept_] = positions_[vertex];
        map_.to_input[kept_] = vertex;
        map_.of_input[vertex] = kept_++;
    } else {
        map_.of_input[vertex] = no_index;
    }
}

bool NumberVerticesKernel::run(uint32_t count) {
    const size_t vertices = map_.of_input.size();
    for (; at_ < vertices; ++at_, --count) {
        if (count == 0) return false;
        number(at_);
    }
    for (; at_ < vertices + copies_.size(); ++at_, --count) {
        if (count == 0) return false;
        const uint32_t from = copies_[at_ - vertices];
        placed_[kept_] = positions_[from];
        map_.to_input[kept_++] = from;
    }
    positions_ = std::move(placed_);
    return true;
}

}  // namespace flg
