// SPDX-License-Identifier: MIT
// The plane that a skeleton is its own mirror image of.
#pragma once

#include <optional>

#include "skeletons/rig.h"

namespace flg::studio {

struct JointSymmetry {
    glm::vec4 plane{0.0f};        // a x + b y + c z = d, a normal of length 1
    std::vector<uint32_t> pairs;  // one a joint: its mirror image; itself on the plane
};

// None if there is no such plane with a joint to its side. Cost: for n joints at most n^4 / 2 steps of 1 ns, as a rule
// n^3: found with the first pair that fits.
std::optional<JointSymmetry> symmetry_of(const Rig& rig);

glm::vec3 mirrored_in(const glm::vec4& plane, const glm::vec3& point);

}  // namespace flg::studio
