// SPDX-License-Identifier: MIT
// Exact distances at any place of a triangle, from the windows that an exact solver kept (ExactSolver::keep_windows)
// and the pieces of a curve that they come from.
//
// A place that no window lights is reached around the nearest end of one, or from a corner: those are ways too, so
// distances are never too short, and never too long by more than rounding.
#pragma once

#include <deque>

#include "surfaces/geodesics/exact_sources.h"

namespace flg {

// The weights of a place at its triangle's corners.
using Weights = std::array<double, 3>;

class ExactPlaces {
public:
    // The solver is done, its faces, windows and pieces outlive this.
    ExactPlaces(const ExactSolver& solver, const GrowingList<Window>& windows,
                const std::pmr::deque<SidedSegment>& pieces, Memory* memory)
        : solver_(solver),
          windows_(windows),
          pieces_(pieces),
          windows_of_{Buffer<uint32_t>(0, memory), {}},
          pieces_of_{Buffer<uint32_t>(0, memory), {}} {}
    friend Task<void> sort_lights(Pace& pace, ExactPlaces& places);

    struct Found {
        double distance;
        uint32_t label;
        std::array<double, 2> of_sides;  // the least distances by labels of the left and of the right
    };
    // About 10 ns for each window that enters the triangle.
    Found at(uint32_t triangle, const Weights& weights) const;
    // What that takes, in units of Cost::some_ns.
    uint32_t work(uint32_t triangle) const {
        return 16 + 2 * static_cast<uint32_t>(windows_of_.of(triangle).size() + pieces_of_.of(triangle).size());
    }
    // In the coordinates of the triangle's first edge, and back; the triangle must have an area there.
    Vec2 place(uint32_t triangle, const Weights& weights) const;
    Weights weights_of_way(uint32_t triangle, const Vec2& way) const;

private:
    const ExactSolver& solver_;
    const GrowingList<Window>& windows_;
    const std::pmr::deque<SidedSegment>& pieces_;
    Groups windows_of_, pieces_of_;  // by triangle
};

Task<void> sort_lights(Pace& pace, ExactPlaces& places);

}  // namespace flg
