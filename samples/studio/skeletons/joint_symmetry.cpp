// SPDX-License-Identifier: MIT
#include "skeletons/joint_symmetry.h"

namespace flg::studio {
namespace {

constexpr float kSamePlace = 0.01f;  // of the model's size: what a hand draws on both sides is the same
constexpr size_t kMostSearched = 400;

bool are_sides(const std::string& a, const std::string& b) {
    const bool have_sides = (a.ends_with(".L") && b.ends_with(".R")) || (a.ends_with(".R") && b.ends_with(".L"));
    return have_sides && a.compare(0, a.size() - 1, b, 0, b.size() - 1) == 0;
}

std::optional<JointSymmetry> symmetry_in(const Rig& rig, const glm::vec4& plane) {
    JointSymmetry symmetry{plane, {}};
    const float near = kSamePlace * rig.size;
    for (size_t j = 0; j < rig.count(); ++j) {
        const glm::vec3 image = mirrored_in(plane, rig.rest[j]);
        uint32_t found = FLG_NO_INDEX;
        for (uint32_t k = 0; k < rig.count() && found == FLG_NO_INDEX; ++k)
            if (glm::distance(rig.rest[k], image) < near) found = k;
        if (found == FLG_NO_INDEX) return std::nullopt;
        symmetry.pairs.push_back(found);
    }
    return symmetry;
}

}  // namespace

glm::vec3 mirrored_in(const glm::vec4& plane, const glm::vec3& point) {
    const glm::vec3 normal(plane);
    return point - 2.0f * (glm::dot(normal, point) - plane.w) * normal;
}

std::optional<JointSymmetry> symmetry_of(const Rig& rig) {
    if (rig.count() > kMostSearched) return std::nullopt;
    // Of mirrored parts first: their plane is exact.
    for (const bool of_sides : {true, false})
        for (uint32_t a = 0; a < rig.count(); ++a)
            for (uint32_t b = a + 1; b < rig.count(); ++b) {
                if (of_sides && !are_sides(rig.keys[a], rig.keys[b])) continue;
                const glm::vec3 across = rig.rest[b] - rig.rest[a];
                if (rig.child_counts[a] != rig.child_counts[b] || glm::length(across) < 2.0f * kSamePlace * rig.size)
                    continue;
                const glm::vec3 normal = glm::normalize(across);
                const glm::vec4 plane(normal, glm::dot(normal, 0.5f * (rig.rest[a] + rig.rest[b])));
                if (auto found = symmetry_in(rig, plane)) return found;
            }
    return std::nullopt;
}

}  // namespace flg::studio
