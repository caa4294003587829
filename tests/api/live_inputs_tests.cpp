// SPDX-License-Identifier: MIT
// Each bad or odd input has a stated behaviour.
#include "api/live_inputs.h"

namespace flg::test {
namespace {

constexpr FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;

// A burst in the middle of a stroke that is refused whole, one by one from the bad sample on, and leaves no trace.
void expect_refused(LiveHost& host, const std::function<void(Samples&)>& spoil, FlgResult expected, const char* words) {
    const Samples good = drawn(60);
    Samples bad(good.begin() + 20, good.begin() + 40);
    spoil(bad);
    const FlgLiveStroke stroke = host.begin();
    Heard heard;
    heard.add(host.push(stroke, good.data(), 20));
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 77;
    expect_failure(push_samples(host.context, stroke, bad.data(), 20, &view), expected, words);
    EXPECT_EQ(view.curve_count, 0u);
    EXPECT_EQ(host.info(stroke).sample_count, 20u);
    heard.add(host.push(stroke, good.data() + 20, 40));
    EXPECT_TRUE(heard == host.push_in_bursts(host.begin(), good, {60})) << words;
}

TEST(LiveStrokeInput, BadSamplesAreRefusedAndTheStrokeGoesOn) {
    LiveHost host;
    expect_refused(
        host, [](Samples& s) { s[5].position[1] = NAN; }, invalid, "samples.positions[5] holds nan");
    expect_refused(
        host, [](Samples& s) { s[0].position[2] = INFINITY; }, invalid, "samples.positions[0] holds inf");
    expect_refused(
        host, [](Samples& s) { s[19].position[0] = 2e30f; }, invalid, "samples.positions[19] holds 2e+30");
    expect_refused(
        host, [](Samples& s) { s[3].orientation[3] = NAN; }, invalid, "samples.orientations[3] holds nan");
    expect_refused(
        host, [](Samples& s) { s[4].pressure = 1.5f; }, invalid, "samples.pressures[4] is 1.5");
    expect_refused(
        host, [](Samples& s) { s[4].pressure = 1.0000001f; }, invalid, "samples.pressures[4] is 1.0000001, must");
    expect_refused(
        host, [](Samples& s) { s[4].pressure = -0.5f; }, invalid, "samples.pressures[4] is -0.5");
    expect_refused(
        host, [](Samples& s) { s[4].pressure = NAN; }, invalid, "samples.pressures[4] is nan");
    expect_refused(
        host, [](Samples& s) { s[7].time = NAN; }, invalid, "samples.times[7] is nan");
    expect_refused(
        host, [](Samples& s) { std::swap(s[7].time, s[8].time); }, invalid, "samples.times[8] is 1001.1");
    expect_refused(
        host, [](Samples& s) { s[0].time -= 1; }, invalid, "samples.times[0] is 999");
}

TEST(LiveStrokeInput, TeleportsAreRefused) {
    LiveHost host;
    for (float metres : {1.1f, 5000.0f, 1e12f}) {
        expect_refused(
            host, [&](Samples& s) { s[6].position[0] += metres; }, FLG_ERROR_LIMIT, "max_jump is 1 m");
    }
    expect_refused(
        host, [](Samples& s) { s[0].position[0] += 5000; }, FLG_ERROR_LIMIT, "samples.positions[0] is 50");
    expect_refused(
        host, [](Samples& s) { s[0].position[0] = 1e30f; }, FLG_ERROR_LIMIT, "max_jump is 1 m");
}

constexpr uint32_t most_points = 1024;  // of a push of one sample

// A way of less than three times as many points as a push makes is caught up with in three samples, and the stroke says
// how far it is behind.
TEST(LiveStrokeInput, AStrokeThatIsBehindSaysSoAndCatchesUp) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    Samples samples = drawn(24);
    host.push(stroke, samples.data(), 10);
    EXPECT_EQ(host.info(stroke).dense_samples, 0u);
    EXPECT_EQ(host.info(stroke).waiting_points, 0u);
    const float step = host.info(stroke).spacing;

