// SPDX-License-Identifier: MIT
// Makes the triangles of a surface even: vertices move towards the mean of their neighbours, along the surface, and back onto it
// (Newton's method along the gradient); sides are flipped towards Delaunay where that keeps the surface and the manifold.
#pragma once

#include <optional>
#include <vector>

#include "inflation/mesh_sides.h"
#include "inflation/part_union.h"

namespace flg {

class MeshImprovement {
public:
    // Of a closed manifold near the surface of the union, with sides of about `spacing`. All outlive the kernel.
    MeshImprovement(const PartUnion& parts, double spacing, std::pmr::vector<Vec3>& positions,
                    std::pmr::vector<TriangleVertices>& triangles, Memory* memory);

    // A unit is about 0.5 us.
    bool run(uint32_t count);

    // After the end: by vertex.
    std::span<const PartUnion::Sample> samples() const { return {samples_.data(), samples_.size()}; }

private:
    enum class Pass { land, sides, flip, clear, gather, move, done };

    void step();
    void land(uint32_t vertex);
    void move(uint32_t vertex);
    void flip(uint32_t triangle);
    bool improves(uint32_t triangle, uint32_t side, uint32_t other, uint32_t other_side) const;
    bool joined(uint32_t triangle, uint32_t corner, uint32_t vertex) const;
    void begin_flips();

    const PartUnion& parts_;
    double spacing_;
    std::pmr::vector<Vec3>& positions_;
    std::pmr::vector<TriangleVertices>& triangles_;
    Memory* memory_;
    Buffer<PartUnion::Sample> samples_;
    Buffer<Vec3> sums_;
    Buffer<uint32_t> counts_;
    Buffer<Across> across_;
    std::optional<MeshSides> sides_;
    uint32_t round_ = 0, flips_ = 0, flip_round_ = 0;
    Pass pass_ = Pass::land;
    uint32_t at_ = 0;
};

}  // namespace flg
