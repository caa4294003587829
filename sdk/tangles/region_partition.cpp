// SPDX-License-Identifier: MIT
#include "tangles/region_partition.h"

#include <algorithm>

#include "tangles/passes.h"

namespace flg {

RegionPartitionKernel::RegionPartitionKernel(const Mesh& mesh, const RegionSet& leaves,
                                             const std::pmr::deque<Corner>& edges, Memory* memory)
    : mesh_(mesh),
      leaves_(leaves),
      edges_(edges),
      cells_(mesh.triangle_count(), memory),
      waiting_(mesh.triangle_count(), memory),
      borders_(memory),
      components_(memory),
      joined_(memory),
      cursor_(mesh, leaves) {}

void RegionPartitionKernel::mark(Corner edge) {
    for (const Corner side : {edge, mesh_.opposite(edge)}) {
        if (side != no_index && is_within(triangle_of(side))) cells_[triangle_of(side)] |= 1u << side % 3;
    }
}

// Takes a triangle into the last component.
void RegionPartitionKernel::visit(uint32_t triangle) {
    cells_[triangle] |= static_cast<uint32_t>(8 * components_.size());
    waiting_[waiting_count_++] = triangle;
}

void RegionPartitionKernel::flood(uint32_t triangle) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbours[triangle][k];
        if (other == no_index || (cells_[triangle] >> k & 1) != 0) continue;
        if (mesh_.regions[other] == mesh_.regions[triangle]) {
            if (cells_[other] < 8) visit(other);
        } else if (other < triangle && is_within(other)) {
            borders_.push_back(3 * triangle + k);
        }
    }
}

uint32_t RegionPartitionKernel::root_of(uint32_t component) {
    while (joined_[component] != component) component = joined_[component] = joined_[joined_[component]];
    return component;
}

// Across the borders between leaves a part goes on.
void RegionPartitionKernel::join(Corner edge) {
    const uint32_t a = root_of(component_of(triangle_of(edge)));
    const uint32_t b = root_of(component_of(mesh_.neighbour_at(edge)));
    joined_[std::max(a, b)] = std::min(a, b);
}

void RegionPartitionKernel::number(uint32_t component) {
    const uint32_t root = root_of(component);
    components_[component].part = root == component ? part_count_++ : components_[root].part;
}

// A unit; false at the end of a pass.
bool RegionPartitionKernel::step() {
    uint32_t triangle = no_index;
    switch (pass_) {
        case Pass::clear:
            cursor_.next_64([this](uint32_t cleared) { cells_[cleared] = 0; });
            if (!cursor_.at_end()) return true;
            cursor_.restart();
            return false;
        case Pass::mark:
            if (at_ == edges_.size()) return false;
            mark(edges_[at_++]);
            return true;
        case Pass::flood:
            if (waiting_count_ > 0) {
                flood(waiting_[--waiting_count_]);
                return true;
            }
            triangle = cursor_.next();
            if (triangle == no_index || cells_[triangle] >= 8) return !cursor_.at_end();
            joined_.push_back(static_cast<uint32_t>(components_.size()));
            components_.push_back({mesh_.regions[triangle], 0, triangle});
            visit(triangle);
            return true;
        case Pass::join:
            if (at_ == borders_.size()) return false;
            join(borders_[at_++]);
            return true;
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
