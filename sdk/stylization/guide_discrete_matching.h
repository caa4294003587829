// SPDX-License-Identifier: MIT
// The discrete matching of guide and style (Minarcik, Fiser, Sykora, sec. 4.2): dynamic programming in the manner of Alt
// and Godau over all points of both, for the energy that guide_matching.h minimizes with continuous places.
//
// Departure from the paper, which wants strictly increasing places: with as many points on the style as on the guide that
// leaves only one sequence. Here places do not decrease.
// Invariants: delta_0 = 0, delta_(N-1) = L_S, non-decreasing; the same bits for every slicing into run(n).
#pragma once

#include <cstdint>

#include "core/memory.h"
#include "stylization/smooth_style_curve.h"

namespace flg {

class DiscreteMatching {
public:
    // Of guide and style each, at most: the table then has 32 MiB.
    static constexpr uint32_t points_max = 4096;

    // As GuideMatching's.
    DiscreteMatching(const SmoothStyleCurve& style, const Vec3* guide, uint32_t count, double beta, Memory* memory);

    // Does n units of work, cells of the table or points; true when done. About 5 ns a unit.
    bool run(uint32_t n);

    // After run() returned true: the arc lengths delta_i on the style, and their energy E'.
    const Buffer<double>& matching() const { return delta_; }
    double energy() const { return energy_; }

private:
    enum class Phase : uint8_t { start, table, choose, trace, done };

    void fill_row(uint32_t end);
    void choose(uint32_t end);

    SmoothStyleCurve style_;
    const Vec3* guide_;
    uint32_t count_;
    double beta_;
    Phase phase_ = Phase::start;
    uint32_t row_ = 1;
    uint32_t column_ = 0;
    Buffer<double> before_,
        now_;                    // by column: the least energy of a sequence that ends there, of a row and of the next
    Buffer<uint16_t> previous_;  // by cell: where the best such sequence was the row before
    double least_;               // of the row before, up to column_
    uint16_t least_column_ = 0;
    Buffer<double> delta_;
    double energy_ = 0;
};

}  // namespace flg
