// SPDX-License-Identifier: MIT
// How a spline on a surface is found, after figures 3 to 6 of Hofer, Pottmann: Energy-minimizing splines in manifolds
// (2004). What is drawn is computed as the paper says, on a surface made here.
#include <Eigen/Dense>
#include <cmath>
#include <deque>
#include <numbers>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/pictures.h"
#include "gallery/sketch.h"
#include "gallery/spline_forms.h"

namespace flg::gallery {
namespace {

// A dome over x and z.
double height(double x, double z) {
    return 0.85 * std::exp(-1.1 * x * x - 0.8 * z * z) + 0.05 * x * z;
}

glm::dvec3 on_dome(double x, double z) {
    return {x, height(x, z), z};
}

glm::dvec3 normal_at(const glm::dvec3& p) {
    constexpr double kBit = 1e-5;
    return glm::normalize(glm::dvec3(-(height(p.x + kBit, p.z) - height(p.x - kBit, p.z)) / (2 * kBit), 1.0,
                                     -(height(p.x, p.z + kBit) - height(p.x, p.z - kBit)) / (2 * kBit)));
}

// The nearest point of the dome, by steps in its tangent planes.
glm::dvec3 footpoint(const glm::dvec3& p) {
    glm::dvec3 q = on_dome(p.x, p.z);
    for (int i = 0; i < 400; ++i) {
        const glm::dvec3 n = normal_at(q), step = (p - q) - glm::dot(p - q, n) * n;
        q = on_dome(q.x + 0.2 * step.x, q.z + 0.2 * step.z);
    }
    return q;
}

filigree::Surface dome(Workshop& workshop) {
    return surface_of(workshop, sheet(200, 200, false,
                                      [](double u, double v) { return on_dome(2.3 * (u - 0.5), -2.3 * (v - 0.5)); }));
}

// One round: the tangent plane's point nearest to p, a step towards it, and that step's footpoint.
struct Round {
    glm::dvec3 current, tangent, step, next;
};

Round round_of(const glm::dvec3& p, const glm::dvec3& current, double stepsize) {
    const glm::dvec3 n = normal_at(current), tangent = p - glm::dot(p - current, n) * n;
    const glm::dvec3 step = current + stepsize * (tangent - current);
    return {current, tangent, step, footpoint(step)};
}

constexpr glm::dvec3 kAim = {0.42, 1.30, 0.35}, kBegin = {-0.75, 0.0, 0.55};  // p, and where rounds begin (x and z)

Note named(const glm::dvec3& at, const char* text, glm::vec2 by, glm::vec3 color = kInk) {
    return {glm::vec3(at), text, by, color, 17.0f};
}

// A square of the tangent plane at a point, as a grid.
std::vector<Points> tangent_plane(const glm::dvec3& at, const glm::dvec3& along, double from, double to, double aside) {
    constexpr int kLines = 6;
    const glm::dvec3 n = normal_at(at), u = glm::normalize(along - glm::dot(along, n) * n), v = glm::cross(n, u);
    std::vector<Points> lines;
    for (int i = 0; i <= kLines; ++i) {
        const double t = static_cast<double>(i) / kLines;
        const double x = from + t * (to - from), y = aside * (2 * t - 1);
        lines.push_back({at + x * u - aside * v, at + x * u + aside * v});
        lines.push_back({at + from * u + y * v, at + to * u + y * v});
    }
    return lines;
}

void footpoints(Workshop& workshop, Studio& studio) {
    const glm::dvec3 start = on_dome(kBegin.x, kBegin.z), foot = footpoint(kAim);
    const Round round = round_of(kAim, start, 0.75);
    Stage left(workshop, {0.25f, -0.42f, -1.0f}), right(workshop, {0.25f, -0.42f, -1.0f});
    left.surface(dome(workshop), kSand);
    left.lines(tangent_plane(start, round.tangent - start, -0.15, glm::distance(start, round.tangent) + 0.15, 0.3),
               kYellow, 0.004f);
    left.lines({{start, round.tangent}}, kInk, 0.010f);
    left.lines({{kAim, round.tangent}}, kGrey, 0.007f);
    left.lines({{round.step, round.next}}, kBlue, 0.009f);
    left.lines({{kAim, foot}}, kRed, 0.006f);
    left.dots({start, round.next}, kBlue, 0.026f);
    left.dots({round.tangent, round.step}, kYellow, 0.024f);
    left.dots({foot}, kRed, 0.030f);
    left.dots({kAim}, kInk, 0.030f);
    left.panel.title = "One round of the projected gradient";
    left.panel.keys = {{kInk, "p"},
                       {kYellow, "p\u209c and x\u209b: on the tangent plane"},
                       {kBlue, "x and x\u208a: on the surface"},
                       {kRed, "p*: the nearest point"}};
    left.panel.notes = {named(kAim, "p", {14.0f, -10.0f}),
                        named(start, "x", {-12.0f, 12.0f}, kBlue),
                        named(round.tangent, "p\u209c", {16.0f, -8.0f}),
                        named(round.step, "x\u209b", {-10.0f, -14.0f}),
                        named(round.next, "x\u208a", {-4.0f, 20.0f}, kBlue),
                        named(foot, "p*", {16.0f, 10.0f}, kRed)};
    // All rounds, and the cone from p to the way they take.
    Points way = {start};
    for (int i = 0; i < 6; ++i) way.push_back(round_of(kAim, way.back(), 0.45).next);
    Points fine;
    for (size_t i = 0; i + 1 < way.size(); ++i) {
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 p = glm::mix(way[i], way[i + 1], k / 8.0);
            fine.push_back(on_dome(p.x, p.z));
        }
    }
    fine.push_back(way.back());
    std::vector<Points> rays;
    for (size_t i = 0; i < fine.size(); i += 2) rays.push_back({kAim, fine[i]});
    right.surface(dome(workshop), kSand);
    right.lines(rays, kGrey, 0.0035f);
    right.curve(fine, kBlue, 0.010f);
    right.dots(way, kBlue, 0.022f);
    right.dots({foot}, kRed, 0.030f);
    right.dots({kAim}, kInk, 0.030f);
    right.panel.title = "The rounds' way, and its cone to p";
    right.panel.notes = {named(kAim, "p", {14.0f, -10.0f}), named(start, "first x", {-10.0f, 18.0f}, kBlue),
                         named(foot, "p*", {16.0f, 12.0f}, kRed)};
    std::vector<Panel> panels = {left.panel, right.panel};
    for (Panel& panel : panels) panel.ground = false, panel.margin = 1.02f;
    studio.take("spline_footpoint", panels, 2, kWidth, 420);
}

// ---- Fig. 4

Note named(const glm::dvec2& at, const char* text, glm::vec2 by, glm::vec3 color = kInk) {
    return named(glm::dvec3(at, 0.0), text, by, color);
}

Line arc(const glm::dvec2& middle, double radius, double from, double to) {
    Line line;
    for (int i = 0; i <= 96; ++i) {
        const double a = from + (to - from) * i / 96.0;
        line.push_back(middle + radius * glm::dvec2(std::sin(a), std::cos(a)));
    }
    return line;
}

// A right angle between two directions, for the eye.
Line right_angle(const glm::dvec2& at, const glm::dvec2& one, const glm::dvec2& other, double size) {
    const glm::dvec2 u = size * glm::normalize(one), v = size * glm::normalize(other);
    return {at + u, at + u + v, at + v};
}

void stepsizes(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.014, kRadius = 1.0, kAngle = -0.72, kDistance = 0.42;
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const double side : {1.0, -1.0}) {  // p towards the centre of curvature, and away from it
        const glm::dvec2 middle(0.0, -kRadius), foot(0.0, 0.0), p(0.0, -side * kDistance);
        const glm::dvec2 radial(std::sin(kAngle), std::cos(kAngle)), current = middle + kRadius * radial;
        const glm::dvec2 along(radial.y, -radial.x), tangent = current + glm::dot(p - current, along) * along;
        const double curvature = side / kRadius, stepsize = 1 / std::abs(kDistance * curvature - 1);
        const glm::dvec2 step = current + stepsize * (tangent - current);
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        sketch.line(arc(middle, kRadius, -1.08, 0.75), kInk, 2.2);
        sketch.line({current - 0.25 * along, current + 1.15 * along}, kGrey, 1.2);
        sketch.line({p, tangent}, kGrey, 1.2);
        sketch.line({foot, step}, kRed, 1.2);
        sketch.line({p, foot}, kRed, 1.6);
        sketch.line({current, step}, kTeal, 2.6);
        sketch.line(right_angle(tangent, p - tangent, current - tangent, 0.05), kGrey, 1.0);
        sketch.line(right_angle(step, foot - step, current - step, 0.035), kRed, 1.0);
        sketch.dots(Line{current, step}, kTeal, 5.0);
        sketch.dots(Line{tangent}, kGold, 5.0);
        sketch.dots(Line{foot}, kRed, 5.5);
        sketch.dots(Line{p}, kInk, 5.5);
        Panel& panel = panels.emplace_back(sketch.panel());
        char words[100];
        std::snprintf(words, sizeof words, "p is %s: s = 1 / |d\u03ba \u2212 1| = %.2f",
                      side > 0 ? "on the hollow side" : "on the other side", stepsize);
        panel.title = words;
        panel.notes = {named(current, "x", {-14.0f, -8.0f}, kTeal),
                       named(tangent, "p on the tangent", {side > 0 ? -80.0f : 82.0f, side > 0 ? -14.0f : 10.0f}),
                       named(step, "the step ends here", {-86.0f, -12.0f}, kTeal),
                       named(foot, "nearest point", {side > 0 ? 64.0f : 20.0f, side > 0 ? -16.0f : 24.0f}, kRed),
                       named(p, "p", {side > 0 ? 16.0f : -16.0f, side > 0 ? 8.0f : -8.0f}),
                       named(0.5 * (p + foot), "d", {14.0f, 0.0f}, kRed)};
    }
    for (Panel& panel : panels) panel.aim = {{-0.95f, -0.55f, 0.0f}, {0.75f, 0.50f, 0.0f}};
    studio.take("spline_stepsize", panels, 2, kWidth, 360);
}

