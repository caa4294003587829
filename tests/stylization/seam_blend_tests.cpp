// SPDX-License-Identifier: MIT
#include "stylization/seam_blend.h"

#include <gtest/gtest.h>

#include "core/moving_frame.h"
#include "stylization/synthesis_inputs.h"

namespace flg {
namespace {

using test::Points;
using test::StylizedCurve;
using test::TestStyle;

constexpr uint32_t patch = 10;

// A style of two straight lines: x = 0 up to node 50, then x = -5 + 0.5 (node - 60).
Vec3 two_lines(uint32_t node) {
    return Vec3(node >= 50 ? -5.0 + 0.5 * (static_cast<double>(node) - 60) : 0.0, 1, 0);
}

// Hermite's cubic through 5 with the slope -0.5, and through 0 with the slope 0, over 4 points.
double cubic(double k) {
    const double t = k / 4;
    return 5 * (1 + 2 * t) * (1 - t) * (1 - t) - 0.5 * 4 * t * (1 - t) * (1 - t);
}

TEST(SeamBlend, GapsInValueAndStepFadeByACubicOverAPatch) {
    SeamBlend blend(4);
    blend.step(7, 8, two_lines);
    EXPECT_EQ(blend.offset(), Vec3(0, 0, 0));
    blend.step(8, 60, two_lines);
    for (uint32_t k = 0; k < 4; ++k) {
        EXPECT_EQ(blend.points_left(), 4 - k);
        EXPECT_LT((blend.offset() - Vec3(cubic(k), 0, 0)).norm(), 1e-14) << k;
        blend.step(60 + k, 61 + k, two_lines);
    }
    EXPECT_EQ(blend.offset(), Vec3(0, 0, 0));  // to the bit
    EXPECT_EQ(blend.points_left(), 0u);
}

// What is added bends by 6 |g| / n^2 + 4 |h| / n at most.
TEST(SeamBlend, WideGapsFadeOverAsManyPointsAsBendLittle) {
    const auto points = [](double gap, double bend) {
        SeamBlend blend(4, bend);
        blend.step(0, 10, [gap](uint32_t node) { return Vec3(node < 10 ? gap : 0.0, 0, 0); });
        return blend.points_left();
    };
    EXPECT_EQ(points(1, 0), 4u);
    EXPECT_EQ(points(1, 6), 4u);
    EXPECT_EQ(points(1, 6.0 / 63), 8u);
    EXPECT_EQ(points(1, 6.0 / 65), 9u);
    EXPECT_EQ(points(1, 1e-6), 16u);
    EXPECT_EQ(points(0, 1e-6), 4u);
    // A blend that is not over is not made longer.
    SeamBlend blend(4, 6.0 / 64);
    blend.step(0, 10, [](uint32_t node) { return Vec3(node < 10 ? 1.0 : 0.0, 0, 0); });
    blend.step(10, 20, [](uint32_t node) { return Vec3(node < 20 ? 1.0 : 0.0, 0, 0); });
    EXPECT_EQ(blend.points_left(), 4u);
}

TEST(SeamBlend, ASeamWithinABlendGoesOnFromWhereThatIsAndAsItWent) {
    SeamBlend blend(4);
    blend.step(8, 60, two_lines);
    blend.step(60, 61, two_lines);
    const double shown = two_lines(61).x() + cubic(1), followed = two_lines(62).x() + cubic(2);
    blend.step(61, 20, two_lines);  // to x = 0 that stays
    EXPECT_NEAR(blend.offset().x(), followed, 1e-14);
    blend.step(20, 21, two_lines);
    const double t = 0.25;
    const double expected = followed * (1 + 2 * t) * (1 - t) * (1 - t) + (followed - shown) * 4 * t * (1 - t) * (1 - t);
    EXPECT_NEAR(blend.offset().x(), expected, 1e-14);
}

// Two runs of a wave, out of phase: between them, from one to the other, as each goes, and the second one again in the
// end. The run that is left ends at node 49 and stays there.
TEST(SeamBlend, ACrossFadeGoesFromOneRunToTheOther) {
    std::vector<Vec3> wave;
    for (int i = 0; i < 100; ++i) wave.emplace_back(std::sin(0.3 * i), std::cos(0.3 * i), 0.01 * i);
    std::vector<uint32_t> curve_end(50, 50);
    curve_end.resize(100, 100);
    const auto displacement = [&](uint32_t node) -> const Vec3& { return wave[node]; };
    constexpr uint32_t points = 20, from = 35, to = 70;
    SeamBlend blend(4);
    blend.cross_fade(points, wave, curve_end);
    blend.step(from, to, displacement);
    for (uint32_t k = 0; k <= points; ++k) {
        EXPECT_EQ(blend.points_left(), points - k);
        const Vec3 left = wave[std::min(from + 1 + k, 49u)], taken = wave[to + k];
        const double r = static_cast<double>(points - k) / points, weight = r * r * (3 - 2 * r);
        const Vec3 shown = taken + blend.offset();
        EXPECT_LT((shown - (weight * left + (1 - weight) * taken)).norm(), 1e-14) << k;
        blend.step(to + k, to + k + 1, displacement);
    }
    EXPECT_EQ(blend.offset(), Vec3(0, 0, 0));  // to the bit
}

// Samples since the last seam: 0 at one.
std::vector<uint32_t> since_seam(const std::vector<float>& indices) {
    std::vector<uint32_t> since{patch};
    for (size_t i = 1; i < indices.size(); ++i)
        since.push_back(indices[i] == indices[i - 1] + 1 ? since.back() + 1 : 0);
    return since;
}

// Along a straight line frames don't turn.
struct Line {
    Points points = test::points_of({{0, 0, 0}, {1, 0, 0}});
    SamplingPlan plan = test::plan_of(points, 6000);
    test::Resampled frames = test::resample(plan);

