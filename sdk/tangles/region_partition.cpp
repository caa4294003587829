// SPDX-License-Identifier: MIT
#include "tangles/region_partition.h"

#include <algorithm>

#include "tangles/passes.h"

namespace flg {

namespace {

constexpr uint32_t skip = 16;  // triangles outside that one unit passes over

}  // namespace

RegionPartitionKernel::RegionPartitionKernel(const Mesh& mesh, const RegionSet& leaves,
                                             const std::pmr::deque<Corner>& edges, Memory* memory)
    : mesh_(mesh),
      leaves_(leaves),
      edges_(edges),
      cells_(mesh.triangle_count(), memory),
      waiting_(mesh.triangle_count(), memory),
      components_(memory),
      joined_(memory) {}

void RegionPartitionKernel::mark(Corner edge) {
    cells_[edge / 3] |= 1u << edge % 3;
    const Corner across = mesh_.opposite(edge);
    if (across != no_index) cells_[across / 3] |= 1u << across % 3;
}

// Takes a triangle into the last component.
void RegionPartitionKernel::visit(uint32_t triangle) {
    cells_[triangle] |= static_cast<uint32_t>(8 * components_.size());
    waiting_[waiting_count_++] = triangle;
}

void RegionPartitionKernel::flood(uint32_t triangle) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbours[triangle][k];
        if (other == no_index || (cells_[triangle] >> k & 1) != 0 || cells_[other] >= 8) continue;
        if (mesh_.regions[other] == mesh_.regions[triangle]) visit(other);
    }
}

uint32_t RegionPartitionKernel::root_of(uint32_t component) {
    while (joined_[component] != component) component = joined_[component] = joined_[joined_[component]];
    return component;
}

// Across the borders between leaves a part goes on.
void RegionPartitionKernel::join(uint32_t triangle) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbours[triangle][k];
        if (other == no_index || other > triangle || cells_[other] < 8 || (cells_[triangle] >> k & 1) != 0) continue;
        const uint32_t a = root_of(component_of(triangle)), b = root_of(component_of(other));
        joined_[std::max(a, b)] = std::min(a, b);
    }
}

void RegionPartitionKernel::number(uint32_t component) {
    const uint32_t root = root_of(component);
    components_[component].part = root == component ? part_count_++ : components_[root].part;
}

// A unit; false at the end of a pass.
bool RegionPartitionKernel::step() {
    const uint32_t triangles = mesh_.triangle_count();
    switch (pass_) {
        case Pass::clear:
            for (const uint32_t end = std::min(triangles, at_ + skip); at_ < end; ++at_) cells_[at_] = 0;
            return at_ < triangles;
        case Pass::mark:
            if (at_ == edges_.size()) return false;
            mark(edges_[at_++]);
            return true;
        case Pass::flood:
            if (waiting_count_ > 0) {
                flood(waiting_[--waiting_count_]);
                return true;
            }
            for (const uint32_t end = std::min(triangles, at_ + skip); at_ < end; ++at_) {
                if (cells_[at_] >= 8 || !leaves_.contains(mesh_.regions[at_])) continue;
                joined_.push_back(static_cast<uint32_t>(components_.size()));
                components_.push_back({mesh_.regions[at_], 0, at_});
                visit(at_);
                return true;
            }
            return at_ < triangles;
        case Pass::join:
            for (const uint32_t end = std::min(triangles, at_ + skip); at_ < end;) {
                const uint32_t triangle = at_++;
                if (cells_[triangle] < 8) continue;
                join(triangle);
                break;
            }
            return at_ < triangles;
        case Pass::number:
            if (at_ == components_.size()) return false;
            number(at_++);
            return true;
        case Pass::done: break;
    }
    return false;
}

bool RegionPartitionKernel::run(uint32_t count) {
    return run_passes(count, pass_, at_, [this] { return step(); });
}

}  // namespace flg
