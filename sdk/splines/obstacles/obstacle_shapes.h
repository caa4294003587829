// SPDX-License-Identifier: MIT
// Obstacles with a distance in closed form, in the plane and in space: balls (discs), boxes, capsules, half-spaces; and
// a host's own. Constructors throw a Failure where a number is not finite or a size not positive.
#pragma once

#include "splines/obstacles/obstacle.h"

namespace flg {

class BallObstacle final : public Obstacle {
public:
    // centre: `dimension` numbers.
    BallObstacle(uint32_t dimension, const double* centre, double radius);
    double evaluate(const double* x, double* gradient, double* second) const override;
    bool is_convex() const override { return true; }
    void draw(double clearance, Wires& wires) const override;

private:
    Place centre_{};
    double radius_;
};

// An oriented box, with sharp edges: at distance d its offset is rounded.
class BoxObstacle final : public Obstacle {
public:
    // axes: `dimension` rows of as many numbers, orthonormal to 1e-6 (else a Failure); null: those of the coordinates.
    // half: half its sides along them.
    BoxObstacle(uint32_t dimension, const double* centre, const double* half, const double* axes);
    double evaluate(const double* x, double* gradient, double* second) const override;
    bool is_convex() const override { return true; }
    void draw(double clearance, Wires& wires) const override;

private:
    Place centre_{}, half_{};
    std::array<Place, max_dimension> axes_{};
};

// All points within `radius` of a segment, which may have length 0.
class CapsuleObstacle final : public Obstacle {
public:
    CapsuleObstacle(uint32_t dimension, const double* from, const double* to, double radius);
    double evaluate(const double* x, double* gradient, double* second) const override;
    bool is_convex() const override { return true; }
    void draw(double clearance, Wires& wires) const override;

private:
    Place from_{}, along_{};  // the unit vector along it; 0 if it has no length
    double length_ = 0, radius_;
};

// All that lies on one side of a plane; in the plane, of a line. Its box is without end.
class HalfSpaceObstacle final : public Obstacle {
public:
    // through: a place of the boundary. outwards: of any length but 0.
    HalfSpaceObstacle(uint32_t dimension, const double* through, const double* outwards);
    double evaluate(const double* x, double* gradient, double* second) const override;
    bool is_convex() const override { return true; }
    // A square of the boundary around `through`, in the plane a piece of the line.
    void draw(double clearance, Wires& wires) const override;

private:
    Place through_{}, outwards_{};  // a unit vector
};

// A host's function: positive outside, nowhere more than the distance, and with a gradient that is not 0 within `reach`
// of its zero set (the blend of a barrier is as wide as the gradient says).
class FunctionObstacle final : public Obstacle {
public:
    struct Function {
        // Of x: the value and the gradient. Any thread.
        double (*value)(void* user, const double* x, double* gradient);
        // The second derivatives, d x d; null: differences of gradients over 1e-5 of the box, 2 d calls.
        void (*second)(void* user, const double* x, double* second);
        void* user;
    };
    // box: has the zero set in it, finite. bounded, core_depth, reach: as of Obstacle.
    FunctionObstacle(uint32_t dimension, const Function& function, const Box& box, bool bounded, double core_depth,
                     double reach);
    double evaluate(const double* x, double* gradient, double* second) const override;

private:
    Function function_;
    double step_;
};

}  // namespace flg
