// SPDX-License-Identifier: MIT
// Several styles along a stroke that is being drawn, against the batch job and against each alone.
#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

constexpr FlgAttribute user = FLG_ATTRIBUTE_USER;
constexpr FlgAttribute shared_columns[] = {FLG_ATTRIBUTE_POSITION,    FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL,
                                           FLG_ATTRIBUTE_STYLE_INDEX, FLG_ATTRIBUTE_ANGLE,   user};
constexpr float scale = 0.3f;

struct Example {
    double radius;
    uint32_t points;
    bool attributes = false;
    bool caps = false;
};

class LiveSeveralStyles : public testing::Test {
protected:
    FlgStyle learn(const Example& example) {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.point_count = example.points;
        Columns style{coil(400, 12, 6, example.radius)};
        const double radius = example.radius;
        style.with(FLG_ATTRIBUTE_ANGLE, 1, [=](uint32_t i, uint32_t) { return 0.08 * radius * i; });
        style.with(user, 1, [=](uint32_t i, uint32_t) { return radius + i / 400.0; });
        desc.style = style.create(host);
        Curves guide;
        guide.add_point(0, 0, 0);
        guide.add_point(6, 0, 0);
        guide.end_curve();
        desc.guide = host.create(guide);
        const FlgStyleAttribute attributes[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 0, 0},
                                                {user, FLG_METRIC_AUTO, 0, 0}};
        desc.attributes = attributes;
        desc.attribute_count = example.attributes ? 2 : 0;
        if (example.caps) desc.start_cap = desc.end_cap = 2;
        const FlgStyle prepared = prepare(host, desc);
        for (const float temperature : {0.0f, 2.0f}) {
            EXPECT_EQ(flgStyleWarm(host.context, prepared, temperature, nullptr, nullptr), FLG_OK);
        }
        host.finish();
        return prepared;
    }
    void learn_all(const std::vector<Example>& examples) {
        styles.clear();
        for (const Example& example : examples) styles.push_back(learn(example));
        host.live.style = styles[0];
        host.live.further_styles = &styles[1];
        host.live.further_style_count = static_cast<uint32_t>(styles.size() - 1);
        host.live.scale = scale;
        drive({choice});
    }
    void drive(const std::vector<FlgStyleDrive>& wanted) {
        drives = wanted;
        host.live.drives = drives.data();
        host.live.drive_count = static_cast<uint32_t>(drives.size());
    }
    // One style all along.
    void choose(float style) { drive({{FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_STYLE, 0, 1, style, style}}); }
    Heard ended(const Samples& samples) {
        const FlgLiveStroke stroke = host.begin();
        host.push_in_bursts(stroke, samples, {3, 1});
        last = host.end(stroke);
        host.finish();
        return heard_of(host.view_of(last.stylized));
    }
    // Of the samples of the stroke that ended last.
    Heard batch() {
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = host.live.style;
        desc.target = last.samples;
        desc.scale = scale;
        desc.exact_spacing = 1;
        desc.further_styles = host.live.further_styles;
        desc.further_style_count = host.live.further_style_count;
        desc.style_blend = host.live.style_blend;
        desc.drives = host.live.drives;
        desc.drive_count = host.live.drive_count;
        return heard_of(host.view_of(stylize(host, desc)));
    }
    double step(uint32_t style) { return scale * style_info(host, styles[style]).spacing; }

    LiveHost host;
    std::vector<FlgStyle> styles;
    const FlgStyleDrive choice{FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_STYLE, 0, 1, 0, 1};
    std::vector<FlgStyleDrive> drives;
    LiveHost::Ended last;
};

// A straight stroke of 200 samples, pressed from sample `pressed` on.
Samples pressed_from(uint32_t pressed, double length = 3) {
    Samples samples = drawn(200);
    for (uint32_t i = 0; i < samples.size(); ++i) {
        samples[i].position[0] = static_cast<float>(length * i / 199.0);
        samples[i].position[1] = samples[i].position[2] = 0;
        samples[i].pressure = i < pressed ? 0.0f : 1.0f;
    }
    return samples;
}

// Pressure that chooses another style every few samples.
Samples restless() {
    Samples samples = drawn(250);
    for (uint32_t i = 0; i < samples.size(); ++i) samples[i].pressure = (i * i / 7) % 5 < 2 ? 0.1f : 0.9f;
    return samples;
}

