// SPDX-License-Identifier: MIT
// An object's placement: scales, rotates and translates from its own space into the world.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "filigree_renderer/camera.h"

namespace flg::render {

struct Placement {
    glm::vec3 at{0.0f};                      // metres
    glm::quat turn{1.0f, 0.0f, 0.0f, 0.0f};  // unit length
    float scale = 1.0f;                      // > 0

    bool operator==(const Placement&) const = default;
    bool is_identity() const { return *this == Placement{}; }
    glm::vec3 point(const glm::vec3& own) const { return at + scale * (turn * own); }
    glm::vec3 direction(const glm::vec3& own) const { return turn * own; }
    Placement inverse() const {
        const glm::quat back = glm::conjugate(turn);
        return {back * (-at / scale), back, 1.0f / scale};
    }
    // Applies `other` first, then this.
    Placement operator*(const Placement& other) const {
        return {point(other.at), glm::normalize(turn * other.turn), scale * other.scale};
    }
    // A box around the placed box.
    Box box(const Box& own) const {
        if (own.empty() || is_identity()) return own;
        const glm::vec3 half = 0.5f * (own.max - own.min);
        const glm::mat3 axes = glm::mat3_cast(turn);
        const glm::vec3 reach =
            scale * (glm::abs(axes[0]) * half.x + glm::abs(axes[1]) * half.y + glm::abs(axes[2]) * half.z);
        const glm::vec3 middle = point(own.center());
        return {middle - reach, middle + reach};
    }
};

}  // namespace flg::render
