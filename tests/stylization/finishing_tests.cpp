// SPDX-License-Identifier: MIT
#include "stylization/finishing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "core/moving_frame.h"
#include "reference/literal_synthesis.h"
#include "stylization/synthesis_inputs.h"

namespace flg {
namespace {

using test::Points;
using test::points_of;
using test::stylize;
using test::StylizedCurve;
using test::StylizeOptions;
using test::TestStyle;

constexpr uint32_t steps = 700;

Points ring() {
    return test::sampled(
        [](double u) {
            const double a = test::two_pi * u;
            const double r = 2 + std::cos(3 * a);
            return Vec3(r * std::cos(2 * a), r * std::sin(2 * a), std::sin(3 * a));
        },
        400, true);
}

// What a walk copies, in its targets' frames.
std::vector<Vec3> copied_by(const TestStyle& style, const std::vector<float>& indices) {
    return literal::copied_displacement(style.vectors, {indices.begin(), indices.end()}, 10);
}

Vec3 in_frame(const Vec3& d, const test::Resampled& frames, size_t i) {
    return d.x() * frames.tangent(i) + d.y() * frames.normal(i) + d.z() * frames.tangent(i).cross(frames.normal(i));
}

TEST(Finishing, PinnedResultsBeginAndEndWhereTheirTargetsDo) {
    const TestStyle style(test::wiggles(300));
    const Points target = test::sampled(test::wild, 200);
    const SamplingPlan plan = test::plan_of(target, steps);
    const test::Resampled plain = test::resample(plan);
    for (double magnitude : {0.0, 1.0, -3.0, 1e4}) {
        const StylizeOptions options{.magnitude = magnitude, .from_start = false, .pin_ends = true};
        const StylizedCurve r = stylize(style, 0.3, plan, options);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(r.curve.positions[k], target.floats[k]);
            EXPECT_EQ(r.curve.positions[3 * steps + k], target.floats[target.floats.size() - 3 + k]);
            EXPECT_EQ(r.displacements[k], 0.0f);
            EXPECT_EQ(r.displacements[3 * steps + k], 0.0f);
        }
    }
    // The paper's formula, with the target's arc length.
    const StylizedCurve r = stylize(style, 0.3, plan, {.magnitude = 0.7, .pin_ends = true});
    const std::vector<Vec3> copied = copied_by(style, r.indices);
    const auto d = [&](size_t i) { return in_frame(copied[i], plain, i); };
    for (size_t i = 0; i <= steps; ++i) {
        const double u = static_cast<double>(i) / steps;
        const Vec3 expected = d(i) - (1 - u) * d(0) - u * d(steps);
        ASSERT_LT((r.displacement(i) - expected).norm(), 1e-5) << i;
        ASSERT_LT((r.curve.position(i) - plain.position(i) - 0.7 * expected).norm(), 1e-5) << i;
    }
}

// The last seam of a closed curve, cross-faded over six patches and, where these are more samples than are left, over
// the curve's first ones.
struct LastSeam {
    static constexpr size_t points = 60;
    size_t at = 0;     // the sample that the last run begins with
    size_t faded = 0;  // samples

