// SPDX-License-Identifier: MIT
#include "inflation/mesh_improvement.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 16;
constexpr uint32_t rounds = 6;               // of smoothing
constexpr uint32_t flips_before[] = {1, 3};  // rounds that flips come before
constexpr uint32_t most_flip_rounds = 4;
constexpr uint32_t newton_steps = 5;  // at most; one or two as a rule
constexpr double near_enough = 1e-3;  // by the spacing
constexpr double longest_step = 0.5;  // onto the surface, by the spacing
constexpr double least_turn = 0.3;    // cosine between triangles whose side may be flipped
constexpr double noise = 1e-9;

}  // namespace

MeshImprovement::MeshImprovement(const PartUnion& parts, double spacing, std::pmr::vector<Vec3>& positions,
                                 std::pmr::vector<TriangleVertices>& triangles, Memory* memory)
    : parts_(parts),
      spacing_(spacing),
      positions_(positions),
      triangles_(triangles),
      memory_(memory),
      samples_(positions.size(), memory),
      sums_(positions.size(), memory),
      counts_(positions.size(), memory),
      across_(triangles.size(), memory) {}

bool MeshImprovement::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void MeshImprovement::step() {
    const auto vertices = static_cast<uint32_t>(positions_.size()),
               triangles = static_cast<uint32_t>(triangles_.size());
    const auto enter = [this](Pass pass) {
        at_ = 0;
        pass_ = pass;
    };
    switch (pass_) {
        case Pass::land:
            for (const uint32_t stop = std::min(vertices, at_ + 2); at_ < stop; ++at_) land(at_);
            if (at_ == vertices) {
                sides_.emplace(vertices, triangles_, std::span<Across>(across_.data(), triangles), memory_);
                enter(Pass::sides);
            }
            break;
        case Pass::sides:
            if (!sides_->run(1)) break;
            sides_.reset();
            enter(Pass::clear);
            break;
        case Pass::flip:
            for (const uint32_t stop = std::min(triangles, at_ + batch / 4); at_ < stop; ++at_) flip(at_);
            if (at_ < triangles) break;
            if (flips_ == 0 || ++flip_round_ == most_flip_rounds) {
                enter(Pass::clear);
            } else {
                flips_ = 0;
                at_ = 0;
            }
            break;
        case Pass::clear:
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                std::construct_at(&sums_[at_], Vec3::Zero());
                counts_[at_] = 0;
            }
            if (at_ == vertices) enter(Pass::gather);
            break;
        case Pass::gather:
            for (const uint32_t stop = std::min(triangles, at_ + batch); at_ < stop; ++at_) {
                const TriangleVertices& t = triangles_[at_];
                for (uint32_t k = 0; k < 3; ++k) {
                    sums_[t[k]] += positions_[t[(k + 1) % 3]];
                    ++counts_[t[k]];
                }
            }
            if (at_ == triangles) enter(Pass::move);
            break;
        case Pass::move:
            for (const uint32_t stop = std::min(vertices, at_ + 2); at_ < stop; ++at_) move(at_);
            if (at_ < vertices) break;
            if (++round_ == rounds) {
                pass_ = Pass::done;
            } else if (std::find(std::begin(flips_before), std::end(flips_before), round_) != std::end(flips_before)) {
                flips_ = flip_round_ = 0;
                enter(Pass::flip);
            } else {
                enter(Pass::clear);
            }
            break;
        case Pass::done: break;
    }
}

// Onto the surface, along the gradient.
void MeshImprovement::land(uint32_t vertex) {
    Vec3& p = positions_[vertex];
    PartUnion::Sample sample = parts_.sample(p);
    double share = 1;
    for (uint32_t i = 0; i < newton_steps; ++i) {
        const double steep = sample.gradient.squaredNorm();
        if (steep < noise || std::fabs(sample.value) < near_enough * spacing_) break;
        const double along =
            std::clamp(sample.value / std::sqrt(steep), -longest_step * spacing_, longest_step * spacing_);
        const Vec3 next = p - share * along / std::sqrt(steep) * sample.gradient;
        const PartUnion::Sample there = parts_.sample(next);
        if (std::fabs(there.value) >= std::fabs(sample.value)) {
            // Too far, next to an edge of the surface.
            share /= 2;
            continue;
        }
        p = next;
        sample = there;
    }
    std::construct_at(&samples_[vertex], sample);
}

