// SPDX-License-Identifier: MIT
// Least curves of R^n in closed form: against the conditions that a textbook gives them, and against energies of
// others.
#include "splines/optimizer/natural_cubic.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "runtime/run_now.h"
#include "splines/nan_memory.h"

namespace flg::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Case {
    std::vector<double> knots, values, slopes;
    CubicEnds ends = CubicEnds::natural;
    double tension = 0;
    size_t dimension = 3;
};

Case random_case(size_t count, CubicEnds ends, double tension) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<double> gap(0.2, 1.5);
    std::normal_distribution<double> place;
    Case made;
    made.ends = ends;
    made.tension = tension;
    double at = -1;
    for (size_t i = 0; i < count + (ends == CubicEnds::periodic); ++i) made.knots.push_back(at += gap(random));
    for (size_t i = 0; i < 3 * count; ++i) made.values.push_back(place(random));
    for (size_t i = 0; i < 6 && ends == CubicEnds::clamped; ++i) made.slopes.push_back(place(random));
    return made;
}

NaturalCubic spline_of(const Case& c, bool haltingly = false) {
    const double* const slopes = c.slopes.empty() ? nullptr : c.slopes.data();
    const CubicData data{c.knots, c.values, c.dimension, c.ends, slopes, c.tension};
    return run_now(
        nan_memory(), [&](Pace& pace) { return natural_cubic(pace, data); }, haltingly);
}

double at(const NaturalCubic& spline, double time, int derivative, size_t component = 0) {
    std::array<double, 3> out{};
    spline.evaluate(time, derivative, out.data());
    return out[component];
}

// Every kind, tensions from none to where pieces are nearly straight, and few knots.
std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const CubicEnds ends : {CubicEnds::natural, CubicEnds::clamped, CubicEnds::periodic}) {
        for (const double tension : {0.0, 1e-18, 1e-3, 0.7, 30.0, 1e4}) {
            for (const size_t count : {2, 3, 4, 9}) all.push_back(random_case(count, ends, tension));
        }
    }
    return all;
}

TEST(NaturalCubic, PassesThroughItsPointsTwiceSmooth) {
    for (const Case& c : all_cases()) {
        const NaturalCubic spline = spline_of(c);
        const bool cycle = c.ends == CubicEnds::periodic;
        const double scale = 1 + c.tension, tiny = 1e-12;
        for (size_t i = 0; i < c.knots.size(); ++i) {
            const size_t value = cycle && i + 1 == c.knots.size() ? 0 : i;
            for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(at(spline, c.knots[i], 0, k), c.values[3 * value + k], 1e-12);
            if (!cycle && (i == 0 || i + 1 == c.knots.size())) continue;
            for (int d = 1; d <= 2; ++d) {
                EXPECT_NEAR(at(spline, c.knots[i] - tiny, d), at(spline, c.knots[i] + tiny, d), 1e-8 * scale)
                    << "derivative " << d << " at knot " << i << " of " << c.knots.size() << ", w " << c.tension;
            }
        }
    }
}

TEST(NaturalCubic, Ends) {
    for (const Case& c : all_cases()) {
        const NaturalCubic spline = spline_of(c);
        for (size_t k = 0; k < 3; ++k) {
            if (c.ends == CubicEnds::natural) {
                EXPECT_NEAR(at(spline, c.knots.front(), 2, k), 0, 1e-13);
                EXPECT_NEAR(at(spline, c.knots.back(), 2, k), 0, 1e-13);
            } else if (c.ends == CubicEnds::clamped) {
                EXPECT_NEAR(at(spline, c.knots.front(), 1, k), c.slopes[k], 1e-11);
                EXPECT_NEAR(at(spline, c.knots.back(), 1, k), c.slopes[3 + k], 1e-11);
            } else {
                const double period = c.knots.back() - c.knots.front();
                EXPECT_NEAR(at(spline, c.knots[1] + 0.1 + 2 * period, 0, k), at(spline, c.knots[1] + 0.1, 0, k), 1e-12);
            }
        }
    }
}

