// SPDX-License-Identifier: MIT
// A tree by a parametric L-system: Prusinkiewicz and Lindenmayer, The Algorithmic Beauty of Plants (1990), Fig. 2.8,
//     A -> !(vr) F(50) [&(a) F(50) A] /(d1) [&(a) F(50) A] /(d2) [&(a) F(50) A],   F(l) -> F(l lr),   !(w) -> !(w vr)
// with its tropism, which bends branches downwards. Each F is a curve, a straight one; it begins at the very point that
// the one before it ends at. Departure: the angles vary a little from branch to branch.
#include <cmath>
#include <numbers>

#include "noise.h"
#include "scene_makers.h"
#include "vector.h"

namespace flg::scenes {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kIterations = 5;
constexpr double kDivergence1 = 94.74, kDivergence2 = 132.63, kBranching = 18.95;  // degrees
constexpr double kElongation = 1.109, kThickening = 1.732;
constexpr double kTropism = 0.14;
constexpr double kTrunk = 60.0;                          // length of the axiom's segment, in units of the book
constexpr double kMetres = 0.0021;                       // one of them
constexpr double kTipRadius = 0.0021, kSpacing = 0.012;  // metres

struct Module {
    char symbol;  // F: forward, A: apex, !: width, &: pitch, /: roll, [ and ]
    double value;
};
using Text = std::vector<Module>;

Text rewritten(const Text& text) {
    Text next;
    for (const Module& module : text) {
        if (module.symbol == 'A') {
            const auto branch = [&] {
                next.insert(next.end(), {{'[', 0}, {'&', kBranching}, {'F', 50}, {'A', 0}, {']', 0}});
            };
            next.insert(next.end(), {{'!', kThickening}, {'F', 50}});
            branch();
            next.push_back({'/', kDivergence1});
            branch();
            next.push_back({'/', kDivergence2});
            branch();
        } else if (module.symbol == 'F') {
            next.push_back({'F', module.value * kElongation});
        } else if (module.symbol == '!') {
            next.push_back({'!', module.value * kThickening});
        } else {
            next.push_back(module);
        }
    }
    return next;
}

struct Turtle {
    Vector position, heading = {0.0, 1.0, 0.0}, left = {1.0, 0.0, 0.0};
    double width = 1.0, width_before = 0.0;
    int depth = 0;
};

// A straight curve; its ends are `from` and `to` themselves.
Curve segment(const Vector& from, const Vector& to, double radius_from, double radius_to, int depth) {
    Curve curve;
    const auto steps = static_cast<uint32_t>(std::max(2.0, std::round(length(to - from) / kSpacing)));
    for (uint32_t i = 0; i <= steps; ++i) {
        const double u = static_cast<double>(i) / steps;
        curve.points.push_back(i == steps ? to_point(to) : to_point(from + u * (to - from)));
        curve.radii.push_back(static_cast<float>(radius_from + u * (radius_to - radius_from)));
    }
    const float young = std::min(1.0f, static_cast<float>(depth) / (kIterations + 1.0f));
    curve.color = {0.16f + 0.10f * young, 0.085f + 0.20f * young * young, 0.050f, 1.0f};
    return curve;
}

}  // namespace

std::vector<Curve> make_tree() {
    Text text = {{'!', 1.0}, {'F', kTrunk}, {'/', 45.0}, {'A', 0.0}};
    for (int i = 0; i < kIterations; ++i) text = rewritten(text);

    std::vector<Curve> curves;
    std::vector<Turtle> stack;
    Turtle turtle;
    const Noise hand(31);
    double turn = 0.0;
    for (const Module& module : text) {
        switch (module.symbol) {
            case '[': stack.push_back(turtle), ++turtle.depth; break;
            case ']': turtle = stack.back(), stack.pop_back(); break;
            case '!': turtle.width = module.value; break;
            case '&':
                turtle.heading =
                    turned(turtle.heading, turtle.left, kDegree * module.value * (1.0 + 0.35 * hand(turn += 1.0)));
                break;
            case '/':
                turtle.left =
                    turned(turtle.left, turtle.heading, kDegree * module.value * (1.0 + 0.12 * hand(turn += 1.0)));
                break;
            case 'F': {
                const double ahead = kMetres * module.value * (1.0 + 0.15 * hand(turn += 1.0));
                const Vector to = turtle.position + ahead * turtle.heading;
                // The book's widths are diameters of pipes; a tip has width 1.
                const double radius = kTipRadius * std::pow(turtle.width, 0.8);
                const double before = turtle.width_before > 0.0 ? turtle.width_before : 1.35 * radius;
                curves.push_back(segment(turtle.position, to, std::min(before, 1.35 * radius), radius, turtle.depth));
                turtle.position = to_vector(curves.back().points.back());
                turtle.width_before = radius;
                const Vector torque = cross(turtle.heading, {0.0, -1.0, 0.0});
                if (length(torque) > 1e-9) {
                    const double bend = kTropism * length(torque);
                    turtle.left = turned(turtle.left, unit(torque), bend);
                    turtle.heading = turned(turtle.heading, unit(torque), bend);
                }
                break;
            }
            default: break;  // A: an apex that did not grow out
        }
    }
    return curves;
}

}  // namespace flg::scenes
