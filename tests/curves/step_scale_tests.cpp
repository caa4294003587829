// SPDX-License-Identifier: MIT
#include "curves/step_scale.h"

#include <gtest/gtest.h>

#include "curves/block_sampler.h"
#include "curves/curve_inputs.h"

namespace flg {
namespace {

TEST(StepScale, StepsAreTheIntegralOfTheInverseScale) {
    for (const auto& [start, end] : {std::pair{0.5, 2.0}, {2.0, 0.5}, {1.0, 1.0 + 1e-12}, {3.0, 3.0}}) {
        const StepScale scale{start, end};
        const double length = 7;
        double sum = 0, middle = 0;
        constexpr int parts = 40000;
        for (int i = 0; i < parts; ++i) {
            sum += length / parts / (start + (end - start) * (i + 0.5) / parts);
            if (i + 1 == parts / 2) middle = sum;
        }
        EXPECT_NEAR(scale.steps(length), sum, 1e-8 * sum) << start << " to " << end;
        EXPECT_NEAR(scale.length(length, middle), length / 2, 1e-8 * length);
        EXPECT_NEAR(scale.length(length, scale.steps(length)), length, 1e-12 * length);
        EXPECT_EQ(scale.length(length, 0), 0);
    }
    EXPECT_NEAR((StepScale{1e-6, 1e6}.steps(7)), 7 / 1e6 * std::log(1e12), 1e-15);
    EXPECT_NEAR((StepScale{1e20, 1}.steps(7)), 7 / 1e20 * std::log(1e20), 1e-30);
}

TEST(StepScale, ConstantScalesDivideTheLength) {
    const test::Points curve = test::sampled(test::wild, 100, true);
    const double length = test::measure(curve).length;
    const std::vector<float> scales(curve.view().count, 0.25f);
    const double steps = run_now(std::pmr::new_delete_resource(),
                                 [&](Pace& pace) { return measure_steps(pace, curve.view(), scales.data()); });
    EXPECT_NEAR(steps, 4 * length, 1e-12 * length);
}

// Equal steps of a curve whose scale changes from point to point: each piece between two samples is worth one step.
TEST(StepScale, SamplesAreASteadyStepApart) {
    const test::Points curve = test::points_of({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}});
    const std::vector<float> scales = {1, 0.5, 2, 1, 3};
    const double length = StepScale{1, 0.5}.steps(1) + StepScale{2, 1}.steps(2) + StepScale{1, 3}.steps(1);
    EXPECT_NEAR(run_now(std::pmr::new_delete_resource(),
                        [&](Pace& pace) { return measure_steps(pace, curve.view(), scales.data()); }),
                length, 1e-12);
    constexpr uint32_t count = 64;
    BlockSampler sampler(curve.view(), length, count, scales.data());
    const auto steps_to = [](double x) {
        if (x <= 1) return StepScale{1, 1 - 0.5 * x}.steps(x);
        if (x <= 3) return StepScale{1, 0.5}.steps(1) + StepScale{2, 2 - 0.5 * (x - 1)}.steps(x - 1);
        return StepScale{1, 0.5}.steps(1) + StepScale{2, 1}.steps(2) + StepScale{1, 1 + 2 * (x - 3)}.steps(x - 3);
    };
    uint32_t units = 1000;
    SampleBlock block;
    for (uint32_t k = 0; k <= count;) {
        ASSERT_TRUE(sampler.next(block, units));
        // Places within a segment are floats.
        for (uint32_t j = 0; j < block.count; ++j, ++k) {
            EXPECT_NEAR(steps_to(block.position_of(j).x()), length * k / count, 1e-6) << k;
        }
    }
    EXPECT_EQ(block.position_of(block.count - 1).x(), 4);
}

}  // namespace
}  // namespace flg
