// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_weld.h"

#include <bit>
#include <cmath>

#include "core/random.h"

namespace flg {

VertexWeldKernel::VertexWeldKernel(const GrowingBuffer<Position>& positions, float distance, Memory* memory)
    : positions_(positions),
      distance_(distance),
      first_in_cell_(std::bit_ceil(positions.size()), memory),
      next_in_cell_(positions.size(), memory),
      joined_to_(positions.size(), memory) {}

uint32_t VertexWeldKernel::cell_of(const Vec3& cell) const {
    uint64_t hash = 0;
    for (double x : cell) hash = mix64(hash ^ std::bit_cast<uint64_t>(x + 0.0));  // -0 is 0
    return static_cast<uint32_t>(hash & (first_in_cell_.size() - 1));
}

uint32_t VertexWeldKernel::find(uint32_t cell, const Vec3& position, uint32_t least) const {
    for (uint32_t other = first_in_cell_[cell]; other != no_index; other = next_in_cell_[other]) {
        const double apart = (load_vec3(positions_[other].data()) - position).squaredNorm();
        if (apart <= distance_ * distance_) least = std::min(least, other);
    }
    return least;
}

void VertexWeldKernel::weld(uint32_t vertex) {
    const Vec3 position = load_vec3(positions_[vertex].data());
    uint32_t cell, least = vertex;
    if (distance_ == 0) {
        cell = cell_of(position);
        least = find(cell, position, least);
    } else {
        const Vec3 place = position / (2 * distance_);
        const Vec3 corner = place.array().floor();
        cell = cell_of(corner);
        for (uint32_t k = 0; k < 8; ++k) {
            Vec3 near = corner;
            for (uint32_t axis = 0; axis < 3; ++axis) {
                if (k >> axis & 1) near[axis] += place[axis] - corner[axis] < 0.5 ? -1 : 1;
            }
            least = find(cell_of(near), position, least);
        }
    }
    joined_to_[vertex] = least;
    if (least != vertex) {
        ++welded_count_;
    } else {
        next_in_cell_[vertex] = std::exchange(first_in_cell_[cell], vertex);
    }
}

bool VertexWeldKernel::run(uint32_t count) {
    for (; cleared_ < first_in_cell_.size(); --count) {
        if (count == 0) return false;
        first_in_cell_[cleared_++] = no_index;
    }
    for (; at_ < positions_.size(); --count) {
        if (count == 0) return false;
        weld(at_++);
    }
    return true;
}

}  // namespace flg