    explicit LastSeam(const std::vector<float>& indices) : faded(std::min(points, indices.size())) {
        for (size_t i = 1; i < indices.size(); ++i) {
            if (indices[i] != indices[i - 1] + 1) at = i;
        }
    }
    double weight(size_t k) const {
        const double r = 1 - std::min(1.0, static_cast<double>(k) / static_cast<double>(faded));
        return r * r * (3 - 2 * r);
    }
};

// In its targets' frames.
std::vector<Vec3> closed_displacement(const TestStyle& style, const std::vector<float>& indices) {
    const LastSeam seam(indices);
    std::vector<float> up_to_seam(indices.begin(), indices.begin() + static_cast<ptrdiff_t>(seam.at));
    const auto left = static_cast<size_t>(up_to_seam.back()) + 1, taken = static_cast<size_t>(indices[seam.at]);
    up_to_seam.push_back(static_cast<float>(left));
    std::vector<Vec3> result = copied_by(style, up_to_seam);
    const Vec3 carried = result.back() - style.vectors[left];
    result.pop_back();
    for (size_t i = seam.at; i < indices.size(); ++i) result.push_back(style.vectors[static_cast<size_t>(indices[i])]);
    const size_t last = style.vectors.size() - 1;
    for (size_t k = 0; k < seam.faded; ++k) {
        const Vec3 gap = style.vectors[std::min(left + k, last)] - style.vectors[std::min(taken + k, last)];
        result[(seam.at + k) % indices.size()] += seam.weight(k) * (carried + gap);
    }
    return result;
}

TEST(Finishing, ClosedResultsComeBackToWhereTheyBegan) {
    const TestStyle style(test::wiggles(300));
    const Points target = ring();
    size_t over_the_start = 0;
    for (const uint32_t samples : {50u, 90u, 290u, steps}) {
        const SamplingPlan plan = test::plan_of(target, samples);
        const test::Resampled plain = test::resample(plan);
        for (uint64_t seed = 1; seed <= 20; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(samples) + " samples");
            const StylizeOptions options{.magnitude = 0.7, .from_start = seed == 1, .seed = seed};
            const StylizedCurve r = stylize(style, 0, plan, options);
            ASSERT_EQ(r.size(), samples);
            EXPECT_EQ(r.indices[samples - 1] + 1, r.indices[0]);
            if (seed == 1) {
                EXPECT_EQ(r.indices[0], 64);
            }
            const std::vector<Vec3> expected = closed_displacement(style, r.indices);
            for (size_t i = 0; i < samples; ++i) {
                const Vec3 d = in_frame(expected[i], plain, i);
                ASSERT_LT((r.displacement(i) - d).norm(), 1e-5) << i;
                ASSERT_LT((r.curve.position(i) - plain.position(i) - 0.7 * d).norm(), 1e-5) << i;
            }
            const LastSeam seam(r.indices);
            over_the_start += seam.at + seam.faded > samples;
        }
    }
    EXPECT_GT(over_the_start, 20u);
    const SamplingPlan plan = test::plan_of(target, steps);
    const test::Resampled plain = test::resample(plan);
    // Magnitude 0 is the resampled target.
    EXPECT_EQ(stylize(style, 0.3, plan, {.magnitude = 0}).curve.positions, plain.positions);
    // Pinned, it passes through its target's first point, and all of it is moved alike, and little.
    double rms = 0;
    for (const Vec3& d : style.vectors) rms += d.squaredNorm() / static_cast<double>(style.vectors.size());
    rms = std::sqrt(rms);
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const StylizedCurve pinned =
            stylize(style, 0, plan, {.magnitude = 2, .from_start = seed == 1, .seed = seed, .pin_ends = true});
        EXPECT_EQ(pinned.curve.position(0), plain.position(0));
        const std::vector<Vec3> expected = closed_displacement(style, pinned.indices);
        EXPECT_LT(expected[0].norm(), 0.7 * rms) << seed;
        for (size_t i = 0; i < steps; ++i) {
            const Vec3 moved = in_frame(expected[i], plain, i) - in_frame(expected[0], plain, 0);
            ASSERT_LT((pinned.displacement(i) - moved).norm(), 1e-5) << i;
        }
    }
}

TEST(Finishing, PositionsFollowFromDisplacementAtAnyMagnitude) {
    const TestStyle style(test::wiggles(300));
    for (const Points& target : {test::sampled(test::wild, 200), ring()}) {
        for (bool pin_ends : {false, true}) {
            const SamplingPlan plan = test::plan_of(target, steps);
            StylizeOptions options{.magnitude = 0.5, .scale = 0.8, .pin_ends = pin_ends};
            const StylizedCurve half = stylize(style, 0.3, plan, options);
            options.magnitude = -2;
            const StylizedCurve other = stylize(style, 0.3, plan, options);
            EXPECT_EQ(half.displacements, other.displacements);
            for (size_t i = 0; i < half.size(); ++i) {
                const Vec3 expected = half.curve.position(i) + (-2 - 0.5) * half.displacement(i);
                ASSERT_LT((other.curve.position(i) - expected).norm(), 2e-6) << i;
            }
        }
    }
}

// A style whose ribbon turns by `turn_rad` a point.
TestStyle turning(double turn_rad, FlgMetric metric) {
    TestStyle style(test::wiggles(300));
    std::vector<float> angles;
    for (int i = 0; i < 300; ++i) angles.push_back(static_cast<float>(turn_rad * i));
    style.add(FLG_ATTRIBUTE_ANGLE, 1, angles, metric);
    return style;
}

