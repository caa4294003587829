// SPDX-License-Identifier: MIT
// Numbers that carry their first and second derivatives after the three coordinates of space (forward differentiation):
// a formula written with them is differentiated exactly, without a second formula that could be wrong.
#pragma once

#include <array>
#include <cmath>

namespace flg {

struct SpaceJet {
    double value = 0;
    std::array<double, 3> gradient{};
    std::array<double, 6> second{};  // xx, xy, xz, yy, yz, zz

    static SpaceJet constant(double value) { return {value, {}, {}}; }
    static SpaceJet coordinate(size_t axis, double value) {
        SpaceJet jet = constant(value);
        jet.gradient[axis] = 1;
        return jet;
    }

    // Of f(this), from f and its derivatives at the value.
    SpaceJet chain(double f, double first, double other) const {
        SpaceJet jet = constant(f);
        for (size_t i = 0, at = 0; i < 3; ++i) {
            jet.gradient[i] = first * gradient[i];
            for (size_t j = i; j < 3; ++j, ++at)
                jet.second[at] = first * second[at] + other * gradient[i] * gradient[j];
        }
        return jet;
    }
};

inline SpaceJet operator+(const SpaceJet& a, const SpaceJet& b) {
    SpaceJet sum = SpaceJet::constant(a.value + b.value);
    for (size_t i = 0; i < 3; ++i) sum.gradient[i] = a.gradient[i] + b.gradient[i];
    for (size_t i = 0; i < 6; ++i) sum.second[i] = a.second[i] + b.second[i];
    return sum;
}

inline SpaceJet operator*(double factor, const SpaceJet& a) {
    return a.chain(factor * a.value, factor, 0);
}

inline SpaceJet operator-(const SpaceJet& a, const SpaceJet& b) {
    return a + -1.0 * b;
}

inline SpaceJet operator+(const SpaceJet& a, double b) {
    SpaceJet sum = a;
    sum.value += b;
    return sum;
}

inline SpaceJet operator*(const SpaceJet& a, const SpaceJet& b) {
    SpaceJet product = SpaceJet::constant(a.value * b.value);
    for (size_t i = 0, at = 0; i < 3; ++i) {
        product.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
        for (size_t j = i; j < 3; ++j, ++at) {
            product.second[at] = a.second[at] * b.value + a.value * b.second[at] + a.gradient[i] * b.gradient[j] +
                                 a.gradient[j] * b.gradient[i];
        }
    }
    return product;
}

inline SpaceJet square(const SpaceJet& a) {
    return a.chain(a.value * a.value, 2 * a.value, 2);
}

inline SpaceJet sin(const SpaceJet& a) {
    const double f = std::sin(a.value);
    return a.chain(f, std::cos(a.value), -f);
}

inline SpaceJet cos(const SpaceJet& a) {
    const double f = std::cos(a.value);
    return a.chain(f, -std::sin(a.value), -f);
}

inline SpaceJet exp(const SpaceJet& a) {
    const double f = std::exp(a.value);
    return a.chain(f, f, f);
}

inline SpaceJet log(const SpaceJet& a) {
    const double inverse = 1 / a.value;
    return a.chain(std::log(a.value), inverse, -inverse * inverse);
}

}  // namespace flg
