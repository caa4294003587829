// SPDX-License-Identifier: MIT
// Guides of scribbles whose middle line is known: bent lines with waves of all kinds on them.
#include <gtest/gtest.h>

#include "stylization/guide_flow.h"
#include "stylization/guide_quality.h"

namespace flg {
namespace {

using test::Curve;

constexpr double tau = 2.0 * std::numbers::pi;

struct Line {
    const char* name;
    Vec3 (*at)(double u);  // of about length 1
};

const Line lines[] = {
    {"straight", [](double u) { return Vec3(u, 0.0, 0.0); }},
    {"arch",
     [](double u) {
         const double a = 2.4 * (u - 0.5);
         return Vec3(std::sin(a) / 2.4, std::cos(a) / 2.4, 0.0);
     }},
    {"S", [](double u) { return Vec3(u, 0.05 * std::sin(tau * u), 0.0); }},
};

// Along the line, across it in its plane, and out of that.
struct Waves {
    const char* name;
    double count;
    Vec3 (*at)(double u);
    double lopsided = 0.0;  // how far off the line their mean is, in parts of the displacement
};

double triangle(double x) {
    return 4.0 * std::abs(x - std::floor(x + 0.5)) - 1.0;
}

const Waves waves[] = {
    {"zigzag", 12, [](double u) { return Vec3(0.0, 0.06 * triangle(12.0 * u), 0.0); }},
    {"tall zigzag", 14, [](double u) { return Vec3(0.0, 0.15 * triangle(14.0 * u), 0.0); }},
    {"loops", 10, [](double u) { return Vec3(0.05 * std::sin(tau * 10 * u), 0.05 * std::cos(tau * 10 * u), 0.0); },
     0.35},  // more of a loop lies where it goes forwards
    {"coil", 10, [](double u) { return Vec3(0.0, 0.05 * std::cos(tau * 10 * u), 0.05 * std::sin(tau * 10 * u)); }},
    {"sine", 8, [](double u) { return Vec3(0.0, 0.03 * std::sin(tau * 8 * u + 1.0), 0.0); }},
    // Hairs of uneven lengths.
    {"fur", 45,
     [](double u) {
         const double length = 0.03 * (1.0 + 0.4 * std::sin(37.0 * u) * std::sin(101.0 * u));
         return Vec3(0.0, length * triangle(45.0 * u), 0.0);
     }},
    {"growing", 14, [](double u) { return Vec3(0.0, (0.015 + 0.06 * u) * triangle(14.0 * u), 0.0); }},
    // Waves of a band of lengths.
    {"band", 12,
     [](double u) {
         Vec3 sum = Vec3::Zero();
         for (int k = 0; k < 9; ++k) {
             const double number = 10.0 + k;
             const double phase = tau * random_unit(5, static_cast<uint64_t>(k), 0);
             sum += Vec3(0.0, 0.013 * std::sin(tau * number * u + phase),
                         0.013 * std::cos(tau * number * u + 2.3 * phase));
         }
         return sum;
     }},
};

Vec3 place(const Line& line, const Waves& wave, double u) {
    const double h = 1e-5;
    const Vec3 tangent = (line.at(u + h) - line.at(u - h)).normalized();
    const Vec3 normal(-tangent.y(), tangent.x(), 0.0);
    const Vec3 offset = wave.at(u);
    return line.at(u) + offset.x() * tangent + offset.y() * normal + Vec3(0.0, 0.0, offset.z());
}

Curve scribble(const Line& line, const Waves& wave, int count) {
    return test::even_curve([&](double u) { return place(line, wave, u); }, count);
}

Curve guide_of(const Curve& style, double smoothing = 1.0) {
    GuideFlowParams params;
    params.smoothing = smoothing;
    const FlowedGuide guide =
        run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return guide_flow(pace, style, params); });
    return {guide.points.begin(), guide.points.end()};
}

