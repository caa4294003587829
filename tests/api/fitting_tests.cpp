// SPDX-License-Identifier: MIT
// Ends of stylized strokes: caps, whole motifs, targets too short for either.
#include <array>

#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

// Waves along x, with a flourish of another kind in front of them and behind them, each a tenth of the whole.
Curves flourished(double front = 1, double back = 1) {
    Curves curves;
    for (uint32_t i = 0; i <= 1000; ++i) {
        const double x = 0.01 * i;
        const double wave = 0.1 * std::sin(8 * M_PI * x);
        const double in_front = x < 1 ? front * std::pow(std::sin(M_PI * x), 2) : 0;
        const double behind = x > 9 ? back * std::pow(std::sin(M_PI * x), 2) : 0;
        curves.add_point(x, wave + 0.25 * in_front, 0.25 * behind);
    }
    curves.end_curve();
    return curves;
}

// Waves each of which is 1.6 times as long as the one before: nothing repeats.
Curves chirp() {
    Curves curves;
    for (uint32_t i = 0; i <= 1000; ++i) {
        const double x = 0.01 * i;
        curves.add_point(x, 0.1 * std::sin(2 * M_PI * std::log(1 + x) / std::log(1.6)), 0);
    }
    curves.end_curve();
    return curves;
}

// So many round loops along x, then an arrow's head: two barbs about a tip.
Curves arrow(uint32_t loops, bool with_head) {
    Curves curves;
    const double length = 0.1 * loops;
    for (uint32_t i = 0; i <= 60 * loops; ++i) {
        const double turn = 2 * M_PI * i / 60;
        curves.add_point(length * i / (60 * loops) + 0.04 * std::sin(turn), 0.04 * std::cos(turn), 0);
    }
    const std::array<std::array<double, 2>, 4> head = {
        {{length, 0.04}, {length + 0.2, 0.04}, {length + 0.1, 0.12}, {length + 0.2, 0.04}}};
    for (size_t k = 0; with_head && k + 1 < head.size(); ++k) {
        for (int i = 1; i <= 20; ++i) {
            const double t = i / 20.0;
            curves.add_point(head[k][0] + t * (head[k + 1][0] - head[k][0]),
                             head[k][1] + t * (head[k + 1][1] - head[k][1]), 0);
        }
    }
    curves.end_curve();
    return curves;
}

// A straight guide, so that the style is all of it.
Curves axis() {
    Curves curves;
    curves.add_point(0, 0, 0);
    curves.add_point(10, 0, 0);
    curves.end_curve();
    return curves;
}

Curves line(double length) {
    Curves curves;
    curves.add_point(0, 0, 0);
    curves.add_point(length, 0, 0);
    curves.end_curve();
    return curves;
}

class Fitting : public testing::Test {
protected:
    void learn(float start_cap, float end_cap) { learn(flourished(), start_cap, end_cap); }
    void learn(Curves example, float start_cap, float end_cap) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(std::move(example));
        style.guide = host.create(axis());
        style.start_cap = start_cap;
        style.end_cap = end_cap;
        desc.style = prepare(host, style);
        desc.keep_displacement = 1;
        info = style_info(host, desc.style);
    }
    Heard along(Curves target) {
        desc.target = host.create(std::move(target));
        return heard_of(host.view_of(stylize(host, desc)));
    }
    std::vector<float> indices(double length) { return along(line(length)).of(FLG_ATTRIBUTE_STYLE_INDEX); }

    // The caps once, at the ends, and nowhere else.
    void expect_caps(const std::vector<float>& index) const {
        const size_t start = info.start_cap_points, end = info.end_cap_points, points = info.point_count;
        ASSERT_GE(index.size(), start + end);
        for (size_t i = 0; i < index.size(); ++i) {
            if (i < start) {
                ASSERT_EQ(index[i], static_cast<float>(i));
            } else if (i >= index.size() - end) {
                ASSERT_EQ(index[i], static_cast<float>(points - (index.size() - i))) << i;
            } else {
                ASSERT_GE(index[i], static_cast<float>(start)) << i;
                ASSERT_LT(index[i], static_cast<float>(points - end)) << i;
            }
        }
    }

    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    FlgStyleInfo info{};
};