TEST(Finishing, AnglesTurnTheNormals) {
    const TestStyle style = turning(0.05, FLG_METRIC_CIRCLE);
    const Points target = test::sampled(test::wild, 200);
    const SamplingPlan plan = test::plan_of(target, 250);
    const test::Resampled plain = test::resample(plan);
    const StylizedCurve r = stylize(style, 0, plan);
    for (size_t i = 0; i <= 250; ++i) {
        const double angle = 0.05 * r.indices[i];
        EXPECT_NEAR(r.attributes[0][i], angle, 1e-6);
        EXPECT_LT((r.curve.normal(i) - turned_about(plain.tangent(i), plain.normal(i), angle)).norm(), 1e-5);
    }
}

TEST(Finishing, AClosedRibbonsTwistGoesOnOverItsStart) {
    for (FlgMetric metric : {FLG_METRIC_CIRCLE, FLG_METRIC_PROJECTIVE}) {
        const TestStyle style = turning(0.023, metric);
        const Points target = ring();
        const SamplingPlan plan = test::plan_of(target, 290);
        const test::Resampled plain = test::resample(plan);
        const double period = metric == FLG_METRIC_PROJECTIVE ? std::numbers::pi : 2 * std::numbers::pi;
        for (uint64_t seed = 1; seed <= 20; ++seed) {
            const StylizedCurve r = stylize(style, 0, plan, {.magnitude = 0, .from_start = seed == 1, .seed = seed});
            // A cubic that lets go of a gap of up to half a period, and of one in step, by no more than this a point.
            const double most = 0.023 + 1.5 * period / 2 / LastSeam::points + 1e-3;
            for (size_t i = 0; i < 290; ++i) {
                const size_t next = (i + 1) % 290;
                const bool blended = r.indices[next] != r.indices[i] + 1;
                const double step = std::remainder(r.attributes[0][next] - r.attributes[0][i], period);
                // At the seams of longer curves patches are as wide as they are.
                ASSERT_LT(std::abs(step), blended ? period / 2 : period / 8) << i;
                const Vec3 expected = turned_about(plain.tangent(i), plain.normal(i), r.attributes[0][i]);
                ASSERT_LT((r.curve.normal(i) - expected).norm(), 1e-4) << i;
            }
            EXPECT_LT(std::abs(std::remainder(r.attributes[0][0] - r.attributes[0][289], period)), most) << seed;
        }
    }
}

TEST(Finishing, EllipsesCloseByTheirMetrics) {
    TestStyle style(test::wiggles(300));
    const auto axis = [](double i) { return 4 + std::sin(0.1 * i) + 0.01 * i; };
    std::vector<float> radii;
    for (int i = 0; i < 300; ++i) {
        radii.insert(radii.end(), {static_cast<float>(axis(i)), 2.0f, 0.02f * static_cast<float>(i)});
    }
    style.add(FLG_ATTRIBUTE_RADII, 3, radii);
    const Points target = ring();
    const ValueRange range = style.prepared.attributes[0].ranges[0];
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const StylizedCurve r = stylize(style, 0, test::plan_of(target, 290), {.scale = 0.5, .seed = seed});
        for (size_t i = 0; i < 290; ++i) {
            const size_t next = (i + 1) % 290;
            EXPECT_EQ(r.attributes[0][3 * i + 1], 1.0f);
            EXPECT_GE(r.attributes[0][3 * i], 0.5f * range.low);
            EXPECT_LE(r.attributes[0][3 * i], 0.5f * range.high);
            // From the smallest to the largest at most, of which a patch's blend lets go.
            EXPECT_LT(std::abs(r.attributes[0][3 * next] - r.attributes[0][3 * i]), 0.3 * (range.high - range.low))
                << i;
        }
        // Where the curve meets itself nothing jumps.
        EXPECT_LT(std::abs(r.attributes[0][0] - r.attributes[0][3 * 289]), 0.15);
        EXPECT_LT(std::abs(std::remainder(r.attributes[0][2] - r.attributes[0][3 * 289 + 2], test::two_pi)), 0.11);
    }
}

