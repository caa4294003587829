// SPDX-License-Identifier: MIT
// Attributes of a style (Minarcik, Fiser, Sykora, sec. 5): values at matched places, and their share in patch
// distances.
#include <gtest/gtest.h>

#include "stylization/scene_inputs.h"
#include "stylization/style_attributes.h"

namespace flg {
namespace {

using test::Scene;

TEST(Attributes, EnterDistancesAsTheLiteralSum) {
    test::expect_literal(Scene{{0, 300}, {{10, 1}}}.with_channel(0.5, 0));
    test::expect_literal(Scene{{0, 300}, {{10, 1}}}.with_channel(0.5, 2 * M_PI));
    test::expect_literal(
        Scene{{0, 120, 200, 420}, {{7, 1}}}.with_channel(0.5, M_PI).with_channel(2, 0).with_channel(0.1, 2 * M_PI));
}

// What counts is how far apart angles are, not where the circle is cut, nor how many turns were made.
TEST(Attributes, TurningAllAnglesChangesNothing) {
    for (const double period : {M_PI, 2 * M_PI}) {
        Scene scene = Scene{{0, 200, 400}, {{10, 1}}}.with_channel(0.5, period);
        const PatchGraph before = test::graph_of(scene);
        for (double& value : scene.channels[0].values) value += 1.234;
        const PatchGraph turned = test::graph_of(scene);
        for (size_t i = 0; i < scene.vectors.size(); i += 3) scene.channels[0].values[i] += 4 * period;
        const PatchGraph wound = test::graph_of(scene);
        ASSERT_EQ(before.jump_count(), turned.jump_count());
        ASSERT_EQ(before.jump_count(), wound.jump_count());
        for (uint32_t k = 0; k < before.jump_count(); ++k) {
            EXPECT_EQ(before.in_source[k], turned.in_source[k]);
            EXPECT_NEAR(before.in_cost[k], turned.in_cost[k], 1e-6);
            EXPECT_EQ(before.in_source[k], wound.in_source[k]);
            EXPECT_NEAR(before.in_cost[k], wound.in_cost[k], 1e-6);
        }
    }
}

// A one-sided ribbon, any of whose points are turned over; a two-sided one minds.
TEST(Attributes, OneSidedRibbonsAreIndifferentToAFlip) {
    Scene scene = Scene{{0, 300}, {{10, 1}}}.with_channel(0.5, M_PI);
    const std::vector<double> before = scene.literal_costs_sq();
    const PatchGraph graph = test::graph_of(scene);
    for (size_t i = 0; i < scene.vectors.size(); ++i) {
        if (random_unit(3, i, 0) < 0.5) scene.channels[0].values[i] += M_PI;
    }
    const PatchGraph flipped = test::graph_of(scene);
    ASSERT_EQ(graph.jump_count(), flipped.jump_count());
    for (uint32_t k = 0; k < graph.jump_count(); ++k) {
        EXPECT_EQ(graph.in_source[k], flipped.in_source[k]);
        EXPECT_NEAR(graph.in_cost[k], flipped.in_cost[k], 1e-6 * graph.in_cost[k] + 1e-9);
    }
    const std::vector<double> after = scene.literal_costs_sq();
    for (size_t k = 0; k < before.size(); ++k) {
        if (before[k] < INFINITY) {
            ASSERT_NEAR(before[k], after[k], 1e-9);
        }
    }
    scene.channels[0].period = 2 * M_PI;
    EXPECT_GT(test::graph_of(scene).temperature_unit, 1.5f * graph.temperature_unit);
}

TEST(Attributes, OfNoWeightOrNoVariationLeaveTheGraphAsItIs) {
    Scene scene{{0, 300}, {{10, 1}}};
    const PatchGraph before = test::graph_of(scene);
    scene.with_channel(3, 0);
    for (double& value : scene.channels[0].values) value = 0.7;
    EXPECT_TRUE(test::same_bits(test::graph_of(scene), before));
}

// Points along x, unevenly spaced, with columns of the caller's choice.
struct Example {
    CurveSet set{test::memory()};

    Example(const std::vector<float>& x, FlgAttribute attribute, uint32_t components,
            const std::vector<float>& values) {
        const auto count = static_cast<uint32_t>(x.size());
        set.allocate_curves(1);
        set.offsets()[0] = 0;
        set.offsets()[1] = count;
        set.begin_curve(0, 0);
        set.allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
            {{FLG_ATTRIBUTE_POSITION, 3}, {attribute, components}}, test::memory()));
        for (uint32_t i = 0; i < count; ++i) {
            store_vec3(Vec3(x[i], 0, 0), set.columns()[0].values.data() + 3 * size_t{i});
        }
        std::copy(values.begin(), values.end(), set.columns()[1].values.data());
    }

    std::vector<float> at(const std::vector<double>& places, FlgMetric metric, bool haltingly = false) {
        std::vector<StyleAttribute> attributes;
        attributes.push_back(make_attribute(set, {set.columns()[1].attribute, metric, 1, 0},
                                            static_cast<uint32_t>(places.size()), test::memory()));
        run_now(
            test::memory(), [&](Pace& pace) { return take_values(pace, set, 0, places, 0, attributes); }, haltingly);
        return {attributes[0].values.begin(), attributes[0].values.end()};
    }
};

void expect_near(const std::vector<float>& values, const std::vector<double>& expected) {
    ASSERT_EQ(values.size(), expected.size());
    for (size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-5) << i;
}