TEST_F(Fitting, StrokesBeginAndEndWithTheMarkedCaps) {
    learn(1.2f, 0.8f);
    EXPECT_GT(info.start_cap_points, info.end_cap_points);
    EXPECT_GT(info.end_cap_points, info.point_count / 30);
    for (const float temperature : {0.0f, 1.0f}) {
        desc.temperature = temperature;
        for (const auto start : {FLG_STYLE_START_STYLE, FLG_STYLE_START_RANDOM}) {
            desc.start = start;
            for (const double length : {3.0, 7.0, 10.0, 45.0}) expect_caps(indices(length));
        }
    }
}

TEST_F(Fitting, EitherCapCanBeMissing) {
    learn(1.2f, 0);
    EXPECT_EQ(info.end_cap_points, 0u);
    expect_caps(indices(30));
    learn(0, 0.8f);
    EXPECT_EQ(info.start_cap_points, 0u);
    expect_caps(indices(30));
    expect_caps(indices(0.5));
}

TEST_F(Fitting, CapsAreFoundWhereNothingRepeats) {
    learn(-1, -1);
    // The flourishes are a tenth of the example each; what is nearer to the waves than a patch is open to doubt.
    const double tenth = info.point_count / 10.0;
    EXPECT_NEAR(info.start_cap_points, tenth, 0.5 * tenth);
    EXPECT_NEAR(info.end_cap_points, tenth, 0.5 * tenth);
    expect_caps(indices(30));
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(flourished(0, 0));
    style.guide = host.create(axis());
    style.start_cap = style.end_cap = -1;
    const FlgStyleInfo plain = style_info(host, prepare(host, style));
    EXPECT_EQ(plain.start_cap_points, 0u);
    EXPECT_EQ(plain.end_cap_points, 0u);
}

// Both caps, in proportion: along the target and away from it.
TEST_F(Fitting, ShortTargetsGetSmallCaps) {
    learn(1.2f, 0.8f);
    const std::vector<float> whole = along(line(3)).of(FLG_ATTRIBUTE_DISPLACEMENT);
    const double needed = info.spacing * (info.start_cap_points + info.end_cap_points);
    for (const double share : {0.5, 0.1}) {
        const Heard small = along(line(share * needed));
        const auto& index = small.of(FLG_ATTRIBUTE_STYLE_INDEX);
        expect_caps(index);
        for (size_t i = 0; i < 3 * size_t{info.start_cap_points}; ++i) {
            EXPECT_NEAR(small.of(FLG_ATTRIBUTE_DISPLACEMENT)[i], share * whole[i], 0.01) << i;
        }
    }
}

TEST_F(Fitting, ClosedTargetsHaveNoCaps) {
    learn(1.2f, 0.8f);
    Curves circle;
    for (int i = 0; i < 60; ++i) circle.add_point(5 * std::cos(0.1 * i), 5 * std::sin(0.1 * i), 0);
    circle.end_curve(FLG_CURVE_CLOSED);
    const Heard around = along(circle);
    for (const float index : around.of(FLG_ATTRIBUTE_STYLE_INDEX)) {
        EXPECT_GE(index, static_cast<float>(info.start_cap_points));
        EXPECT_LT(index, static_cast<float>(info.point_count - info.end_cap_points));
    }
}