// x'''' = w x'' between knots: the third derivative changes by w times the slope; and each derivative is that of the
// one before.
TEST(NaturalCubic, FourthDerivativeIsTensionTimesTheSecond) {
    for (const Case& c : all_cases()) {
        const NaturalCubic spline = spline_of(c);
        for (size_t i = 0; i + 1 < c.knots.size(); ++i) {
            const double h = c.knots[i + 1] - c.knots[i], a = c.knots[i] + 0.3 * h, b = c.knots[i] + 0.6 * h;
            const double jump = at(spline, b, 3) - at(spline, a, 3);
            const double slope = at(spline, b, 1) - at(spline, a, 1);
            EXPECT_NEAR(jump, c.tension * slope, 1e-9 * (1 + c.tension + std::abs(at(spline, a, 3)))) << c.tension;
            for (int d = 0; d < 3; ++d) {
                const double e = 1e-5 * h / (1 + std::sqrt(c.tension) * h);
                const double difference = (at(spline, a + e, d) - at(spline, a - e, d)) / (2 * e);
                const double exact = at(spline, a, d + 1);
                EXPECT_NEAR(difference, exact,
                            1e-5 * (1 + std::abs(exact) + (1 + c.tension) * std::abs(at(spline, a, d))));
            }
        }
    }
}

TEST(NaturalCubic, ACubicIsItsOwnClampedSpline) {
    const auto cubic = [](double t) { return 1 - 2 * t + 0.5 * t * t - 0.25 * t * t * t; };
    const auto slope = [](double t) { return -2 + t - 0.75 * t * t; };
    Case c;
    c.dimension = 1;
    c.ends = CubicEnds::clamped;
    c.knots = {-1, 0.5, 0.75, 2};
    for (const double t : c.knots) c.values.push_back(cubic(t));
    c.slopes = {slope(-1), slope(2)};
    const NaturalCubic spline = spline_of(c);
    for (double t = -1; t <= 2; t += 0.125) EXPECT_NEAR(at(spline, t, 0), cubic(t), 1e-14);
}

// The textbook's example: 0, 1, 0 at -1, 0, 1 has the moment -3 in the middle, and E2 = 2/3 * 9.
TEST(NaturalCubic, ThreePointsInClosedForm) {
    Case c;
    c.dimension = 1;
    c.knots = {-1, 0, 1};
    c.values = {0, 1, 0};
    const NaturalCubic spline = spline_of(c);
    EXPECT_NEAR(at(spline, 0, 2), -3, 1e-14);
    EXPECT_NEAR(at(spline, 0.5, 0), 1 - 1.5 * 0.25 + 0.5 * 0.125, 1e-14);
    EXPECT_NEAR(spline.energy(), 6, 1e-13);
}

// A sine with 16 knots a period is met to the fourth power of the step: some 1e-4.
TEST(NaturalCubic, APeriodicSplineOfACircleTurnsWithIt) {
    Case c;
    c.dimension = 2;
    c.ends = CubicEnds::periodic;
    constexpr size_t count = 16;
    constexpr double step = 2 * std::numbers::pi / count;
    for (size_t i = 0; i <= count; ++i) c.knots.push_back(step * i);
    for (size_t i = 0; i < count; ++i) c.values.insert(c.values.end(), {std::cos(step * i), std::sin(step * i)});
    const NaturalCubic spline = spline_of(c);
    for (size_t i = 0; i < count; ++i) {
        const double t = step * (i + 0.37);
        const double radius = std::hypot(at(spline, t, 0, 0), at(spline, t, 0, 1));
        EXPECT_NEAR(radius, std::hypot(at(spline, 0.37 * step, 0, 0), at(spline, 0.37 * step, 0, 1)), 1e-13);
        EXPECT_NEAR(radius, 1, 1e-4);
    }
}

