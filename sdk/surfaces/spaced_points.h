// SPDX-License-Identifier: MIT
// Points far from each other in space, each as far as possible from those before it: Gonzalez (1985). What is so far apart in
// space is at least as far apart along any surface.
#pragma once

#include <array>
#include <deque>

#include "surfaces/mesh.h"

namespace flg {

class SpacedPointsKernel {
public:
    // Of how many vertices the points are chosen for each one that there is room for: this fixes how evenly they lie.
    static constexpr uint32_t vertices_a_point = 32;
    static constexpr uint32_t most_points = 512;

    SpacedPointsKernel(const Mesh& mesh, uint64_t seed, Memory* memory) : mesh_(mesh), seed_(seed), vertices_(memory) {}

    // A vertex to choose from, no nearer than `distance` (metres, >= 0) to what points keep away from.
    void add(uint32_t vertex, float distance);
    // At most so many points, up to most_points, no nearer to each other or to what they keep away from than `spacing`, metres.
    void begin(float spacing, uint32_t most);
    // A unit is 64 vertices: about 0.1 us. True when no point fits any more.
    bool run(uint32_t count);

    // In the order they were chosen.
    const std::array<uint32_t, most_points>& points() const { return points_; }
    uint32_t point_count() const { return point_count_; }

private:
    // By distance; of those equally far by a number drawn for it.
    struct Vertex {
        float distance;
        uint32_t index;
        uint64_t draw;
        std::array<float, 3> place;  // from the first vertex

        bool operator<(const Vertex& other) const {
            return distance != other.distance ? distance < other.distance : draw < other.draw;
        }
    };
    void look(uint32_t at);

    const Mesh& mesh_;
    const uint64_t seed_;
    std::pmr::deque<Vertex> vertices_;
    Vec3 origin_;
    std::array<uint32_t, most_points> points_;
    uint32_t point_count_ = 0, most_ = 0;
    float spacing_ = 0;
    const Vertex* furthest_ = nullptr;   // of those looked at in this round
    std::array<float, 3> last_point_{};  // of the round before
    uint32_t at_ = 0;
};

}  // namespace flg
