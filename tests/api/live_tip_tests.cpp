// SPDX-License-Identifier: MIT
// The provisional tip: with the points so far it is the stroke that its end would give, and it leaves no trace.
#include "api/live_inputs.h"
#include "core/random.h"

namespace flg::test {
namespace {

constexpr size_t max_tip_points = 256;  // as the header has it

// A scribble as hands make them: loops with a tremor, slower and faster, with rests and samples that repeat.
Samples scribble(uint32_t count, uint64_t seed) {
    Samples samples = drawn(count, 1.5);
    double way = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const auto noise = [&](uint32_t k) {
            return static_cast<float>(static_cast<double>(mix64(seed * 1000003 + 3 * i + k) >> 11) * 0x1p-53 - 0.5);
        };
        way += 0.012 * (1 + std::sin(0.11 * i));
        samples[i].position[0] = static_cast<float>(0.3 * way + 0.06 * std::cos(9 * way)) + 4e-4f * noise(0);
        samples[i].position[1] = static_cast<float>(1.2 + 0.06 * std::sin(9 * way)) + 4e-4f * noise(1);
        samples[i].position[2] = 4e-4f * noise(2);
        if (i > 0 && i % 41 < 5) std::copy_n(samples[i - 1].position, 3, samples[i].position);
    }
    return samples;
}

// Points so far, and behind them the tip's.
Heard points_and_tip(LiveHost& host, FlgLiveStroke stroke) {
    Heard heard = heard_of(host.points(stroke));
    const Heard tip = heard_of(host.tip(stroke));
    if (tip.points() == 0) return heard;
    const size_t shared = heard.points() > 0 ? 1 : 0;  // the tip begins with the last point
    EXPECT_GT(tip.points(), shared);
    if (shared > 0) {
        for (size_t k = 0; k < tip.columns.size(); ++k) {
            const size_t components = tip.columns[k].size() / tip.points();
            EXPECT_TRUE(std::equal(heard.columns[k].end() - static_cast<ptrdiff_t>(components), heard.columns[k].end(),
                                   tip.columns[k].begin()));
        }
    }
    for (size_t k = 0; k < tip.columns.size(); ++k) {
        const size_t components = tip.columns[k].size() / tip.points();
        const auto from = tip.columns[k].begin() + static_cast<ptrdiff_t>(shared * components);
        heard.columns[k].insert(heard.columns[k].end(), from, tip.columns[k].end());
    }
    return heard;
}

// Ends the stroke, and takes the end back.
Heard ended(LiveHost& host, FlgLiveStroke stroke) {
    const LiveHost::Ended end = host.end(stroke);
    host.finish();
    EXPECT_EQ(host.result_of(end.job), FLG_OK);
    const Heard whole = heard_of(host.view_of(end.stylized));
    EXPECT_TRUE(heard_of(host.points(stroke)) == whole);
    EXPECT_EQ(host.tip(stroke).curve_count, 0u) << "an ended stroke has no tip";
    EXPECT_EQ(flgLiveStrokeResume(host.context, stroke), FLG_OK) << flgErrorGetMessage();
    flgCurveSetRelease(host.context, end.stylized);
    flgCurveSetRelease(host.context, end.samples);
    flgJobRelease(host.context, end.job);
    return whole;
}

void expect_tips_are_ends(LiveHost& host, const Samples& samples) {
    const FlgLiveStroke stroke = host.begin();
    size_t tips = 0;
    for (size_t i = 0; i < samples.size(); ++i) {
        host.push(stroke, &samples[i], 1);
        const Heard seen = points_and_tip(host, stroke);
        if (seen.points() > host.info(stroke).point_count) ++tips;
        if (i > 8 && i % 7 != 0) continue;
        ASSERT_TRUE(seen == ended(host, stroke)) << "after " << i + 1 << " samples";
    }
    EXPECT_GT(tips, samples.size() / 2);
}

TEST(LiveTip, WithThePointsSoFarItIsWhatTheEndGives) {
    for (uint32_t workers : {0u, 2u}) {
        LiveHost host(workers);
        expect_tips_are_ends(host, drawn(150));
        for (uint64_t seed : {1u, 2u, 3u}) expect_tips_are_ends(host, scribble(160, seed));
        host.live.smoothing = 0.03f;
        host.live.start = FLG_STYLE_START_RANDOM;
        expect_tips_are_ends(host, scribble(160, 4));
        host.live.frame = FLG_FRAME_METHOD_SUPPLIED;
        expect_tips_are_ends(host, scribble(160, 5));
    }
}

// Times of points count on from the point before, which the tip holds itself.
TEST(LiveTip, HasTheStylesAttributesAndTimes) {
    LiveHost host;
    Curves curves = coil(256, 8, 4, 0.2);
    std::vector<float> speeds, radii;
    for (int i = 0; i < 256; ++i) {
        speeds.push_back(1 + 0.5f * std::sin(0.1f * static_cast<float>(i)));
        radii.push_back(0.01f + 0.0001f * static_cast<float>(i));
    }
    FlgCurveSetView view = curves.view();
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, curves.positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0},
                                 {FLG_ATTRIBUTE_SPEED, 1, speeds.data(), 0, 0}};
    view.columns = columns;
    view.column_count = 3;
    const FlgStyleAttribute attributes[] = {{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 0, 0},
                                            {FLG_ATTRIBUTE_SPEED, FLG_METRIC_AUTO, 0, 0}};
    FlgStyleDesc desc = flgStyleDefaults();
    ASSERT_EQ(flgCurveSetCreate(host.context, &view, &desc.style), FLG_OK) << flgErrorGetMessage();
    desc.attributes = attributes;
    desc.attribute_count = 2;
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &host.style, nullptr), FLG_OK) << flgErrorGetMessage();
    host.warm(0);
    host.live.style = host.style;
    expect_tips_are_ends(host, scribble(160, 6));
}

