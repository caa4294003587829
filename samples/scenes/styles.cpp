// SPDX-License-Identifier: MIT
// The style strokes. Each is an offset from a gently bent axis, as a function of the place on the axis; turns come a
// little early or late, grow and shrink, and fade in and out at the ends, as a hand makes them.
#include "hand.h"

namespace flg::scenes {
namespace {

Offset loops(double u) {
    const Hand hand(101);
    const double turns = 11.0;
    const double a = hand.angle(u, turns, 0.10), s = 0.062 * hand.strength(u, turns, 0.30);
    // Written e's: round, leaning forwards, all on one side of the axis; each comes a little nearer to the viewer.
    return {s * (1.05 * std::sin(a) + 0.35 * (1.0 - std::cos(a))), s * (1.0 - std::cos(a)),
            0.30 * s * std::sin(0.5 * a)};
}

Offset zigzag(double u) {
    const Hand hand(202);
    const double turns = 14.0;
    const double a = hand.angle(u, turns, 0.12), s = 0.055 * hand.strength(u, turns, 0.45);
    // asin(k sin a) / asin(k): a triangle wave with corners as sharp as a wrist makes them.
    const double k = 0.985;
    const double wave = std::asin(k * std::sin(a)) / std::asin(k);
    return {0.03 * s * std::cos(a), s * wave, 0.25 * s * hand.shake.rough(turns * u * 1.3)};
}

Offset curls(double u) {
    const Hand hand(303);
    const double turns = 11.0;
    // A corkscrew that swells and narrows three times, like hair.
    const double swell = 0.45 + 0.55 * std::pow(std::sin(0.5 * kTau * (3.0 * u + 0.12 * hand.timing(5.0 * u))), 2.0);
    const double a = hand.angle(u, turns, 0.10), s = 0.066 * swell * hand.strength(u, turns, 0.18);
    return {0.95 * s * std::sin(a + 0.9), s * std::sin(a), 0.9 * s * std::cos(a)};
}

// Four bows, each a loop above the thread and one below it, on a thread that hangs a little loose.
Offset knots(double u) {
    const Hand hand(404);
    constexpr double kCentres[] = {0.15, 0.36, 0.63, 0.86};
    constexpr double kHalves[] = {0.085, 0.10, 0.095, 0.08};
    Offset offset = {0.0, 0.014 * hand.shake(7.0 * u), 0.012 * hand.shake.rough(6.0 * u + 31.0)};
    for (int knot = 0; knot < 4; ++knot) {
        const double local = 0.5 + 0.5 * (u - kCentres[knot]) / kHalves[knot];
        if (local <= 0.0 || local >= 1.0) continue;
        const double a = 2.0 * kTau * smooth_step(local);
        const double first = a < kTau ? 1.0 : -0.8 - 0.2 * hand.size(knot * 3.1);
        const double s = 0.036 * (1.0 + 0.35 * hand.size(knot * 5.7 + 0.5));
        offset.along += 1.25 * s * std::sin(a);
        offset.up += first * s * (1.0 - std::cos(a));
        offset.side += 0.45 * s * std::sin(0.5 * a) * std::sin(0.5 * a + 0.4);
    }
    return offset;
}

Offset tremor(double u) {
    const Hand hand(505);
    const double s = hand.strength(u, 12.0, 0.6);
    return {0.004 * s * hand.timing.rough(60.0 * u),
            s * (0.013 * hand.shake.rough(24.0 * u) + 0.004 * hand.size(75.0 * u)),
            s * (0.013 * hand.shake.rough(22.0 * u + 400.0) + 0.005 * hand.size(70.0 * u + 90.0))};
}

Offset braid(double u) {
    const Hand hand(606);
    const double turns = 8.0;
    const double a = hand.angle(u, turns, 0.07), s = 0.048 * hand.strength(u, turns, 0.16);
    // One strand of three: a lying eight across the axis.
    return {-0.35 * s * std::sin(2.0 * a), s * std::sin(a), 0.62 * s * std::sin(2.0 * a)};
}

// Drawn in a plane: a wave whose crests lean forwards.
Offset wave(double u) {
    const Hand hand(707);
    const double turns = 12.0;
    const double a = hand.angle(u, turns, 0.10), s = 0.040 * hand.strength(u, turns, 0.35);
    return {0.55 * s * std::sin(a + 0.5) * std::sin(a), s * std::sin(a), 0.0};
}

// Drawn in a plane: stitches, each an omega that overlaps its neighbours.
Offset knit(double u) {
    const Hand hand(808);
    const double turns = 10.0;
    const double a = hand.angle(u, turns, 0.05), s = 0.058 * hand.strength(u, turns, 0.12);
    return {-0.75 * s * std::sin(2.0 * a), s * std::sin(a) * (1.0 + 0.08 * hand.shake(6.0 * u)), 0.0};
}

// A thread with drops on it, of all sizes: what matters is the radius.
Offset beads(double u) {
    const Hand hand(909);
    const double s = hand.strength(u, 9.0, 0.5);
    return {0.0, 0.020 * s * hand.shake.rough(9.0 * u), 0.020 * s * hand.shake.rough(8.0 * u + 50.0)};
}

// A ribbon that rolls over again and again while it swings to and fro.
Offset twist(double u) {
    const Hand hand(111);
    const double a = hand.angle(u, 4.0, 0.14), s = 0.052 * hand.strength(u, 4.0, 0.25);
    return {0.0, s * std::sin(a), 0.6 * s * std::cos(a + 0.7)};
}

// From a moment's width of a drop to the next: 0 between them, 1 on them.
double drop(double u) {
    const Noise timing(919);
    return std::pow(std::sin(0.5 * kTau * (16.0 * u + 0.30 * timing(14.0 * u))), 4.0);
}

double bead_radius(double u) {
    const Noise size(929);
    return 0.0035 + 0.0125 * drop(u) * (1.0 + 0.45 * size(13.0 * u));
}

Color bead_color(double u) {
    const auto ripe = static_cast<float>(drop(u));
    return {0.05f + 0.75f * ripe, 0.22f - 0.20f * ripe, 0.10f - 0.04f * ripe, 1.0f};
}

double twist_angle(double u) {
    const Noise timing(121);
    return kTau * (5.0 * u + 0.25 * timing(6.0 * u));
}

double twist_radius(double u) {
    const Noise size(131);
    return 0.020 * (1.0 + 0.30 * size.rough(7.0 * u));
}

// Red on one side of a half turn, gold on the other.
Color twist_color(double u) {
    const auto gold = static_cast<float>(0.5 + 0.5 * std::sin(twist_angle(u)));
    return {0.62f + 0.28f * gold, 0.03f + 0.42f * gold, 0.05f + 0.01f * gold, 1.0f};
}

// A pen's pressure.
double pen_radius(double u, uint64_t seed) {
    const Noise pressure(seed * 31 + 7);
    return 0.0045 * (1.0 + 0.35 * pressure.rough(9.0 * u));
}

constexpr Recipe kRecipes[] = {
    {"loops", loops, 600, 1, {0.86f, 0.16f, 0.10f, 1.0f}},
    {"zigzag", zigzag, 420, 2, {0.95f, 0.55f, 0.05f, 1.0f}},
    {"curls", curls, 560, 3, {0.12f, 0.45f, 0.75f, 1.0f}},
    {"knots", knots, 540, 4, {0.18f, 0.55f, 0.25f, 1.0f}},
    {"tremor", tremor, 320, 5, {0.35f, 0.30f, 0.28f, 1.0f}},
    {"braid", braid, 480, 6, {0.55f, 0.20f, 0.60f, 1.0f}},
    {"wave", wave, 420, 7, {0.10f, 0.35f, 0.60f, 1.0f}, true},
    {"knit", knit, 560, 8, {0.60f, 0.12f, 0.16f, 1.0f}, true},
    {"beads", beads, 400, 9, {0.40f, 0.10f, 0.08f, 1.0f}, false, bead_radius, nullptr, bead_color},
    {"twist", twist, 360, 10, {0.75f, 0.20f, 0.06f, 1.0f}, false, twist_radius, twist_angle, twist_color},
};

// The gently bent axis and its frame.
Point place(double u, const Recipe& recipe, const Offset& o) {
    const Noise bend(recipe.seed * 977);
    const double depth = recipe.planar ? 0.0 : 0.045;
    const auto axis = [&](double v) {
        return std::array{v, 0.055 * std::sin(2.6 * v + 0.4) + 0.020 * bend(2.0 * v), depth * bend(1.7 * v + 40.0)};
    };
    const double h = 1e-4;
    const auto at = axis(u), before = axis(u - h), after = axis(u + h);
    std::array<double, 3> t;
    for (int i = 0; i < 3; ++i) t[i] = (after[i] - before[i]) / (2.0 * h);
    const double tangent = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    for (double& c : t) c /= tangent;
    // side = t x (0, 1, 0), up = side x t.
    const double flat = std::sqrt(t[0] * t[0] + t[2] * t[2]);
    const std::array<double, 3> side = {-t[2] / flat, 0.0, t[0] / flat};
    const std::array<double, 3> up = {side[1] * t[2] - side[2] * t[1], side[2] * t[0] - side[0] * t[2],
                                      side[0] * t[1] - side[1] * t[0]};
    std::array<float, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = static_cast<float>(at[i] + o.along * t[i] + o.up * up[i] + o.side * side[i]);
    return {p[0], p[1], p[2]};
}

}  // namespace

const std::vector<std::string>& style_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Recipe& recipe : kRecipes) list.emplace_back(recipe.name);
        return list;
    }();
    return names;
}

