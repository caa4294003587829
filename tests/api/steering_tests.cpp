// SPDX-License-Identifier: MIT
// Columns of a target, and the hand that draws it, steer a style along the way.
#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

constexpr auto painted = static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 3);

// `count` points along x; the painted column goes from one value to the other.
Columns line(double length, uint32_t count, double from, double to, bool closed = false) {
    Columns columns;
    for (uint32_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        if (closed) {
            columns.curves.add_point(length * std::cos(6 * u), length * std::sin(6 * u), 0);
        } else {
            columns.curves.add_point(length * u, 0, 0);
        }
    }
    columns.curves.end_curve(closed ? FLG_CURVE_CLOSED : 0);
    return columns.with(painted, 1, [=](uint32_t i, uint32_t) { return from + (to - from) * i / (count - 1); });
}

class Steering : public testing::Test {
protected:
    Steering() {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(coil());
        desc.style = prepare(host, style);
        desc.keep_displacement = 1;
        step = style_info(host, desc.style).spacing;
    }
    Heard stylized(std::initializer_list<FlgStyleDrive> drives) {
        desc.drives = drives.size() > 0 ? drives.begin() : nullptr;
        desc.drive_count = static_cast<uint32_t>(drives.size());
        return heard_of(host.view_of(stylize(host, desc)));
    }
    void expect_refused(std::initializer_list<FlgStyleDrive> drives, const char* words) {
        desc.drives = drives.begin();
        desc.drive_count = static_cast<uint32_t>(drives.size());
        FlgCurveSet out{};
        expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, words);
    }

    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    double step = 0;
};

TEST_F(Steering, MagnitudeFollowsTheColumn) {
    desc.target = line(20, 30, -0.5, 2).create(host);
    desc.magnitude = 1.5f;
    const Heard plain = stylized({});
    const Heard driven = stylized({{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0.2f, 1}});
    ASSERT_EQ(driven.of(FLG_ATTRIBUTE_STYLE_INDEX), plain.of(FLG_ATTRIBUTE_STYLE_INDEX));
    const auto& value = driven.of(painted);
    for (size_t i = 0; i < 3 * plain.points(); ++i) {
        const double v = value[i / 3];
        // Between two points of the target the column passes 0 and 1, beyond which it drives no further.
        if (std::abs(v) < 0.1 || std::abs(v - 1) < 0.1) continue;
        const double factor = 0.2 + 0.8 * std::clamp(v, 0.0, 1.0);
        const double d = plain.of(FLG_ATTRIBUTE_DISPLACEMENT)[i];
        EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_DISPLACEMENT)[i], factor * d, 1e-6) << i;
        const double target = plain.of(FLG_ATTRIBUTE_POSITION)[i] - 1.5 * d;
        EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_POSITION)[i], target + 1.5 * factor * d, 1e-5) << i;
    }
}

TEST_F(Steering, AColumnThatChangesNothingGivesTheSameBits) {
    for (const bool closed : {false, true}) {
        desc.target = line(closed ? 3 : 20, 40, 1, 1, closed).create(host);
        const Heard plain = stylized({});
        EXPECT_TRUE(plain == stylized({{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0.2f, 1},
                                       {painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 2, 0}}));
        desc.temperature = 2;
        const Heard hot = stylized({});
        desc.temperature = 0;
        EXPECT_TRUE(hot == stylized({{painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 2}}));
        EXPECT_FALSE(hot == plain);
    }
}

TEST_F(Steering, AConstantScaleIsThatScale) {
    for (const bool closed : {false, true}) {
        desc.target = line(closed ? 3 : 20, 40, 1, 1, closed).create(host);
        desc.scale = 0.5f;
        const Heard expected = stylized({});
        desc.scale = 1;
        const Heard driven = stylized({{painted, FLG_STYLE_DRIVEN_SCALE, 0, 2, 0.2f, 0.8f}});
        ASSERT_EQ(driven.of(FLG_ATTRIBUTE_STYLE_INDEX), expected.of(FLG_ATTRIBUTE_STYLE_INDEX));
        for (size_t i = 0; i < 3 * expected.points(); ++i) {
            EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_POSITION)[i], expected.of(FLG_ATTRIBUTE_POSITION)[i], 1e-4) << i;
        }
    }
}