double distance_to(const Vec3& point, const Curve& curve) {
    double least = 1e300;
    for (size_t i = 1; i < curve.size(); ++i) {
        const Vec3 edge = curve[i] - curve[i - 1];
        const double t = std::clamp(edge.dot(point - curve[i - 1]) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (curve[i - 1] + t * edge - point).norm());
    }
    return least;
}

// A line that goes on a little beyond both ends.
Curve dense(const Line& line) {
    Curve points;
    for (int i = -40; i <= 440; ++i) points.push_back(line.at(i / 400.0));
    return points;
}

// Of points [first, last) in parts of 100: root mean square distance to the curve.
double off(const Curve& guide, const Curve& line, size_t first, size_t last) {
    double sum = 0.0, count = 0.0;
    for (size_t i = guide.size() * first / 100; i < guide.size() * last / 100; ++i) {
        const double distance = distance_to(guide[i], line);
        sum += distance * distance;
        count += 1.0;
    }
    return std::sqrt(sum / count);
}

TEST(GuideQuality, GuidesLieOnTheMiddleLine) {
    for (const Line& line : lines) {
        const Curve middle = dense(line);
        for (const Waves& wave : waves) {
            const Curve style = scribble(line, wave, 900);
            const Curve guide = guide_of(style);
            const test::GuideQuality quality = test::guide_quality(style, guide, wave.count);
            const std::string name = std::string(wave.name) + " on " + line.name;
            EXPECT_LT(off(guide, middle, 15, 85), (0.18 + wave.lopsided) * quality.displacement) << name;
            EXPECT_LT(off(guide, middle, 0, 100), (0.25 + wave.lopsided) * quality.displacement) << name;
            EXPECT_LT(quality.waves, 0.03) << name;
            EXPECT_LT(quality.offset, 0.2) << name;
            const double length = test::polyline_length(guide);
            EXPECT_GT(length, 0.85) << name;
            EXPECT_LT(length, 1.15) << name;
        }
    }
}

TEST(GuideQuality, SamplingAndDirectionDoNotMatter) {
    for (const Waves& wave : waves) {
        const Curve style = scribble(lines[1], wave, 900);
        const Curve guide = guide_of(style);
        const double part = test::guide_quality(style, guide, wave.count).displacement;
        EXPECT_LT(off(guide_of(scribble(lines[1], wave, 1400)), guide, 2, 98), 0.05 * part) << wave.name;
        EXPECT_LT(off(guide_of({style.rbegin(), style.rend()}), guide, 2, 98), 0.05 * part) << wave.name;
    }
}

// A pen is put down beside the line, and leaves it at the end.
TEST(GuideQuality, HooksAtTheEndsDoNotBendTheGuide) {
    for (const Waves& wave : waves) {
        const Curve middle = dense(lines[0]);
        const double size =
            test::guide_quality(scribble(lines[0], wave, 900), guide_of(scribble(lines[0], wave, 900)), wave.count)
                .displacement;
        const Curve style = test::even_curve(
            [&](double u) {
                const double from_end = std::min(u, 1.0 - u), hook = std::clamp(1.0 - from_end / 0.03, 0.0, 1.0);
                const double v = std::clamp((u - 0.03) / 0.94, 0.0, 1.0);
                return Vec3(place(lines[0], wave, v) + Vec3(0.0, 2.0 * hook * size, hook * size));
            },
            900);
        const Curve guide = guide_of(style);
        EXPECT_LT(off(guide, middle, 15, 85), (0.15 + wave.lopsided) * size) << wave.name;
        EXPECT_LT(off(guide, middle, 0, 100), (0.5 + wave.lopsided) * size) << wave.name;
    }
}

TEST(GuideQuality, LittleSmoothingLeavesTheWaves) {
    for (const Waves& wave : waves) {
        const Curve style = scribble(lines[1], wave, 900);
        const Curve guide = guide_of(style, 1e-5);
        const double part = test::guide_quality(style, guide_of(style), wave.count).displacement;
        EXPECT_LT(off(style, guide, 2, 98), 0.1 * part) << wave.name;
    }
}

}  // namespace
}  // namespace flg
