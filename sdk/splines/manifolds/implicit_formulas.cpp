// SPDX-License-Identifier: MIT
// Surfaces that have a name. Each is negative inside, and 1 to 2 metres large.
#include <algorithm>
#include <numbers>

#include "splines/manifolds/implicit_surfaces.h"
#include "splines/manifolds/space_jet.h"

namespace flg {

namespace {

using Jet = SpaceJet;

// The logarithm of a sum of Gaussians goes on rising far away, where the sum itself is flat. (Blinn, 1982.)
Jet blobs(const Jet& x, const Jet& y, const Jet& z) {
    constexpr double sharpness = 9, threshold = 0.4;
    constexpr double centres[][3] = {{-0.5, -0.2, 0}, {0.45, -0.3, 0.1}, {0.05, 0.45, -0.15}, {-0.05, -0.05, 0.5}};
    // Far away all would be 0: as shares of the largest they are not.
    double nearest = 1e300;
    std::array<Jet, 4> squares;
    for (size_t i = 0; i < 4; ++i) {
        squares[i] = square(x + -centres[i][0]) + square(y + -centres[i][1]) + square(z + -centres[i][2]);
        nearest = std::min(nearest, squares[i].value);
    }
    Jet sum;
    for (const Jet& from : squares) sum = sum + exp(-sharpness * (from + -nearest));
    return -1.0 * log(sum) + (sharpness * nearest + std::log(threshold));
}

Jet ellipsoid(const Jet& x, const Jet& y, const Jet& z) {
    return square(x) + 1 / (0.7 * 0.7) * square(y) + 1 / (0.5 * 0.5) * square(z) + -1;
}

// Around a figure of eight, x^4 - x^2 + y^2 = 0.
Jet genus2(const Jet& x, const Jet& y, const Jet& z) {
    const Jet xx = square(x);
    return square(xx * (xx + -1) + square(y)) + square(z) + -0.03;
}

// Of period 2. (Schoen, 1970.)
Jet gyroid(const Jet& x, const Jet& y, const Jet& z) {
    constexpr double pi = std::numbers::pi;
    return sin(pi * x) * cos(pi * y) + sin(pi * y) * cos(pi * z) + sin(pi * z) * cos(pi * x);
}

// Taubin's heart (1994) is pointed where its halves meet: a level set outside of it is not.
Jet heart(const Jet& x, const Jet& y, const Jet& z) {
    const Jet inner = square(x) + 9.0 / 4 * square(y) + square(z) + -1;
    const Jet cube = z * square(z);
    return inner * square(inner) - (square(x) + 9.0 / 80 * square(y)) * cube + -0.01;
}

Jet rounded_cube(const Jet& x, const Jet& y, const Jet& z) {
    return square(square(x)) + square(square(y)) + square(square(z)) + -0.5;
}

// Of period 2. (Schwarz, 1890.)
Jet schwarz_p(const Jet& x, const Jet& y, const Jet& z) {
    constexpr double pi = std::numbers::pi;
    return -1.0 * (cos(pi * x) + cos(pi * y) + cos(pi * z));
}

// Eight lumps, joined along the edges of a cube: genus 5.
Jet tangle_cube(const Jet& x, const Jet& y, const Jet& z) {
    const auto along = [](const Jet& a) {
        const Jet aa = square(2.0 * a);
        return aa * (aa + -5);
    };
    return along(x) + along(y) + along(z) + 11.8;
}

constexpr ImplicitFormula formulas[] = {
    {"blobs", "four balls that run together", 2, true, blobs},
    {"ellipsoid", "half axes 1, 0.7 and 0.5", 2, true, ellipsoid},
    {"genus2", "a thick figure of eight", 2.2, true, genus2},
    {"gyroid", "the triply periodic surface, period 2", 2, false, gyroid},
    {"heart", "a heart without the point between its halves", 2.4, true, heart},
    {"rounded_cube", "x^4 + y^4 + z^4 = 1/2", 2.4, true, rounded_cube},
    {"schwarz_p", "tubes along three axes, period 2", 2, false, schwarz_p},
    {"tangle_cube", "eight lumps joined to a cube", 2.4, true, tangle_cube},
};

}  // namespace

std::span<const ImplicitFormula> implicit_formulas() {
    return formulas;
}

const ImplicitFormula* find_implicit_formula(std::string_view name) {
    const auto* found = std::find_if(std::begin(formulas), std::end(formulas),
                                     [&](const auto& formula) { return name == formula.name; });
    return found == std::end(formulas) ? nullptr : found;
}

}  // namespace flg