    LiveHost other;
    other.live.max_points = 100'000;
    other.live.max_jump = 1e6f;
    for (size_t i = 10; i < 24; ++i) samples[i].position[0] += 2900 * step;
    const FlgLiveStroke jumping = other.begin();
    other.push(jumping, samples.data(), 12);
    const uint32_t waiting = other.info(jumping).waiting_points;
    EXPECT_NEAR(waiting, 2900.0 - most_points, 60.0);
    other.push(jumping, samples.data() + 12, 1);
    EXPECT_NEAR(other.info(jumping).waiting_points, static_cast<double>(waiting) - most_points, 60.0);
    other.push(jumping, samples.data() + 13, 2);
    EXPECT_EQ(other.info(jumping).waiting_points, 0u);
    EXPECT_EQ(other.info(jumping).waiting_samples, 0u);
    EXPECT_EQ(other.info(jumping).dense_samples, 1u);
    ASSERT_EQ(flgLiveStrokeUndo(other.context, jumping, 6, nullptr), FLG_OK);
    EXPECT_EQ(other.info(jumping).dense_samples, 0u);
}

// Long ways that are allowed are followed in slices, by the samples after them, and by the end's job.
TEST(LiveStrokeInput, WorkOfAPushIsBounded) {
    LiveHost host;
    host.live.max_jump = 1e6f;
    host.live.max_points = 1'000'000;
    const FlgLiveStroke stroke = host.begin();
    Samples samples = drawn(40);
    for (size_t i = 20; i < 40; ++i) samples[i].position[0] += 1000;
    uint32_t before = 0;
    for (const LiveSample& sample : samples) {
        host.push(stroke, &sample, 1);
        const uint32_t points = host.info(stroke).point_count;
        EXPECT_LE(points - before, most_points);
        before = points;
    }
    EXPECT_GT(host.info(stroke).waiting_samples, 10u);
    EXPECT_GT(before, 18u * most_points);
    const LiveHost::Ended ended = host.end(stroke);
    host.finish(100);
    EXPECT_EQ(host.info(stroke).waiting_samples, 0u);
    const Heard live = heard_of(host.view_of(ended.stylized));
    EXPECT_GT(live.points(), static_cast<size_t>(1000 / host.info(stroke).spacing));
    EXPECT_TRUE(host.replay(host.live, ended.samples) == live);
    // Undone while much is waiting, the state is the same too.
    const FlgLiveStroke other = host.begin();
    host.push(other, samples.data(), 40);
    const Heard all = heard_of(host.points(other));
    ASSERT_EQ(flgLiveStrokeUndo(host.context, other, 11, nullptr), FLG_OK);
    host.push(other, samples.data() + 29, 11);
    EXPECT_TRUE(heard_of(host.points(other)) == all);
}

// A style so fine that every sample makes more points than a push delivers: nothing is lost and nothing moves.
TEST(LiveStrokeInput, WhatIsDueIsDeliveredInOrderAtAnyScale) {
    LiveHost host;
    host.live.scale = 0.0002f;
    host.live.max_points = 1u << 21;
    const Samples samples = drawn(120);
    const FlgLiveStroke stroke = host.begin();
    Heard heard;
    for (const LiveSample& sample : samples) {
        const size_t before = heard.points();
        heard.add(host.push(stroke, &sample, 1));
        ASSERT_LE(heard.points() - before, most_points);
    }
    EXPECT_GT(host.info(stroke).waiting_samples, 10u);
    EXPECT_TRUE(host.push_in_bursts(host.begin(), samples, {120}) == heard);
    EXPECT_TRUE(host.push_in_bursts(host.begin(), samples, {17, 2}) == heard);
    const LiveHost::Ended ended = host.end(stroke);
    host.finish(100);
    const Heard whole = heard_of(host.view_of(ended.stylized));
    EXPECT_GT(whole.points(), 2 * heard.points());
    for (size_t k = 0; k < whole.columns.size(); ++k) {
        EXPECT_TRUE(std::equal(heard.columns[k].begin(), heard.columns[k].end(), whole.columns[k].begin()));
    }
    EXPECT_TRUE(host.replay(host.live, ended.samples) == whole);
    EXPECT_EQ(host.info(stroke).cut, 0u);
}

TEST(LiveStrokeInput, RepeatedSamplesMakeNoPoints) {
    LiveHost host;
    const Samples samples = drawn(60);
    Samples repeated;
    for (const LiveSample& sample : samples) repeated.insert(repeated.end(), 3, sample);
    EXPECT_TRUE(host.push_in_bursts(host.begin(), repeated, {1}) == host.push_in_bursts(host.begin(), samples, {1}));
    // Trembling within a thousandth of a step.
    const FlgLiveStroke still = host.begin();
    LiveSample sample = samples[0];
    for (int i = 0; i < 50; ++i) {
        sample.position[0] = samples[0].position[0] + 1e-6f * static_cast<float>(i % 3);
        EXPECT_EQ(host.push(still, &sample, 1).curve_count, 0u);
    }
}

TEST(LiveStrokeInput, AHandThatStaysIsOnePointNotDisplaced) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const LiveSample sample{{1, 2, 3}, {0, 0, 0, 0}, 0.5f, 0};
    host.push(stroke, &sample, 1);
    const LiveHost::Ended ended = host.end(stroke);
    host.finish();
    const Heard point = heard_of(host.view_of(ended.stylized));
    EXPECT_EQ(point.of(FLG_ATTRIBUTE_POSITION), (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(point.of(FLG_ATTRIBUTE_RADIUS), std::vector<float>{0.003f});
    EXPECT_TRUE(host.replay(host.live, ended.samples) == point);
}

TEST(LiveStrokeInput, OrientationGivesTheFirstNormal) {
    LiveHost host;
    const auto first_normal = [&](std::vector<float> q, float direction_y) {
        const FlgLiveStroke stroke = host.begin();
        Samples samples(6);
        for (size_t i = 0; i < 6; ++i) {
            samples[i] = {};
            samples[i].position[direction_y > 0 ? 1 : 0] = 0.1f * static_cast<float>(i);
            std::copy(q.begin(), q.end(), samples[i].orientation);
            samples[i].time = static_cast<double>(i);
        }
        host.push(stroke, samples.data(), 6);
        const std::vector<float> normals = heard_of(host.points(stroke)).of(FLG_ATTRIBUTE_NORMAL);
        return std::vector<float>(normals.begin(), normals.begin() + 3);
    };
    const auto expect_near = [](const std::vector<float>& a, const std::vector<float>& b) {
        for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-6);
    };
    const float half = std::sqrt(0.5f);
    expect_near(first_normal({0, 0, 0, 1}, 0), {0, 1, 0});
    expect_near(first_normal({half, 0, 0, half}, 0), {0, 0, 1});          // a quarter turn about x
    expect_near(first_normal({7 * half, 0, 0, 7 * half}, 0), {0, 0, 1});  // of any length
    expect_near(first_normal({0, 0, 0, 1}, 1), {1, 0, 0});                // drawn along the controller's y axis
    expect_near(first_normal({0, 0, 0, 0}, 0), {0, 1, 0});                // none
    expect_near(first_normal({1e-30f, 0, 0, 1e-30f}, 0), {0, 0, 1});
}

TEST(LiveStrokeInput, NothingIsBegunBeforeItsTime) {
    LiveHost host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil());
    FlgLiveStrokeDesc live = host.live;
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &live.style, nullptr), FLG_OK);
    FlgLiveStroke stroke{5};
    const auto not_ready = [&](const char* words) {
        EXPECT_EQ(flgLiveStrokeBegin(host.context, &live, &stroke), FLG_NOT_READY);
        EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << flgErrorGetMessage();
        EXPECT_EQ(stroke.id, 0u);
    };
    not_ready("desc.style is not prepared yet");
    host.finish();
    not_ready("desc.style is not warm at desc.temperature, 0; call flgStyleWarm");
    live.style = host.style;
    live.temperature = 0.5f;
    not_ready("not warm at desc.temperature, 0.5;");
    host.warm(0.5f);
    host.begin(live);
    // A style whose job failed.
    Curves point;
    point.add_point(1, 1, 1);
    point.end_curve();
    desc.style = host.create(point);
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &live.style, nullptr), FLG_OK);
    host.finish();
    expect_failure(flgLiveStrokeBegin(host.context, &live, &stroke), invalid, "has no length");
    expect_failure(flgStyleWarm(host.context, live.style, 0, nullptr, nullptr), FLG_ERROR_DEPENDENCY, "has no length");
}