    Vec3 in_frame(const Vec3& d) const {
        const Vec3 t = frames.tangent(0), n = frames.normal(0);
        return Vec3(d.dot(t), d.dot(n), d.dot(t.cross(n)));
    }
};

TEST(SeamBlend, AwayFromSeamsRunsAreExact) {
    const TestStyle style(test::wiggles(600), patch);
    const Line line;
    for (double tau : {0.0, 0.5, 3.0}) {
        const StylizedCurve r = stylize(style, tau, line.plan);
        const std::vector<uint32_t> since = since_seam(r.indices);
        size_t away = 0, blended = 0;
        for (size_t i = 0; i < r.size(); ++i) {
            const double off =
                (line.in_frame(r.displacement(i)) - style.vectors[static_cast<size_t>(r.indices[i])]).norm();
            if (since[i] >= patch) {
                ASSERT_LT(off, 1e-6) << i;
                ++away;
            } else {
                blended += off > 1e-6;
            }
        }
        EXPECT_GT(away, 50u) << tau;
        EXPECT_GT(blended, 50u) << tau;
    }
}

double largest_step(const std::vector<Vec3>& d) {
    double largest = 0;
    for (size_t i = 1; i < d.size(); ++i) largest = std::max(largest, (d[i] - d[i - 1]).norm());
    return largest;
}

// Root mean square difference of the 2p + 1 samples about `at` to the style's nearest patch.
double to_nearest_patch(const std::vector<Vec3>& samples, size_t at, const std::vector<Vec3>& style) {
    double min_sq = HUGE_VAL;
    for (size_t c = patch; c + patch < style.size(); ++c) {
        double sum_sq = 0;
        for (size_t k = 0; k <= 2 * patch; ++k)
            sum_sq += (samples[at + k - patch] - style[c + k - patch]).squaredNorm();
        min_sq = std::min(min_sq, sum_sq);
    }
    return std::sqrt(min_sq / (2 * patch + 1));
}

TEST(SeamBlend, SeamsAreNoKinks) {
    const TestStyle style(test::wiggles(300), patch);
    const double of_style = largest_step(style.vectors);
    const Line line;
    for (double tau : {0.0, 0.5, 1.0, 3.0}) {
        const StylizedCurve r = stylize(style, tau, line.plan);
        std::vector<Vec3> copied, blended;
        for (size_t i = 0; i < r.size(); ++i) {
            copied.push_back(style.vectors[static_cast<size_t>(r.indices[i])]);
            blended.push_back(line.in_frame(r.displacement(i)));
        }
        EXPECT_GT(largest_step(copied), 2 * of_style) << tau;
        // Long runs: the style's own steps. Where seams come faster than blends fade, shares of several gaps add up.
        EXPECT_LT(largest_step(blended), (tau == 0 ? 1.1 : 2.0) * of_style) << tau;
        // And what is about seams is more like the style than before.
        double copied_sum = 0, blended_sum = 0;
        const std::vector<uint32_t> since = since_seam(r.indices);
        uint32_t looked_at = 0;
        for (size_t i = patch; i + patch < r.size() && looked_at < 300; ++i) {
            if (since[i] != 0) continue;
            copied_sum += to_nearest_patch(copied, i, style.vectors);
            blended_sum += to_nearest_patch(blended, i, style.vectors);
            ++looked_at;
        }
        EXPECT_LT(blended_sum, copied_sum) << tau;
    }
}

// Attributes of all metrics that vary along with `wiggles`, but are not compared by the patch graph: seams find them
// anywhere.
struct Varied {
    static constexpr int points = 300;
    TestStyle style{test::wiggles(points), patch};

