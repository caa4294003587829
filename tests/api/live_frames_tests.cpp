// SPDX-License-Identifier: MIT
// Live strokes: by which frame points are displaced, in which basis, and when a motion along them is where.
#include "api/live_inputs.h"

namespace flg::test {
namespace {

using Vec = std::array<double, 3>;

double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec vec_at(const std::vector<float>& values, size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

// A hand that goes along the x axis at 1 m/s and rolls the controller by 2 rad a metre, at 90 Hz.
Samples rolling(uint32_t count) {
    Samples samples(count);
    for (uint32_t i = 0; i < count; ++i) {
        const double x = i / 90.0, half_roll = x;
        samples[i].position[0] = static_cast<float>(x);
        samples[i].orientation[0] = static_cast<float>(std::sin(half_roll));
        samples[i].orientation[3] = static_cast<float>(std::cos(half_roll));
        samples[i].pressure = 1;
        samples[i].time = 50 + x;
    }
    return samples;
}

TEST(LiveStrokeFrames, SuppliedNormalsAreTheControllers) {
    LiveHost host;
    host.live.frame = FLG_FRAME_METHOD_SUPPLIED;
    const FlgLiveStroke stroke = host.begin();
    const double spacing = host.info(stroke).spacing;
    const Heard heard = host.push_in_bursts(stroke, rolling(150), {1});
    ASSERT_GT(heard.points(), 100u);
    for (size_t i = 0; i < heard.points(); ++i) {
        const double roll = 2 * spacing * static_cast<double>(i);
        const Vec normal = vec_at(heard.of(FLG_ATTRIBUTE_NORMAL), i);
        // Between samples, 0.022 rad apart, the chord's direction: off by less than the cube of their distance.
        EXPECT_NEAR(normal[0], 0, 1e-6) << i;
        EXPECT_NEAR(normal[1], std::cos(roll), 1e-5) << i;
        EXPECT_NEAR(normal[2], std::sin(roll), 1e-5) << i;
    }
}

TEST(LiveStrokeFrames, SuppliedNormalsAreThoseOfFlgResample) {
    LiveHost host;
    host.live.magnitude = 0;
    host.live.frame = FLG_FRAME_METHOD_SUPPLIED;
    const Samples samples = drawn(100);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), samples.size());
    const Heard live = heard_of(host.points(stroke));
    std::vector<float> positions, normals;
    for (const LiveSample& sample : samples) {
        positions.insert(positions.end(), sample.position, sample.position + 3);
        const float s = sample.orientation[0], c = sample.orientation[3];  // a turn about x
        normals.insert(normals.end(), {0, c * c - s * s, 2 * c * s});
    }
    Curves curve;
    curve.positions = positions;
    curve.end_curve();
    FlgCurveSetView view = curve.view();
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0}};
    view.columns = columns;
    view.column_count = 2;
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    ASSERT_EQ(flgCurveSetCreate(host.context, &view, &desc.curves), FLG_OK) << flgErrorGetMessage();
    const double step = host.info(stroke).spacing;
    desc.spacing = static_cast<float>(step / 64);
    desc.frame = FLG_FRAME_METHOD_SUPPLIED;
    FlgCurveSet fine{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgCurveSetView resampled = host.view_of(fine);
    const float* p = resampled.columns[0].data;
    const float* n = find_column(resampled, FLG_ATTRIBUTE_NORMAL)->data;
    size_t at = 0;
    for (size_t i = 0; i < live.points(); ++i) {
        const Vec place = vec_at(live.of(FLG_ATTRIBUTE_POSITION), i);
        const auto distance = [&](size_t k) {
            return std::hypot(p[3 * k] - place[0], p[3 * k + 1] - place[1], p[3 * k + 2] - place[2]);
        };
        while (at + 1 < resampled.curve_offsets[1] && distance(at + 1) <= distance(at)) ++at;
        ASSERT_LT(distance(at), 0.02 * step) << i;
        const Vec normal = vec_at(live.of(FLG_ATTRIBUTE_NORMAL), i);
        for (size_t k = 0; k < 3; ++k) ASSERT_NEAR(normal[k], n[3 * at + k], 0.01) << i;
    }
}

