// SPDX-License-Identifier: MIT
#include "surfaces/spaced_points.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace flg {

void SpacedPointsKernel::add(uint32_t vertex, float distance) {
    if (vertices_.empty()) origin_ = mesh_.position(vertex);
    const Vec3 place = mesh_.position(vertex) - origin_;
    vertices_.push_back(
        {distance,
         vertex,
         random_bits(seed_, vertex, 0),
         {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())}});
}

void SpacedPointsKernel::begin(float spacing, uint32_t most) {
    spacing_ = spacing;
    most_ = std::min(most, most_points);
}

// Brings a vertex up to date with the last point.
void SpacedPointsKernel::look(uint32_t at) {
    Vertex& vertex = vertices_[at];
    if (point_count_ > 0) {
        float squared = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            const float along = vertex.place[k] - last_point_[k];
            squared += along * along;
        }
        vertex.distance = std::min(vertex.distance, std::sqrt(squared));
    }
    if (furthest_ == nullptr || *furthest_ < vertex) furthest_ = &vertex;
}

bool SpacedPointsKernel::run(uint32_t count) {
    const auto size = static_cast<uint32_t>(vertices_.size());
    for (; count > 0; --count) {
        for (const uint32_t end = std::min(size, at_ + 64); at_ < end; ++at_) look(at_);
        if (at_ < size) continue;
        if (furthest_ == nullptr || furthest_->distance < spacing_ || point_count_ == most_) return true;
        points_[point_count_++] = furthest_->index;
        last_point_ = furthest_->place;
        furthest_ = nullptr;
        at_ = 0;
    }
    return false;
}

}  // namespace flg