TEST_F(Fitting, CapsGoWithTheStylesData) {
    learn(1.2f, 0.8f);
    const std::vector<float> before = indices(12);
    size_t size = 0;
    ASSERT_EQ(flgStyleGetData(host.context, desc.style, nullptr, 0, &size), FLG_OK);
    std::vector<char> bytes(size);
    ASSERT_EQ(flgStyleGetData(host.context, desc.style, bytes.data(), size, &size), FLG_OK);
    ASSERT_EQ(flgStyleCreateFromData(host.context, bytes.data(), size, &desc.style), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(style_info(host, desc.style).start_cap_points, info.start_cap_points);
    EXPECT_EQ(style_info(host, desc.style).end_cap_points, info.end_cap_points);
    EXPECT_EQ(indices(12), before);
}

// Motif after motif, whatever the length: the number of them that is nearest, and nothing skipped.
TEST_F(Fitting, WholeMotifsFillTheLength) {
    desc.fit = 1;
    learn(0, 0);
    const auto points = static_cast<float>(info.point_count);
    for (const double motifs : {0.1, 0.7, 1.0, 1.4, 2.6, 7.3}) {
        const std::vector<float> index = indices(motifs * info.guide_length);
        const double whole = std::max(std::floor(motifs + 0.5), 1.0);
        EXPECT_EQ(static_cast<double>(index.size()), whole * (points - 1) + 1) << motifs;
        EXPECT_EQ(index.front(), 0);
        EXPECT_EQ(index.back(), points - 1);
        for (size_t i = 1; i < index.size(); ++i) {
            ASSERT_TRUE(index[i] == index[i - 1] + 1 || (index[i] == 0 && index[i - 1] == points - 2)) << i;
        }
    }
}

// Sizes that the SDK chooses: a line gets the example's proportion, and so one motif, however long it is.
TEST_F(Fitting, EachCurveIsFittedInItsOwnSize) {
    desc.fit = 1;
    desc.scale = 0;
    learn(0, 0);
    for (const double length : {0.3, 4.0, 50.0}) {
        const std::vector<float> index = indices(length);
        ASSERT_EQ(index.size(), size_t{info.point_count}) << length;
        for (size_t i = 0; i < index.size(); ++i) ASSERT_EQ(index[i], static_cast<float>(i)) << i;
    }
}

// Of an example that repeats nothing.
TEST_F(Fitting, FitChoosesBetweenStretchingAndCopying) {
    learn(chirp(), 1.2f, 0.8f);
    const double motif = info.point_count - info.start_cap_points - info.end_cap_points - 1;
    const double caps = info.start_cap_points + info.end_cap_points;
    for (const double motifs : {0.8, 1.3, 2.4}) {
        for (const float fit : {0.01f, 0.5f, 1.0f}) {
            desc.fit = fit;
            const double whole = std::max(std::floor(motifs + 0.5), 1.0);
            const std::vector<float> index = indices((motifs * motif + caps) * info.spacing);
            expect_caps(index);
            const double steps = caps + whole * motif * std::pow(motifs / whole, 1 - double{fit});
            EXPECT_NEAR(static_cast<double>(index.size()) - 1, steps, 1.5) << motifs << " " << fit;
            size_t jumps = 0;
            for (size_t i = 1; i < index.size(); ++i) jumps += index[i] != index[i - 1] + 1;
            // One into each further motif; one for what is left over, in a motif that was begun for it.
            EXPECT_LE(jumps, static_cast<size_t>(whole - 1 + (fit < 1 ? 2 : 0)));
        }
    }
}

// A chain ends with a link: as many as come nearest, whatever `fit`, and no jump inside of one.
TEST_F(Fitting, MotifsAreTheExamplesRepetitions) {
    const double wave = 0.25;
    for (const bool capped : {false, true}) {
        if (capped) {
            learn(1.0f, 1.0f);
        } else {
            learn(flourished(0, 0), 0, 0);
        }
        const double caps = info.start_cap_points + info.end_cap_points;
        for (const float fit : {0.02f, 0.5f, 1.0f}) {
            desc.fit = fit;
            for (const double length : {3.1, 4.3, 12.4, 31.0}) {
                SCOPED_TRACE(testing::Message() << length << " m, fit " << fit << (capped ? ", capped" : ""));
                const std::vector<float> index = indices(length);
                const double steps = static_cast<double>(index.size()) - 1, points = wave / info.spacing;
                EXPECT_NEAR(steps * info.spacing, length, 0.6 * wave);
                if (capped) {
                    expect_caps(index);
                } else {
                    EXPECT_NEAR(std::remainder((steps - caps) / points, 1), 0, 0.1);
                }
                for (size_t i = 1; i < index.size(); ++i) {
                    const double leap = index[i] - index[i - 1] - 1;
                    // Nodes lie a little otherwise on each wave.
                    EXPECT_NEAR(std::remainder(leap / points, 1), 0, 0.2) << i;
                }
            }
        }
    }
}

TEST_F(Fitting, EqualSidesHaveEqualMotifs) {
    learn(flourished(0, 0), 0, 0);
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    Curves square;
    for (const auto& p : {std::array{0.0, 0.0}, {3.1, 0.0}, {3.1, 3.1}, {0.0, 3.1}}) square.add_point(p[0], p[1], 0);
    square.end_curve(FLG_CURVE_CLOSED);
    const Heard heard = along(square);
    const auto& index = heard.of(FLG_ATTRIBUTE_STYLE_INDEX);
    const size_t side = index.size() / 4;
    ASSERT_EQ(index.size() % 4, 0u);
    EXPECT_NEAR(static_cast<double>(side) * info.spacing, 3.1, 0.13);
    for (size_t i = 0; i < index.size(); ++i) ASSERT_EQ(index[i], index[i % side]) << i;
}

// What is marked as a cap doesn't bend the guide of the rest, and is copied as it is drawn.
TEST_F(Fitting, CapsAreDrawnOverAStraightGuide) {
    FlgStyleDesc style = flgStyleDefaults();
    const double head = 0.2 + 2 * std::hypot(0.1, 0.08);
    style.style = host.create(arrow(10, true));
    style.end_cap = static_cast<float>(head);
    desc.style = prepare(host, style);
    info = style_info(host, desc.style);
    FlgCurveSet guide{};
    ASSERT_EQ(flgStyleGetGuide(host.context, desc.style, &guide), FLG_OK);
    const Heard nodes = heard_of(host.view_of(guide));
    const auto& at = nodes.of(FLG_ATTRIBUTE_POSITION);
    // Its direction along the last loops and the head is the axis'.
    for (size_t i = nodes.points() / 2; i + 1 < nodes.points(); ++i) {
        const double x = at[3 * i + 3] - at[3 * i], y = at[3 * i + 4] - at[3 * i + 1];
        EXPECT_LT(std::abs(y), 0.2 * x) << i;
    }
    desc.keep_displacement = 1;
    const Heard along_line = along(line(2));
    expect_caps(along_line.of(FLG_ATTRIBUTE_STYLE_INDEX));
    // The tip and the far end of the barb, as far apart as they are drawn.
    const auto& p = along_line.of(FLG_ATTRIBUTE_POSITION);
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = along_line.points() - info.end_cap_points; i < along_line.points(); ++i) {
        const double across = std::hypot(p[3 * i + 1], p[3 * i + 2]);
        low = std::min(low, across);
        high = std::max(high, across);
    }
    EXPECT_NEAR(high, 0.12, 0.02);
    EXPECT_LT(low, 0.05);
}