TEST(Finishing, SpeedsGiveTimes) {
    TestStyle style(test::wiggles(300));
    std::vector<float> speeds;
    for (int i = 0; i < 300; ++i) speeds.push_back(1.0f + 0.01f * static_cast<float>(i % 50));
    style.add(FLG_ATTRIBUTE_SPEED, 1, speeds);
    const Points target = test::sampled(test::wild, 200);
    for (bool pin_ends : {false, true}) {
        const StylizedCurve r =
            stylize(style, 0.1, test::plan_of(target, 250), {.pin_ends = pin_ends, .start_time = 4});
        EXPECT_EQ(r.times[0], 4.0f);
        for (size_t i = 1; i <= 250; ++i) {
            const double distance = (r.curve.position(i) - r.curve.position(i - 1)).norm();
            const double speed = 0.5 * (r.attributes[0][i] + r.attributes[0][i - 1]);
            EXPECT_NEAR(r.times[i] - r.times[i - 1], distance / speed, 2e-6);
        }
    }
    const StylizedCurve point = stylize(style, 0, test::plan_of(points_of({{1, 2, 3}}), 0), {.start_time = 4});
    EXPECT_EQ(point.times, std::vector<float>{4});
}

TEST(Finishing, BasesTurnTheDisplacement) {
    const TestStyle style(test::wiggles(300));
    TestStyle turned(test::wiggles(300));
    const std::array<double, 9> basis{0, 2, 0, 0.5, 0, -1, 1, 1, 1};
    const Eigen::Matrix3d matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(basis.data());
    for (uint32_t i = 0; i < 300; ++i) {
        const Vec3 d = matrix * turned.vectors[i];
        turned.prepared.displacement.along_tangent[i] = d.x();
        turned.prepared.displacement.along_normal[i] = d.y();
        turned.prepared.displacement.along_binormal[i] = d.z();
    }
    const Points target = test::sampled(test::wild, 200);
    const SamplingPlan plan = test::plan_of(target, 250);
    const StylizedCurve a = stylize(style, 0, plan, {.basis = basis}), b = stylize(turned, 0, plan);
    for (size_t i = 0; i <= 250; ++i) EXPECT_LT((a.curve.position(i) - b.curve.position(i)).norm(), 1e-5);
}

TEST(Finishing, DegenerateTargets) {
    TestStyle style = turning(0.05, FLG_METRIC_CIRCLE);
    style.add(FLG_ATTRIBUTE_SPEED, 1, std::vector<float>(300, 2.0f));
    for (const Points& target :
         {points_of({{3, 4, 5}}), points_of({{3, 4, 5}}, true), points_of(std::vector<Vec3>(7, Vec3(3, 4, 5)), true)}) {
        const StylizedCurve r = stylize(style, 0, test::plan_of(target, 0), {.pin_ends = true});
        ASSERT_EQ(r.size(), 1u);
        EXPECT_EQ(r.curve.position(0), Vec3(3, 4, 5));
        EXPECT_EQ(r.displacement(0), Vec3(0, 0, 0));
    }
    // There and back: the smallest closed curve.
    const Points pair = points_of({{0, 0, 0}, {1, 0, 0}}, true);
    const StylizedCurve r = stylize(style, 0, test::plan_of(pair, 3), {.pin_ends = true});
    EXPECT_EQ(r.curve.position(0), Vec3(0, 0, 0));
    for (float v : r.curve.positions) EXPECT_TRUE(std::isfinite(v));
    for (float v : r.curve.normals) EXPECT_TRUE(std::isfinite(v));
}

TEST(Finishing, ResultsDoNotDependOnTheSlices) {
    TestStyle style = turning(0.05, FLG_METRIC_CIRCLE);
    style.add(FLG_ATTRIBUTE_SPEED, 1, std::vector<float>(300, 2.0f));
    for (const Points& target : {test::sampled(test::wild, 200), ring()}) {
        for (bool pin_ends : {false, true}) {
            const SamplingPlan plan = test::plan_of(target, steps);
            StylizeOptions options{.pin_ends = pin_ends};
            const StylizedCurve whole = stylize(style, 0.2, plan, options);
            for (uint32_t slice : {1u, 7u, 256u}) {
                options.slice = slice;
                const StylizedCurve sliced = stylize(style, 0.2, plan, options);
                EXPECT_EQ(sliced.curve.positions, whole.curve.positions);
                EXPECT_EQ(sliced.curve.normals, whole.curve.normals);
                EXPECT_EQ(sliced.displacements, whole.displacements);
                EXPECT_EQ(sliced.attributes, whole.attributes);
                EXPECT_EQ(sliced.times, whole.times);
            }
        }
    }
}

}  // namespace
}  // namespace flg