TEST(Attributes, AreInterpolatedByArcLength) {
    Example radius({0, 1, 5, 7}, FLG_ATTRIBUTE_RADIUS, 1, {2, 4, 0, 1});
    expect_near(radius.at({0, 0.5, 1, 2, 4, 5, 6.5, 7}, FLG_METRIC_AUTO), {2, 3, 4, 3, 1, 0, 0.75, 1});
    Example color({0, 2}, FLG_ATTRIBUTE_COLOR, 4, {0, 1, 2, 3, 4, 3, 2, 1});
    expect_near(color.at({0, 0.5, 2}, FLG_METRIC_EUCLIDEAN), {0, 1, 2, 3, 1, 1.5, 2, 2.5, 4, 3, 2, 1});
}

TEST(Attributes, RepeatedPointsDoNotMatter) {
    Example radius({0, 0, 1, 1, 1, 5}, FLG_ATTRIBUTE_RADIUS, 1, {2, 2, 4, 4, 4, 0});
    expect_near(radius.at({0, 0.5, 1, 2, 5}, FLG_METRIC_AUTO), {2, 3, 4, 3, 0});
}

TEST(Attributes, AnglesGoTheShorterWay) {
    const std::vector<float> x = {0, 1, 2, 3};
    // Across the cut at pi, and on: 3, 3.28, 3.58 and back to 3.
    const auto cut = static_cast<float>(2 * M_PI);
    Example angle(x, FLG_ATTRIBUTE_ANGLE, 1, {3, 3.28f - cut, 3.58f - cut, 3});
    expect_near(angle.at({0, 0.5, 1, 1.5, 2, 2.5, 3}, FLG_METRIC_AUTO), {3, 3.14, 3.28, 3.43, 3.58, 3.29, 3});
    // A half turn is nothing to a one-sided ribbon.
    Example one_sided(x, FLG_ATTRIBUTE_ANGLE, 1, {0, 0.2f + static_cast<float>(M_PI), 0.4f, 0.2f});
    expect_near(one_sided.at({0, 0.5, 1, 1.5, 2, 2.5, 3}, FLG_METRIC_PROJECTIVE), {0, 0.1, 0.2, 0.3, 0.4, 0.3, 0.2});
    // Only the third component of elliptic cross-sections is an angle.
    Example radii({0, 1}, FLG_ATTRIBUTE_RADII, 3, {1, 5, 0.1f, 9, 5, 0.1f - cut});
    for (FlgMetric metric : {FLG_METRIC_AUTO, FLG_METRIC_CIRCLE}) {
        expect_near(radii.at({0, 0.5, 1}, metric), {1, 5, 0.1, 5, 5, 0.1, 9, 5, 0.1});
    }
    // And if a half turn is nothing to an ellipse: half axes don't wrap even so.
    const float half_turn = static_cast<float>(M_PI);
    Example ellipse({0, 1}, FLG_ATTRIBUTE_RADII, 3, {1, 5, 0.1f, 9, 5, 0.3f + half_turn});
    expect_near(ellipse.at({0, 0.5, 1}, FLG_METRIC_PROJECTIVE), {1, 5, 0.1, 5, 5, 0.2, 9, 5, 0.3});
}

TEST(Attributes, ManyTurnsAreKept) {
    std::vector<float> x, values;
    std::vector<double> places, expected;
    for (int i = 0; i <= 40; ++i) {
        x.push_back(static_cast<float>(i));
        values.push_back(static_cast<float>(i));
        places.push_back(i);
        expected.push_back(i);
    }
    expect_near(Example(x, FLG_ATTRIBUTE_ANGLE, 1, values).at(places, FLG_METRIC_CIRCLE), expected);
}

TEST(Attributes, DoNotDependOnTheSlices) {
    Example radius({0, 1, 5, 7}, FLG_ATTRIBUTE_RADIUS, 1, {2, 4, 0, 1});
    const std::vector<double> places = {0, 0.1, 0.1, 3, 6.9, 7};
    EXPECT_EQ(radius.at(places, FLG_METRIC_AUTO), radius.at(places, FLG_METRIC_AUTO, true));
}

TEST(Attributes, ChannelsCarryWeightAndPeriod) {
    StyleAttribute attribute{FLG_ATTRIBUTE_RADII, 3, FLG_METRIC_EUCLIDEAN, 2, Buffer<float>(6, test::memory()), {}};
    const float values[6] = {1, 2, -1, 3, 4, 7};
    std::copy(values, values + 6, attribute.values.data());
    std::pmr::vector<PatchChannel> channels(test::memory());
    run_haltingly(test::memory(), [&](Pace& pace) { return add_channels(pace, attribute, channels); });
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].period, 0);
    EXPECT_EQ(channels[0].values[1], 6);
    EXPECT_EQ(channels[1].values[0], 4);
    EXPECT_DOUBLE_EQ(channels[2].period, 4 * M_PI);
    EXPECT_NEAR(channels[2].values[0], 4 * M_PI - 2, 1e-12);
    EXPECT_NEAR(channels[2].values[1], 14 - 4 * M_PI, 1e-12);
    attribute.metric = FLG_METRIC_PROJECTIVE;
    EXPECT_EQ(attribute.period(0), 0);
    EXPECT_EQ(attribute.period(1), 0);
    EXPECT_EQ(attribute.period(2), M_PI);
}

}  // namespace
}  // namespace flg
