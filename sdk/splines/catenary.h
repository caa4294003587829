// SPDX-License-Identifier: MIT
// The catenary: how a cable of a given length hangs freely between two points, in closed form.
//
// By the length s from its lowest point it is x = a asinh(s / a), z = sqrt(a^2 + s^2), where a is the horizontal pull
// over the weight of a metre. With the horizontal distance h and the rise v of its ends, u = h / (2 a) solves
// sinh(u) / u = sqrt(L^2 - v^2) / h, and the first end is at s = v / 2 coth(u) - L / 2.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/vec.h"

namespace flg {

class Catenary {
public:
    // `down`: a unit vector. length: at least the straight distance; no more than that to 1e-9 is straight.
    Catenary(const Vec3& from, const Vec3& to, double length, const Vec3& down)
        : from_(from), to_(to), up_(-down), length_(length) {
        rise_ = (to - from).dot(up_);
        aside_ = to - from - rise_ * up_;
        across_ = aside_.norm();
        const double straight = (to - from).norm();
        is_straight_ = length <= straight * (1 + least_slack);
        if (is_straight_) return;
        if (across_ > 0) aside_ /= across_;
        // Of the logarithm of the ratio of both sides.
        const double square = across_ * across_, more = (length - straight) * (length + straight);
        const double wanted = square > 0 ? 0.5 * std::log1p(more / square) : HUGE_VAL;
        double coth = 1;
        if (wanted < most_fold) {
            double u = wanted < 1 ? std::sqrt(6 * wanted) : wanted + std::log(2 * wanted + 2);
            for (int round = 0; round < 60; ++round) {
                const double step = (excess(u) - wanted) / slope(u);
                u -= std::clamp(step, -u, 0.9 * u);
                if (std::abs(step) <= 1e-15 * u) break;
            }
            pull_ = across_ / (2 * u);
            coth = 1 / std::tanh(u);
        }
        begin_ = 0.5 * (rise_ * coth - length);
    }

    // At a length from the first end.
    Vec3 place(double length) const {
        const double share = length / length_;
        if (is_straight_) return from_ + share * (to_ - from_);
        const double s = begin_ + length;
        const double aside = pull_ > 0 ? pull_ * (std::asinh(s / pull_) - std::asinh(begin_ / pull_)) : share * across_;
        const double high = std::hypot(pull_, s) + std::hypot(pull_, begin_);
        const double up = high > 0 ? (s - begin_) * (s + begin_) / high : 0;
        return from_ + aside * aside_ + up * up_;
    }
    // How far along it turns from down to up, within a bend as narrow as `radius`; none where it does not.
    std::optional<double> bend(double radius) const {
        const bool turns = !is_straight_ && pull_ < radius && begin_ < 0 && begin_ + length_ > 0;
        return turns ? std::optional(-begin_) : std::nullopt;
    }
    // The greatest, over the weight of a metre: a length. Of a straight one it would be infinite.
    double tension() const {
        if (is_straight_) return straight_tension * length_;
        return std::hypot(pull_, std::max(std::abs(begin_), std::abs(begin_ + length_)));
    }

private:
    static constexpr double least_slack = 1e-9, most_fold = 300, straight_tension = 1e4;

    static double excess(double u) {
        if (u < 1e-2) return u * u / 6 * (1 - u * u / 30);
        return u + std::log1p(-std::exp(-2 * u)) - std::log(2 * u);
    }
    static double slope(double u) {
        if (u < 1e-2) return u / 3 * (1 - u * u / 15);
        return 1 / std::tanh(u) - 1 / u;
    }

    Vec3 from_, to_, up_, aside_;
    double length_, rise_ = 0, across_ = 0;
    double pull_ = 0;   // metres: the horizontal pull over the weight of a metre
    double begin_ = 0;  // metres: the first end, from the lowest point
    bool is_straight_ = false;
};

}  // namespace flg
