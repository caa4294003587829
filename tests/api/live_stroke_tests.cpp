// SPDX-License-Identifier: MIT
// What live strokes promise: same bits however samples come, however they are undone; points that stay; the batch's
// equal; no allocation.
#include "api/live_inputs.h"

namespace flg::test {
namespace {

constexpr FlgAttribute position = FLG_ATTRIBUTE_POSITION;

TEST(LiveStroke, OneByOneAndInBurstsGiveTheSameBits) {
    LiveHost host;
    for (float smoothing : {0.0f, 0.03f}) {
        host.live.smoothing = smoothing;
        const Samples samples = drawn(300);
        const Heard single = host.push_in_bursts(host.begin(), samples, {1});
        EXPECT_GT(single.points(), 200u);
        for (const std::vector<size_t>& sizes : {std::vector<size_t>{300}, {7}, {1, 40, 3}}) {
            const FlgLiveStroke stroke = host.begin();
            EXPECT_TRUE(host.push_in_bursts(stroke, samples, sizes) == single);
            EXPECT_TRUE(heard_of(host.points(stroke)) == single);
        }
    }
}

TEST(LiveStroke, FinalPointsNeverMove) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    Heard before;
    for (const LiveSample& sample : drawn(200)) {
        before.add(host.push(stroke, &sample, 1));
        EXPECT_TRUE(heard_of(host.points(stroke)) == before);
    }
    const LiveHost::Ended ended = host.end(stroke);
    host.finish();
    const Heard whole = heard_of(host.view_of(ended.stylized));
    ASSERT_GT(whole.points(), before.points());
    for (size_t k = 0; k < whole.columns.size(); ++k) {
        EXPECT_TRUE(std::equal(before.columns[k].begin(), before.columns[k].end(), whole.columns[k].begin()));
    }
    EXPECT_TRUE(heard_of(host.points(stroke)) == whole);
}

TEST(LiveStroke, PointsReachToTheLastButOneSample) {
    LiveHost host;
    host.live.magnitude = 0;
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = drawn(120);
    const double step = host.info(stroke).spacing;
    for (size_t i = 0; i < samples.size(); ++i) {
        host.push(stroke, &samples[i], 1);
        const FlgCurveSetView view = host.points(stroke);
        if (i < 2) {
            EXPECT_EQ(view.curve_count, 0u);
            continue;
        }
        EXPECT_EQ(host.info(stroke).waiting_samples, 0u);
        const float* last = view.columns[0].data + 3 * size_t{view.curve_offsets[1] - 1};
        const float* reached = samples[i - 1].position;
        EXPECT_LE(std::hypot(last[0] - reached[0], last[1] - reached[1], last[2] - reached[2]), step * 1.001);
    }
}

TEST(LiveStroke, LiveEqualsBatch) {
    LiveHost host;
    for (float smoothing : {0.0f, 0.02f}) {
        host.live.smoothing = smoothing;
        host.live.start = smoothing > 0 ? FLG_STYLE_START_RANDOM : FLG_STYLE_START_AUTO;
        const FlgLiveStroke stroke = host.begin();
        host.push_in_bursts(stroke, drawn(250), {3});
        const LiveHost::Ended ended = host.end(stroke);
        host.finish();
        const Heard live = heard_of(host.view_of(ended.stylized));
        EXPECT_TRUE(host.replay(host.live, ended.samples) == live);
    }
}

// Bits and length do not depend on who draws besides.
TEST(LiveStroke, ManyStrokesAtOnceAreIndependent) {
    LiveHost host;
    const Samples samples = drawn(200);
    std::vector<Samples> hands;
    std::vector<Heard> alone, together(20);
    std::vector<FlgLiveStroke> strokes;
    for (int k = 0; k < 20; ++k) {
        hands.push_back(samples);
        for (LiveSample& sample : hands.back()) sample.position[1] += 0.1f * static_cast<float>(k) * sample.position[0];
        alone.push_back(host.push_in_bursts(host.begin(), hands.back(), {1}));
        strokes.push_back(host.begin());
    }
    for (size_t i = 0; i < samples.size(); ++i) {
        for (size_t k = 0; k < strokes.size(); ++k) together[k].add(host.push(strokes[k], &hands[k][i], 1));
    }
    for (size_t k = 0; k < strokes.size(); ++k) EXPECT_TRUE(together[k] == alone[k]) << k;
}

// The same way of a hand, sampled at 90 and at 720 Hz.
TEST(LiveStroke, SampleRateDoesNotMatter) {
    LiveHost host;
    for (float smoothing : {0.0f, 0.05f}) {
        host.live.smoothing = smoothing;
        Heard sampled[2];
        for (int k = 0; k < 2; ++k) {
            const FlgLiveStroke stroke = host.begin();
            host.push_in_bursts(stroke, drawn(k == 0 ? 181 : 1441), {16});
            const LiveHost::Ended ended = host.end(stroke);
            host.finish();
            sampled[k] = heard_of(host.view_of(ended.stylized));
        }
        const double step = host.info(host.begin()).spacing;
        // A filtered hand is taken to move evenly between samples, which at 90 Hz it doesn't quite.
        const double tolerance = smoothing > 0 ? 0.1 : 0.05;
        const size_t common = std::min(sampled[0].points(), sampled[1].points());
        EXPECT_GE(common + 1, std::max(sampled[0].points(), sampled[1].points()));
        for (size_t i = 0; i < common; ++i) {
            ASSERT_EQ(sampled[0].of(FLG_ATTRIBUTE_STYLE_INDEX)[i], sampled[1].of(FLG_ATTRIBUTE_STYLE_INDEX)[i]);
        }
        for (size_t i = 0; i < 3 * common; ++i) {
            ASSERT_NEAR(sampled[0].of(position)[i], sampled[1].of(position)[i], tolerance * step) << i / 3;
        }
        for (size_t i = 0; i < common; ++i) {
            ASSERT_NEAR(sampled[0].of(FLG_ATTRIBUTE_RADIUS)[i], sampled[1].of(FLG_ATTRIBUTE_RADIUS)[i], 2e-5);
        }
    }
}

TEST(LiveStroke, PointsLieEvenlyOnTheCurveOfFlgResample) {
    LiveHost host;
    host.live.magnitude = 0;
    const Samples samples = drawn(100);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), samples.size());
    const LiveHost::Ended ended = host.end(stroke);
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = ended.samples;
    desc.spacing = host.info(stroke).spacing / 64;
    FlgCurveSet fine{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgCurveSetView curve = host.view_of(fine), live = host.view_of(ended.stylized);
    const float* c = curve.columns[0].data;
    double length = 0;
    for (uint32_t i = 1; i < curve.curve_offsets[1]; ++i) {
        length += std::hypot(c[3 * i] - c[3 * i - 3], c[3 * i + 1] - c[3 * i - 2], c[3 * i + 2] - c[3 * i - 1]);
    }
    const double fine_step = length / (curve.curve_offsets[1] - 1), step = host.info(stroke).spacing;
    EXPECT_EQ(live.curve_offsets[1], static_cast<uint32_t>(length / step) + 1);
    for (uint32_t i = 0; i < live.curve_offsets[1]; ++i) {
        const float* p = live.columns[0].data + 3 * i;
        const auto at = static_cast<uint32_t>(std::lround(i * step / fine_step));
        ASSERT_LE(std::hypot(p[0] - c[3 * at], p[1] - c[3 * at + 1], p[2] - c[3 * at + 2]), 0.03 * step) << i;
    }
}

