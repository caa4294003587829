// SPDX-License-Identifier: MIT
// Normals that all point to the same side: along a spanning tree of the neighbours graph that prefers neighbours whose
// normals are nearly parallel (Hoppe, DeRose, Duchamp, McDonald, Stuetzle: Surface reconstruction from unorganized
// points, 1992). Of each connected part, the normal of its highest point (along z) points up: outwards, if the part is
// closed.
#pragma once

#include <array>

#include "surfaces/mesh.h"

namespace flg {

class CloudOrientationKernel {
public:
    // `neighbours`: as many of each point as `per_point`, no_index where there are fewer. `normals`, of unit length or
    // 0, are turned over in place. All outlive the kernel. Memory: 24 bytes a point and 4 a neighbour.
    CloudOrientationKernel(const Buffer<Position>& places, const Buffer<uint32_t>& neighbours, uint32_t per_point,
                           Buffer<Position>& normals, Memory* memory);
    // A unit is a point or a neighbour in one of six passes: 2 to 30 ns.
    bool run(uint32_t count);
    // After run() returned true: connected parts.
    uint32_t parts() const { return parts_; }

private:
    static constexpr uint32_t buckets = 64;  // by angle, from parallel to perpendicular
    enum class Pass { clear, count, sum, place, grow, done };
    struct Node {
        uint32_t next, previous;  // in its bucket's list
        uint32_t from;            // the neighbour to follow
        uint32_t bucket;          // `buckets`: in none; no_index: done
    };

    void step_grow();
    bool take_next();
    void visit(uint32_t point);
    void relax(uint32_t point);
    void unlink(uint32_t point);

    const Buffer<Position>& places_;
    const Buffer<uint32_t>& neighbours_;
    const uint32_t points_, per_point_;
    Buffer<Position>& normals_;
    Buffer<Node> nodes_;
    Buffer<uint32_t> ends_, back_;  // whose neighbour a point is: back[ends[i - 1]] to back[ends[i] - 1]
    Buffer<uint32_t> order_;        // points as they were visited
    std::array<uint32_t, buckets> heads_;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
    uint32_t current_ = no_index, edge_ = 0;                    // whose neighbours are looked at
    uint32_t seed_ = 0, visited_ = 0, first_ = 0, turned_ = 0;  // the part began with order[first]
    uint32_t lowest_ = buckets, top_ = no_index, parts_ = 0;
    bool turning_ = false;
};

}  // namespace flg
