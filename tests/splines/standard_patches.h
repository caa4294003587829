// SPDX-License-Identifier: MIT
// Patches in closed form: a torus, which closes in both parameters, and graphs over the plane.
#pragma once

#include "splines/manifolds/parametric_patch.h"

namespace flg {

// Around the z axis: u along it, v about it, 0 at the outer equator, radians. 0 < tube < ring, metres.
class TorusPatch final : public ParametricPatch {
public:
    TorusPatch(double ring, double tube, Memory* memory);
    PatchPoint evaluate(double u, double v) const override;

private:
    double ring_, tube_;
};

// z = height cos(2 pi u / length) cos(2 pi v / length) over the square of half side `reach`, metres; > 0 each. Hills
// and hollows by turns, as on an egg box. Outwards is upwards.
class WavePatch final : public ParametricPatch {
public:
    WavePatch(double height, double length, double reach, Memory* memory);
    PatchPoint evaluate(double u, double v) const override;

private:
    double height_, wave_number_;
};

// z = (u^3 - 3 u v^2) / scale^2 over the square of half side `reach`, metres; > 0 each. Three ways up, three ways down.
class MonkeySaddlePatch final : public ParametricPatch {
public:
    MonkeySaddlePatch(double scale, double reach, Memory* memory);
    PatchPoint evaluate(double u, double v) const override;

private:
    double factor_;
};

}  // namespace flg