const std::vector<std::string>& library_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list = style_names();
        for (const Recipe& recipe : motif_recipes()) list.emplace_back(recipe.name);
        return list;
    }();
    return names;
}

Curve make_style(std::string_view name) {
    Curve curve;
    std::vector<Recipe> recipes(std::begin(kRecipes), std::end(kRecipes));
    recipes.insert(recipes.end(), motif_recipes().begin(), motif_recipes().end());
    for (const Recipe& recipe : recipes) {
        if (name != recipe.name) continue;
        curve.color = recipe.color;
        curve.points.reserve(recipe.count);
        for (uint32_t i = 0; i < recipe.count; ++i) {
            const double u = static_cast<double>(i) / (recipe.count - 1);
            curve.points.push_back(place(u, recipe, recipe.offset(u)));
            const double ends = 0.35 + 0.65 * smooth_step(u / 0.08) * smooth_step((1.0 - u) / 0.08);
            const double radius = recipe.radius != nullptr ? recipe.radius(u) : pen_radius(u, recipe.seed);
            curve.radii.push_back(static_cast<float>(ends * radius));
            if (recipe.angle != nullptr) curve.angles.push_back(static_cast<float>(recipe.angle(u)));
            if (recipe.varied_color != nullptr) curve.colors.push_back(recipe.varied_color(u));
        }
    }
    return curve;
}

}  // namespace flg::scenes