TEST(LiveStroke, UndoAndRedoGiveTheSameBits) {
    LiveHost host;
    host.live.smoothing = 0.01f;
    const Samples samples = drawn(200);
    const FlgLiveStroke stroke = host.begin();
    std::vector<uint32_t> points_at{0};
    for (const LiveSample& sample : samples) {
        host.push(stroke, &sample, 1);
        points_at.push_back(host.info(stroke).point_count);
    }
    const Heard whole = heard_of(host.points(stroke));
    uint32_t drawn_samples = 200;
    for (uint32_t count : {1u, 3u, 8u, 13u, 64u, 0u, 111u}) {
        uint32_t points = 99;
        ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, count, &points), FLG_OK) << flgErrorGetMessage();
        drawn_samples -= count;
        EXPECT_EQ(points, points_at[drawn_samples]);
        EXPECT_EQ(host.info(stroke).sample_count, drawn_samples);
    }
    ASSERT_EQ(drawn_samples, 0u);
    for (uint32_t from : {0u, 150u, 41u, 8u, 199u}) {
        if (from > 0) {
            ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 200 - from, nullptr), FLG_OK);
        }
        host.push(stroke, samples.data() + from, 200 - from);
        EXPECT_TRUE(heard_of(host.points(stroke)) == whole) << from;
    }
    uint32_t points = 99;
    expect_failure(flgLiveStrokeUndo(host.context, stroke, 201, &points), FLG_ERROR_INVALID_ARGUMENT, "count is 201");
    EXPECT_EQ(points, 0u);
}