TEST_F(Steering, ScaleIsAFactorOnTheChosenOne) {
    desc.target = line(20, 40, 1, 1).create(host);
    desc.scale = 0;
    const FlgStyleDrive half{painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 0.5f};
    desc.drives = &half;
    desc.drive_count = 1;
    const FlgCurveSet result = stylize(host, desc);
    FlgCurveSetScales chosen = flgCurveSetScalesDefaults();
    ASSERT_EQ(flgCurveSetGetScales(host.context, result, &chosen), FLG_OK);
    const Heard driven = heard_of(host.view_of(result));
    desc.scale = 0.5f * chosen.scales[0];
    const Heard expected = stylized({});
    ASSERT_EQ(driven.of(FLG_ATTRIBUTE_STYLE_INDEX), expected.of(FLG_ATTRIBUTE_STYLE_INDEX));
    for (size_t i = 0; i < 3 * expected.points(); ++i) {
        EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_POSITION)[i], expected.of(FLG_ATTRIBUTE_POSITION)[i], 1e-4) << i;
    }
}

// Steps are as long as the scale where they are: with a scale that goes from a to b along L, point k lies at
// a L / (b - a) (exp((b - a) k step / L) - 1).
TEST_F(Steering, ScaleStretchesTheSteps) {
    const float a = 0.5f, b = 2;
    const double length = 20;
    desc.target = line(length, 2, 0, 1).create(host);
    desc.magnitude = 0;
    desc.exact_spacing = 1;
    const Heard driven = stylized({{painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, a, b}});
    const double steps = length / (b - a) * std::log(b / a);
    EXPECT_EQ(driven.points(), static_cast<size_t>(std::floor(steps / step)) + 1);
    for (size_t k = 0; k < driven.points(); ++k) {
        const double x = a * length / (b - a) * std::expm1((b - a) * static_cast<double>(k) * step / length);
        EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_POSITION)[3 * k], x, 1e-4 * length) << k;
    }
    // The ends are met in equal steps of the style; displacements have the scale of their place.
    desc.exact_spacing = 0;
    desc.magnitude = 1;
    const Heard whole = stylized({{painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, a, b}});
    EXPECT_NEAR(static_cast<double>(whole.points()), steps / step + 1, 0.51);
    const Heard unscaled = [&] {
        desc.target = line(steps, 2, 0, 1).create(host);
        return stylized({});
    }();
    ASSERT_EQ(whole.of(FLG_ATTRIBUTE_STYLE_INDEX), unscaled.of(FLG_ATTRIBUTE_STYLE_INDEX));
    const auto size = [](const Heard& heard, size_t k) {
        const float* d = &heard.of(FLG_ATTRIBUTE_DISPLACEMENT)[3 * k];
        return std::hypot(double{d[0]}, double{d[1]}, double{d[2]});
    };
    for (size_t k = 0; k < whole.points(); ++k) {
        const double scale = a + (b - a) * whole.of(painted)[k];
        EXPECT_NEAR(size(whole, k), scale * size(unscaled, k), 1e-4) << k;
    }
}

TEST_F(Steering, TemperatureRisesAlongTheWay) {
    desc.target = line(1000, 200, 0, 1).create(host);
    const Heard driven = stylized({{painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 5}});
    const auto& index = driven.of(FLG_ATTRIBUTE_STYLE_INDEX);
    std::array<size_t, 4> jumps{};
    for (size_t i = 1; i < index.size(); ++i) jumps[i * 4 / index.size()] += index[i] != index[i - 1] + 1;
    for (size_t k = 1; k < 4; ++k) EXPECT_GT(jumps[k], jumps[k - 1]);
    EXPECT_TRUE(driven == stylized({{painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 5}}));
}

TEST_F(Steering, RadiiAreDrivenWhoseEverTheyAre) {
    const auto radius = [](uint32_t i, uint32_t) { return 0.1 + 0.01 * i; };
    desc.target = line(20, 30, 0, 1).with(FLG_ATTRIBUTE_RADIUS, 1, radius).create(host);
    const auto expect_driven = [&] {
        const Heard plain = stylized({});
        const Heard driven = stylized({{painted, FLG_STYLE_DRIVEN_RADIUS, 0, 1, 3, 1}});
        for (size_t i = 0; i < plain.points(); ++i) {
            const double factor = 3 - 2 * driven.of(painted)[i];
            EXPECT_NEAR(driven.of(FLG_ATTRIBUTE_RADIUS)[i], factor * plain.of(FLG_ATTRIBUTE_RADIUS)[i], 1e-5) << i;
        }
        EXPECT_EQ(driven.of(FLG_ATTRIBUTE_POSITION), plain.of(FLG_ATTRIBUTE_POSITION));
    };
    expect_driven();
    FlgStyleDesc style = flgStyleDefaults();
    Columns example{coil()};
    style.style = example.with(FLG_ATTRIBUTE_RADIUS, 1, radius).create(host);
    const FlgStyleAttribute attribute{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 0.1f, 0};
    style.attributes = &attribute;
    style.attribute_count = 1;
    desc.style = prepare(host, style);
    expect_driven();
}