TEST(LiveStrokeInput, AfterTheEndNothingIsTaken) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = drawn(30);
    expect_failure(flgLiveStrokeEnd(host.context, stroke, nullptr, nullptr, nullptr, nullptr), invalid, "no samples");
    expect_failure(flgLiveStrokeResume(host.context, stroke), invalid, "not ended");
    host.push(stroke, samples.data(), 20);
    host.end(stroke);
    for (int published = 0; published < 2; ++published) {
        expect_failure(push_samples(host.context, stroke, samples.data() + 20, 10, nullptr), invalid, "has ended");
        expect_failure(flgLiveStrokeUndo(host.context, stroke, 1, nullptr), invalid, "has ended");
        expect_failure(flgLiveStrokeEnd(host.context, stroke, nullptr, nullptr, nullptr, nullptr), invalid,
                       "ended already");
        host.finish();
    }
    ASSERT_EQ(flgLiveStrokeRelease(host.context, stroke), FLG_OK);
    expect_failure(push_samples(host.context, stroke, samples.data(), 1, nullptr), FLG_ERROR_INVALID_HANDLE,
                   "is not a living live stroke");
}

TEST(LiveStrokeInput, AReleasedOrCancelledEndLeavesNoTrace) {
    LiveHost host;
    const Samples samples = drawn(60);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), 40);
    const LiveHost::Ended ended = host.end(stroke);
    ASSERT_EQ(flgJobCancel(host.context, ended.job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(ended.job), FLG_ERROR_CANCELLED);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    EXPECT_EQ(flgCurveSetGetView(host.context, ended.stylized, &view), FLG_ERROR_CANCELLED);
    host.push(stroke, samples.data() + 40, 20);  // goes on
    EXPECT_TRUE(heard_of(host.points(stroke)) == host.push_in_bursts(host.begin(), samples, {1}));
    const LiveHost::Ended again = host.end(stroke);
    ASSERT_EQ(flgLiveStrokeRelease(host.context, stroke), FLG_OK);  // the job keeps what it needs
    host.finish(50);
    EXPECT_EQ(host.result_of(again.job), FLG_OK);
}