// Where the controller says nothing of it, the frame goes on without turning.
TEST(LiveStrokeFrames, WithoutADirectionTheFrameIsCarriedOn) {
    LiveHost host;
    host.live.frame = FLG_FRAME_METHOD_SUPPLIED;
    Samples samples = rolling(120);
    for (size_t i = 40; i < 80; ++i) std::fill_n(samples[i].orientation, 4, 0.0f);
    const float half = std::sqrt(0.5f);
    for (size_t i = 80; i < 120; ++i) {  // the y axis along the stroke
        const float turn_about_z[] = {0, 0, -half, half};
        std::copy_n(turn_about_z, 4, samples[i].orientation);
    }
    const FlgLiveStroke stroke = host.begin();
    const Heard heard = host.push_in_bursts(stroke, samples, {1});
    const double spacing = host.info(stroke).spacing;
    const auto point_of = [&](size_t sample) { return static_cast<size_t>(sample / 90.0 / spacing); };
    const Vec last = vec_at(heard.of(FLG_ATTRIBUTE_NORMAL), point_of(40));
    EXPECT_NEAR(last[2], std::sin(2 * 39.5 / 90), 0.02);  // it has come so far
    for (size_t i = point_of(40); i < heard.points(); ++i) {
        const Vec normal = vec_at(heard.of(FLG_ATTRIBUTE_NORMAL), i);
        for (size_t k = 0; k < 3; ++k) ASSERT_NEAR(normal[k], last[k], 1e-5) << i;
    }
    // Never a direction: as the rotation-minimizing frame.
    for (LiveSample& sample : samples) std::fill_n(sample.orientation, 4, 0.0f);
    const Heard supplied = host.push_in_bursts(host.begin(), samples, {1});
    host.live.frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
    EXPECT_TRUE(host.push_in_bursts(host.begin(), samples, {1}) == supplied);
}

// With smoothing the axis is filtered along with the position that it belongs to.
TEST(LiveStrokeFrames, SmoothingFiltersTheAxisWithThePosition) {
    LiveHost host;
    host.live.frame = FLG_FRAME_METHOD_SUPPLIED;
    host.live.magnitude = 0;
    host.live.smoothing = 0.05f;
    const Heard heard = host.push_in_bursts(host.begin(), rolling(180), {1});
    for (size_t i = heard.points() / 2; i < heard.points(); ++i) {
        const double x = heard.of(FLG_ATTRIBUTE_POSITION)[3 * i];
        const Vec normal = vec_at(heard.of(FLG_ATTRIBUTE_NORMAL), i);
        // A turning vector, followed by an exponential filter, lags by atan(rate * tau); a moving point by tau.
        const double lag = std::atan(2 * 0.05), roll = 2 * (x + 0.05) - lag;
        ASSERT_NEAR(std::remainder(std::atan2(normal[2], normal[1]) - roll, 2 * M_PI), 0, 2e-3) << i;
    }
}

TEST(LiveStrokeFrames, BasesTurnTheDisplacement) {
    LiveHost host;
    const Samples samples = drawn(150);
    const auto draw = [&](float magnitude, const std::array<float, 9>& basis) {
        FlgLiveStrokeDesc desc = host.live;
        desc.magnitude = magnitude;
        std::copy(basis.begin(), basis.end(), desc.basis);
        return host.push_in_bursts(host.begin(desc), samples, {3});
    };
    const std::array<float, 9> identity{1, 0, 0, 0, 1, 0, 0, 0, 1}, basis{0, 2, 0, 0.5f, 0, -1, 1, 1, 1};
    const Heard bare = draw(0, identity), once = draw(1, identity), turned = draw(1, basis);
    EXPECT_TRUE(once == host.push_in_bursts(host.begin(), samples, {3}));  // the default
    double largest = 0;
    for (size_t i = 0; i < bare.points(); ++i) {
        const Vec tangent = vec_at(bare.of(FLG_ATTRIBUTE_TANGENT), i),
                  normal = vec_at(bare.of(FLG_ATTRIBUTE_NORMAL), i);
        const Vec frame[] = {tangent, normal, cross(tangent, normal)};
        const auto in_frame = [&](const Heard& heard) {
            Vec d = vec_at(heard.of(FLG_ATTRIBUTE_POSITION), i);
            for (size_t k = 0; k < 3; ++k) d[k] -= bare.of(FLG_ATTRIBUTE_POSITION)[3 * i + k];
            return Vec{dot(d, frame[0]), dot(d, frame[1]), dot(d, frame[2])};
        };
        const Vec d = in_frame(once), b = in_frame(turned);
        for (size_t row = 0; row < 3; ++row) {
            const Vec of_row{basis[3 * row], basis[3 * row + 1], basis[3 * row + 2]};
            ASSERT_NEAR(b[row], dot(of_row, d), 2e-6) << i;
        }
        largest = std::max(largest, dot(d, d));
    }
    EXPECT_GT(std::sqrt(largest), 0.05);
}

// A coil that is run through slower and faster.
FlgCurveSet coil_with_speed(const Host& host, std::vector<float>& speeds) {
    Curves curves = coil(256, 8, 4, 0.2);
    for (size_t i = 0; i < 256; ++i) speeds.push_back(1.0f + 0.01f * static_cast<float>(i % 60));
    FlgCurveSetView view = curves.view();
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, curves.positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_SPEED, 1, speeds.data(), 0, 0}};
    view.columns = columns;
    view.column_count = 2;
    FlgCurveSet set{};
    EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
    return set;
}