// ---- Fig. 5

void development(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.012;
    const glm::dvec3 before = on_dome(kBegin.x, kBegin.z), current = round_of(kAim, before, 0.5).next;
    const Round round = round_of(kAim, current, 1.0);
    Stage left(workshop, {0.25f, -0.42f, -1.0f});
    left.surface(dome(workshop), kSand);
    left.lines({{before, current}, {current, round.tangent}}, kBlue, 0.010f);
    left.lines({{kAim, before}, {kAim, current}, {kAim, round.tangent}, {before, round.tangent}}, kGrey, 0.007f);
    left.dots({before, current}, kBlue, 0.026f);
    left.dots({round.tangent}, kYellow, 0.026f);
    left.dots({kAim}, kInk, 0.030f);
    left.panel.title = "Distances in space: two triangles";
    left.panel.ground = false;
    left.panel.margin = 1.02f;
    left.panel.notes = {named(kAim, "p", {0.0f, -16.0f}), named(before, "last x", {-14.0f, 18.0f}, kBlue),
                        named(current, "x", {-4.0f, 20.0f}, kBlue), named(round.tangent, "p\u209c", {18.0f, -4.0f})};

    // In the plane: x is the origin, the tangent the first axis. Of two places for the last x the one that is off less.
    const double a = glm::distance(current, round.tangent), up = glm::distance(kAim, round.tangent),
                 to_p = glm::distance(before, kAim), to_x = glm::distance(before, current);
    const glm::dvec2 p(a, up), direction = p / glm::length(p), across(-direction.y, direction.x);
    const double share = (to_x * to_x - to_p * to_p + glm::dot(p, p)) / (2 * glm::length(p));
    const glm::dvec2 aside = std::sqrt(std::max(0.0, to_x * to_x - share * share)) * across;
    const auto off = [&](const glm::dvec2& place) {
        return std::abs(glm::distance(place, glm::dvec2(a, 0.0)) - glm::distance(before, round.tangent));
    };
    const glm::dvec2 one = share * direction + aside, other = share * direction - aside,
                     last = off(one) < off(other) ? one : other;
    // The circle through it that touches the tangent in x; the paper has the radius with xi for eta.
    const double radius = glm::dot(last, last) / (2 * last.y);
    const glm::dvec2 middle(0.0, radius), foot = middle + std::abs(radius) * glm::normalize(p - middle);
    Sketch sketch(workshop, kUnit);
    const double turn = radius < 0 ? 0.0 : std::numbers::pi;
    sketch.line(arc(middle, std::abs(radius), turn - 0.9, turn + 0.9), kInk, 2.0);
    sketch.line({glm::dvec2(last.x - 0.15, 0.0), glm::dvec2(a + 0.25, 0.0)}, kGrey, 1.2);
    sketch.lines(std::vector<Line>{{p, last}, {p, {0.0, 0.0}}, {p, {a, 0.0}}, {last, {a, 0.0}}}, kGrey, 1.6);
    sketch.line({last, {0.0, 0.0}}, kTeal, 2.4);
    sketch.line({p, foot}, kRed, 1.6);
    sketch.line(right_angle({a, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, 0.05), kGrey, 1.0);
    sketch.dots(Line{last, {0.0, 0.0}}, kTeal, 6.0);
    sketch.dots(Line{{a, 0.0}}, kGold, 6.0);
    sketch.dots(Line{foot}, kRed, 6.0);
    sketch.dots(Line{p}, kInk, 6.5);
    Panel right = sketch.panel();
    right.title = "Laid into the plane";
    right.keys = {{kInk, "a circle through both x tells the curvature \u03ba"}, {kRed, "and the distance d"}};
    right.notes = {named(p, "p", {0.0f, -16.0f}),
                   named(last, "last x (\u03be, \u03b7)", {44.0f, 24.0f}, kTeal),
                   named(glm::dvec2(0.0), "x", {-6.0f, -18.0f}, kTeal),
                   named(glm::dvec2(a, 0.0), "p\u209c", {18.0f, -12.0f}),
                   named(0.5 * (p + foot), "d", {-14.0f, 4.0f}, kRed),
                   named(foot, "nearest point", {-20.0f, 20.0f}, kRed)};
    right.margin = 1.45f;
    right.aim = {
        glm::vec3(last, 0.0f), glm::vec3(p, 0.0f), {static_cast<float>(a), -0.30f, 0.0f}, glm::vec3(foot, 0.0f)};
    const Panel panels[] = {left.panel, right};
    studio.take("spline_development", panels, 2, kWidth, 420);
}

// ---- Fig. 6

// Displacements in the tangent planes after which the sum of squared second differences is least; the first, the middle
// and the last point stay.
Points displaced(const Points& points) {
    const auto count = static_cast<Eigen::Index>(points.size());
    std::vector<Eigen::Index> number(points.size(), -1);
    Eigen::Index unknowns = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        if (i != 0 && i + 1 != points.size() && 2 * i + 1 != points.size()) number[i] = 2 * unknowns++;
    }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * (count - 2), 2 * unknowns);
    Eigen::VectorXd right(3 * (count - 2));
    const auto frame = [&](size_t i) {
        const glm::dvec3 n = normal_at(points[i]), u = glm::normalize(glm::cross(n, glm::dvec3(0.0, 0.0, 1.0)));
        return std::array{u, glm::cross(n, u)};
    };
    for (Eigen::Index k = 0; k + 2 < count; ++k) {
        const auto i = static_cast<size_t>(k);
        const glm::dvec3 second = points[i] - 2.0 * points[i + 1] + points[i + 2];
        for (int c = 0; c < 3; ++c) right(3 * k + c) = -second[c];
        for (size_t j = 0; j < 3; ++j) {
            if (number[i + j] < 0) continue;
            const std::array<glm::dvec3, 2> axes = frame(i + j);
            for (int c = 0; c < 3; ++c) {
                for (int axis = 0; axis < 2; ++axis) {
                    matrix(3 * k + c, number[i + j] + axis) =
                        (j == 1 ? -2.0 : 1.0) * axes[static_cast<size_t>(axis)][c];
                }
            }
        }
    }
    const Eigen::VectorXd solution = matrix.colPivHouseholderQr().solve(right);
    Points result = points;
    for (size_t i = 0; i < points.size(); ++i) {
        if (number[i] < 0) continue;
        const std::array<glm::dvec3, 2> axes = frame(i);
        result[i] += solution(number[i]) * axes[0] + solution(number[i] + 1) * axes[1];
    }
    return result;
}