// Where no column has the speed, the times have it.
TEST_F(Steering, SpeedIsMadeOfTimes) {
    const double speed = 0.25;
    Columns target = line(20, 30, 0.5, 0.5);
    const auto time = [=](uint32_t i, uint32_t) { return 20.0 / 29 * i / speed; };
    desc.target = target.with(FLG_ATTRIBUTE_TIME, 1, time).create(host);
    const Heard by_speed = stylized({{FLG_ATTRIBUTE_SPEED, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 0.5f, 0, 1}});
    const Heard by_column = stylized({{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0, 1}});
    for (size_t i = 0; i < 3 * by_speed.points(); ++i) {
        EXPECT_NEAR(by_speed.of(FLG_ATTRIBUTE_POSITION)[i], by_column.of(FLG_ATTRIBUTE_POSITION)[i], 1e-5);
    }
}

// A circle painted with half a wave: where it begins, it goes on as evenly as elsewhere.
TEST_F(Steering, ClosedTargetsMeetTheirBeginning) {
    Columns circle = line(3, 60, 1, 1, true);
    circle.extra.clear();
    circle.with(painted, 1, [](uint32_t i, uint32_t) { return 0.5 + 0.5 * std::cos(i * 2 * M_PI / 60); });
    desc.target = circle.create(host);
    const Heard driven = stylized(
        {{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0.1f, 1}, {painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 0.2f, 0.4f}});
    const auto& p = driven.of(FLG_ATTRIBUTE_POSITION);
    const auto distance = [&](size_t i, size_t j) {
        return std::hypot(double{p[3 * i]} - p[3 * j], double{p[3 * i + 1]} - p[3 * j + 1],
                          double{p[3 * i + 2]} - p[3 * j + 2]);
    };
    double longest = 0;
    for (size_t i = 1; i < driven.points(); ++i) longest = std::max(longest, distance(i, i - 1));
    EXPECT_LT(distance(0, driven.points() - 1), 1.5 * longest);
}

TEST_F(Steering, Refusals) {
    desc.target = line(20, 30, 0, 1).create(host);
    const float nan = NAN;
    expect_refused({{FLG_ATTRIBUTE_WIDTH, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 2}}, "desc.drives[0].attribute is");
    expect_refused({{FLG_ATTRIBUTE_POSITION, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 2}}, "one float");
    expect_refused({{painted, static_cast<FlgStyleDriven>(5), 0, 1, 1, 2}}, "desc.drives[0].driven");
    expect_refused({{painted, FLG_STYLE_DRIVEN_SCALE, 1, 1, 1, 2}}, "desc.drives[0].to");
    expect_refused({{painted, FLG_STYLE_DRIVEN_SCALE, nan, 1, 1, 2}}, "desc.drives[0].from");
    expect_refused({{painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 0, 2}}, "desc.drives[0].at_from is 0, must be above 0");
    expect_refused({{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 1, nan}}, "desc.drives[0].at_to");
    expect_refused({{painted, FLG_STYLE_DRIVEN_RADIUS, 0, 1, -1, 1}}, "at least 0");
    expect_refused(
        {{painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 1}, {painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 1}},
        "desc.drives[1] drives the temperature");
    expect_refused(
        {{painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1e-20f, 1}, {painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1e-20f, 1}},
        "1e-30");
    desc.drive_count = 9;
    FlgCurveSet out{};
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.drive_count");
    desc.drive_count = 1;
    desc.drives = nullptr;
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, "desc.drives");
    const FlgStyleDrive radius{painted, FLG_STYLE_DRIVEN_RADIUS, 0, 1, 1, 2};
    desc.drives = &radius;
    FlgJob job{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
}

TEST_F(Steering, SameBitsUnderAnyWorkersAndBudgets) {
    const FlgStyleDrive drives[] = {{painted, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0.2f, 1},
                                    {painted, FLG_STYLE_DRIVEN_SCALE, 0, 1, 0.3f, 1},
                                    {painted, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 3}};
    expect_same_bits([&](const Host& other) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = other.create(coil());
        FlgCurveSetStylizeDesc wanted = flgCurveSetStylizeDefaults();
        EXPECT_EQ(flgStyleCreate(other.context, &style, &wanted.style, nullptr), FLG_OK);
        Columns targets{arcs(40)};
        wanted.target = targets.with(painted, 1, [](uint32_t i, uint32_t) { return 0.02 * (i % 60); }).create(other);
        wanted.drives = drives;
        wanted.drive_count = 3;
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetStylize(other.context, &wanted, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        return out;
    });
}

