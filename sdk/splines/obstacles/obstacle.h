// SPDX-License-Identifier: MIT
// What curves keep out of (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec. 5): a solid of the plane
// or of space, known by the signed distance from its boundary, positive outside.
//
// Invariants
// - The value is never more than the distance: what is `value` away from a place is free. Within `reach` of the
//   boundary it is the distance, its gradient has length 1 and its second derivatives are those of the distance
//   wherever it has any.
// - Where several points of the boundary are nearest (inside of a solid, in front of a dent) one of them is taken,
//   always the same; gradient and second derivatives are that one's.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/memory.h"

namespace flg {

class Obstacle {
public:
    static constexpr uint32_t max_dimension = 3;
    using Place = std::array<double, max_dimension>;
    struct Box {
        Place lower{}, upper{};
    };
    // Takes the lines of a wireframe.
    class Wires {
    public:
        virtual void line(const Place& a, const Place& b) = 0;

    protected:
        ~Wires() = default;
    };

    virtual ~Obstacle() = default;

    // The signed distance of x, its gradient (d numbers) and its second derivatives (d x d), each but the value may be
    // null. Finite x. Any thread. 1 us at most.
    virtual double evaluate(const double* x, double* gradient, double* second) const = 0;
    // The same from the solid itself, where evaluate() smooths it: the value is never more than the distance, to
    // rounding. What certifies that a curve is clear looks at this one. Where the distance is above exact_below and
    // neither derivative is asked for it may be less, by a little.
    virtual double evaluate_exactly(const double* x, double* gradient, double* second,
                                    [[maybe_unused]] double exact_below = 0) const {
        return evaluate(x, gradient, second);
    }

    // Whether the signed distance is a convex function: that of a convex solid.
    virtual bool is_convex() const { return false; }
    // Whether the straight way from a to b meets the boundary.
    enum class Meets { no, yes, unknown };
    virtual Meets meets(const double*, const double*) const { return Meets::unknown; }

    // A plane between a straight piece and a part of the solid, which is all below it, as the piece is above.
    struct Parting {
        Place outwards{};
        double height = 0;  // along that
        double away = 0;    // how far the piece is from that part
    };
    static constexpr uint32_t no_parting = ~uint32_t{0};
    // Parts the way from a to b from the boundary within `reach` of it: out[0] to out[before - 1] are planes that do,
    // the next one parts it from the nearest part that is not below these. Returns how many there are then: no more
    // where none is needed; or no_parting, where the way meets the boundary, and of solids that are convex or no
    // triangles.
    virtual uint32_t part(const double*, const double*, double, std::span<Parting>, uint32_t) const {
        return no_parting;
    }

    // A wireframe of the boundary, moved outwards by `clearance` >= 0 without rounding corners; that of the box if the
    // shape has none of its own.
    virtual void draw(double clearance, Wires& wires) const;

    uint32_t dimension() const { return dimension_; }  // d, 2 or 3
    // Has all of the boundary in it.
    const Box& box() const { return box_; }
    // The solid is inside of the box; else it is what lies around it.
    bool bounded() const { return bounded_; }
    // A length. Steps of a point that are shorter, followed by a way out along the gradient, leave it on its side: the
    // solid has a connected core that is deeper everywhere.
    double core_depth() const { return core_depth_; }
    // A place deep inside: what ways of the plane turn around, on one side or the other.
    const Place& core() const { return core_; }
    // How far from the boundary the value is exact and smooth.
    double reach() const { return reach_; }

protected:
    Obstacle(uint32_t dimension, const Box& box, bool bounded, double core_depth,
             double reach = std::numeric_limits<double>::infinity())
        : dimension_(dimension), box_(box), bounded_(bounded), core_depth_(core_depth), reach_(reach) {
        for (uint32_t k = 0; k < max_dimension; ++k) core_[k] = 0.5 * (box.lower[k] + box.upper[k]);
    }
    // The edges of a box with unit axes.
    void draw_box(const Place& centre, const Place& half, const std::array<Place, max_dimension>& axes,
                  Wires& wires) const;
    // The box's middle is it otherwise.
    void set_core(const Place& core) { core_ = core; }
    Obstacle(const Obstacle&) = default;
    Obstacle& operator=(const Obstacle&) = default;

private:
    uint32_t dimension_;
    Box box_;
    bool bounded_;
    double core_depth_, reach_;
    Place core_{};
};

// Several obstacles as one: the distance is the least one, less a clearance to keep from all of them (the radius of a
// body whose centre the curve is). The obstacles outlive the set and do not change meanwhile.
class ObstacleSet {
public:
    // Throws a Failure: no obstacle or more than max_count, one null or of another dimension, a clearance that is
    // negative or not finite or too large for the reach of an obstacle.
    ObstacleSet(std::span<const Obstacle* const> obstacles, double clearance, Memory* memory);