    Varied() {
        add(FLG_ATTRIBUTE_RADIUS, 1, FLG_METRIC_EUCLIDEAN);
        add(FLG_ATTRIBUTE_RADII, 3, FLG_METRIC_PROJECTIVE);
        add(FLG_ATTRIBUTE_ANGLE, 1, FLG_METRIC_CIRCLE);
        add(FLG_ATTRIBUTE_WIDTH, 1, FLG_METRIC_EUCLIDEAN);
        add(FLG_ATTRIBUTE_SPEED, 1, FLG_METRIC_EUCLIDEAN);
        add(FLG_ATTRIBUTE_COLOR, 4, FLG_METRIC_EUCLIDEAN);
        add(user, 2, FLG_METRIC_EUCLIDEAN);
        add(static_cast<FlgAttribute>(user + 1), 1, FLG_METRIC_PROJECTIVE);
    }

    static constexpr FlgAttribute user = FLG_ATTRIBUTE_USER;

private:
    // Sizes go down to 0; angles turn on and on.
    void add(FlgAttribute attribute, uint32_t components, FlgMetric metric) {
        std::vector<float> values;
        const StyleAttribute kind{attribute, components, metric, 0, {}, {}};
        for (int i = 0; i < points; ++i) {
            for (uint32_t k = 0; k < components; ++k) {
                const double wave = std::sin(0.21 * i + 3 * std::sin(0.013 * i) + k + static_cast<int>(attribute));
                values.push_back(static_cast<float>(kind.period(k) > 0                 ? 0.2 * i + 0.2 * wave
                                                    : attribute == FLG_ATTRIBUTE_SPEED ? 1.1 + wave
                                                                                       : 1 + wave));
            }
        }
        style.add(attribute, components, values, metric);
    }
};

double largest_step(const std::vector<float>& values, size_t width, size_t k, double period = 0) {
    double largest = 0;
    for (size_t i = width + k; i < values.size(); i += width) {
        const double step = static_cast<double>(values[i]) - values[i - width];
        largest = std::max(largest, std::abs(period > 0 ? std::remainder(step, period) : step));
    }
    return largest;
}

TEST(SeamBlend, AttributesHaveNoStepsAtSeams) {
    const Varied varied;
    const Line line;
    const StylizedCurve r = stylize(varied.style, 0, line.plan, {.scale = 1});
    for (size_t a = 0; a < r.attributes.size(); ++a) {
        const StyleAttribute& own = varied.style.prepared.attributes[a];
        const std::vector<float> values(own.values.begin(), own.values.end());
        const size_t width = own.components;
        std::vector<float> copied;
        for (float node : r.indices) {
            const float* from = &values[static_cast<size_t>(node) * width];
            copied.insert(copied.end(), from, from + width);
        }
        for (size_t k = 0; k < width; ++k) {
            const double period = own.period(static_cast<uint32_t>(k));
            const double of_style = largest_step(values, width, k);
            SCOPED_TRACE("attribute " + std::to_string(own.attribute) + ", component " + std::to_string(k));
            // Angles are compared around their circle only where they are copied: the result's go on.
            EXPECT_GT(largest_step(copied, width, k, period), 2.5 * of_style);
            EXPECT_LT(largest_step(r.attributes[a], width, k), 1.8 * of_style);
        }
    }
}

TEST(SeamBlend, AttributesStayWithinWhatTheStyleHas) {
    const Varied varied;
    const Line line;
    for (double tau : {0.0, 1.0, 10.0}) {
        const StylizedCurve r = stylize(varied.style, tau, line.plan, {.scale = 3});
        size_t at_the_edge = 0;
        for (size_t a = 0; a < r.attributes.size(); ++a) {
            const StyleAttribute& own = varied.style.prepared.attributes[a];
            for (size_t i = 0; i < r.attributes[a].size(); ++i) {
                const auto k = static_cast<uint32_t>(i % own.components);
                if (own.period(k) > 0) continue;
                const float scale = k < own.length_count() ? 3.0f : 1.0f;
                ASSERT_GE(r.attributes[a][i], scale * own.ranges[k].low);
                ASSERT_LE(r.attributes[a][i], scale * own.ranges[k].high);
                at_the_edge += r.attributes[a][i] == scale * own.ranges[k].low;
            }
        }
        EXPECT_GT(at_the_edge, 0u) << tau;
        for (size_t i = 1; i < r.size(); ++i) ASSERT_LT(r.times[i - 1], r.times[i]);
    }
}

TEST(SeamBlend, AwayFromSeamsAttributesAreTheStyles) {
    const Varied varied;
    const Line line;
    const StylizedCurve r = stylize(varied.style, 0.5, line.plan, {.scale = 2});
    const std::vector<uint32_t> since = since_seam(r.indices);
    size_t away = 0;
    for (size_t i = 0; i < r.size(); ++i) {
        if (since[i] < patch) continue;
        ++away;
        for (size_t a = 0; a < r.attributes.size(); ++a) {
            const StyleAttribute& own = varied.style.prepared.attributes[a];
            for (uint32_t k = 0; k < own.components; ++k) {
                const float value = own.values[static_cast<size_t>(r.indices[i]) * own.components + k];
                const double off =
                    r.attributes[a][i * own.components + k] - (k < own.length_count() ? 2 * value : value);
                // Angles up to whole turns, floats of which are as exact as they are large.
                if (own.period(k) > 0) {
                    ASSERT_NEAR(std::remainder(off, own.period(k)), 0, 1e-3);
                } else {
                    ASSERT_EQ(off, 0);
                }
            }
        }
    }
    EXPECT_GT(away, 50u);
}

// The ribbon itself, not only the numbers: one-sided, so half turns would show.
TEST(SeamBlend, RibbonsTurnAsTheirAnglesDo) {
    TestStyle style(test::wiggles(300), patch);
    std::vector<float> angles;
    for (int i = 0; i < 300; ++i) angles.push_back(0.1f * static_cast<float>(i));
    style.add(FLG_ATTRIBUTE_ANGLE, 1, angles, FLG_METRIC_PROJECTIVE);
    const Line line;
    const StylizedCurve r = stylize(style, 0.5, line.plan);
    for (size_t i = 0; i < r.size(); ++i) {
        const Vec3 expected = turned_about(line.frames.tangent(i), line.frames.normal(i), r.attributes[0][i]);
        ASSERT_LT((r.curve.normal(i) - expected).norm(), 1e-4) << i;
        // The style's own turn, and what fades of two gaps of up to a quarter turn.
        if (i > 0) {
            ASSERT_GT(r.curve.normal(i).dot(r.curve.normal(i - 1)), std::cos(0.1 + 2 * 1.58 / 11)) << i;
        }
    }
}

}  // namespace
}  // namespace flg
