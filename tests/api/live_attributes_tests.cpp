// SPDX-License-Identifier: MIT
// Live strokes with styles that have attributes.
#include "api/live_inputs.h"

namespace flg::test {
namespace {

constexpr FlgAttribute user = FLG_ATTRIBUTE_USER;

// A coil whose radius, ribbon and a value of the host's change along it.
struct Example {
    Curves curves = coil(256, 8, 4, 0.2);
    std::vector<float> radii, angles, widths, values;
    std::vector<FlgStyleAttribute> attributes = {{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 0, 0},
                                                 {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 0, 0},
                                                 {FLG_ATTRIBUTE_WIDTH, FLG_METRIC_AUTO, 0, 0},
                                                 {user, FLG_METRIC_AUTO, 0, 0}};

    FlgCurveSet create(const Host& host) {
        const size_t count = curves.positions.size() / 3;
        for (size_t i = 0; i < count; ++i) {
            const float u = static_cast<float>(i) / static_cast<float>(count);
            radii.push_back(0.01f + 0.02f * u);
            angles.push_back(2.0f * u);
            widths.push_back(0.1f + 0.1f * u);
            values.push_back(u);
        }
        FlgCurveSetView view = curves.view();
        const std::vector<FlgColumn> columns = {{FLG_ATTRIBUTE_POSITION, 3, curves.positions.data(), 0, 0},
                                                {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0},
                                                {FLG_ATTRIBUTE_ANGLE, 1, angles.data(), 0, 0},
                                                {FLG_ATTRIBUTE_WIDTH, 1, widths.data(), 0, 0},
                                                {user, 1, values.data(), 0, 0}};
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
        return set;
    }
};

TEST(LiveStrokeAttributes, ComeFromTheStyle) {
    LiveHost host;
    Example example;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = example.create(host);
    desc.attributes = example.attributes.data();
    desc.attribute_count = static_cast<uint32_t>(example.attributes.size());
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &host.style, nullptr), FLG_OK) << flgErrorGetMessage();
    host.warm(1);
    FlgLiveStrokeDesc live = host.live;
    live.temperature = 1;
    live.style = host.style;
    live.min_radius = live.max_radius = 0.01f;
    const FlgLiveStroke stroke = host.begin(live);
    Samples samples = drawn(150);
    host.push(stroke, samples.data(), samples.size());
    const Heard with = heard_of(host.points(stroke));
    ASSERT_GT(with.points(), 50u);
    // Where on the style's way a point is, as the host's value says, and all else with it.
    double mean_ratio = 0;
    for (size_t i = 0; i < with.points(); ++i) {
        const float u = with.of(user)[i];
        EXPECT_NEAR(with.of(FLG_ATTRIBUTE_ANGLE)[i], 2 * u, 1e-3);
        EXPECT_NEAR(with.of(FLG_ATTRIBUTE_WIDTH)[i], live.scale * (0.1f + 0.1f * u), 1e-4);
        const double ratio = with.of(FLG_ATTRIBUTE_RADIUS)[i] / (0.01 * (0.01 + 0.02 * u));
        mean_ratio = i == 0 ? ratio : mean_ratio;
        EXPECT_NEAR(ratio, mean_ratio, 0.01 * mean_ratio);
    }
    EXPECT_NEAR(1 / mean_ratio, 0.02, 0.001);  // the mean radius of the style
    // No steps where the style is jumped about in, by temperature 1: those of whole values over a patch of 10 points.
    for (size_t i = 1; i < with.points(); ++i) {
        EXPECT_LT(std::abs(with.of(user)[i] - with.of(user)[i - 1]), 2.0 / 11 + 0.01);
        EXPECT_LT(std::abs(with.of(FLG_ATTRIBUTE_ANGLE)[i] - with.of(FLG_ATTRIBUTE_ANGLE)[i - 1]), 4.0 / 11 + 0.02);
    }
    // Undone and drawn again, and drawn in one go: the same bits.
    ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 61, nullptr), FLG_OK);
    host.push(stroke, samples.data() + samples.size() - 61, 61);
    const LiveHost::Ended drawn_again = host.end(stroke);
    host.finish();
    EXPECT_TRUE(host.replay(live, drawn_again.samples) == heard_of(host.view_of(drawn_again.stylized)));
    // The angle turns the normal about the tangent.
    live.style = {};
    FlgStyle plain{};
    desc.attribute_count = 0;
    desc.attributes = nullptr;
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &plain, nullptr), FLG_OK);
    host.style = plain;
    host.warm(1);
    live.style = plain;
    const FlgLiveStroke bare = host.begin(live);
    host.push(bare, samples.data(), samples.size());
    const Heard without = heard_of(host.points(bare));
    ASSERT_EQ(without.points(), with.points());
    EXPECT_EQ(without.columns.size(), 6u);
    for (size_t i = 0; i < with.points(); ++i) {
        const float* a = &without.of(FLG_ATTRIBUTE_NORMAL)[3 * i];
        const float* b = &with.of(FLG_ATTRIBUTE_NORMAL)[3 * i];
        const float* t = &with.of(FLG_ATTRIBUTE_TANGENT)[3 * i];
        const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const double across = t[0] * (a[1] * b[2] - a[2] * b[1]) + t[1] * (a[2] * b[0] - a[0] * b[2]) +
                              t[2] * (a[0] * b[1] - a[1] * b[0]);
        EXPECT_NEAR(std::atan2(across, along), with.of(FLG_ATTRIBUTE_ANGLE)[i], 1e-4);
    }
    // The batch has the same.
    live.style = plain;
    const LiveHost::Ended ended = host.end(bare);
    host.finish();
    EXPECT_TRUE(host.replay(live, ended.samples) == heard_of(host.view_of(ended.stylized)));
}

}  // namespace
}  // namespace flg::test
