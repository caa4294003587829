// SPDX-License-Identifier: MIT
// The border of a mesh as the nodes of a curve see it: which way it is, how far away, and what it keeps them from.
//
// A node that the border keeps from going on is pressed: it moves along the border only, up to it. At a corner that
// points out it may come to rest.
#pragma once

#include "splines/manifolds/manifold.h"
#include "splines/manifolds/mesh_border.h"

namespace flg {

class BorderWalls {
public:
    // The border near a node. Then the second vector of its basis points inwards.
    struct Wall {
        double away;       // m, to go until it is there
        double rate;       // of that, along the second vector
        double curvature;  // of the border, see BorderView
        uint8_t pressed;   // directions that the border takes: none, the second one, or both at a corner
        uint8_t began;     // the same, as the round began
        bool is_near;
    };

    // border: null, or it outlives this, as the manifold does. within: m, so far from it nodes stay; below 0: beyond.
    BorderWalls(const Manifold& manifold, const MeshBorder* border, double within, uint32_t nodes, Memory* memory)
        : manifold_(manifold), border_(border), within_(within), walls_(border != nullptr ? nodes : 0, memory) {}

    Wall& operator[](uint32_t node) { return walls_[node]; }
    const Wall& operator[](uint32_t node) const { return walls_[node]; }

    // Which way the border is from x, and whether the energy's gradient there presses the node against it. Turns the
    // basis. The wall was cleared.
    void find(uint32_t node, const double* x, const double* gradient, double* basis);
    // Where a step takes a pressed node across the border's way.
    double push(uint32_t node) const;
    // Whether a step along the second vector leads over the border.
    bool is_passed(uint32_t node, double step) const;
    // Puts a point beyond the border onto it, and onto the manifold; false if it can't be. `basis`: of a place near it,
    // or null.
    bool confine(double* x, double* hint, const double* basis) const;

private:
    void face(Wall& wall, const BorderView& view, double* basis) const;

    const Manifold& manifold_;
    const MeshBorder* border_;
    double within_;
    Buffer<Wall> walls_;  // by node
};

}  // namespace flg