// ---- live ----

const std::vector<FlgStyleDrive> hand_drives = {{FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_MAGNITUDE, 0, 1, 0.2f, 1.5f},
                                                {FLG_ATTRIBUTE_SPEED, FLG_STYLE_DRIVEN_SCALE, 0.5f, 2, 2, 0.5f},
                                                {FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_TEMPERATURE, 0.2f, 1, 0, 2},
                                                {FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_RADIUS, 0, 1, 1, 3}};

TEST(LiveSteering, LiveIsBatch) {
    for (const uint32_t rest : {0u, 4u}) {
        LiveHost host;
        host.warm(2);
        host.live.drives = hand_drives.data();
        host.live.drive_count = static_cast<uint32_t>(hand_drives.size());
        Samples samples = drawn(250);
        for (uint32_t i = 1; rest > 0 && i < samples.size(); ++i) {
            if (i % rest == 1) std::copy_n(samples[i - 1].position, 3, samples[i].position);
        }
        const FlgLiveStroke stroke = host.begin();
        host.push_in_bursts(stroke, samples, {3, 1});
        const LiveHost::Ended ended = host.end(stroke);
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = host.live.style;
        desc.target = ended.samples;
        desc.scale = host.live.scale;
        desc.exact_spacing = 1;
        desc.drives = hand_drives.data();
        desc.drive_count = static_cast<uint32_t>(hand_drives.size());
        const Heard batch = heard_of(host.view_of(stylize(host, desc)));
        const Heard live = heard_of(host.view_of(ended.stylized));
        ASSERT_GT(live.points(), 50u);
        for (const FlgAttribute attribute :
             {FLG_ATTRIBUTE_STYLE_INDEX, FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL}) {
            EXPECT_TRUE(live.of(attribute) == batch.of(attribute)) << attribute;
        }
        // Samples have the hand's radii; in between, a stroke has those of its pressure, a batch goes evenly.
        for (size_t i = 0; i < live.points(); ++i) {
            const float radius = live.of(FLG_ATTRIBUTE_RADIUS)[i];
            EXPECT_NEAR(radius, batch.of(FLG_ATTRIBUTE_RADIUS)[i], 0.03 * radius) << i;
        }
        EXPECT_TRUE(live == host.replay(host.live, ended.samples));
    }
}

TEST(LiveSteering, UndoneSamplesLeaveNothing) {
    LiveHost host;
    host.warm(2);
    host.live.drives = hand_drives.data();
    host.live.drive_count = static_cast<uint32_t>(hand_drives.size());
    const Samples samples = drawn(100);
    const FlgLiveStroke once = host.begin(), twice = host.begin();
    host.push_in_bursts(once, samples, {1});
    host.push_in_bursts(twice, samples, {7});
    ASSERT_EQ(flgLiveStrokeUndo(host.context, twice, 31, nullptr), FLG_OK);
    host.push(twice, samples.data() + 69, 31);
    EXPECT_TRUE(heard_of(host.points(once)) == heard_of(host.points(twice)));
    EXPECT_TRUE(heard_of(host.tip(once)) == heard_of(host.tip(twice)));
}

TEST(LiveSteering, Refusals) {
    LiveHost host;
    const auto begin = [&](const FlgStyleDrive& drive) {
        host.live.drives = &drive;
        host.live.drive_count = 1;
        FlgLiveStroke stroke{};
        return flgLiveStrokeBegin(host.context, &host.live, &stroke);
    };
    expect_failure(begin({FLG_ATTRIBUTE_RADIUS, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 2}), FLG_ERROR_INVALID_ARGUMENT,
                   "FLG_ATTRIBUTE_PRESSURE");
    EXPECT_EQ(begin({FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 1, 0, 7}), FLG_NOT_READY);
    const FlgStyleDrive by_speed{FLG_ATTRIBUTE_SPEED, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 2};
    ASSERT_EQ(begin(by_speed), FLG_OK);
    host.live.drives = &by_speed;
    const FlgLiveStroke stroke = host.begin();
    const Samples samples = drawn(3);
    FlgLiveSampleView view = view_of(samples.data(), samples.size());
    view.times = nullptr;
    expect_failure(flgLiveStrokePush(host.context, stroke, &view, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "drive by SPEED needs times");
}

}  // namespace
}  // namespace flg::test
