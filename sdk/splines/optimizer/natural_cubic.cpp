// SPDX-License-Identifier: MIT
#include "splines/optimizer/natural_cubic.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Below this s h the hyperbolic functions are summed as series: their differences would lose digits.
constexpr double small_stiffness = 1;
constexpr int series_terms = 12;

// x / sinh(x)
double over_sinh(double x) {
    return x < 1e-8 ? 1 : x / std::sinh(x);
}

// sinh(x r) / sinh(x) and cosh(x r) / sinh(x) for r from 0 to 1: neither overflows.
double sinh_ratio(double x, double r) {
    return std::exp(x * (r - 1)) * -std::expm1(-2 * x * r) / -std::expm1(-2 * x);
}
double cosh_ratio(double x, double r) {
    return std::exp(x * (r - 1)) * (1 + std::exp(-2 * x * r)) / -std::expm1(-2 * x);
}

// The derivative of S at t, of order 0 to 3.
double basis(double h, double s, double t, int derivative) {
    const double x = s * h, r = t / h;
    if (x < small_stiffness && derivative < 3) {
        // sum over k of x^(2k - 2) (r^(2k + 1) - r) / (2k + 1)!, times x / sinh x, and its derivatives
        double sum = 0, power = 1, factorial = 1;
        double r_even = 1;  // r^(2k - 2)
        for (int k = 1; k <= series_terms; ++k) {
            factorial *= 2 * k * (2 * k + 1);
            double term = 0;
            if (derivative == 0) term = r * (r_even * r * r - 1);
            if (derivative == 1) term = (2 * k + 1) * r_even * r * r - 1;
            if (derivative == 2) term = 2 * k * (2 * k + 1) * r_even * r;
            sum += power * term / factorial;
            power *= x * x;
            r_even *= r * r;
        }
        const double scale = derivative == 0 ? h * h : derivative == 1 ? h : 1;
        return scale * sum * over_sinh(x);
    }
    if (x < 1e-8) return 1 / h;
    switch (derivative) {
        case 0: return (sinh_ratio(x, r) - r) / (s * s);
        case 1: return (cosh_ratio(x, r) - 1 / x) / s;
        case 2: return sinh_ratio(x, r);
        default: return s * cosh_ratio(x, r);
    }
}

}  // namespace

NaturalCubic::NaturalCubic(const CubicData& data, Memory* memory)
    : data_(data),
      count_(data.values.size() / data.dimension),
      pieces_(data.knots.size() - 1),
      first_row_(data.ends == CubicEnds::clamped || data.ends == CubicEnds::clamped_begin ? 0 : 1),
      end_row_(data.ends == CubicEnds::natural || data.ends == CubicEnds::clamped_begin ? count_ - 1 : count_),
      stiffness_(std::sqrt(data.tension)),
      moments_(data.values.size(), memory),
      upper_(count_, memory),
      from_first_(data.ends == CubicEnds::periodic ? count_ : 0, memory) {}

CubicPiece cubic_piece(double h, double stiffness) {
    return {-basis(h, stiffness, 0, 1), basis(h, stiffness, h, 1)};
}

CubicPiece NaturalCubic::piece(size_t index) const {
    return cubic_piece(data_.knots[index + 1] - data_.knots[index], stiffness_);
}

// By how much the slope of the straight lines changes at a knot; at clamped ends, from the given slope and to it.
double NaturalCubic::bend(size_t knot, size_t component) const {
    const size_t n = data_.dimension;
    const double x = data_.values[knot * n + component];
    double before = 0, after = 0;
    if (knot < pieces_) {
        after = (data_.values[next(knot) * n + component] - x) / (data_.knots[knot + 1] - data_.knots[knot]);
    } else if (data_.slopes) {
        after = data_.slopes[n + component];
    }
    if (knot > 0) {
        before = (x - data_.values[(knot - 1) * n + component]) / (data_.knots[knot] - data_.knots[knot - 1]);
    } else if (periodic()) {
        const size_t last = count_ - 1;
        before = (x - data_.values[last * n + component]) / (data_.knots[pieces_] - data_.knots[last]);
    } else if (data_.slopes) {
        before = data_.slopes[component];
    }
    return after - before;
}

