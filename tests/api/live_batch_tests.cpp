// SPDX-License-Identifier: MIT
// A live stroke against flgCurveSetStylize of its samples.
#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

constexpr FlgAttribute shared_columns[] = {FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL,
                                           FLG_ATTRIBUTE_STYLE_INDEX};

// A hand that draws `drawn()` with corners, rests and a corner at the very end.
Samples angular(uint32_t count) {
    Samples samples = drawn(count);
    for (uint32_t i = 0; i < count; ++i) {
        samples[i].position[1] += 0.05f * static_cast<float>(i % 9 < 5 ? i % 9 : 9 - i % 9);
        if (i % 7 == 3) std::copy_n(samples[i - 1].position, 3, samples[i].position);
    }
    return samples;
}

struct Restyled {
    Heard live, batch;
};

Restyled restyled(LiveHost& host, const Samples& samples, bool exact) {
    const FlgLiveStroke stroke = host.begin();
    host.push_in_bursts(stroke, samples, {3, 1});
    const LiveHost::Ended ended = host.end(stroke);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.live.style;
    desc.target = ended.samples;
    desc.magnitude = host.live.magnitude;
    desc.scale = host.live.scale;
    desc.temperature = host.live.temperature;
    desc.start = host.live.start;
    desc.seed = host.live.seed;
    std::copy(std::begin(host.live.basis), std::end(host.live.basis), desc.basis);
    desc.exact_spacing = exact;
    FlgCurveSet out{};
    EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return {heard_of(host.view_of(ended.stylized)), heard_of(host.view_of(out))};
}

// By how much a normal is turned about the tangent, radians.
double turn(const Heard& a, const Heard& b, size_t i) {
    const float *n = &a.of(FLG_ATTRIBUTE_NORMAL)[3 * i], *m = &b.of(FLG_ATTRIBUTE_NORMAL)[3 * i];
    return std::acos(std::clamp(double{n[0]} * m[0] + double{n[1]} * m[1] + double{n[2]} * m[2], -1.0, 1.0));
}

// With the defaults, too: the same frames, so that nothing turns about itself when a stroke is done.
TEST(LiveBatch, ARestyledStrokeDoesNotTurnAboutItself) {
    for (const bool held : {true, false}) {
        LiveHost host;
        Samples samples = drawn(120);
        for (LiveSample& sample : samples) {
            if (!held) std::fill_n(sample.orientation, 4, 0.0f);
        }
        const auto [live, batch] = restyled(host, samples, false);
        ASSERT_LE(live.points(), batch.points() + 1);
        for (size_t i = 0; i < std::min(live.points(), batch.points()); ++i) {
            ASSERT_LT(turn(live, batch, i), 0.02) << i << (held ? "" : ", without an orientation");
        }
    }
}

TEST(LiveBatch, ExactSpacingGivesTheSameBits) {
    const float basis[] = {0, 1, 0, -1, 0, 0.5f, 0, 0, 1};
    for (const bool turned : {false, true}) {
        for (const float temperature : {0.0f, 1.0f}) {
            for (const auto start : {FLG_STYLE_START_AUTO, FLG_STYLE_START_RANDOM}) {
                LiveHost host;
                host.warm(temperature);
                host.live.temperature = temperature;
                host.live.start = start;
                host.live.seed = 7;
                host.live.magnitude = 1.3f;
                if (turned) std::copy(std::begin(basis), std::end(basis), host.live.basis);
                for (const Samples& samples : {drawn(250), drawn(40, 0.3), angular(150)}) {
                    const auto [live, batch] = restyled(host, samples, true);
                    ASSERT_GT(live.points(), 50u);
                    for (const FlgAttribute attribute : shared_columns)
                        EXPECT_TRUE(live.of(attribute) == batch.of(attribute));
                }
            }
        }
    }
}

// The last point lies up to a step before the end; closed curves have equal steps as ever, curves shorter than a step
// two points.
TEST(LiveBatch, ExactSpacingIsExact) {
    LiveHost host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.style;
    desc.magnitude = 0;
    desc.exact_spacing = 1;
    const double step = style_info(host, host.style).spacing;
    Curves curves;
    for (const double steps : {7.0, 7.6, 0.5}) {
        curves.add_point(0, 0, 0);
        curves.add_point(steps * step, 0, 0);
        curves.end_curve();
    }
    for (const double corner : {0.0, 4.3, 8.6}) curves.add_point(corner * step, corner == 4.3 ? 5 * step : 0, 0);
    curves.end_curve(FLG_CURVE_CLOSED);
    desc.target = host.create(curves);
    const FlgCurveSetView view = host.view_of(stylize(host, desc));
    const float* p = view.columns[0].data;
    EXPECT_EQ(view.curve_offsets[2] - view.curve_offsets[1], 8u);
    for (uint32_t i = view.curve_offsets[1]; i < view.curve_offsets[2]; ++i) {
        EXPECT_NEAR(p[3 * i], (i - view.curve_offsets[1]) * step, 1e-5 * step);
    }
    EXPECT_EQ(view.curve_offsets[3] - view.curve_offsets[2], 2u);
    const uint32_t around = view.curve_offsets[4] - view.curve_offsets[3];
    EXPECT_NEAR(around, (8.6 + 2 * std::hypot(4.3, 5.0)), 0.51);
}

TEST(LiveBatch, ExactSpacingHasNoEndToPin) {
    LiveHost host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.style;
    desc.target = host.create(arcs(1));
    desc.exact_spacing = desc.pin_ends = 1;
    FlgCurveSet out{};
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.exact_spacing");
}

}  // namespace
}  // namespace flg::test