double integral(const NaturalCubic& spline, const Case& c) {
    constexpr int parts = 4000;
    double sum = 0;
    for (size_t i = 0; i + 1 < c.knots.size(); ++i) {
        const double h = (c.knots[i + 1] - c.knots[i]) / parts;
        for (int j = 0; j < parts; ++j) {
            for (size_t k = 0; k < 3; ++k) {
                const double t = c.knots[i] + (j + 0.5) * h;
                const double bend = std::isinf(c.tension) ? 0 : at(spline, t, 2, k), speed = at(spline, t, 1, k);
                sum += h * (bend * bend + (std::isinf(c.tension) ? 1 : c.tension) * speed * speed);
            }
        }
    }
    return sum;
}

TEST(NaturalCubic, EnergyIsTheIntegral) {
    for (const CubicEnds ends : {CubicEnds::natural, CubicEnds::clamped, CubicEnds::periodic}) {
        for (const double tension : {0.0, 2.0, 50.0, infinite}) {
            if (ends == CubicEnds::clamped && std::isinf(tension)) continue;
            const Case c = random_case(5, ends, tension);
            const NaturalCubic spline = spline_of(c);
            const double energy = spline.energy();
            EXPECT_NEAR(energy, integral(spline, c), 1e-5 * energy) << tension;
        }
    }
}

// Another curve through the same points: the spline with one knot more, off the first one's way there.
TEST(NaturalCubic, OtherCurvesHaveMoreEnergy) {
    for (const double tension : {0.0, 0.5, 20.0}) {
        const Case c = random_case(6, CubicEnds::natural, tension);
        const NaturalCubic spline = spline_of(c);
        const double middle = 0.5 * (c.knots[2] + c.knots[3]);
        double before = 0;
        for (const double off : {-1e-2, 0.0, 1e-2}) {
            Case bent = c;
            std::array<double, 3> x{};
            spline.evaluate(middle, 0, x.data());
            x[1] += off;
            bent.knots.insert(bent.knots.begin() + 3, middle);
            bent.values.insert(bent.values.begin() + 9, x.begin(), x.end());
            const double rise = spline_of(bent).energy() - spline.energy();
            if (off == 0) {
                EXPECT_NEAR(rise, 0, 1e-11 * spline.energy());
            } else {
                EXPECT_GT(rise, 1e-5);
            }
            // Without a linear term.
            if (off > 0) {
                EXPECT_NEAR(rise, before, 1e-8);
            }
            before = off < 0 ? rise : before;
        }
    }
}

TEST(NaturalCubic, TensionGoesFromTheCubicToThePolyline) {
    const Case cubic = random_case(7, CubicEnds::natural, 0), straight = random_case(7, CubicEnds::natural, infinite);
    const NaturalCubic first = spline_of(cubic), last = spline_of(straight);
    // Just below and above where series take over.
    Case low = cubic, high = cubic;
    low.tension = 0.999, high.tension = 1.001;
    const NaturalCubic below = spline_of(low), above = spline_of(high);
    Case loose = cubic, tight = cubic;
    loose.tension = 1e-10, tight.tension = 1e10;
    const NaturalCubic looser = spline_of(loose), tighter = spline_of(tight);
    for (double t = cubic.knots.front(); t <= cubic.knots.back(); t += 0.01) {
        EXPECT_NEAR(at(below, t, 0), at(above, t, 0), 1e-3);
        EXPECT_NEAR(at(looser, t, 0), at(first, t, 0), 1e-9);
        EXPECT_NEAR(at(tighter, t, 0), at(last, t, 0), 1e-4);
    }
}

TEST(NaturalCubic, SameBitsWhateverTheSlices) {
    for (const Case& c : all_cases()) {
        const NaturalCubic whole = spline_of(c), cut = spline_of(c, true);
        for (double t = c.knots.front(); t < c.knots.back(); t += 0.1) EXPECT_EQ(at(whole, t, 0), at(cut, t, 0));
    }
}

}  // namespace
}  // namespace flg::test