// Smaller in all directions, as long as the target is.
TEST_F(Fitting, ATargetShorterThanAPatchGetsASmallMotif) {
    desc.fit = 0.01f;
    learn(0, 0);
    const std::vector<float> whole = along(line(info.guide_length)).of(FLG_ATTRIBUTE_DISPLACEMENT);
    const double share = 0.01;
    const Heard small = along(line(share * info.guide_length));
    ASSERT_EQ(small.points(), size_t{info.point_count});
    for (size_t i = 0; i < whole.size(); ++i) {
        EXPECT_NEAR(small.of(FLG_ATTRIBUTE_DISPLACEMENT)[i], share * whole[i], 1e-5) << i;
    }
}

// A style with a start cap alone: live is batch.
TEST(LiveFitting, StrokesBeginWithTheStartCap) {
    LiveHost host;
    FlgStyleDesc style = flgStyleDefaults();
    style.point_count = 256;
    style.style = host.create(coil());
    style.start_cap = 2;
    host.style = host.live.style = prepare(host, style);
    host.warm(0);
    const uint32_t cap = style_info(host, host.style).start_cap_points;
    ASSERT_GT(cap, 5u);
    const FlgLiveStroke stroke = host.begin();
    host.push_in_bursts(stroke, drawn(250), {3, 1});
    const LiveHost::Ended ended = host.end(stroke);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.style;
    desc.target = ended.samples;
    desc.scale = host.live.scale;
    desc.exact_spacing = 1;
    const Heard batch = heard_of(host.view_of(stylize(host, desc)));
    const Heard live = heard_of(host.view_of(ended.stylized));
    for (uint32_t i = 0; i < cap; ++i) {
        ASSERT_EQ(live.of(FLG_ATTRIBUTE_STYLE_INDEX)[i], static_cast<float>(i));
    }
    EXPECT_TRUE(live.of(FLG_ATTRIBUTE_STYLE_INDEX) == batch.of(FLG_ATTRIBUTE_STYLE_INDEX));
    EXPECT_TRUE(live.of(FLG_ATTRIBUTE_POSITION) == batch.of(FLG_ATTRIBUTE_POSITION));
}

