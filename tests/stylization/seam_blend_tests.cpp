// SPDX-License-Identifier: MIT
#include "stylization/seam_blend.h"

#include <gtest/gtest.h>

#include "stylization/synthesis_inputs.h"

namespace flg {
namespace {

using test::Points;
using test::StylizedCurve;
using test::TestStyle;

constexpr uint32_t patch = 10;

TEST(SeamBlend, AGapFadesLinearlyOverAPatch) {
    SeamBlend blend(4);
    const auto displacement = [](uint32_t node) { return Vec3(node >= 50 ? -5.0 : 0.0, 1, 0); };
    blend.step(7, 8, displacement);
    EXPECT_EQ(blend.offset(), Vec3(0, 0, 0));
    blend.step(8, 60, displacement);  // a gap of 5
    for (uint32_t k = 0; k < 4; ++k) {
        EXPECT_LT((blend.offset() - Vec3(4.0 - k, 0, 0)).norm(), 1e-14) << k;
        blend.step(60 + k, 61 + k, displacement);
    }
    EXPECT_EQ(blend.offset(), Vec3(0, 0, 0));  // to the bit
}

TEST(SeamBlend, ASeamWithinABlendGoesOnFromWhereThatIs) {
    SeamBlend blend(4);
    const auto displacement = [](uint32_t node) { return Vec3(node >= 50 ? -5.0 : 0.0, 0, 0); };
    blend.step(8, 60, displacement);
    blend.step(60, 61, displacement);  // 3 is left
    blend.step(61, 20, displacement);  // 2 would be left, at -5: a gap of -3 to 0
    EXPECT_LT((blend.offset() - Vec3(-2.4, 0, 0)).norm(), 1e-14);
    blend.step(20, 21, displacement);
    EXPECT_LT((blend.offset() - Vec3(-1.8, 0, 0)).norm(), 1e-14);
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
    double least_sq = HUGE_VAL;
    for (size_t c = patch; c + patch < style.size(); ++c) {
        double sum_sq = 0;
        for (size_t k = 0; k <= 2 * patch; ++k)
            sum_sq += (samples[at + k - patch] - style[c + k - patch]).squaredNorm();
        least_sq = std::min(least_sq, sum_sq);
    }
    return std::sqrt(least_sq / (2 * patch + 1));
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

}  // namespace
}  // namespace flg