TEST(LiveStroke, UndoneSamplesCanBeDrawnElsewhere) {
    LiveHost host;
    const Samples samples = drawn(100);
    Samples other = samples;
    for (size_t i = 60; i < 100; ++i) other[i].position[1] += 0.004f * static_cast<float>(i - 60);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), 100);
    ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 40, nullptr), FLG_OK);
    host.push(stroke, other.data() + 60, 40);
    EXPECT_TRUE(heard_of(host.points(stroke)) == host.push_in_bursts(host.begin(), other, {1}));
}

TEST(LiveStroke, ResumingIsAsIfTheStrokeHadNeverEnded) {
    LiveHost host;
    const Samples samples = drawn(150);
    const Heard unbroken = host.push_in_bursts(host.begin(), samples, {1});
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), 70);
    const LiveHost::Ended ended = host.end(stroke);
    EXPECT_EQ(host.info(stroke).ended, 1u);
    EXPECT_EQ(flgLiveStrokeResume(host.context, stroke), FLG_NOT_READY);
    host.finish();
    const std::string first = bits(host.view_of(ended.stylized));
    ASSERT_EQ(flgLiveStrokeResume(host.context, stroke), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(host.info(stroke).ended, 0u);
    host.push(stroke, samples.data() + 70, 80);
    EXPECT_TRUE(heard_of(host.points(stroke)) == unbroken);
    EXPECT_EQ(bits(host.view_of(ended.stylized)), first);
}

TEST(LiveStroke, SplitsAtAPoint) {
    LiveHost host;
    const Samples samples = drawn(150);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), 150);
    FlgCurveSet first{7}, second{7};
    expect_failure(flgLiveStrokeSplit(host.context, stroke, 50, nullptr, &first, &second, nullptr),
                   FLG_ERROR_INVALID_ARGUMENT, "has not ended");
    EXPECT_EQ(first.id, 0u);
    const LiveHost::Ended ended = host.end(stroke);
    EXPECT_EQ(flgLiveStrokeSplit(host.context, stroke, 50, nullptr, &first, &second, nullptr), FLG_NOT_READY);
    host.finish();
    ASSERT_EQ(flgLiveStrokeSplit(host.context, stroke, 50, nullptr, &first, &second, nullptr), FLG_OK)
        << flgErrorGetMessage();
    EXPECT_EQ(flgLiveStrokeResume(host.context, stroke), FLG_NOT_READY);  // it is being read
    host.finish();
    const Heard whole = heard_of(host.view_of(ended.stylized));
    const Heard a = heard_of(host.view_of(first)), b = heard_of(host.view_of(second));
    ASSERT_EQ(a.points(), 51u);
    ASSERT_EQ(b.points(), whole.points() - 50);
    for (size_t k = 0; k < whole.columns.size(); ++k) {
        const size_t components = whole.columns[k].size() / whole.points();
        std::vector<float> joined = a.columns[k];
        joined.resize(50 * components);
        joined.insert(joined.end(), b.columns[k].begin(), b.columns[k].end());
        EXPECT_EQ(joined, whole.columns[k]);
    }
    expect_failure(flgLiveStrokeSplit(host.context, stroke, static_cast<uint32_t>(whole.points()), nullptr, &first,
                                      nullptr, nullptr),
                   FLG_ERROR_INVALID_ARGUMENT, "stroke has");
    EXPECT_EQ(flgLiveStrokeResume(host.context, stroke), FLG_OK);
}

