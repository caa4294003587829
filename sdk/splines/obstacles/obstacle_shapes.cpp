// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/failure.h"
#include "core/vec.h"

namespace flg {

namespace {

using Place = Obstacle::Place;
constexpr double axes_tolerance = 1e-6;
constexpr double relative_step = 1e-5;  // of a box: errors of differences then are 1e-10, their noise 1e-11

uint32_t checked(uint32_t dimension) {
    if (dimension != 2 && dimension != 3) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "an obstacle has dimension %u, it must be 2 or 3", dimension);
    }
    return dimension;
}

Place checked_place(const char* name, uint32_t dimension, const double* numbers) {
    Place place{};
    for (uint32_t k = 0; k < checked(dimension); ++k) {
        place[k] = numbers[k];
        if (!std::isfinite(place[k])) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "an obstacle's %s[%u] is not finite", name, k);
        }
    }
    return place;
}

double checked_size(const char* name, double size) {
    if (!(size > 0) || !std::isfinite(size)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "an obstacle's %s is %g, it must be finite and positive", name, size);
    }
    return size;
}

double dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The distance from a point at `to`, or from an axis at right angles to it (`axis` a unit vector, else 0). At distance
// 0 some direction across the axis is taken, without second derivatives.
double radial(uint32_t d, const Place& to, const Place& axis, double* gradient, double* second) {
    const double rho = std::sqrt(dot(to, to));
    Place g{};
    if (rho > 0) {
        for (uint32_t k = 0; k < d; ++k) g[k] = to[k] / rho;
    } else {
        uint32_t least = 0;
        for (uint32_t k = 1; k < d; ++k) {
            if (std::abs(axis[k]) < std::abs(axis[least])) least = k;
        }
        for (uint32_t k = 0; k < d; ++k) g[k] = (k == least ? 1 : 0) - axis[least] * axis[k];
        const double length = std::sqrt(dot(g, g));
        for (uint32_t k = 0; k < d; ++k) g[k] /= length;
    }
    if (gradient != nullptr) std::copy_n(g.begin(), d, gradient);
    if (second != nullptr) {
        for (uint32_t i = 0; i < d; ++i) {
            for (uint32_t j = 0; j < d; ++j) {
                second[i * d + j] = rho > 0 ? ((i == j ? 1 : 0) - g[i] * g[j] - axis[i] * axis[j]) / rho : 0;
            }
        }
    }
    return rho;
}

Obstacle::Box around(uint32_t dimension, const Place& a, const Place& b, const Place& radius) {
    Obstacle::Box box;
    for (uint32_t k = 0; k < dimension; ++k) {
        box.lower[k] = std::min(a[k], b[k]) - radius[k];
        box.upper[k] = std::max(a[k], b[k]) + radius[k];
    }
    return box;
}

// How far a turned box reaches along the coordinates.
Place reaches(uint32_t d, const double* half, const double* axes) {
    Place sum{};
    for (uint32_t i = 0; i < checked(d); ++i) {
        for (uint32_t k = 0; k < d; ++k) {
            sum[k] += half[i] * (axes == nullptr ? (i == k ? 1 : 0) : std::abs(axes[i * d + k]));
        }
    }
    return sum;
}

double diagonal(uint32_t d, const Obstacle::Box& box) {
    double square = 0;
    for (uint32_t k = 0; k < d; ++k) square += (box.upper[k] - box.lower[k]) * (box.upper[k] - box.lower[k]);
    return std::sqrt(square);
}

// A ball moved along `axis`, a unit vector, by `length`, which may be 0: both ends' arcs, and what joins them.
void draw_capsule(uint32_t d, const Place& from, const Place& axis, double length, double radius,
                  Obstacle::Wires& wires) {
    constexpr uint32_t steps = 32;  // of a full circle; a multiple of 4
    const Vec3 along = length > 0 ? Vec3(axis.data()) : Vec3::UnitX();
    const Vec3 sides[] = {d == 2 ? Vec3(-along.y(), along.x(), 0) : along.unitOrthogonal(),
                          along.cross(along.unitOrthogonal())};
    const auto line = [&](const Vec3& a, const Vec3& b) { wires.line({a[0], a[1], a[2]}, {b[0], b[1], b[2]}); };
    const auto arc = [&](const Vec3& centre, const Vec3& u, const Vec3& v, uint32_t count) {
        const auto at = [&](uint32_t i) -> Vec3 {
            const double angle = 2 * M_PI * i / steps;
            return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
        };
        for (uint32_t i = 0; i < count; ++i) line(at(i), at(i + 1));
    };
    const Vec3 begin(from.data()), end = begin + length * along;
    for (uint32_t s = 0; s < d - 1; ++s) {
        arc(begin, sides[s], -along, steps / 2);
        arc(end, sides[s], along, steps / 2);
        if (length == 0) continue;
        line(begin + radius * sides[s], end + radius * sides[s]);
        line(begin - radius * sides[s], end - radius * sides[s]);
    }
    if (d == 2) return;
    arc(begin, sides[0], sides[1], steps);
    if (length > 0) arc(end, sides[0], sides[1], steps);
}

}  // namespace