TEST(LiveStrokeInput, LimitsEndTheStroke) {
    LiveHost host;
    const Samples samples = drawn(200);
    host.live.max_samples = 50;
    const FlgLiveStroke few_samples = host.begin();
    expect_failure(push_samples(host.context, few_samples, samples.data(), 51, nullptr), FLG_ERROR_LIMIT,
                   "max_samples, 50");
    host.push(few_samples, samples.data(), 50);
    expect_failure(push_samples(host.context, few_samples, samples.data() + 50, 1, nullptr), FLG_ERROR_LIMIT,
                   "max_samples, 50");
    host.live.max_samples = 200;
    const Heard unlimited = host.push_in_bursts(host.begin(), samples, {1});
    host.live.max_points = 40;
    const FlgLiveStroke few_points = host.begin();
    uint32_t taken = 0;
    while (push_samples(host.context, few_points, &samples[taken], 1, nullptr) == FLG_OK) ++taken;
    expect_failure(push_samples(host.context, few_points, &samples[taken], 1, nullptr), FLG_ERROR_LIMIT,
                   "max_points, 40");
    ASSERT_EQ(host.info(few_points).point_count, 40u);
    EXPECT_EQ(host.info(few_points).cut, 1u);
    const std::vector<float>& positions = unlimited.of(FLG_ATTRIBUTE_POSITION);
    EXPECT_EQ(heard_of(host.points(few_points)).of(FLG_ATTRIBUTE_POSITION),
              std::vector<float>(positions.begin(), positions.begin() + 120));
    ASSERT_EQ(flgLiveStrokeUndo(host.context, few_points, 10, nullptr), FLG_OK);
    EXPECT_EQ(host.info(few_points).cut, 0u);
    host.push(few_points, &samples[taken - 10], 1);
    const LiveHost::Ended ended = host.end(few_points);
    host.finish();
    EXPECT_EQ(host.info(few_points).cut, 0u);
    EXPECT_TRUE(host.replay(host.live, ended.samples) == heard_of(host.view_of(ended.stylized)));
}