// A live host with such a style.
struct MovingHost : LiveHost {
    std::vector<float> speeds;

    MovingHost() {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = coil_with_speed(*this, speeds);
        const FlgStyleAttribute speed{FLG_ATTRIBUTE_SPEED, FLG_METRIC_AUTO, 0, 0};
        desc.attributes = &speed;
        desc.attribute_count = 1;
        EXPECT_EQ(flgStyleCreate(context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
        warm(0);
        live.style = style;
    }
};

TEST(LiveStrokeTimes, SpeedsGiveTimes) {
    MovingHost host;
    for (size_t burst : {size_t{1}, size_t{50}}) {
        const FlgLiveStroke stroke = host.begin();
        const Samples samples = drawn(200);
        host.push_in_bursts(stroke, samples, {burst});
        ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 70, nullptr), FLG_OK);
        host.push(stroke, samples.data() + 130, 70);
        const Heard heard = heard_of(host.points(stroke));
        const std::vector<float>&times = heard.of(FLG_ATTRIBUTE_TIME), &speeds = heard.of(FLG_ATTRIBUTE_SPEED);
        ASSERT_GT(heard.points(), 100u);
        EXPECT_EQ(times[0], 0.0f);
        for (size_t i = 1; i < heard.points(); ++i) {
            const Vec a = vec_at(heard.of(FLG_ATTRIBUTE_POSITION), i - 1);
            const Vec b = vec_at(heard.of(FLG_ATTRIBUTE_POSITION), i);
            const double distance = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
            ASSERT_NEAR(times[i] - times[i - 1], distance / (0.5 * (speeds[i] + speeds[i - 1])), 2e-6) << i;
        }
    }
}

// Without a SPEED: when the hand was there.
TEST(LiveStrokeTimes, AreTheHands) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    const double spacing = host.info(stroke).spacing;
    const Heard heard = host.push_in_bursts(stroke, rolling(150), {1});
    for (size_t i = 0; i < heard.points(); ++i) {
        EXPECT_NEAR(heard.of(FLG_ATTRIBUTE_TIME)[i], spacing * static_cast<double>(i), 1e-5);
    }
}

TEST(LiveStrokeFrames, LiveEqualsBatchWithAllOptions) {
    MovingHost host;
    const float basis[] = {0, 1, 0, -1, 0, 0.5f, 0, 0, 1};
    std::copy(std::begin(basis), std::end(basis), host.live.basis);
    for (FlgFrameMethod frame : {FLG_FRAME_METHOD_ROTATION_MINIMIZING, FLG_FRAME_METHOD_SUPPLIED}) {
        for (float smoothing : {0.0f, 0.02f}) {
            host.live.frame = frame;
            host.live.smoothing = smoothing;
            const Samples samples = drawn(200);
            const Heard single = host.push_in_bursts(host.begin(), samples, {1});
            const FlgLiveStroke stroke = host.begin();
            EXPECT_TRUE(host.push_in_bursts(stroke, samples, {7, 30}) == single);
            ASSERT_EQ(flgLiveStrokeUndo(host.context, stroke, 61, nullptr), FLG_OK);
            host.push(stroke, samples.data() + 139, 61);
            EXPECT_TRUE(heard_of(host.points(stroke)) == single);
            const LiveHost::Ended ended = host.end(stroke);
            host.finish();
            EXPECT_TRUE(host.replay(host.live, ended.samples) == heard_of(host.view_of(ended.stylized)));
        }
    }
}

TEST(LiveStrokeFrames, RefusesWhatCannotBeFinal) {
    LiveHost host;
    const auto refused = [&](auto change, const char* words) {
        FlgLiveStrokeDesc desc = host.live;
        change(desc);
        FlgLiveStroke stroke{5};
        expect_failure(flgLiveStrokeBegin(host.context, &desc, &stroke), FLG_ERROR_INVALID_ARGUMENT, words);
        FlgCurveSet out{5};
        expect_failure(flgLiveStrokeReplay(host.context, &desc, host.create(arcs(1)), nullptr, &out, nullptr),
                       FLG_ERROR_INVALID_ARGUMENT, words);
    };
    refused([](auto& d) { d.frame = FLG_FRAME_METHOD_FRENET; }, "desc.frame is FLG_FRAME_METHOD_FRENET");
    refused([](auto& d) { d.frame = static_cast<FlgFrameMethod>(3); }, "desc.frame is 3");
    refused([](auto& d) { d.basis[4] = NAN; }, "desc.basis[4] is nan");
}

}  // namespace
}  // namespace flg::test