TEST_F(LiveSeveralStyles, OneThatIsAloneIsBatch) {
    for (const bool attributes : {false, true}) {
        learn_all({{0.1, 300, attributes}, {0.3, 300, attributes}, {0.2, 150, attributes}});
        for (const float style : {0.0f, 1.0f, 2.0f}) {
            choose(style);
            const Heard live = ended(drawn(250)), expected = batch();
            ASSERT_GT(live.points(), 50u);
            for (const FlgAttribute attribute : shared_columns) {
                if (style == 2) continue;
                const auto &a = live.of(attribute), &b = expected.of(attribute);
                if (attribute != FLG_ATTRIBUTE_NORMAL || !attributes || style == 0) {
                    EXPECT_TRUE(a == b) << attribute;
                    continue;
                }
                // Turned by the angle once, and twice.
                ASSERT_EQ(a.size(), b.size());
                for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 2e-6) << i;
            }
            // What the curve bends within a step of the style with the wider spacing.
            const auto &p = live.of(FLG_ATTRIBUTE_POSITION), &q = expected.of(FLG_ATTRIBUTE_POSITION);
            ASSERT_LE(q.size(), p.size());
            for (size_t i = 0; i + 9 < q.size(); ++i) ASSERT_NEAR(p[i], q[i], 0.05 * step(2)) << style << ", " << i / 3;
        }
    }
}

TEST_F(LiveSeveralStyles, OneThatIsAloneIsItself) {
    learn_all({{0.1, 300, true}, {0.3, 300, true}});
    choose(1);
    const Heard mixed = ended(drawn(250));
    host.live.style = styles[1];
    host.live.further_style_count = host.live.drive_count = 0;
    const Heard alone = ended(drawn(250));
    const auto points = static_cast<float>(style_info(host, styles[0]).point_count);
    for (size_t k = 0; k < alone.columns.size(); ++k) {
        if (alone.attributes[k] != FLG_ATTRIBUTE_STYLE_INDEX) {
            EXPECT_TRUE(mixed.columns[k] == alone.columns[k]) << alone.attributes[k];
            continue;
        }
        for (size_t i = 0; i < alone.points(); ++i) ASSERT_EQ(mixed.columns[k][i], points + alone.columns[k][i]);
    }
}

// It begins where the choice changes; before and behind it live is batch.
TEST_F(LiveSeveralStyles, OneTurnsIntoTheNextBehindTheChange) {
    learn_all({{0.1, 300}, {0.3, 300}});
    const double blend = 0.5, change = 3 * 79.5 / 199;
    host.live.style_blend = static_cast<float>(blend);
    choose(0);
    const Heard first = ended(pressed_from(80));
    choose(1);
    const Heard second = ended(pressed_from(80));
    drive({choice});
    const Heard mixed = ended(pressed_from(80)), expected = batch();
    ASSERT_EQ(mixed.points(), first.points());
    ASSERT_EQ(mixed.points(), expected.points());
    const float points = static_cast<float>(style_info(host, styles[0]).point_count);
    for (size_t i = 0; i < mixed.points(); ++i) {
        const double s = step(0) * static_cast<double>(i);
        const double r = std::clamp((s - change) / blend, 0.0, 1.0), weight = r * r * (3 - 2 * r);
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double wanted =
                (1 - weight) * first.of(FLG_ATTRIBUTE_POSITION)[c] + weight * second.of(FLG_ATTRIBUTE_POSITION)[c];
            ASSERT_NEAR(mixed.of(FLG_ATTRIBUTE_POSITION)[c], wanted, 1e-5) << i;
        }
        if (s < change - 0.51 * blend || s > change + 1.01 * blend) {
            for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
                ASSERT_EQ(mixed.of(FLG_ATTRIBUTE_POSITION)[c], expected.of(FLG_ATTRIBUTE_POSITION)[c]) << i;
            }
        }
        const float index = mixed.of(FLG_ATTRIBUTE_STYLE_INDEX)[i];
        if (weight < 0.49) {
            EXPECT_LT(index, points);
        }
        if (weight > 0.51) {
            EXPECT_GE(index, points);
        }
    }
}

// However often the choice changes, results have neither steps nor corners that the styles don't have.
TEST_F(LiveSeveralStyles, RestlessHandsMakeNoSteps) {
    learn_all({{0.1, 300}, {0.3, 300}, {0.2, 120}});
    drive({{FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_STYLE, 0, 1, 0, 2}});
    const auto sharpest = [](const Heard& heard) {
        const auto& p = heard.of(FLG_ATTRIBUTE_POSITION);
        double bend = 0;
        for (size_t i = 3; i + 3 < p.size(); ++i) {
            bend = std::max(bend, std::abs(double{p[i - 3]} - 2.0 * p[i] + p[i + 3]));
        }
        return bend;
    };
    double usual = 0;
    const Heard mixed = ended(restless());
    for (const float style : {0.0f, 1.0f, 2.0f}) {
        choose(style);
        usual = std::max(usual, sharpest(ended(restless())));
    }
    EXPECT_LT(sharpest(mixed), 1.5 * usual);
}

