// SPDX-License-Identifier: MIT
// The order in which many rays are best shot: by where they enter the scene, along a Morton curve, so that rays that
// follow each other read the same parts of a large structure while the processor still has them.
#pragma once

#include <vector>

#include "pick/pick_target.h"

namespace flg::pick {

// Below this many the structure's parts that rays read have little in common, whatever the order.
constexpr uint32_t fewest_to_order = 10'000;

// Indices of the rays, each once. `lower` and `upper`: the scene's box, not empty. Memory: 20 bytes a ray.
std::vector<uint32_t> order_rays(const FlgRay* rays, uint32_t count, const Vec3f& lower, const Vec3f& upper);

}  // namespace flg::pick
