// SPDX-License-Identifier: MIT
#include "splines/manifolds/implicit_surfaces.h"

#include <algorithm>
#include <cmath>

#include "splines/manifolds/space_jet.h"

namespace flg {

namespace {

// Distances need no bound on a step: the first one arrives.
constexpr double unbounded = 1e300;
// Of the size: a step along other functions' gradients, which hold near the surface only.
constexpr double max_step = 0.1;

}  // namespace

SphereSurface::SphereSurface(double radius) : Hypersurface(3, 0, 2 * radius, unbounded), radius_(radius) {}

bool SphereSurface::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    if (!(length > 0)) return false;
    *value = length - radius_;
    for (int i = 0; i < 3; ++i) gradient[i] = x[i] / length;
    if (!second) return true;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) second[3 * i + j] = ((i == j ? 1 : 0) - gradient[i] * gradient[j]) / length;
    }
    return true;
}

TorusSurface::TorusSurface(double radius, double tube)
    : Hypersurface(3, 0, 2 * (radius + tube), unbounded), radius_(radius), tube_(tube) {}

// In the half plane through the axis, the distance from a circle; turning the half plane gives the other curvature.
bool TorusSurface::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    const double out = std::sqrt(x[0] * x[0] + x[1] * x[1]);
    const double across = out - radius_;
    const double length = std::sqrt(across * across + x[2] * x[2]);
    if (!(out > 0) || !(length > 0)) return false;
    const double radial[] = {x[0] / out, x[1] / out, 0}, around[] = {-radial[1], radial[0], 0};
    const double cosine = across / length, sine = x[2] / length;
    *value = length - tube_;
    for (int i = 0; i < 2; ++i) gradient[i] = cosine * radial[i];
    gradient[2] = sine;
    if (!second) return true;
    const double along[] = {-sine * radial[0], -sine * radial[1], cosine};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            second[3 * i + j] = along[i] * along[j] / length + around[i] * around[j] * (cosine / out);
        }
    }
    return true;
}

PlaneSurface::PlaneSurface(double size) : Hypersurface(3, 0, size, unbounded) {}

bool PlaneSurface::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    *value = x[2];
    gradient[0] = gradient[1] = 0;
    gradient[2] = 1;
    if (second) std::fill_n(second, 9, 0.0);
    return true;
}

NamedSurface::NamedSurface(const ImplicitFormula& formula)
    : Hypersurface(3, 0, formula.size, max_step * formula.size), function_(formula.function) {}

bool NamedSurface::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    const SpaceJet jet =
        function_(SpaceJet::coordinate(0, x[0]), SpaceJet::coordinate(1, x[1]), SpaceJet::coordinate(2, x[2]));
    *value = jet.value;
    std::copy(jet.gradient.begin(), jet.gradient.end(), gradient);
    if (!second) return true;
    const auto& s = jet.second;
    const double all[] = {s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5]};
    std::copy(all, all + 9, second);
    return true;
}

}  // namespace flg
