// SPDX-License-Identifier: MIT
// An architect's wireframe: a chapel with a steep roof and pointed windows beside a bell tower. Lines end where they
// meet others, at the very same points.
#include <cmath>

#include "scene_makers.h"
#include "vector.h"

namespace flg::scenes {
namespace {

constexpr double kSpacing = 0.01, kRadius = 0.0036;  // metres

class Drawing {
public:
    void line(const Vector& from, const Vector& to) { curve({from, to}); }

    void ring(const std::vector<Vector>& corners) {
        for (size_t i = 0; i < corners.size(); ++i) line(corners[i], corners[(i + 1) % corners.size()]);
    }

    // A pointed arch between two points on a level: two arcs, each around the other's foot.
    void arch(const Vector& left, const Vector& right) {
        const Vector across = right - left;
        const double span = length(across);
        const Vector up = {0.0, 1.0, 0.0}, along = unit(across);
        const auto side = [&](const Vector& centre, const Vector& towards) {
            constexpr double kPointed = 1.0471975511965976;  // a third of a half turn
            std::vector<Vector> points;
            for (int i = 0; i <= 12; ++i) {
                const double a = kPointed * i / 12.0;
                points.push_back(centre + span * (std::cos(a) * towards + std::sin(a) * up));
            }
            return points;
        };
        std::vector<Vector> rise = side(right, -1.0 * along), fall = side(left, along);
        const Vector tip = 0.5 * (left + right) + span * std::sqrt(0.75) * up;
        rise.front() = left, rise.back() = tip;
        fall.front() = right, fall.back() = tip;
        curve(rise);
        curve(fall);
    }

    // A window or door standing on `foot`, `right` wide, `height` high up to where its arch springs.
    void opening(const Vector& foot, const Vector& right, double height) {
        const Vector up = {0.0, height, 0.0};
        line(foot, foot + up);
        line(foot + right, foot + right + up);
        line(foot, foot + right);
        arch(foot + up, foot + right + up);
    }

    std::vector<Curve> take() { return std::move(curves_); }

private:
    // A polyline, sampled evenly on each of its pieces.
    void curve(const std::vector<Vector>& corners) {
        Curve made;
        for (size_t i = 0; i + 1 < corners.size(); ++i) {
            const Vector piece = corners[i + 1] - corners[i];
            const auto steps = static_cast<uint32_t>(std::max(1.0, std::round(length(piece) / kSpacing)));
            for (uint32_t k = 0; k < steps; ++k) {
                made.points.push_back(to_point(corners[i] + (static_cast<double>(k) / steps) * piece));
            }
        }
        made.points.push_back(to_point(corners.back()));
        made.radii.assign(made.points.size(), static_cast<float>(kRadius));
        made.color = {0.07f, 0.08f, 0.12f, 1.0f};
        curves_.push_back(std::move(made));
    }

    std::vector<Curve> curves_;
};

// The four corners of a level rectangle, counterclockwise from above.
std::vector<Vector> level(double x0, double x1, double z0, double z1, double y) {
    return {{x0, y, z1}, {x1, y, z1}, {x1, y, z0}, {x0, y, z0}};
}

void chapel(Drawing& d) {
    const double x0 = 0.30, x1 = 1.20, z0 = -0.25, z1 = 0.25, eaves = 0.45, ridge = 0.92;
    const auto floor = level(x0, x1, z0, z1, 0.0), top = level(x0, x1, z0, z1, eaves);
    d.ring(floor);
    d.ring(top);
    for (size_t i = 0; i < 4; ++i) d.line(floor[i], top[i]);
    const Vector west = {x0, ridge, 0.0}, east = {x1, ridge, 0.0};
    d.line(west, east);
    d.line(top[0], west), d.line(top[3], west), d.line(top[1], east), d.line(top[2], east);
    // Rafters, buttresses and windows, bay by bay.
    constexpr int kBays = 4;
    const double bay = (x1 - x0) / kBays;
    for (int i = 0; i < kBays; ++i) {
        const double x = x0 + bay * i;
        for (double z : {z0, z1}) {
            d.opening({x + 0.3 * bay, 0.10, z}, {0.4 * bay, 0.0, 0.0}, 0.17);
            if (i == 0) continue;
            d.line({x, eaves, z}, {x, ridge, 0.0});
            const double out = z < 0.0 ? -0.09 : 0.09;
            d.line({x, 0.0, z + out}, {x, 0.30, z});
            d.line({x, 0.0, z}, {x, 0.30, z});
            d.line({x, 0.30, z}, {x, eaves, z});
            d.line({x, 0.0, z}, {x, 0.0, z + out});
        }
    }
    // A rose window in the gable: sixteen spokes within two rings.
    constexpr int kSpokes = 12;
    const auto rose = [&](double radius, int i) {
        const double a = 6.283185307179586 * (i % kSpokes) / kSpokes;
        return Vector{x1, 0.36 + radius * std::cos(a), radius * std::sin(a)};
    };
    for (int i = 0; i < kSpokes; ++i) {
        d.line(rose(0.11, i), rose(0.11, i + 1));
        d.line(rose(0.035, i), rose(0.035, i + 1));
        d.line(rose(0.035, i), rose(0.11, i));
    }
    d.opening({x1, 0.0, -0.07}, {0.0, 0.0, 0.14}, 0.09);
}

void tower(Drawing& d) {
    const double half = 0.19, x = 0.11;
    const double storeys[] = {0.0, 0.48, 0.88, 1.22};
    std::vector<Vector> below;
    for (double y : storeys) {
        const auto ring = level(x - half, x + half, -half, half, y);
        d.ring(ring);
        for (size_t i = 0; i < below.size(); ++i) d.line(below[i], ring[i]);
        below = ring;
    }
    const Vector tip = {x, 1.98, 0.0};
    const auto shoulder = level(x - 0.62 * half, x + 0.62 * half, -0.62 * half, 0.62 * half, 1.43);
    d.ring(shoulder);
    for (size_t i = 0; i < 4; ++i) d.line(below[i], shoulder[i]), d.line(shoulder[i], tip);
    // The cross on top.
    const Vector cross = {x, 2.06, 0.0};
    d.line(tip, cross), d.line(cross, {x, 2.12, 0.0});
    d.line({x - 0.045, 2.06, 0.0}, cross), d.line(cross, {x + 0.045, 2.06, 0.0});
    for (double z : {-half, half}) {
        d.opening({x - 0.05, 0.60, z}, {0.10, 0.0, 0.0}, 0.10);
        d.opening({x - 0.12, 0.95, z}, {0.10, 0.0, 0.0}, 0.13);
        d.opening({x + 0.02, 0.95, z}, {0.10, 0.0, 0.0}, 0.13);
    }
    d.opening({x - 0.07, 0.0, half}, {0.14, 0.0, 0.0}, 0.22);
    d.opening({x - half, 0.95, -0.12}, {0.0, 0.0, 0.10}, 0.13);
    d.opening({x - half, 0.95, 0.02}, {0.0, 0.0, 0.10}, 0.13);
}

}  // namespace

std::vector<Curve> make_tower() {
    Drawing drawing;
    chapel(drawing);
    tower(drawing);
    return drawing.take();
}

}  // namespace flg::scenes
