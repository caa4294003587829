// SPDX-License-Identifier: MIT
#include "surfaces/cut_regions.h"

#include "core/failure.h"
#include "filigree/filigree_surface.h"

namespace flg {

RegionDivider::RegionDivider(Mesh& mesh, const std::pmr::deque<Corner>& edges, uint32_t first_label, MeshEdit& edit,
                             std::pmr::deque<RegionPart>& parts, Memory* memory)
    : mesh_(mesh),
      edges_(edges),
      next_label_(first_label),
      edit_(edit),
      parts_(parts),
      cells_(mesh.triangle_count(), memory),
      waiting_(mesh.triangle_count(), memory),
      components_(memory) {}

void RegionDivider::mark(Corner edge) {
    cells_[edge / 3] |= 1u << edge % 3;
    const Corner across = mesh_.opposite(edge);
    if (across != no_index) cells_[across / 3] |= 1u << across % 3;
}

// Takes a triangle into the last component.
void RegionDivider::visit(uint32_t triangle) {
    cells_[triangle] |= static_cast<uint32_t>(8 * components_.size());
    waiting_[waiting_count_++] = triangle;
}

// From the edges' sides, one after the other; at_ counts sides.
bool RegionDivider::flood(uint32_t& count) {
    for (; count > 0; --count) {
        if (waiting_count_ > 0) {
            const uint32_t triangle = waiting_[--waiting_count_];
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t other = mesh_.neighbours[triangle][k];
                if (other == no_index || (cells_[triangle] >> k & 1) != 0 || cells_[other] >= 8) continue;
                if (mesh_.regions[other] == mesh_.regions[triangle]) visit(other);
            }
            continue;
        }
        if (at_ == 2 * edges_.size()) return true;
        const Corner edge = edges_[at_ / 2];
        const uint32_t triangle = at_ % 2 == 0 ? triangle_of(edge) : mesh_.neighbour_at(edge);
        ++at_;
        if (triangle == no_index || cells_[triangle] >= 8) continue;
        const auto index = static_cast<uint32_t>(components_.size());
        components_.push_back({index, 1, no_index, mesh_.regions[triangle]});
        visit(triangle);
    }
    return false;
}

uint32_t RegionDivider::root_of(uint32_t component) {
    while (components_[component].joined != component) {
        component = components_[component].joined = components_[components_[component].joined].joined;
    }
    return component;
}

// What a chain separates was one before.
void RegionDivider::join(Corner edge) {
    const uint32_t other = mesh_.neighbour_at(edge);
    if (other == no_index || mesh_.regions[other] != mesh_.regions[triangle_of(edge)]) return;
    const uint32_t a = root_of(component_of(triangle_of(edge))), b = root_of(component_of(other));
    if (a == b) return;
    components_[std::max(a, b)].joined = std::min(a, b);
    components_[std::min(a, b)].size += components_[std::max(a, b)].size;
}

void RegionDivider::number(uint32_t component) {
    if (components_[root_of(component)].size == 1) return;
    if (next_label_ > FLG_REGION_MAX) {
        throw Failure(FLG_ERROR_LIMIT, "the parts of regions that fall apart need more labels than up to %u",
                      FLG_REGION_MAX);
    }
    components_[component].label = next_label_++;
    parts_.push_back({components_[component].label, components_[component].old_label});
}

void RegionDivider::relabel(uint32_t triangle) {
    if (cells_[triangle] < 8) return;
    const uint32_t label = components_[component_of(triangle)].label;
    if (label != no_index) edit_.set_region(mesh_, triangle, label);
}

uint32_t RegionDivider::size_of(Pass pass) const {
    switch (pass) {
        case Pass::mark:
        case Pass::join: return static_cast<uint32_t>(edges_.size());
        case Pass::number: return static_cast<uint32_t>(components_.size());
        default: return mesh_.triangle_count();
    }
}

bool RegionDivider::run(uint32_t count) {
    while (count > 0 && pass_ != Pass::done) {
        if (pass_ == Pass::flood) {
            if (!flood(count)) return false;
            pass_ = Pass::join;
            at_ = 0;
        }
        const uint32_t end = static_cast<uint32_t>(std::min<uint64_t>(size_of(pass_), uint64_t{at_} + count));
        count -= end - at_;
        for (; at_ < end; ++at_) {
            switch (pass_) {
                case Pass::clear: cells_[at_] = 0; break;
                case Pass::mark: mark(edges_[at_]); break;
                case Pass::join: join(edges_[at_]); break;
                case Pass::number: number(at_); break;
                case Pass::relabel: relabel(at_); break;
                case Pass::flood:
                case Pass::done: break;
            }
        }
        if (at_ == size_of(pass_)) {
            at_ = 0;
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
