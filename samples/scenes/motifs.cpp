// SPDX-License-Identifier: MIT
// Styles made of motifs: each is a way from (0, 0) to (1, 0) that the stroke goes over and over again, a little wider,
// narrower, higher or lower each time.
#include <algorithm>
#include <array>
#include <cstdint>

#include "hand.h"

namespace flg::scenes {
namespace {

// Share of the stroke that is plain at both ends.
constexpr double kLead = 0.04;

// Along the motif, up and sideways from the axis, in widths of a motif.
struct Place {
    double along, up, side = 0.0;
};

template <class Motif>
Offset repeated(double u, uint64_t seed, int count, double unevenness, const Motif& motif) {
    const Hand hand(seed);
    const double at = std::clamp((u - kLead) / (1.0 - 2.0 * kLead), 0.0, 1.0) * count;
    const int turn = std::min(static_cast<int>(at), count - 1);
    const auto border = [&](int i) {
        const double shift = i == 0 || i == count ? 0.0 : unevenness * hand.timing(3.1 * i);
        return kLead + (1.0 - 2.0 * kLead) * (i + shift) / count;
    };
    if (u <= kLead || u >= 1.0 - kLead) return {0.0, 0.0, 0.0};
    const double begin = border(turn), width = border(turn + 1) - begin;
    const Place p = motif(at - turn, turn);
    const double size = width * (1.0 + 1.6 * unevenness * hand.size(2.3 * turn));
    const double shake = 0.012 * width;
    return {begin + width * p.along - u, size * p.up + shake * hand.shake.rough(5.0 * at),
            size * p.side + shake * hand.shake.rough(4.0 * at + 70.0)};
}

// At t along a chain of straight lines, as much time for each as it is long.
template <size_t N>
Place along_lines(const std::array<Place, N>& corners, double t) {
    double length = 0.0;
    for (size_t i = 1; i < N; ++i)
        length += std::hypot(corners[i].along - corners[i - 1].along, corners[i].up - corners[i - 1].up);
    double left = t * length;
    for (size_t i = 1; i < N; ++i) {
        const Place a = corners[i - 1], b = corners[i];
        const double step = std::hypot(b.along - a.along, b.up - a.up);
        if (left > step && i + 1 < N) {
            left -= step;
            continue;
        }
        const double s = step > 0.0 ? std::min(left / step, 1.0) : 0.0;
        return {a.along + s * (b.along - a.along), a.up + s * (b.up - a.up), a.side + s * (b.side - a.side)};
    }
    return corners[N - 1];
}

// Straight on to the middle, a figure that begins and ends there, and straight on.
template <class Figure>
Place around_middle(double t, double straight, const Figure& figure) {
    if (t < straight) return {0.5 * t / straight, 0.0};
    if (t > 1.0 - straight) return {1.0 - 0.5 * (1.0 - t) / straight, 0.0};
    const Place p = figure((t - straight) / (1.0 - 2.0 * straight));
    return {0.5 + p.along, p.up, p.side};
}

Offset bubbles(double u) {
    return repeated(u, 1201, 9, 0.16, [](double t, int turn) {
        const double size = 0.22 + 0.20 * (0.5 + 0.5 * Noise(1231)(1.7 * turn)), below = turn % 3 == 1 ? -1.0 : 1.0;
        return around_middle(t, 0.12, [&](double s) {
            const double a = kTau * s;
            return Place{size * std::sin(a), below * size * (1.0 - std::cos(a)), 0.3 * size * std::sin(0.5 * a)};
        });
    });
}

Offset clouds(double u) {
    return repeated(u, 1301, 12, 0.24, [](double t, int) {
        const double a = 0.5 * kTau * t;
        return Place{0.5 - 0.5 * std::cos(a), 0.85 * std::sin(a), 0.12 * std::sin(2.0 * a)};
    });
}

Offset fret(double u) {
    return repeated(u, 1401, 8, 0.08, [](double t, int) {
        constexpr std::array<Place, 7> kKey = {
            {{0.0, 0.0}, {0.02, 0.78}, {0.70, 0.80}, {0.71, 0.34}, {0.36, 0.33}, {0.37, 0.0}, {1.0, 0.0}}};
        return along_lines(kKey, t);
    });
}

Offset grass(double u) {
    return repeated(u, 1501, 22, 0.30, [](double t, int turn) {
        const Noise blade(1531);
        const double tip = 1.5 + 0.9 * blade(4.3 * turn), lean = 0.55 + 0.45 * blade(5.9 * turn + 8.0);
        const double rise = t < 0.25 ? 0.0 : (t > 0.85 ? 0.0 : 1.0 - std::abs(t - 0.55) / 0.30);
        return Place{t + lean * rise * rise, tip * std::sin(0.25 * kTau * rise), 0.5 * rise * blade(3.7 * turn + 40.0)};
    });
}

Offset hearts(double u) {
    return repeated(u, 1601, 7, 0.12, [](double t, int) {
        return around_middle(t, 0.16, [](double s) {
            const double a = 0.5 * kTau + kTau * s;
            const double x = std::pow(std::sin(a), 3.0);
            const double y = 13.0 * std::cos(a) - 5.0 * std::cos(2.0 * a) - 2.0 * std::cos(3.0 * a) - std::cos(4.0 * a);
            return Place{0.44 * x, 0.028 * (y + 17.0), 0.05 * std::sin(kTau * s)};
        });
    });
}

Offset heartbeat(double u) {
    return repeated(u, 1701, 7, 0.14, [](double t, int) {
        constexpr std::array<Place, 10> kBeat = {{{0.0, 0.0},
                                                  {0.20, 0.0},
                                                  {0.28, 0.14},
                                                  {0.36, 0.0},
                                                  {0.42, -0.12},
                                                  {0.49, 0.95},
                                                  {0.57, -0.34},
                                                  {0.63, 0.0},
                                                  {0.78, 0.20},
                                                  {1.0, 0.0}}};
        return along_lines(kBeat, t);
    });
}

Offset leaves(double u) {
    return repeated(u, 1801, 11, 0.16, [](double t, int turn) {
        const double side = turn % 2 == 0 ? 1.0 : -1.0;
        return around_middle(t, 0.16, [&](double s) {
            // Out along one edge, back along the other.
            const double out = 1.0 - std::abs(2.0 * s - 1.0), belly = 0.30 * std::sin(0.5 * kTau * out);
            const double edge = s < 0.5 ? belly : -belly;
            return Place{0.62 * out - 0.62 * edge, side * (1.05 * out + 0.55 * edge), 0.25 * side * out * out};
        });
    });
}

Offset ripples(double u) {
    const Hand hand(1901);
    const double burst = std::pow(std::sin(0.5 * kTau * (5.0 * u + 0.10 * hand.timing(5.0 * u))), 2.0);
    const double a = hand.angle(u, 34.0, 0.10), s = 0.060 * burst * hand.strength(u, 10.0, 0.30);
    return {0.06 * s * std::cos(a), s * std::sin(a), 0.0};
}

Offset rope(double u) {
    const Hand hand(2001);
    const double a = hand.angle(u, 6.0, 0.06), b = hand.angle(u, 48.0, 0.06);
    const double s = 0.042 * hand.strength(u, 6.0, 0.14), strand = 0.015 * hand.strength(u, 24.0, 0.20);
    const double out = s + strand * std::cos(b);
    return {strand * std::sin(b), out * std::sin(a), out * std::cos(a)};
}

Offset rosettes(double u) {
    return repeated(u, 2101, 5, 0.10, [](double t, int) {
        return around_middle(t, 0.09, [](double s) {
            // Five petals through the middle.
            const double a = 0.5 * kTau * s, r = 0.46 * std::sin(5.0 * a);
            return Place{r * std::cos(a + 0.3), r * std::sin(a + 0.3), 0.10 * std::sin(10.0 * a)};
        });
    });
}

Offset script(double u) {
    return repeated(u, 2201, 17, 0.22, [](double t, int turn) {
        // Letters, long and short, above and below the line.
        constexpr double kHeights[] = {0.62, 0.50, 1.45, 0.55, 0.60, -1.15, 0.52, 1.55, 1.35, 0.48, 0.58, 0.50};
        const double height = kHeights[static_cast<size_t>(turn) % std::size(kHeights)];
        const double a = kTau * t, up = 0.5 * height * (1.0 - std::cos(a));
        return Place{t + 0.27 * std::sin(a) + 0.32 * up, up, 0.10 * std::sin(0.5 * a)};
    });
}

Offset scrolls(double u) {
    return repeated(u, 2301, 7, 0.10, [](double t, int) {
        // A spiral in, and one out of its middle.
        const double s = 2.0 * t - 1.0, r = 0.5 * std::copysign(std::pow(std::abs(s), 0.75), s);
        const double a = kTau * 1.5 * (std::abs(s) - 1.0);
        return Place{0.5 + r * std::cos(a), r * std::sin(a), 0.08 * std::sin(kTau * t)};
    });
}

Offset stars(double u) {
    return repeated(u, 2401, 7, 0.12, [](double t, int) {
        constexpr std::array<Place, 8> kStar = {{{0.0, 0.0},
                                                 {0.22, 0.0},
                                                 {0.50, 0.86},
                                                 {0.78, 0.0},
                                                 {0.05, 0.54},
                                                 {0.95, 0.56},
                                                 {0.24, -0.02},
                                                 {1.0, 0.0}}};
        return along_lines(kStar, t);
    });
}

Offset thorns(double u) {
    return repeated(u, 2501, 13, 0.20, [](double t, int turn) {
        constexpr std::array<Place, 5> kThorn = {{{0.0, 0.0}, {0.42, 0.04}, {0.62, 0.74}, {0.66, 0.05}, {1.0, 0.0}}};
        Place p = along_lines(kThorn, t);
        if (turn % 2 == 1) p.up = -p.up;
        p.side = 0.4 * p.up * Noise(2531)(3.3 * turn);
        return p;
    });
}

constexpr Recipe kRecipes[] = {
    {"bubbles", bubbles, 520, 11, {0.20f, 0.50f, 0.65f, 1.0f}},
    {"clouds", clouds, 460, 12, {0.35f, 0.45f, 0.60f, 1.0f}},
    {"fret", fret, 560, 13, {0.55f, 0.30f, 0.12f, 1.0f}, true},
    {"grass", grass, 600, 14, {0.20f, 0.48f, 0.12f, 1.0f}},
    {"hearts", hearts, 560, 15, {0.80f, 0.12f, 0.25f, 1.0f}},
    {"heartbeat", heartbeat, 480, 16, {0.75f, 0.10f, 0.10f, 1.0f}, true},
    {"leaves", leaves, 600, 17, {0.25f, 0.50f, 0.18f, 1.0f}},
    {"ripples", ripples, 600, 18, {0.10f, 0.42f, 0.60f, 1.0f}, true},
    {"rope", rope, 600, 19, {0.55f, 0.42f, 0.22f, 1.0f}},
    {"rosettes", rosettes, 600, 20, {0.70f, 0.30f, 0.55f, 1.0f}},
    {"script", script, 580, 21, {0.10f, 0.12f, 0.30f, 1.0f}},
    {"scrolls", scrolls, 560, 22, {0.60f, 0.42f, 0.10f, 1.0f}},
    {"stars", stars, 520, 23, {0.85f, 0.62f, 0.10f, 1.0f}},
    {"thorns", thorns, 480, 24, {0.35f, 0.22f, 0.15f, 1.0f}},
};

}  // namespace

std::span<const Recipe> motif_recipes() {
    return kRecipes;
}

}  // namespace flg::scenes