TEST(LiveStroke, PushingAllocatesNothing) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = drawn(4000, 6);
    const int64_t calls = host.allocator.calls;
    for (const LiveSample& sample : samples) host.push(stroke, &sample, 1);
    ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 1000, nullptr), FLG_OK);
    host.push(stroke, samples.data() + 3000, 1000);
    host.points(stroke);
    EXPECT_EQ(host.allocator.calls, calls);
    EXPECT_GT(host.info(stroke).point_count, 500u);
}

// A stroke just drawn becomes a style in ticks of 2 ms, and the next stroke has its character.
TEST(LiveStroke, AStrokeBecomesAStyle) {
    LiveHost host;
    host.live.magnitude = 0;
    Samples curls = drawn(400, 3);
    for (size_t i = 0; i < curls.size(); ++i) {
        curls[i].position[1] += 0.03f * std::sin(0.5f * static_cast<float>(i));
        curls[i].position[2] += 0.03f * std::cos(0.5f * static_cast<float>(i));
    }
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, curls.data(), curls.size());
    const LiveHost::Ended ended = host.end(stroke);
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = ended.samples;
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgStyleWarm(host.context, style, 0, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgLiveStrokeDesc next = flgLiveStrokeDefaults();
    next.style = style;
    FlgLiveStroke restyled{};
    EXPECT_EQ(flgLiveStrokeBegin(host.context, &next, &restyled), FLG_NOT_READY);
    host.finish(2000);
    restyled = host.begin(next);
    const Heard with = host.push_in_bursts(restyled, drawn(200), {2});
    next.magnitude = 0;
    const Heard without = host.push_in_bursts(host.begin(next), drawn(200), {2});
    ASSERT_EQ(with.points(), without.points());
    double sum_sq = 0;
    for (size_t i = 0; i < 3 * with.points(); ++i) {
        sum_sq += std::pow(with.of(position)[i] - without.of(position)[i], 2);
    }
    const double rms = std::sqrt(sum_sq / static_cast<double>(with.points()));
    EXPECT_GT(rms, 0.02);  // curls of 3 cm, on bends of 15 cm
    EXPECT_LT(rms, 0.2);
}

TEST(LiveStroke, SamplesCanBeStylizedAgain) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = drawn(100);
    host.push(stroke, samples.data(), 100);
    const LiveHost::Ended ended = host.end(stroke);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.style;
    desc.target = ended.samples;
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_NE(find_column(host.view_of(out), FLG_ATTRIBUTE_PRESSURE), nullptr);
    const FlgCurveSetView raw = host.view_of(ended.samples);
    ASSERT_EQ(raw.curve_offsets[1], 100u);
    EXPECT_EQ(find_column(raw, FLG_ATTRIBUTE_TIME)->data[0], 0.0f);
    EXPECT_NEAR(find_column(raw, FLG_ATTRIBUTE_TIME)->data[99], 2.0f, 1e-6);
    EXPECT_EQ(find_column(raw, FLG_ATTRIBUTE_ORIENTATION)->data[4 * 50], samples[50].orientation[0]);
    EXPECT_EQ(find_column(raw, FLG_ATTRIBUTE_PRESSURE)->data[50], samples[50].pressure);
}

}  // namespace
}  // namespace flg::test