TEST_F(LiveSeveralStyles, PushesUndoTipEndAndReplayAgree) {
    learn_all({{0.1, 300, true}, {0.3, 300, true}, {0.2, 130, true}});
    drive({{FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_STYLE, 0, 1, 0, 2},
           {FLG_ATTRIBUTE_SPEED, FLG_STYLE_DRIVEN_SCALE, 0.5f, 2, 1.2f, 0.7f},
           {FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 2}});
    const Samples samples = restless();
    const FlgLiveStroke once = host.begin(), bursts = host.begin();
    const Heard pushed = host.push_in_bursts(once, samples, {1});
    host.push_in_bursts(bursts, samples, {7, 2});
    EXPECT_TRUE(pushed == heard_of(host.points(bursts)));
    const Heard tip = heard_of(host.tip(once));
    for (const uint32_t undone : {31u, 250u}) {
        ASSERT_EQ(flgLiveStrokeUndo(host.context, bursts, undone, nullptr), FLG_OK);
        host.push(bursts, samples.data() + samples.size() - undone, undone);
        EXPECT_TRUE(pushed == heard_of(host.points(bursts)));
        EXPECT_TRUE(tip == heard_of(host.tip(bursts)));
    }
    const LiveHost::Ended ended = host.end(once);
    EXPECT_TRUE(tip == heard_of(host.tip(once)));
    host.finish();
    const Heard whole = heard_of(host.view_of(ended.stylized));
    for (size_t k = 0; k < whole.columns.size(); ++k) {
        const size_t width = whole.columns[k].size() / whole.points();
        std::vector<float> expected = pushed.columns[k];
        expected.insert(expected.end(), tip.columns[k].begin() + static_cast<ptrdiff_t>(width), tip.columns[k].end());
        EXPECT_TRUE(whole.columns[k] == expected) << whole.attributes[k];
    }
    EXPECT_TRUE(whole == host.replay(host.live, ended.samples));
    ASSERT_EQ(flgLiveStrokeResume(host.context, once), FLG_OK);
    EXPECT_TRUE(pushed == heard_of(host.points(once)));
    EXPECT_TRUE(tip == heard_of(host.tip(once)));
}

TEST_F(LiveSeveralStyles, EndCapsAreBatch) {
    learn_all({{0.1, 300, false, true}, {0.3, 300, false, true}});
    host.live.end_cap = 1;
    for (const float style : {0.0f, 1.0f}) {
        choose(style);
        const Heard live = ended(pressed_from(80)), expected = batch();
        for (const FlgAttribute attribute : shared_columns) {
            EXPECT_TRUE(live.of(attribute) == expected.of(attribute)) << attribute;
        }
        const float points = static_cast<float>(style_info(host, styles[0]).point_count);
        EXPECT_EQ(live.of(FLG_ATTRIBUTE_STYLE_INDEX).back(), (1 + style) * points - 1);
        EXPECT_TRUE(live == host.replay(host.live, last.samples));
    }
}

TEST_F(LiveSeveralStyles, AStrokeWithoutLengthIsAPoint) {
    learn_all({{0.1, 300, true}, {0.3, 120, true}});
    EXPECT_EQ(ended(Samples(3, drawn(2)[0])).points(), 1u);
}

TEST_F(LiveSeveralStyles, PushesTakeNoMemory) {
    learn_all({{0.1, 300, true}, {0.3, 120, true}});
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = restless();
    const int64_t calls = host.allocator.calls;
    for (const LiveSample& sample : samples) host.push(stroke, &sample, 1);
    host.tip(stroke);
    EXPECT_EQ(host.allocator.calls, calls);
}

TEST_F(LiveSeveralStyles, Refusals) {
    learn_all({{0.1, 300}, {0.3, 300}});
    const auto refused = [&](FlgResult result, const char* words) {
        FlgLiveStroke stroke{};
        expect_failure(flgLiveStrokeBegin(host.context, &host.live, &stroke), result, words);
    };
    host.live.style_blend = -1;
    refused(FLG_ERROR_INVALID_ARGUMENT, "desc.style_blend");
    host.live.style_blend = 0;
    host.live.further_style_count = 8;
    refused(FLG_ERROR_INVALID_ARGUMENT, "desc.further_style_count");
    host.live.further_style_count = 0;
    refused(FLG_ERROR_INVALID_ARGUMENT, "one of desc.drives drives the style");
    host.live.further_style_count = 1;
    host.live.drive_count = 0;
    refused(FLG_ERROR_INVALID_ARGUMENT, "none of desc.drives drives the style");
    host.live.drive_count = 1;
    host.live.further_styles = nullptr;
    refused(FLG_ERROR_INVALID_ARGUMENT, "desc.further_styles");
    const FlgStyle other = learn({0.2, 300, true});
    host.live.further_styles = &other;
    refused(FLG_ERROR_INVALID_ARGUMENT, "desc.further_styles[0] transfers other attributes");
    host.live.further_styles = &styles[1];
    host.live.temperature = 1;
    ASSERT_EQ(flgStyleWarm(host.context, styles[0], 1, nullptr, nullptr), FLG_OK);
    host.finish();
    refused(FLG_NOT_READY, "desc.further_styles[0] is not warm");
}

}  // namespace
}  // namespace flg::test
