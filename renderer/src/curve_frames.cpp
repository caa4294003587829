// SPDX-License-Identifier: MIT
// Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, ACM TOG 2008, section 4.
// Given normals need not be perpendicular to the curve: results of flgCurveSetStylize bring their target's.
#include "curve_frames.h"

#include <cmath>

namespace flg::render {
namespace {

glm::vec3 unit(glm::vec3 v) {
    const float size = glm::length(v);
    return size > 0.0f ? v / size : v;
}

glm::vec3 reflect_across(glm::vec3 v, glm::vec3 mirror_normal) {
    const float square = glm::dot(mirror_normal, mirror_normal);
    return square > 0.0f ? v - mirror_normal * (2.0f * glm::dot(v, mirror_normal) / square) : v;
}

glm::vec3 any_normal(glm::vec3 tangent) {
    // The axis that the tangent is least along; y first, so that ribbons of level curves lie flat.
    const glm::vec3 axis = std::abs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return unit(axis - tangent * glm::dot(axis, tangent));
}

// Sine of the angle to the tangent below which a given normal says too little: beside such a point it turns about the
// curve at once.
constexpr float min_said = 0.1f;

// Of points that are positions, or begin with them.
template <class Point>
class Frames {
public:
    Frames(const Point* points, uint32_t count, bool closed) : points_(points), count_(count), closed_(closed) {}

    glm::vec3 tangent(uint32_t i) const {
        const uint32_t before = i > 0 ? i - 1 : closed_ ? count_ - 2 : 0;
        const uint32_t after = i + 1 < count_ ? i + 1 : closed_ ? 1 : i;
        const glm::vec3 in = i > 0 || closed_ ? unit(position(i) - position(before)) : glm::vec3(0);
        const glm::vec3 out = i + 1 < count_ || closed_ ? unit(position(after) - position(i)) : glm::vec3(0);
        const glm::vec3 sum = in + out;
        return glm::dot(sum, sum) > 1e-6f ? unit(sum) : in;  // a full turn back keeps the way in
    }

    // A given normal made perpendicular to the curve; zero if it says too little.
    static glm::vec3 leveled(glm::vec3 given, glm::vec3 tangent) {
        const glm::vec3 direction = unit(given);
        const glm::vec3 level = direction - tangent * glm::dot(direction, tangent);
        return glm::dot(level, level) > min_said * min_said ? unit(level) : glm::vec3(0);
    }

    // The normal at point `from` brought to its neighbour `to`, whose tangents these are.
    glm::vec3 carry(glm::vec3 normal, uint32_t from, uint32_t to, glm::vec3 tangent_from, glm::vec3 tangent_to) const {
        const glm::vec3 chord = unit(position(to) - position(from));
        const glm::vec3 normal_left = reflect_across(normal, chord);
        const glm::vec3 tangent_left = reflect_across(tangent_from, chord);
        const glm::vec3 next = reflect_across(normal_left, tangent_to - tangent_left);
        const glm::vec3 level = next - tangent_to * glm::dot(next, tangent_to);
        return glm::dot(level, level) > 1e-8f ? unit(level) : any_normal(tangent_to);
    }

private:
    glm::vec3 position(uint32_t i) const { return glm::vec3(points_[i]); }

    const Point* points_;
    uint32_t count_;
    bool closed_;
};

}  // namespace

void carry_normals(const glm::vec3* positions, uint32_t count, bool closed, glm::vec3* out_normals) {
    const Frames frames(positions, count, closed);
    glm::vec3 tangent = frames.tangent(0);
    out_normals[0] = any_normal(tangent);
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const glm::vec3 next = frames.tangent(i + 1);
        out_normals[i + 1] = frames.carry(out_normals[i], i, i + 1, tangent, next);
        tangent = next;
    }
    if (!closed || count < 3) return;
    const glm::vec3 last = out_normals[count - 1];
    const float twist = std::atan2(glm::dot(glm::cross(last, out_normals[0]), tangent), glm::dot(last, out_normals[0]));
    for (uint32_t i = 0; i < count; ++i) {
        const float angle = twist * static_cast<float>(i) / static_cast<float>(count - 1);
        const glm::vec3 across = glm::cross(frames.tangent(i), out_normals[i]);
        out_normals[i] = std::cos(angle) * out_normals[i] + std::sin(angle) * across;
    }
}

void follow_normals(const glm::vec3* positions, uint32_t count, bool closed, glm::vec3* in_out_normals) {
    const Frames frames(positions, count, closed);
    uint32_t first = count;  // that has a direction
    for (uint32_t i = 0; i < count; ++i) {
        in_out_normals[i] = frames.leveled(in_out_normals[i], frames.tangent(i));
        if (first == count && in_out_normals[i] != glm::vec3(0)) first = i;
    }
    if (first == count) return carry_normals(positions, count, closed, in_out_normals);
    for (uint32_t i = first; i-- > 0;)
        in_out_normals[i] = frames.carry(in_out_normals[i + 1], i + 1, i, frames.tangent(i + 1), frames.tangent(i));
    glm::vec3 tangent = frames.tangent(first);
    for (uint32_t i = first + 1; i < count; ++i) {
        const glm::vec3 next = frames.tangent(i);
        const glm::vec3 carried = frames.carry(in_out_normals[i - 1], i - 1, i, tangent, next);
        glm::vec3& normal = in_out_normals[i];
        if (normal == glm::vec3(0))
            normal = carried;
        else if (glm::dot(normal, carried) < 0.0f)
            normal = -normal;
        tangent = next;
    }
}

GrowingNormals::GrowingNormals(uint32_t capacity) {
    given_.reserve(capacity);
    normals_.reserve(capacity);
}

void GrowingNormals::truncate(uint32_t count) {
    given_.resize(count);
    normals_.resize(count);
}

uint32_t GrowingNormals::find(const glm::vec4* centers, uint32_t from) {
    const auto count = static_cast<uint32_t>(given_.size());
    const Frames frames(centers, count, false);
    normals_.resize(count);
    // What those before were carried back from may be gone, or turned.
    if (first_said_ != none && first_said_ >= from) {
        first_said_ = none;
        from = 0;
    }
    uint32_t changed = from;
    for (uint32_t i = from; i < count; ++i) {
        const glm::vec3 tangent = frames.tangent(i);
        const glm::vec3 level = frames.leveled(given_[i], tangent);
        if (first_said_ == none && level != glm::vec3(0)) {
            first_said_ = i;
            normals_[i] = level;
            for (uint32_t k = i; k-- > 0;)
                normals_[k] = frames.carry(normals_[k + 1], k + 1, k, frames.tangent(k + 1), frames.tangent(k));
            changed = 0;
            continue;
        }
        const glm::vec3 carried =
            i == 0 ? any_normal(tangent) : frames.carry(normals_[i - 1], i - 1, i, frames.tangent(i - 1), tangent);
        if (level == glm::vec3(0))
            normals_[i] = carried;
        else
            normals_[i] = glm::dot(level, carried) < 0.0f ? -level : level;
    }
    return changed;
}

}  // namespace flg::render
