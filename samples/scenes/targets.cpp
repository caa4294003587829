// SPDX-License-Identifier: MIT
// The targets: short strokes by formula, attractors by integration, and the bouquet.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "attractors.h"
#include "noise.h"
#include "vector.h"

namespace flg::scenes {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

Point point(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Point s_curve(double u) {
    const double a = kTau * (u - 0.5);
    return point(0.45 * std::sin(a), 1.1 * (u - 0.5), 0.16 * std::sin(0.5 * a) * std::cos(a));
}

Point spiral(double u) {
    const double a = kTau * 4.0 * u, r = 0.06 + 0.60 * u;
    return point(r * std::cos(a), 0.9 * (1.0 - u) - 0.45, r * std::sin(a));
}

// A signature: two tall loops, a run of small ones, and an underline that swings back.
Point flourish(double u) {
    const Noise hand(77);
    const double write = smooth_step(u / 0.72), back = smooth_step((u - 0.66) / 0.34);
    const double a = kTau * 5.5 * std::min(u / 0.72, 1.0);
    const double tall =
        0.10 + 0.26 * std::exp(-std::pow((u - 0.13) / 0.10, 2.0)) + 0.12 * std::exp(-std::pow((u - 0.47) / 0.05, 2.0));
    const double fade = 1.0 - smooth_step((u - 0.62) / 0.12);
    const double x = -0.75 + 1.45 * write - 1.75 * back + 0.11 * fade * std::sin(a);
    const double y = fade * tall * (1.0 - std::cos(a)) * 0.8 - 0.30 * std::sin(0.5 * kTau * back) + 0.05 * back +
                     0.03 * hand(4.0 * u);
    return point(x, y, 0.10 * std::sin(a * 0.5) * fade + 0.12 * hand(3.0 * u + 9.0));
}

Point ring(double u) {
    const double a = kTau * u;
    return point(0.6 * std::cos(a), 0.12 * std::sin(3.0 * a), 0.6 * std::sin(a));
}

// A trefoil knot, as a wreath hung on a wall.
Point vine(double u) {
    const double a = kTau * u, r = 0.46 + 0.19 * std::cos(3.0 * a);
    return point(r * std::cos(2.0 * a), r * std::sin(2.0 * a), 0.19 * std::sin(3.0 * a));
}

// A track in the shape of an eight, over three hills; where it crosses itself one way is 0.7 m above the other.
Point coaster(double u) {
    const double a = kTau * u;
    return point(1.25 * std::sin(a), 0.42 + 0.25 * std::cos(a) + 0.13 * std::cos(3.0 * a) - 0.05 * std::sin(5.0 * a),
                 0.62 * std::sin(2.0 * a));
}

// Normals of a closed track that lean into its turns: up, and a share of the curvature.
void bank(Curve& track) {
    constexpr double kLean = 0.75;    // metres: the radius of a turn that is banked by 45 degrees
    constexpr double kMaxLean = 1.2;  // tangent of the bank
    constexpr size_t kReach = 6;      // points; evens the bank out
    const size_t count = track.points.size(), reach = std::clamp<size_t>(count / 4, 1, kReach);
    const auto at = [&](size_t i) { return to_vector(track.points[i % count]); };
    for (size_t i = 0; i < count; ++i) {
        const Vector before = at(i + count - reach), here = at(i), after = at(i + reach);
        const double half = std::max(0.5 * length(after - before), 1e-6);
        const Vector curvature = (1.0 / (half * half)) * (after + before - 2.0 * here);
        const double sideways = kLean * std::hypot(curvature.x, curvature.z);
        const double held = kLean * std::min(1.0, kMaxLean / std::max(sideways, 1e-12));
        const Vector lean = {held * curvature.x, 1.0, held * curvature.z};
        const Vector tangent = at(i + 1) - at(i + count - 1);
        const Vector normal = lean - dot(lean, tangent) / std::max(dot(tangent, tangent), 1e-12) * tangent;
        track.normals.push_back(to_point(unit(normal)));
    }
}

struct Shape {
    const char* name;
    Point (*at)(double u);  // null: an attractor
    const Attractor& (*attractor)();
    uint32_t usual_count;
    bool closed;
    std::array<float, 4> color;
};

constexpr Shape kShapes[] = {
    {"s_curve", s_curve, nullptr, 200, false, {0.80f, 0.25f, 0.12f, 1.0f}},
    {"spiral", spiral, nullptr, 600, false, {0.12f, 0.40f, 0.70f, 1.0f}},
    {"flourish", flourish, nullptr, 500, false, {0.10f, 0.12f, 0.30f, 1.0f}},
    {"ring", ring, nullptr, 300, true, {0.75f, 0.55f, 0.10f, 1.0f}},
    {"vine", vine, nullptr, 600, true, {0.16f, 0.30f, 0.07f, 1.0f}},
    {"coaster", coaster, nullptr, 800, true, {0.70f, 0.10f, 0.08f, 1.0f}},
    {"lorenz", nullptr, lorenz, 10000, false, {0.85f, 0.35f, 0.10f, 1.0f}},
    {"thomas", nullptr, thomas, 369400, false, {0.15f, 0.55f, 0.60f, 1.0f}},
};

constexpr uint32_t kMinCount = 2, kMaxCount = 100'000'000;

// One stem: rises, leans outwards, and rolls up into a volute at its end.
Curve stem(uint32_t index) {
    constexpr uint32_t kPoints = 90;
    constexpr double kGoldenAngle = 2.399963229728653;
    const Noise hand(1000 + index);
    const double heading = kGoldenAngle * index + 0.25 * hand(0.5);
    const double height = 0.75 + 0.35 * hand(7.5), lean = 0.22 + 0.20 * std::sqrt(index / 15.0) + 0.05 * hand(3.5);
    const double roll = 0.095 + 0.03 * hand(5.5), turns = 1.3 + 0.3 * hand(9.5);
    Curve curve;
    // The stem bends in its own upright plane: a turtle whose curvature grows towards the end.
    double along = 0.02 + 0.03 * hand(11.5), up = 0.0, pitch = 0.5 * std::numbers::pi - 0.6 * lean;
    const double stem_step = height / (0.62 * kPoints);
    for (uint32_t i = 0; i < kPoints; ++i) {
        const double u = static_cast<double>(i) / (kPoints - 1);
        const double sway = 0.03 * u * hand(2.5 * u + 20.0);
        curve.points.push_back(point(along * std::cos(heading) - sway * std::sin(heading), up - 0.55,
                                     along * std::sin(heading) + sway * std::cos(heading)));
        curve.radii.push_back(static_cast<float>(0.016 * (1.0 - 0.7 * u) + 0.002));
        const double volute = smooth_step((u - 0.55) / 0.25);
        const double radius = roll * (1.3 - u);
        const double step = stem_step * (1.0 - volute) + volute * kTau * turns * roll * 0.6 / (0.38 * kPoints);
        pitch -= (1.0 - volute) * lean * 2.2 / kPoints + volute * step / radius;
        along += step * std::cos(pitch);
        up += step * std::sin(pitch);
    }
    constexpr Color kInks[] = {{0.62f, 0.035f, 0.020f, 1.0f},
                               {0.015f, 0.200f, 0.170f, 1.0f},
                               {0.85f, 0.300f, 0.020f, 1.0f},
                               {0.030f, 0.100f, 0.330f, 1.0f}};
    curve.color = kInks[index % std::size(kInks)];
    return curve;
}

}  // namespace

const std::vector<std::string>& target_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Shape& shape : kShapes) list.emplace_back(shape.name);
        return list;
    }();
    return names;
}

Curve make_target(std::string_view name, uint32_t count) {
    Curve curve;
    for (const Shape& shape : kShapes) {
        if (name != shape.name) continue;
        const uint32_t points = count == 0 ? shape.usual_count : std::min(std::max(count, kMinCount), kMaxCount);
        curve.color = shape.color;
        curve.closed = shape.closed;
        if (shape.at == nullptr) {
            curve.points = follow(shape.attractor(), points);
            continue;
        }
        curve.points.reserve(points);
        // A closed curve does not repeat its first point.
        const double steps = shape.closed ? points : points - 1.0;
        for (uint32_t i = 0; i < points; ++i) curve.points.push_back(shape.at(i / steps));
        if (shape.at == coaster) bank(curve);
    }
    return curve;
}

std::vector<Curve> make_bouquet() {
    constexpr uint32_t kStems = 15;
    std::vector<Curve> curves;
    for (uint32_t i = 0; i < kStems; ++i) curves.push_back(stem(i));
    return curves;
}

}  // namespace flg::scenes
