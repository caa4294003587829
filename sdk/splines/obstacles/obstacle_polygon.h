// SPDX-License-Identifier: MIT
// A simple polygon, convex or not, as an obstacle of the plane, and the upright prism over it as one of space. The
// nearest point is looked for among all edges; the side follows from the edge or corner that it lies on.
#pragma once

#include "splines/obstacles/obstacle.h"

namespace flg {

class PolygonObstacle final : public Obstacle {
public:
    static constexpr uint32_t max_vertices = 256;

    // x and y of each vertex, around it in either sense; the last one is joined to the first. Copied. Throws a Failure:
    // fewer than 3 vertices or more than max_vertices, numbers that are not finite, edges without length, that meet or
    // lie on each other. 0.2 ms with 256 vertices.
    PolygonObstacle(std::span<const double> vertices, Memory* memory);
    double evaluate(const double* x, double* gradient, double* second) const override;
    void draw(double clearance, Wires& wires) const override;

private:
    static constexpr uint32_t run_size = 16;  // edges that share a box
    struct Vertex {
        double x, y;
    };
    struct Shape;
    struct Run {
        double lower_x, lower_y, upper_x, upper_y;
    };

    explicit PolygonObstacle(Shape&& shape);

    Place find_core() const;
    uint32_t next(uint32_t i) const { return i + 1 == vertices_.size() ? 0 : i + 1; }

    std::pmr::vector<Vertex> vertices_;  // counter-clockwise
    std::pmr::vector<Run> runs_;
};

class PrismObstacle final : public Obstacle {
public:
    // The polygon lies in the plane of the first two axes through the centre, its places relative to that; the prism
    // reaches half_height > 0 to either side of it. axes: three rows, orthonormal to 1e-6; null: those of the
    // coordinates. Throws a Failure: as above.
    PrismObstacle(PolygonObstacle polygon, const double* centre, const double* axes, double half_height);
    double evaluate(const double* x, double* gradient, double* second) const override;
    void draw(double clearance, Wires& wires) const override;

private:
    PolygonObstacle polygon_;
    Place centre_{};
    std::array<Place, max_dimension> axes_{};
    double half_height_;
};

}  // namespace flg