    ObstacleSet(const ObstacleSet& other, Memory* memory)
        : obstacles_(other.obstacles_, memory),
          dimension_(other.dimension_),
          clearance_(other.clearance_),
          is_smooth_(other.is_smooth_) {}

    static constexpr uint32_t max_count = 256;

    // Less than the reach of each. Nobody else uses the set meanwhile.
    void set_clearance(double clearance) { clearance_ = clearance; }
    // Whether evaluate() may smooth, as it does at first. Likewise.
    void set_smooth(bool smooth) { is_smooth_ = smooth; }

    uint32_t dimension() const { return dimension_; }
    uint32_t count() const { return static_cast<uint32_t>(obstacles_.size()); }
    double clearance() const { return clearance_; }
    const Obstacle& operator[](uint32_t i) const { return *obstacles_[i]; }

    // The distance from obstacle i, less the clearance: for barriers, so without jumps, whatever is asked for.
    double evaluate(uint32_t i, const double* x, double* gradient, double* second) const {
        const Obstacle& obstacle = *obstacles_[i];
        if (is_smooth_) return obstacle.evaluate(x, gradient, second) - clearance_;
        return obstacle.evaluate_exactly(x, gradient, second, std::numeric_limits<double>::infinity()) - clearance_;
    }
    // That distance is no less than this; quickly.
    double at_least(uint32_t i, const double* x) const;
    // The least distance, of obstacle `which`: exact where it is not positive, else never more than it is. Nothing is
    // evaluated that can't be less than `below`: then that is returned. Each may be null but x. 5 ns an obstacle that
    // is far, beside those that are near.
    double distance(const double* x, uint32_t* which = nullptr, double* gradient = nullptr,
                    double below = std::numeric_limits<double>::infinity()) const;

    // Whether the straight way from a to b stays clear: in steps of the distance, each of which ends `margin` (> 0)
    // away at least, the ends of the way too. Exact: a way that is said to be clear has no point nearer than 0. Takes
    // so many steps and, if these did not do, goes on from `done` (0 at first, a length) when called again.
    enum class Way { clear, blocked, unfinished };
    Way follow(const double* a, const double* b, double margin, uint32_t steps, double* done) const;

    // Whether a curve's straight piece from a to b may become that from c to e, as far as one step tells, without a
    // change of sides: in the plane, what the piece sweeps over has no core in it; in space, its ends do not go through
    // a solid; and the new piece goes through none that the old one went around. Through: deeper than half of
    // core_depth(). Of a curve of which given points stay, all pieces together keep its homotopy class in the plane. 5
    // ns an obstacle that is far, and some evaluations of each that is near.
    bool keeps_sides(const double* a, const double* b, const double* c, const double* e) const;

    // Step limit of a point of the curve: shorter ones, projected, pass no obstacle (see core_depth()).
    double step_limit() const;
    // How far from the boundaries the distance is smooth.
    double reach() const;
    // Of all boundaries of which the box is finite; false if there is none.
    bool box(Obstacle::Box& box) const;

private:
    bool pierces(uint32_t i, const double* a, const double* b) const;

    std::pmr::vector<const Obstacle*> obstacles_;
    uint32_t dimension_ = 0;
    double clearance_;
    bool is_smooth_ = true;
};

}  // namespace flg