void MeshImprovement::move(uint32_t vertex) {
    Vec3 step = sums_[vertex] / counts_[vertex] - positions_[vertex];
    const Vec3& normal = samples_[vertex].gradient;
    const double steep = normal.squaredNorm();
    if (steep > noise) step -= normal * (normal.dot(step) / steep);
    positions_[vertex] += step;
    land(vertex);
}

// Whether a vertex is next to the vertex at a corner of a triangle.
bool MeshImprovement::joined(uint32_t triangle, uint32_t corner, uint32_t vertex) const {
    const uint32_t centre = triangles_[triangle][corner];
    uint32_t here = triangle, k = corner;
    do {
        if (triangles_[here][(k + 1) % 3] == vertex) return true;
        here = across_[here][(k + 1) % 3];
        const TriangleVertices& t = triangles_[here];
        k = t[0] == centre ? 0 : t[1] == centre ? 1 : 2;
    } while (here != triangle);
    return false;
}

bool MeshImprovement::improves(uint32_t triangle, uint32_t side, uint32_t other, uint32_t other_side) const {
    const TriangleVertices &t = triangles_[triangle], &o = triangles_[other];
    const uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3], d = o[other_side];
    const Vec3 &pa = positions_[a], &pb = positions_[b], &pc = positions_[c], &pd = positions_[d];
    const Vec3 first = (pb - pa).cross(pc - pa), second = (pc - pd).cross(pb - pd);
    const double lengths = first.norm() * second.norm();
    // The cotangents at a and d: their sum is below 0 if the angles are more than half a turn.
    const double cosine_a = (pb - pa).dot(pc - pa), cosine_d = (pc - pd).dot(pb - pd);
    if (cosine_a * second.norm() + cosine_d * first.norm() >= -noise * lengths) return false;
    if (first.dot(second) < least_turn * lengths) return false;
    const Vec3 made = (pb - pa).cross(pd - pa), made_too = (pd - pa).cross(pc - pa), both = first + second;
    if (made.dot(both) <= least_turn * made.norm() * both.norm() ||
        made_too.dot(both) <= least_turn * made_too.norm() * both.norm())
        return false;
    return !joined(triangle, side, d);
}

// Of triangles (a, b, c) and (d, c, b) makes (a, b, d) and (a, d, c).
void MeshImprovement::flip(uint32_t triangle) {
    for (uint32_t side = 0; side < 3; ++side) {
        const uint32_t other = across_[triangle][side];
        const TriangleVertices t = triangles_[triangle], o = triangles_[other];
        const uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
        const uint32_t j = o[0] != b && o[0] != c ? 0 : o[1] != b && o[1] != c ? 1 : 2;
        const uint32_t d = o[j];
        if (a == d || !improves(triangle, side, other, j)) continue;
        const uint32_t beyond_ab = across_[triangle][(side + 2) % 3], beyond_ca = across_[triangle][(side + 1) % 3];
        const uint32_t beyond_bd = across_[other][(j + 1) % 3], beyond_dc = across_[other][(j + 2) % 3];
        triangles_[triangle] = {a, b, d};
        across_[triangle] = {beyond_bd, other, beyond_ab};
        triangles_[other] = {a, d, c};
        across_[other] = {beyond_dc, beyond_ca, triangle};
        for (uint32_t& across : across_[beyond_bd])
            if (across == other) across = triangle;
        for (uint32_t& across : across_[beyond_ca])
            if (across == triangle) across = other;
        ++flips_;
        return;
    }
}

}  // namespace flg