// On the surface by the straight line's points.
Points first_guess(const std::array<glm::dvec3, 3>& given, int between) {
    Points points;
    for (size_t i = 0; i + 1 < given.size(); ++i) {
        for (int k = 0; k <= between; ++k) {
            const glm::dvec3 p = glm::mix(given[i], given[i + 1], k / (between + 1.0));
            points.push_back(on_dome(p.x, p.z));
        }
    }
    points.push_back(given.back());
    return points;
}

void iteration(Workshop& workshop, Studio& studio) {
    constexpr int kBetween = 3;
    const std::array given = {on_dome(-0.95, -0.1), on_dome(0.0, 0.62), on_dome(0.95, -0.2)};
    const glm::vec3 sight(-0.05f, -0.85f, -1.0f);
    const Points guess = first_guess(given, kBetween), moved = displaced(guess);
    Points next;
    for (const glm::dvec3& p : moved) next.push_back(footpoint(p));
    Stage left(workshop, sight), right(workshop, sight);
    left.surface(dome(workshop), kSand);
    left.lines({next}, kBlue, 0.008f);
    left.dots(next, kBlue, 0.020f);
    left.dots(Points(given.begin(), given.end()), kRed, 0.030f);
    left.panel.title = "A spline is a chain of points";
    left.panel.keys = {{kRed, "p: given"}, {kBlue, "q: to be found"}};
    const char* const kNames[] = {"p\u2081",       "q\u2081\u2081", "q\u2081\u2082", "q\u2081\u2083", "p\u2082",
                                  "q\u2082\u2081", "q\u2082\u2082", "q\u2082\u2083", "p\u2083"};
    for (size_t i = 0; i < next.size(); ++i) {
        left.panel.notes.push_back(named(next[i], kNames[i], {0.0f, 22.0f}, i % (kBetween + 1) == 0 ? kRed : kBlue));
    }
    right.surface(dome(workshop), kSand);
    right.lines({guess}, kInk, 0.006f);
    right.lines({next}, kBlue, 0.008f);
    std::vector<Points> steps;
    for (size_t i = 0; i < guess.size(); ++i) {
        if (i % (kBetween + 1) != 0) steps.push_back({guess[i], moved[i], next[i]});
    }
    right.lines(steps, kYellow, 0.009f);
    right.dots(guess, kInk, 0.018f);
    right.dots(next, kBlue, 0.020f);
    right.dots(Points(given.begin(), given.end()), kRed, 0.030f);
    right.panel.title = "One round";
    right.panel.keys = {{kInk, "the chain as it is"},
                        {kYellow, "each q moves in its tangent plane, and back"},
                        {kBlue, "the next chain"}};
    std::vector<Panel> panels = {left.panel, right.panel};
    for (Panel& panel : panels) {
        panel.ground = false;
        panel.margin = 1.0f;
        panel.aim = {{-1.1f, 0.95f, -0.2f}, {1.1f, 0.95f, -0.2f}, {-1.05f, 0.0f, 0.75f}, {1.05f, 0.0f, 0.75f}};
        for (Layer& layer : panel.layers) layer.look.in_front = true;  // chords run below the dome
    }
    studio.take("spline_iteration", panels, 2, kWidth, 420);
}

constexpr Picture kPictures[] = {
    {"spline_footpoint", "Fig. 3: the nearest point of a surface by the projected gradient, and the cone of its rounds",
     true, footpoints},
    {"spline_stepsize", "Fig. 4: the step that ends nearest to the nearest point", true, stepsizes},
    {"spline_development", "Fig. 5: curvature and distance from two triangles laid into the plane", true, development},
    {"spline_iteration", "Fig. 6: a spline as a chain of points, and one round of the optimization", true, iteration},
};

}  // namespace

std::span<const Picture> footpoint_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
