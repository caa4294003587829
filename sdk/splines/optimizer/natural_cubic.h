// SPDX-License-Identifier: MIT
// The curves of R^n through given points at given times that have the least energy, in closed form: cubic splines (de
// Boor, A Practical Guide to Splines, 1978), splines in tension (Schweikert, An interpolating curve using a spline in
// tension, 1966), and polylines. What Hofer and Pottmann's energies (1) to (3) give where nothing restricts a curve:
// paths of barycentres, first curves.
//
// Between two knots a distance h apart x = L + M_0 S(h - t) + M_1 S(t): L is the straight line, M are the second
// derivatives at the knots, and S = (sinh(s t) / sinh(s h) - t / h) / s^2 with s^2 = w, for w = 0 the cubic (t^3 - t
// h^2) / (6 h). The moments make the slopes at knots agree: one tridiagonal system, diagonally dominant.
#pragma once

#include <span>

#include "runtime/each.h"

namespace flg {

enum class CubicEnds { natural, clamped, clamped_begin, clamped_end, periodic };

// Arrays live as long as the spline.
struct CubicData {
    std::span<const double>
        knots;  // ascending; at least 2, one a value and with periodic ends one more: the value 0 again
    std::span<const double> values;  // `dimension` numbers a knot; finite
    size_t dimension = 3;
    CubicEnds ends = CubicEnds::natural;
    // With clamped ends: the first and the last derivative, `dimension` numbers each.
    const double* slopes = nullptr;
    double tension = 0;  // w of E_t, 1 / unit of time squared, at least 0; infinite: a polyline, the least E_1
};

// How the slopes at the ends of a piece depend on its moments: by `own` on the moment there, by `across` on the other.
struct CubicPiece {
    double across, own;  // -S'(0), S'(h)
};
// `stiffness`: the square root of w.
CubicPiece cubic_piece(double h, double stiffness);

class NaturalCubic {
public:
    // The derivative of order 0 to 3 at a time; before the first and after the last knot, that of the first and the
    // last piece, with periodic ends that of the time in the period. At knots the third derivative is that after it.
    // `dimension` numbers. Some 50 ns, and 5 ns more each time the number of knots doubles.
    void evaluate(double time, int derivative, double* out) const;

    // The curve's energy: the integral of |x''|^2 + w |x'|^2; of a polyline that of |x'|^2.
    double energy() const { return energy_; }

private:
    friend Task<NaturalCubic> natural_cubic(Pace& pace, CubicData data);
    NaturalCubic(const CubicData& data, Memory* memory);

    size_t next(size_t knot) const { return knot + 1 == count_ && periodic() ? 0 : knot + 1; }
    bool periodic() const { return data_.ends == CubicEnds::periodic; }
    CubicPiece piece(size_t index) const;
    double bend(size_t knot, size_t component) const;
    void forward(size_t row);
    void backward(size_t row);
    void close();
    void add_energy(size_t knot);

    CubicData data_;
    size_t count_;  // of different values
    size_t pieces_;
    size_t first_row_, end_row_;  // of the system, but row 0 of a periodic one
    double stiffness_;            // s
    double energy_ = 0;
    Buffer<double> moments_;
    Buffer<double> upper_, from_first_;
};

// Some 40 ns a knot, times the dimension.
Task<NaturalCubic> natural_cubic(Pace& pace, CubicData data);

}  // namespace flg