// Thomas's algorithm. In a cycle the moment of knot 0 stays unknown, and each row keeps how much of it it takes away.
void NaturalCubic::forward(size_t row) {
    const size_t n = data_.dimension;
    const bool has_before = row > 0, has_after = row < pieces_;
    const CubicPiece before = has_before ? piece(row - 1) : CubicPiece{}, after = has_after ? piece(row) : CubicPiece{};
    const bool couples = row > first_row_;
    const double pivot =
        (has_before ? before.own : 0) + (has_after ? after.own : 0) - (couples ? before.across * upper_[row - 1] : 0);
    const bool last = row + 1 == end_row_;
    upper_[row] = last ? 0 : after.across / pivot;
    for (size_t c = 0; c < n; ++c) {
        double right = bend(row, c);
        if (couples) right -= before.across * moments_[(row - 1) * n + c];
        moments_[row * n + c] = right / pivot;
    }
    if (!periodic()) return;
    double from = couples ? -before.across * from_first_[row - 1] : before.across;
    if (last) from += after.across;
    from_first_[row] = from / pivot;
}

void NaturalCubic::backward(size_t row) {
    if (row + 1 == end_row_) return;
    const size_t n = data_.dimension;
    for (size_t c = 0; c < n; ++c) moments_[row * n + c] -= upper_[row] * moments_[(row + 1) * n + c];
    if (periodic()) from_first_[row] -= upper_[row] * from_first_[row + 1];
}

// Row 0 of a cycle.
void NaturalCubic::close() {
    const size_t n = data_.dimension, last = count_ - 1;
    const CubicPiece after = piece(0), before = piece(pieces_ - 1);
    const double pivot = before.own + after.own - after.across * from_first_[1] - before.across * from_first_[last];
    for (size_t c = 0; c < n; ++c) {
        moments_[c] = (bend(0, c) - after.across * moments_[n + c] - before.across * moments_[last * n + c]) / pivot;
    }
}

// A knot's moment without what that of knot 0 takes away, and the knot's share of the energy: moment times bend, and
// tension times that of the straight line after it.
void NaturalCubic::add_energy(size_t knot) {
    const size_t n = data_.dimension;
    const double weight = std::isinf(data_.tension) ? 1 : data_.tension;
    for (size_t c = 0; c < n; ++c) {
        double& moment = moments_[knot * n + c];
        if (periodic() && knot > 0) moment -= from_first_[knot] * moments_[c];
        energy_ += moment * bend(knot, c);
        if (knot == pieces_) continue;
        const double change = data_.values[next(knot) * n + c] - data_.values[knot * n + c];
        energy_ += weight * change * change / (data_.knots[knot + 1] - data_.knots[knot]);
    }
}

Task<NaturalCubic> natural_cubic(Pace& pace, CubicData data) {
    NaturalCubic cubic(data, pace.memory());
    NaturalCubic* const c = &cubic;
    const auto knots = static_cast<uint32_t>(cubic.count_);
    co_await each(pace, knots, Cost::tens_of_ns, [c](uint32_t knot) {
        std::fill_n(c->moments_.begin() + knot * c->data_.dimension, c->data_.dimension, 0.0);
        if (c->periodic()) c->from_first_[knot] = 0;
    });
    if (!std::isinf(data.tension)) {
        const auto first = static_cast<uint32_t>(cubic.first_row_);
        const auto end = std::max(static_cast<uint32_t>(cubic.end_row_), first);
        co_await each(pace, first, end, Cost::hundreds_of_ns, [c](uint32_t row) { c->forward(row); });
        co_await each(pace, end - first, Cost::tens_of_ns, [c, end](uint32_t k) { c->backward(end - 1 - k); });
        if (cubic.periodic()) cubic.close();
    }
    co_await each(pace, knots, Cost::tens_of_ns, [c](uint32_t knot) { c->add_energy(knot); });
    co_return cubic;
}

void NaturalCubic::evaluate(double time, int derivative, double* out) const {
    const size_t n = data_.dimension;
    const double first = data_.knots.front(), last = data_.knots.back();
    if (periodic() && (time < first || time >= last))
        time -= (last - first) * std::floor((time - first) / (last - first));
    const auto after = std::upper_bound(data_.knots.begin() + 1, data_.knots.end() - 1, time);
    const size_t begin = static_cast<size_t>(after - data_.knots.begin()) - 1, end = next(begin);
    const double h = data_.knots[begin + 1] - data_.knots[begin], t = time - data_.knots[begin];
    const bool straight = std::isinf(data_.tension);
    const double to_end = straight ? 0 : basis(h, stiffness_, t, derivative);
    const double to_begin = straight ? 0 : (derivative % 2 == 0 ? 1 : -1) * basis(h, stiffness_, h - t, derivative);
    const double share = derivative == 0 ? t / h : derivative == 1 ? 1 / h : 0;
    const double rest = derivative == 0 ? (h - t) / h : -share;
    for (size_t c = 0; c < n; ++c) {
        out[c] = rest * data_.values[begin * n + c] + share * data_.values[end * n + c] +
                 to_begin * moments_[begin * n + c] + to_end * moments_[end * n + c];
    }
}

}  // namespace flg