// With an end cap: what was drawn stays, what the end makes is the batch job's.
TEST(LiveFitting, EndedStrokesEndWithTheEndCap) {
    for (const double start_cap : {0.0, 2.0}) {
        for (const uint32_t samples : {60u, 250u}) {
            LiveHost host;
            FlgStyleDesc style = flgStyleDefaults();
            style.point_count = 256;
            style.style = host.create(coil());
            style.start_cap = static_cast<float>(start_cap);
            style.end_cap = 3;
            host.style = host.live.style = prepare(host, style);
            host.warm(0.5f);
            host.live.temperature = 0.5f;
            const FlgStyleInfo info = style_info(host, host.style);
            ASSERT_GT(info.end_cap_points, 5u);
            const FlgLiveStroke plain = host.begin();
            host.push_in_bursts(plain, drawn(samples), {3, 1});
            const LiveHost::Ended without = host.end(plain);
            host.live.end_cap = 1;
            const FlgLiveStroke stroke = host.begin();
            host.push_in_bursts(stroke, drawn(samples), {3, 1});
            const LiveHost::Ended ended = host.end(stroke);
            FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
            desc.style = host.style;
            desc.target = ended.samples;
            desc.scale = host.live.scale;
            desc.temperature = 0.5f;
            desc.exact_spacing = 1;
            const Heard batch = heard_of(host.view_of(stylize(host, desc)));
            const Heard live = heard_of(host.view_of(ended.stylized));
            for (const FlgAttribute column :
                 {FLG_ATTRIBUTE_STYLE_INDEX, FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL}) {
                EXPECT_TRUE(live.of(column) == batch.of(column)) << samples << " samples, column " << column;
            }
            EXPECT_EQ(live.of(FLG_ATTRIBUTE_STYLE_INDEX).back(), static_cast<float>(info.point_count - 1));
            // The stroke itself is as it was drawn.
            const Heard drawn_points = heard_of(host.view_of(without.stylized));
            FlgCurveSetView points = flgCurveSetViewDefaults();
            ASSERT_EQ(flgLiveStrokeGetPoints(host.context, stroke, &points), FLG_OK);
            EXPECT_TRUE(heard_of(points) == drawn_points);
            EXPECT_FALSE(live == drawn_points);
            // So are the hand's radii and times.
            EXPECT_TRUE(live.of(FLG_ATTRIBUTE_RADIUS) == drawn_points.of(FLG_ATTRIBUTE_RADIUS));
            EXPECT_TRUE(live.of(FLG_ATTRIBUTE_TIME) == drawn_points.of(FLG_ATTRIBUTE_TIME));
            // Recorded samples give it again.
            FlgCurveSet replayed{};
            FlgJob job{};
            ASSERT_EQ(flgLiveStrokeReplay(host.context, &host.live, ended.samples, nullptr, &replayed, &job), FLG_OK)
                << flgErrorGetMessage();
            host.finish();
            ASSERT_EQ(host.result_of(job), FLG_OK);
            EXPECT_TRUE(heard_of(host.view_of(replayed)) == live);
        }
    }
}

TEST_F(Fitting, Refusals) {
    learn(0, 0);
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(flourished());
    style.start_cap = style.end_cap = 12;
    expect_failing_job(host, style, FLG_ERROR_INVALID_ARGUMENT, "m long, is too short for two patches");
    style.start_cap = NAN;
    FlgStyle none{};
    expect_failure(flgStyleCreate(host.context, &style, &none, nullptr), FLG_ERROR_INVALID_ARGUMENT, "desc.start_cap");
    FlgCurveSet out{};
    desc.target = host.create(line(3));
    desc.fit = 1.5f;
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, "desc.fit");
    desc.fit = 0.5f;
    desc.exact_spacing = 1;
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, "desc.fit");
}

}  // namespace
}  // namespace flg::test