// As many points as there is room for are whole, one less is cut, and says so.
TEST(LiveStrokeInput, AnEndThatIsCutSaysSo) {
    LiveHost host;
    const Samples samples = drawn(60);
    const auto ended_with = [&](uint32_t max_points, uint32_t cut) {
        host.live.max_points = max_points;
        const FlgLiveStroke stroke = host.begin();
        host.push_in_bursts(stroke, Samples(samples.begin(), samples.end() - 1), {1});
        EXPECT_EQ(host.info(stroke).cut, 0u);
        EXPECT_EQ(push_samples(host.context, stroke, &samples.back(), 1, nullptr), FLG_OK) << flgErrorGetMessage();
        const LiveHost::Ended ended = host.end(stroke);
        host.finish();
        EXPECT_EQ(host.result_of(ended.job), FLG_OK);
        EXPECT_EQ(host.info(stroke).cut, cut) << max_points;
        EXPECT_EQ(host.view_of(ended.samples).curve_offsets[1], 60u);
        return ended;
    };
    const Heard whole = heard_of(host.view_of(ended_with(8192, 0).stylized));
    const auto points = static_cast<uint32_t>(whole.points());
    EXPECT_TRUE(heard_of(host.view_of(ended_with(points, 0).stylized)) == whole);
    const LiveHost::Ended cut = ended_with(points - 1, 1);
    EXPECT_EQ(heard_of(host.view_of(cut.stylized)).points(), points - 1);
    // The batch form refuses it.
    FlgCurveSet out{};
    FlgJob job{};
    ASSERT_EQ(flgLiveStrokeReplay(host.context, &host.live, cut.samples, nullptr, &out, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_LIMIT);
    const std::string words = "curve 0 comes to more than max_points, " + std::to_string(points - 1);
    EXPECT_NE(std::strstr(host.status_of(job).error, words.c_str()), nullptr) << host.status_of(job).error;
}

TEST(LiveStrokeInput, RefusesEachBadDescriptor) {
    LiveHost host;
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgLiveStrokeDesc desc = host.live;
        change(desc);
        FlgLiveStroke stroke{5};
        expect_failure(flgLiveStrokeBegin(host.context, &desc, &stroke), expected, words);
        EXPECT_EQ(stroke.id, 0u);
    };
    refused([](auto& d) { d.struct_size = 4; }, invalid, "struct_size is 4");
    refused([](auto& d) { d.start = static_cast<FlgStyleStart>(9); }, invalid, "desc.start is 9");
    refused([](auto& d) { d.style = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.style is null");
    refused([](auto& d) { d.magnitude = NAN; }, invalid, "desc.magnitude is nan");
    refused([](auto& d) { d.temperature = -1; }, invalid, "desc.temperature is -1");
    refused([](auto& d) { d.scale = -1; }, invalid, "desc.scale is -1");
    refused([](auto& d) { d.min_radius = -1; }, invalid, "desc.min_radius is -1");
    refused([](auto& d) { d.max_radius = INFINITY; }, invalid, "desc.max_radius is inf");
    refused([](auto& d) { d.smoothing = -1; }, invalid, "desc.smoothing is -1");
    refused([](auto& d) { d.max_jump = 0; }, invalid, "desc.max_jump is 0");
    refused([](auto& d) { d.max_samples = 0; }, invalid, "desc.max_samples is 0");
    refused([](auto& d) { d.max_samples = (1u << 20) + 1; }, invalid, "desc.max_samples is 1048577, must");
    refused([](auto& d) { d.max_points = 0; }, invalid, "desc.max_points is 0");
    expect_failure(flgStyleWarm(host.context, host.style, NAN, nullptr, nullptr), invalid, "temperature is nan");
    expect_failure(flgLiveStrokePush(host.context, host.begin(), nullptr, nullptr), invalid, "samples is null");
    FlgCurveSetView view = flgCurveSetViewDefaults();
    const FlgLiveSampleView none = flgLiveSampleViewDefaults();
    EXPECT_EQ(flgLiveStrokePush(host.context, host.begin(), &none, &view), FLG_OK);
    const Samples samples = drawn(3);
    const auto refused_view = [&](auto change, const char* words) {
        FlgLiveSampleView changed = view_of(samples.data(), 3);
        change(changed);
        expect_failure(flgLiveStrokePush(host.context, host.begin(), &changed, &view), invalid, words);
    };
    refused_view([](auto& v) { v.struct_size = 4; }, "samples: struct_size is 4");
    refused_view([](auto& v) { v.reserved = 4; }, "samples.reserved is 4, must be 0");
    refused_view([](auto& v) { v.positions = nullptr; }, "samples.positions is null");
    refused_view([](auto& v) { v.stride = 8; }, "samples.stride is 8, must be 0, or a multiple of 4");
    refused_view([](auto& v) { v.stride = 12; }, "samples.stride is 12");
    refused_view([](auto& v) { v.stride = 20; }, "samples.stride is 20");
    refused_view([](auto& v) { v.times = reinterpret_cast<const double*>(reinterpret_cast<const char*>(v.times) + 4); },
                 "must be aligned to 8 bytes");
    refused_view(
        [](auto& v) { v.pressures = reinterpret_cast<const float*>(reinterpret_cast<const char*>(v.pressures) + 1); },
        "must be aligned to 4 bytes");
    FlgLiveStrokeDesc smooth = host.live;
    smooth.smoothing = 0.01f;
    FlgLiveSampleView timeless = view_of(samples.data(), 3);
    timeless.times = nullptr;
    expect_failure(flgLiveStrokePush(host.context, host.begin(smooth), &timeless, nullptr), invalid,
                   "samples.times is null, but the stroke's smoothing needs times");
}

// Packed columns, members of a struct, and columns that are left out: the same samples are the same points.
TEST(LiveStrokeInput, ColumnsMayBePackedOrMembers) {
    LiveHost host;
    Samples samples = drawn(60);
    std::vector<float> positions, orientations, pressures;
    std::vector<double> times;
    for (const LiveSample& sample : samples) {
        positions.insert(positions.end(), sample.position, sample.position + 3);
        orientations.insert(orientations.end(), sample.orientation, sample.orientation + 4);
        pressures.push_back(sample.pressure);
        times.push_back(sample.time);
    }
    FlgLiveSampleView packed = flgLiveSampleViewDefaults();
    packed.sample_count = 60;
    packed.positions = positions.data();
    packed.orientations = orientations.data();
    packed.pressures = pressures.data();
    packed.times = times.data();
    const auto pushed = [&](const FlgLiveSampleView& view) {
        const FlgLiveStroke stroke = host.begin();
        EXPECT_EQ(flgLiveStrokePush(host.context, stroke, &view, nullptr), FLG_OK) << flgErrorGetMessage();
        return heard_of(host.points(stroke));
    };
    const Heard members = pushed(view_of(samples.data(), 60));
    EXPECT_GT(members.points(), 20u);
    EXPECT_TRUE(members == pushed(packed));

    packed.orientations = packed.pressures = nullptr;
    packed.times = nullptr;
    for (LiveSample& sample : samples) {
        std::fill_n(sample.orientation, 4, 0.0f);
        sample.pressure = 1;
        sample.time = 0;
    }
    const Heard left_out = pushed(packed);
    EXPECT_TRUE(left_out == pushed(view_of(samples.data(), 60)));
    EXPECT_FALSE(left_out == members);
}

TEST(LiveStrokeInput, ReplayRefusesWhatALiveStrokeDoes) {
    LiveHost host;
    const auto fails = [&](Curves curves, const FlgLiveStrokeDesc& desc, FlgResult expected, const char* words) {
        FlgCurveSet out{};
        FlgJob job{};
        ASSERT_EQ(flgLiveStrokeReplay(host.context, &desc, host.create(curves), nullptr, &out, &job), FLG_OK);
        host.finish();
        EXPECT_EQ(host.result_of(job), expected);
        EXPECT_NE(std::strstr(host.status_of(job).error, words), nullptr) << host.status_of(job).error;
    };
    FlgLiveStrokeDesc desc = host.live;
    fails(arcs(2, 10), desc, FLG_ERROR_LIMIT, "curve 0: samples.positions[1] is");
    desc.max_jump = 10;
    desc.smoothing = 0.1f;
    fails(arcs(2, 10), desc, invalid, "no TIME column");
    desc.smoothing = 0;
    const Heard replayed = host.replay(desc, host.create(arcs(1, 10)));  // neither orientation, pressure nor time
    EXPECT_GT(replayed.points(), 100u);
    for (float radius : replayed.of(FLG_ATTRIBUTE_RADIUS)) ASSERT_EQ(radius, desc.max_radius);
}

// Curve c of a replay is a live stroke of seed + c, under any number of workers.
TEST(LiveStrokeInput, ReplaysManyCurves) {
    LiveHost host;
    host.live.start = FLG_STYLE_START_RANDOM;
    Curves curves;
    std::vector<Samples> hands;
    for (int c = 0; c < 5; ++c) {
        hands.push_back(drawn(40 + 20 * c));
        for (LiveSample& sample : hands.back()) {
            sample.pressure = 1;
            std::fill_n(sample.orientation, 4, 0.0f);
            curves.add_point(sample.position[0], sample.position[1], sample.position[2]);
        }
        curves.end_curve();
    }
    FlgCurveSet out{};
    ASSERT_EQ(flgLiveStrokeReplay(host.context, &host.live, host.create(curves), nullptr, &out, nullptr), FLG_OK);
    host.finish(500);
    const FlgCurveSetView view = host.view_of(out);
    ASSERT_EQ(view.curve_count, 5u);
    for (uint32_t c = 0; c < 5; ++c) {
        FlgLiveStrokeDesc desc = host.live;
        desc.seed = host.live.seed + c;
        const FlgLiveStroke stroke = host.begin(desc);
        host.push(stroke, hands[c].data(), hands[c].size());
        const LiveHost::Ended ended = host.end(stroke);
        host.finish();
        const Heard live = heard_of(host.view_of(ended.stylized));
        ASSERT_EQ(live.points(), view.curve_offsets[c + 1] - view.curve_offsets[c]);
        const std::vector<float>& positions = live.of(FLG_ATTRIBUTE_POSITION);
        EXPECT_TRUE(
            std::equal(positions.begin(), positions.end(), view.columns[0].data + 3 * size_t{view.curve_offsets[c]}));
    }
}

TEST(LiveStrokeInput, MemoryThatRunsOutAnywhereLeavesTheStrokeUsable) {
    LiveHost host;
    const Samples samples = drawn(60);
    int64_t failures = 0;
    for (int64_t fail = 0;; ++fail) {
        host.allocator.fail_at = host.allocator.calls + fail;
        FlgLiveStroke stroke{};
        FlgCurveSet stylized{}, raw{};
        FlgJob job{};
        FlgResult result = flgLiveStrokeBegin(host.context, &host.live, &stroke);
        if (result == FLG_OK) {
            host.push(stroke, samples.data(), 60);
            result = flgLiveStrokeEnd(host.context, stroke, nullptr, &stylized, &raw, &job);
            if (result == FLG_OK) {
                host.finish();
                result = host.result_of(job);
            }
            host.allocator.fail_at = -1;
            if (result != FLG_OK) {
                EXPECT_EQ(host.info(stroke).ended, 0u);
                EXPECT_EQ(flgLiveStrokeUndo(host.context, stroke, 60, nullptr), FLG_OK);
            }
            EXPECT_EQ(flgLiveStrokeRelease(host.context, stroke), FLG_OK);
        }
        host.allocator.fail_at = -1;
        if (result == FLG_OK) break;
        ++failures;
        ASSERT_EQ(result, FLG_ERROR_OUT_OF_MEMORY) << flgResultGetName(result);
    }
    EXPECT_GT(failures, 15);
}

}  // namespace
}  // namespace flg::test