TEST(LiveTip, LeavesNoTrace) {
    for (uint32_t workers : {0u, 2u}) {
        LiveHost host(workers);
        const Samples samples = scribble(300, 7);
        const FlgLiveStroke plain = host.begin(), watched = host.begin();
        Heard first, second;
        for (size_t i = 0; i < samples.size(); ++i) {
            first.add(host.push(plain, &samples[i], 1));
            const FlgCurveSetView made = host.push(watched, &samples[i], 1);
            host.tip(watched);
            const Heard tip = heard_of(host.tip(watched));
            EXPECT_TRUE(tip == heard_of(host.tip(watched)));
            second.add(made);  // a tip leaves other views
            if (i != 200) continue;
            for (FlgLiveStroke stroke : {plain, watched}) {
                EXPECT_EQ(flgLiveStrokeUndo(host.context, stroke, 20, nullptr), FLG_OK);
                if (stroke.id == watched.id) host.tip(stroke);
                host.push(stroke, &samples[181], 20);
            }
        }
        EXPECT_TRUE(first == second);
        EXPECT_TRUE(heard_of(host.points(plain)) == heard_of(host.points(watched)));
        const LiveHost::Ended a = host.end(plain), b = host.end(watched);
        const Heard tip = heard_of(host.tip(watched));
        EXPECT_GT(tip.points(), 1u) << "seen until the end is published";
        host.finish();
        EXPECT_TRUE(heard_of(host.view_of(a.stylized)) == heard_of(host.view_of(b.stylized)));
        EXPECT_TRUE(host.replay(host.live, b.samples) == heard_of(host.view_of(b.stylized)));
    }
}

TEST(LiveTip, OfAStrokeWithoutLengthIsItsOnePoint) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    EXPECT_EQ(host.tip(stroke).curve_count, 0u);
    const LiveSample sample{{1, 2, 3}, {0, 0, 0, 0}, 0.5f, 0};
    host.push(stroke, &sample, 1);
    const Heard tip = heard_of(host.tip(stroke));
    EXPECT_EQ(tip.of(FLG_ATTRIBUTE_POSITION), (std::vector<float>{1, 2, 3}));
    EXPECT_TRUE(tip == ended(host, stroke));
}

// However far the hand is ahead: the tip is what the end gives, as far as it goes.
TEST(LiveTip, LooksAheadSoFarAndNoFurther) {
    LiveHost host;
    host.live.max_jump = 1e6f;
    host.live.max_points = 100'000;
    const FlgLiveStroke stroke = host.begin();
    Samples samples = drawn(40);
    for (size_t i = 20; i < 40; ++i) samples[i].position[0] += 100;
    size_t longest = 0;
    for (const LiveSample& sample : samples) {
        host.push(stroke, &sample, 1);
        const size_t final_points = host.info(stroke).point_count;
        const Heard seen = points_and_tip(host, stroke);
        longest = std::max(longest, seen.points() - final_points);
        ASSERT_LE(seen.points() - final_points, max_tip_points);
        const Heard whole = ended(host, stroke);
        ASSERT_LE(seen.points(), whole.points());
        if (whole.points() - final_points <= max_tip_points / 2) {
            ASSERT_TRUE(seen == whole);
        }
        for (size_t k = 0; k < seen.columns.size(); ++k) {
            ASSERT_TRUE(std::equal(seen.columns[k].begin(), seen.columns[k].end(), whole.columns[k].begin()));
        }
    }
    EXPECT_EQ(longest, max_tip_points);
}

TEST(LiveTip, EndsWhereTheStrokeIsCut) {
    LiveHost host;
    const Samples samples = drawn(200);
    const FlgLiveStroke whole = host.begin();
    host.push(whole, samples.data(), samples.size());
    // So that the last points that fit are the tip's, then none is left for it.
    for (uint32_t less : {0u, 1u, 5u}) {
        host.live.max_points = host.info(whole).point_count + 1 - less;
        const FlgLiveStroke stroke = host.begin();
        host.push(stroke, samples.data(), samples.size());
        EXPECT_TRUE(points_and_tip(host, stroke) == ended(host, stroke));
    }
}

TEST(LiveTip, AllocatesNothing) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const int64_t calls = host.allocator.calls;
    for (const LiveSample& sample : drawn(1000, 4)) {
        host.push(stroke, &sample, 1);
        host.tip(stroke);
    }
    EXPECT_EQ(host.allocator.calls, calls);
}

TEST(LiveTip, RefusesWhatItCannotWriteTo) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    EXPECT_EQ(flgLiveStrokeGetTip(host.context, stroke, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.struct_size = 1;
    EXPECT_EQ(flgLiveStrokeGetTip(host.context, stroke, &view), FLG_ERROR_INVALID_ARGUMENT);
    view = flgCurveSetViewDefaults();
    view.curve_count = 77;
    expect_failure(flgLiveStrokeGetTip(host.context, {}, &view), FLG_ERROR_INVALID_HANDLE, "stroke is null");
    EXPECT_EQ(view.curve_count, 0u);
}

}  // namespace
}  // namespace flg::test