BallObstacle::BallObstacle(uint32_t dimension, const double* centre, double radius)
    : Obstacle(dimension,
               around(dimension, checked_place("centre", dimension, centre), checked_place("centre", dimension, centre),
                      {radius, radius, radius}),
               true, radius),
      centre_(checked_place("centre", dimension, centre)),
      radius_(checked_size("radius", radius)) {}

double BallObstacle::evaluate(const double* x, double* gradient, double* second) const {
    Place to{};
    for (uint32_t k = 0; k < dimension(); ++k) to[k] = x[k] - centre_[k];
    return radial(dimension(), to, {}, gradient, second) - radius_;
}

void BallObstacle::draw(double clearance, Wires& wires) const {
    draw_capsule(dimension(), centre_, {}, 0, radius_ + clearance, wires);
}

BoxObstacle::BoxObstacle(uint32_t dimension, const double* centre, const double* half, const double* axes)
    : Obstacle(dimension,
               around(dimension, checked_place("centre", dimension, centre), checked_place("centre", dimension, centre),
                      reaches(dimension, half, axes)),
               true, *std::min_element(half, half + checked(dimension))),
      centre_(checked_place("centre", dimension, centre)),
      half_(checked_place("half", dimension, half)) {
    for (uint32_t i = 0; i < dimension; ++i) {
        checked_size("half side", half[i]);
        for (uint32_t k = 0; k < dimension; ++k)
            axes_[i][k] = axes == nullptr ? (i == k ? 1 : 0) : axes[i * dimension + k];
    }
    for (uint32_t i = 0; i < dimension; ++i) {
        for (uint32_t j = 0; j <= i; ++j) {
            if (!(std::abs(dot(axes_[i], axes_[j]) - (i == j ? 1 : 0)) < axes_tolerance)) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a box's axes %u and %u are not orthonormal", j, i);
            }
        }
    }
}

double BoxObstacle::evaluate(const double* x, double* gradient, double* second) const {
    const uint32_t d = dimension();
    Place to{}, beyond{}, sign{};
    for (uint32_t k = 0; k < d; ++k) to[k] = x[k] - centre_[k];
    uint32_t outer = 0;
    double square = 0;
    for (uint32_t i = 0; i < d; ++i) {
        const double along = dot(axes_[i], to);
        sign[i] = along < 0 ? -1 : 1;
        beyond[i] = std::abs(along) - half_[i];
        if (beyond[i] > beyond[outer]) outer = i;
        if (beyond[i] > 0) square += beyond[i] * beyond[i];
    }
    const bool outside = square > 0;
    const double value = outside ? std::sqrt(square) : beyond[outer];
    if (gradient == nullptr && second == nullptr) return value;
    // Along the axes of the box: off a face, an edge or a corner.
    Place g{};
    for (uint32_t i = 0; i < d; ++i) {
        if (outside ? beyond[i] > 0 : i == outer) g[i] = sign[i] * (outside ? beyond[i] / value : 1);
    }
    if (gradient != nullptr) {
        for (uint32_t k = 0; k < d; ++k) {
            gradient[k] = 0;
            for (uint32_t i = 0; i < d; ++i) gradient[k] += axes_[i][k] * g[i];
        }
    }
    if (second != nullptr) {
        std::fill_n(second, d * d, 0.0);
        for (uint32_t i = 0; i < d && outside; ++i) {
            for (uint32_t j = 0; j < d; ++j) {
                if (!(beyond[i] > 0 && beyond[j] > 0)) continue;
                const double local = ((i == j ? 1 : 0) - g[i] * g[j]) / value;
                for (uint32_t k = 0; k < d; ++k) {
                    for (uint32_t l = 0; l < d; ++l) second[k * d + l] += local * axes_[i][k] * axes_[j][l];
                }
            }
        }
    }
    return value;
}

void BoxObstacle::draw(double clearance, Wires& wires) const {
    Place half = half_;
    for (double& side : half) side += clearance;
    draw_box(centre_, half, axes_, wires);
}

CapsuleObstacle::CapsuleObstacle(uint32_t dimension, const double* from, const double* to, double radius)
    : Obstacle(dimension,
               around(dimension, checked_place("from", dimension, from), checked_place("to", dimension, to),
                      {radius, radius, radius}),
               true, radius),
      from_(checked_place("from", dimension, from)),
      radius_(checked_size("radius", radius)) {
    for (uint32_t k = 0; k < dimension; ++k) along_[k] = to[k] - from[k];
    length_ = std::sqrt(dot(along_, along_));
    for (double& a : along_) a = length_ > 0 ? a / length_ : 0;
}

