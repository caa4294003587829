// SPDX-License-Identifier: MIT
// Surfaces in R^3 that a formula is zero on, with exact derivatives, around the origin: those whose distance is a
// formula too (sphere, torus, plane), and a table of others that are found by name (implicit_formulas.cpp).
#pragma once

#include <span>
#include <string_view>

#include "splines/manifolds/hypersurface.h"

namespace flg {

// Their functions are signed distances, negative inside: a projection is to the nearest point, in one step.

// Not defined at its middle.
class SphereSurface final : public Hypersurface {
public:
    explicit SphereSurface(double radius);  // > 0
    bool evaluate(const double* x, double*, double* value, double* gradient, double* second) const override;

private:
    double radius_;
};

// Around the z axis. Not defined on the axis and on the circle inside of the tube.
class TorusSurface final : public Hypersurface {
public:
    TorusSurface(double radius, double tube);  // of the circle inside, and of the tube around it: radius > tube > 0
    bool evaluate(const double* x, double*, double* value, double* gradient, double* second) const override;

private:
    double radius_, tube_;
};

// z = 0, of which the upper side is outside. It has no bounds: the size, > 0, is what tolerances are measured by.
class PlaneSurface final : public Hypersurface {
public:
    explicit PlaneSurface(double size);
    bool evaluate(const double* x, double*, double* value, double* gradient, double* second) const override;
};

struct SpaceJet;

// What a name stands for. Smooth: the gradient is not 0 anywhere on the surface.
struct ImplicitFormula {
    const char* name;
    const char* meaning;
    double size;  // a diameter or, of surfaces that go on forever, a period
    bool bounded;
    SpaceJet (*function)(const SpaceJet& x, const SpaceJet& y, const SpaceJet& z);
};

// All that have a name, in the order of their names.
std::span<const ImplicitFormula> implicit_formulas();
// Null if there is none.
const ImplicitFormula* find_implicit_formula(std::string_view name);

// 0.1 to 0.4 us an evaluation.
class NamedSurface final : public Hypersurface {
public:
    explicit NamedSurface(const ImplicitFormula& formula);
    bool evaluate(const double* x, double*, double* value, double* gradient, double* second) const override;

private:
    SpaceJet (*function_)(const SpaceJet& x, const SpaceJet& y, const SpaceJet& z);
};

}  // namespace flg
