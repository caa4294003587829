// SPDX-License-Identifier: MIT
// A hierarchy of boxes over points that were sorted along a space-filling curve (spatial_order.h): eight points in a
// row are a leaf, four nodes in a row have a parent. Points may be balls; then boxes hold all of each.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "runtime/each.h"

namespace flg {

class PointTree {
public:
    PointTree() = default;
    PointTree(uint32_t points, Memory* memory);  // one at least; 8 bytes a point. Its boxes are not made yet.

    uint32_t size() const { return points_; }

    // Makes a box: for 0 to box_count() - 1 in turn, about 50 ns each. `ball(i, centre, radius)` tells the centre
    // (three numbers) and the radius of the i-th point of the order.
    uint32_t box_count() const { return starts_[levels_]; }
    template <class Ball>
    void make_box(uint32_t at, const Ball& ball) {
        at < starts_[1] ? make_leaf(at, ball) : make_node(at);
    }

    // Calls visit(first, end) with ranges of the order, upwards: those leaves whose box is not farther from x than
    // `slack`, >= 0. With all boxes made.
    template <class Visit>
    void around(const double* x, double slack, Visit&& visit) const {
        walk_down([&](uint32_t node) { return square_to(boxes_[node], x) <= slack * slack; }, visit);
    }

    // Calls visit(first, end) with ranges of the order, upwards: those leaves whose box the ray from x in the direction
    // of an axis meets. With all boxes made.
    template <class Visit>
    void along(const double* x, uint32_t axis, Visit&& visit) const {
        const auto meets = [&](uint32_t node) {
            const Box& box = boxes_[node];
            bool inside = x[axis] <= box.upper[axis];
            for (uint32_t k = 0; k < 3; ++k)
                inside = inside && (k == axis || (box.lower[k] <= x[k] && x[k] <= box.upper[k]));
            return inside;
        };
        walk_down(meets, visit);
    }

    // Calls visit(first, end) with leaves that may hold something whose square distance from x is less than `square`,
    // which visit() lowers: near ones first. With all boxes made.
    template <class Visit>
    void nearest(const double* x, const double& square, Visit&& visit) const {
        nearest_by([x](const Box& box) { return square_to(box, x); }, square, visit);
    }
    struct Box {
        std::array<double, 3> lower, upper;
    };
    // The same by a square distance of one's own from a box: no more than that of anything in it.
    template <class Measure, class Visit>
    void nearest_by(const Measure& square_to_box, const double& square, Visit&& visit) const;

private:
    static constexpr uint32_t leaf_size = 8, fan = 4, max_levels = 16;
    static double square_to(const Box& box, const double* x) {
        double sum = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double away = std::max({box.lower[k] - x[k], x[k] - box.upper[k], 0.0});
            sum += away * away;
        }
        return sum;
    }
    template <class Ball>
    void make_leaf(uint32_t at, const Ball& ball);
    void make_node(uint32_t at);
    // The level of a node that is kept on a stack is kept with it.
    struct Place {
        uint32_t level, index;
        double square;
    };
    using Stack = std::array<Place, max_levels * fan>;
    template <class Near, class Visit>
    void walk_down(Near&& near, Visit&& visit) const;

    uint32_t points_ = 0, levels_ = 0;
    std::array<uint32_t, max_levels + 1> starts_{};  // of the levels among the boxes; leaves are level 0
    Buffer<Box> boxes_;
};

inline PointTree::PointTree(uint32_t points, Memory* memory) : points_(points) {
    uint32_t nodes = (points + leaf_size - 1) / leaf_size;
    for (;; nodes = (nodes + fan - 1) / fan) {
        starts_[levels_ + 1] = starts_[levels_] + nodes;
        ++levels_;
        if (nodes == 1) break;
    }
    boxes_ = Buffer<Box>(starts_[levels_], memory);
}

template <class Ball>
void PointTree::make_leaf(uint32_t at, const Ball& ball) {
    Box& box = boxes_[at];
    const uint32_t first = at * leaf_size, end = std::min(first + leaf_size, points_);
    for (uint32_t i = first; i < end; ++i) {
        double centre[3], radius;
        ball(i, centre, radius);
        for (size_t k = 0; k < 3; ++k) {
            box.lower[k] = i == first ? centre[k] - radius : std::min(box.lower[k], centre[k] - radius);
            box.upper[k] = i == first ? centre[k] + radius : std::max(box.upper[k], centre[k] + radius);
        }
    }
}

// Children lie below, and are done.
inline void PointTree::make_node(uint32_t at) {
    uint32_t level = 1;
    while (at >= starts_[level + 1]) ++level;
    const uint32_t first = starts_[level - 1] + (at - starts_[level]) * fan;
    const uint32_t end = std::min(first + fan, starts_[level]);
    Box box = boxes_[first];
    for (uint32_t child = first + 1; child < end; ++child) {
        for (size_t k = 0; k < 3; ++k) {
            box.lower[k] = std::min(box.lower[k], boxes_[child].lower[k]);
            box.upper[k] = std::max(box.upper[k], boxes_[child].upper[k]);
        }
    }
    boxes_[at] = box;
}

template <class Near, class Visit>
void PointTree::walk_down(Near&& near, Visit&& visit) const {
    Stack stack;
    size_t open = 0;
    stack[open++] = {levels_ - 1, 0, 0};
    while (open > 0) {
        const Place place = stack[--open];
        if (!near(starts_[place.level] + place.index)) continue;
        if (place.level == 0) {
            visit(place.index * leaf_size, std::min((place.index + 1) * leaf_size, points_));
            continue;
        }
        const uint32_t below = place.level - 1, first = place.index * fan;
        const uint32_t end = std::min(first + fan, starts_[place.level] - starts_[below]);
        for (uint32_t child = end; child > first; --child) stack[open++] = {below, child - 1, 0};
    }
}

template <class Measure, class Visit>
void PointTree::nearest_by(const Measure& square_to_box, const double& square, Visit&& visit) const {
    Stack stack;
    size_t open = 0;
    stack[open++] = {levels_ - 1, 0, 0};
    while (open > 0) {
        const Place place = stack[--open];
        if (!(place.square < square)) continue;
        if (place.level == 0) {
            visit(place.index * leaf_size, std::min((place.index + 1) * leaf_size, points_));
            continue;
        }
        const uint32_t below = place.level - 1, first = place.index * fan;
        const uint32_t end = std::min(first + fan, starts_[place.level] - starts_[below]);
        const size_t under = open;
        for (uint32_t child = first; child < end; ++child) {
            const double away = square_to_box(boxes_[starts_[below] + child]);
            if (!(away < square)) continue;
            size_t at = open++;
            for (; at > under && stack[at - 1].square <= away; --at) stack[at] = stack[at - 1];
            stack[at] = {below, child, away};
        }
    }
}

template <class Ball>
Task<PointTree> point_tree(Pace& pace, uint32_t points, Ball ball) {
    PointTree tree(points, pace.memory());
    PointTree* const made = &tree;
    co_await each(pace, tree.box_count(), Cost::tens_of_ns, [=](uint32_t at) { made->make_box(at, ball); });
    co_return tree;
}

}  // namespace flg