double CapsuleObstacle::evaluate(const double* x, double* gradient, double* second) const {
    const uint32_t d = dimension();
    Place to{};
    for (uint32_t k = 0; k < d; ++k) to[k] = x[k] - from_[k];
    const double at = dot(to, along_);
    const double nearest = std::clamp(at, 0.0, length_);
    for (uint32_t k = 0; k < d; ++k) to[k] -= nearest * along_[k];
    const bool beside = at > 0 && at < length_;
    return radial(d, to, beside ? along_ : Place{}, gradient, second) - radius_;
}

void CapsuleObstacle::draw(double clearance, Wires& wires) const {
    draw_capsule(dimension(), from_, along_, length_, radius_ + clearance, wires);
}

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double core_of_half_space = 1e30;  // metres below the boundary: no way turns around it
constexpr double drawn_half = 5;             // metres

}  // namespace

HalfSpaceObstacle::HalfSpaceObstacle(uint32_t dimension, const double* through, const double* outwards)
    : Obstacle(checked(dimension), {{-endless, -endless, -endless}, {endless, endless, endless}}, false, endless),
      through_(checked_place("through", dimension, through)),
      outwards_(checked_place("direction outwards", dimension, outwards)) {
    const double length = checked_size("length of the direction outwards", std::sqrt(dot(outwards_, outwards_)));
    Place core{};
    for (uint32_t k = 0; k < dimension; ++k) {
        outwards_[k] /= length;
        core[k] = through_[k] - core_of_half_space * outwards_[k];
    }
    set_core(core);
}

double HalfSpaceObstacle::evaluate(const double* x, double* gradient, double* second) const {
    const uint32_t d = dimension();
    double value = 0;
    for (uint32_t k = 0; k < d; ++k) value += (x[k] - through_[k]) * outwards_[k];
    if (gradient != nullptr) std::copy_n(outwards_.begin(), d, gradient);
    if (second != nullptr) std::fill_n(second, d * d, 0.0);
    return value;
}

void HalfSpaceObstacle::draw(double clearance, Wires& wires) const {
    const Vec3 out(outwards_.data()), middle = Vec3(through_.data()) + clearance * out;
    const Vec3 u = dimension() == 2 ? Vec3::UnitZ().cross(out) : out.unitOrthogonal(), v = out.cross(u);
    const auto at = [&](double along, double beside) -> Place {
        const Vec3 x = middle + drawn_half * (along * u + beside * v);
        return {x.x(), x.y(), x.z()};
    };
    if (dimension() == 2) return wires.line(at(-1, 0), at(1, 0));
    wires.line(at(-1, -1), at(1, -1));
    wires.line(at(1, -1), at(1, 1));
    wires.line(at(1, 1), at(-1, 1));
    wires.line(at(-1, 1), at(-1, -1));
}

FunctionObstacle::FunctionObstacle(uint32_t dimension, const Function& function, const Box& box, bool bounded,
                                   double core_depth, double reach)
    : Obstacle(checked(dimension), box, bounded, checked_size("core depth", core_depth), reach),
      function_(function),
      step_(relative_step * diagonal(dimension, box)) {
    checked_place("box.lower", dimension, box.lower.data());
    checked_place("box.upper", dimension, box.upper.data());
    if (function.value == nullptr) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "an obstacle's function is null");
    checked_size("box", step_);
    if (!(reach > 0))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "an obstacle's reach is %g, it must be positive", reach);
}

double FunctionObstacle::evaluate(const double* x, double* gradient, double* second) const {
    const uint32_t d = dimension();
    Place own{};
    if (second != nullptr && function_.second != nullptr) function_.second(function_.user, x, second);
    if (second != nullptr && function_.second == nullptr) {
        Place at{}, above{}, below{};
        std::copy_n(x, d, at.begin());
        for (uint32_t j = 0; j < d; ++j) {
            at[j] = x[j] + step_;
            function_.value(function_.user, at.data(), above.data());
            at[j] = x[j] - step_;
            function_.value(function_.user, at.data(), below.data());
            at[j] = x[j];
            for (uint32_t i = 0; i < d; ++i) second[i * d + j] = (above[i] - below[i]) / (2 * step_);
        }
        for (uint32_t i = 0; i < d; ++i) {
            for (uint32_t j = 0; j < i; ++j) {
                second[i * d + j] = second[j * d + i] = 0.5 * (second[i * d + j] + second[j * d + i]);
            }
        }
    }
    return function_.value(function_.user, x, gradient == nullptr ? own.data() : gradient);
}

}  // namespace flg
