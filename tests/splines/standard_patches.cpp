// SPDX-License-Identifier: MIT
#include "splines/standard_patches.h"

#include <cmath>
#include <numbers>

namespace flg {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

PatchDomain square(double reach) {
    return {{-reach, -reach}, {reach, reach}};
}

PatchPoint graph_point(double u, double v, double z, double zu, double zv, double zuu, double zuv, double zvv) {
    return {Vec3(u, v, z), Vec3(1, 0, zu), Vec3(0, 1, zv), Vec3(0, 0, zuu), Vec3(0, 0, zuv), Vec3(0, 0, zvv)};
}

}  // namespace

TorusPatch::TorusPatch(double ring, double tube, Memory* memory)
    : ParametricPatch({{0, 0}, {full_turn, full_turn}, {true, true}}, 2 * (ring + tube), memory),
      ring_(ring),
      tube_(tube) {
    prepare();
}

PatchPoint TorusPatch::evaluate(double u, double v) const {
    const double cu = std::cos(u), su = std::sin(u), c = tube_ * std::cos(v), s = tube_ * std::sin(v);
    const double out = ring_ + c;
    return {Vec3(out * cu, out * su, s),   Vec3(-out * su, out * cu, 0), Vec3(-s * cu, -s * su, c),
            Vec3(-out * cu, -out * su, 0), Vec3(s * su, -s * cu, 0),     Vec3(-c * cu, -c * su, -s)};
}

WavePatch::WavePatch(double height, double length, double reach, Memory* memory)
    : ParametricPatch(square(reach), 2 * reach, memory), height_(height), wave_number_(full_turn / length) {
    prepare();
}

PatchPoint WavePatch::evaluate(double u, double v) const {
    const double k = wave_number_, h = height_;
    const double cu = std::cos(k * u), su = std::sin(k * u), cv = std::cos(k * v), sv = std::sin(k * v);
    return graph_point(u, v, h * cu * cv, -h * k * su * cv, -h * k * cu * sv, -h * k * k * cu * cv, h * k * k * su * sv,
                       -h * k * k * cu * cv);
}

MonkeySaddlePatch::MonkeySaddlePatch(double scale, double reach, Memory* memory)
    : ParametricPatch(square(reach), 2 * reach, memory), factor_(1 / (scale * scale)) {
    prepare();
}

PatchPoint MonkeySaddlePatch::evaluate(double u, double v) const {
    const double f = factor_;
    return graph_point(u, v, f * (u * u * u - 3 * u * v * v), 3 * f * (u * u - v * v), -6 * f * u * v, 6 * f * u,
                       -6 * f * v, -6 * f * u);
}

}  // namespace flg
