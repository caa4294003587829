// SPDX-License-Identifier: MIT
// Scale 0: the SDK sizes the style on each curve. Closed forms for straight lines and circles, what must not matter,
// and what the rule is for: painted strokes.
#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

using Transform = std::function<std::array<double, 3>(double, double, double)>;

Curves moved(const Curves& curves, const Transform& transform, double radius_factor = 1) {
    Curves out = curves;
    for (size_t i = 0; i < out.positions.size(); i += 3) {
        const auto p = transform(curves.positions[i], curves.positions[i + 1], curves.positions[i + 2]);
        for (size_t k = 0; k < 3; ++k) out.positions[i + k] = static_cast<float>(p[k]);
    }
    for (float& radius : out.radii) radius *= static_cast<float>(radius_factor);
    return out;
}

void add_line(Curves& curves, double length, double height, double radius = -1, uint32_t points = 20) {
    for (uint32_t i = 0; i < points; ++i) {
        curves.add_point(length * i / (points - 1), height, 0);
        if (radius >= 0) curves.radii.push_back(static_cast<float>(radius));
    }
    curves.end_curve();
}

Curves line(double length, double radius = -1) {
    Curves curves;
    add_line(curves, length, 0, radius);
    return curves;
}

Curves circle(double radius) {
    Curves curves;
    for (uint32_t i = 0; i < 720; ++i) {
        const double a = 2 * M_PI * i / 720;
        curves.add_point(radius * std::cos(a), radius * std::sin(a), 0);
    }
    curves.end_curve(FLG_CURVE_CLOSED);
    return curves;
}

struct Sized {
    FlgStyle style{};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    std::vector<float> scales;
};

FlgStyle prepared(const Host& host, const Curves& example, const Curves& guide) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(example);
    desc.guide = host.create(guide);
    FlgStyle style{};
    EXPECT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    return style;
}

std::vector<float> scales_of(const Host& host, FlgCurveSet set) {
    FlgCurveSetScales scales = flgCurveSetScalesDefaults();
    EXPECT_EQ(flgCurveSetGetScales(host.context, set, &scales), FLG_OK) << flgErrorGetMessage();
    return {scales.scales, scales.scales + scales.curve_count};
}

Sized sized(const Host& host, FlgStyle style, const Curves& target, float scale = 0, uint32_t strokes = 1) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.target = host.create(target);
    desc.scale = scale;
    desc.strokes = strokes;
    desc.keep_displacement = 1;
    desc.start = FLG_STYLE_START_STYLE;
    FlgCurveSet out{};
    FlgJob job{};
    EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK);
    return {style, host.view_of(out), scales_of(host, out)};
}

// Around the x axis, from 0 to `length`.
FlgStyle coil_style(const Host& host, double unit = 1) {
    return prepared(host, coil(400, 12, 6 * unit, 0.25 * unit), line(6 * unit));
}

TEST(AutomaticScale, HasTheProportionOfTheExample) {
    Host host;
    const FlgStyle style = coil_style(host);
    Curves target;
    add_line(target, 6, 0);
    add_line(target, 0.6, 3);
    add_line(target, 90, 5);
    const std::vector<float> scales = sized(host, style, target).scales;
    ASSERT_EQ(scales.size(), 3u);
    EXPECT_NEAR(scales[0], 1, 1e-5);
    EXPECT_NEAR(scales[1], 0.1, 1e-6);
    EXPECT_NEAR(scales[2], 15, 1e-4);
    // A circle's points are a radius away from their centre: D = sqrt(12) r, L = 2 pi r.
    const double spread = std::sqrt(12.0) * 2, around = 2 * M_PI * 2;
    EXPECT_NEAR(sized(host, style, circle(2)).scales[0], spread * std::cbrt(spread / around) / 6, 1e-4);
}

TEST(AutomaticScale, SwingsAsWideAsAStrokeWasPainted) {
    Host host;
    const FlgStyle style = coil_style(host);
    host.finish();
    const double rms = style_info(host, style).displacement_rms;
    const auto scale = [&](double length, double radius) { return sized(host, style, line(length, radius)).scales[0]; };
    EXPECT_NEAR(scale(6, 0.1), 1.2 * 0.1 / rms, 1e-4);
    EXPECT_NEAR(scale(6, 0.001), 1.0 / 8, 1e-5) << "no finer than that";
    EXPECT_NEAR(scale(6, 10), 1.25, 1e-5) << "no coarser";
    EXPECT_NEAR(scale(6, 0), 1, 1e-5) << "as without a radius";
}

TEST(AutomaticScale, MakesTheRadiusThinner) {
    Host host;
    const FlgStyle style = coil_style(host);
    const Sized thick = sized(host, style, line(6, 0.1));
    const float rms = style_info(host, style).displacement_rms;
    const auto radius = [](const Sized& s) { return find_column(s.view, FLG_ATTRIBUTE_RADIUS)->data; };
    for (uint32_t i = 0; i < thick.view.curve_offsets[1]; ++i)
        ASSERT_NEAR(radius(thick)[i], 0.14f * rms * thick.scales[0], 1e-6);
    EXPECT_NEAR(radius(sized(host, style, line(6, 0.001)))[0], 0.001f, 1e-8) << "thin enough";
    EXPECT_EQ(radius(sized(host, style, line(6, 0.1), 1))[0], 0.1f) << "scale given: as it was";
}

TEST(AutomaticScale, IsThatOfACallWithTheSameScale) {
    for (uint32_t workers : {0u, 3u}) {
        Host host(workers);
        const FlgStyle style = coil_style(host);
        Curves both;
        add_line(both, 3, 0);
        add_line(both, 40, 2);
        const Sized chosen = sized(host, style, both, 0, 2);
        ASSERT_EQ(chosen.scales.size(), 4u);
        const auto positions = [](const Sized& s) { return find_column(s.view, FLG_ATTRIBUTE_POSITION)->data; };
        const Sized first = sized(host, style, both, chosen.scales[0], 2);
        ASSERT_EQ(first.view.curve_offsets[1], chosen.view.curve_offsets[1]);
        for (uint32_t i = 0; i < 3 * first.view.curve_offsets[1]; ++i)
            ASSERT_NEAR(positions(first)[i], positions(chosen)[i], 1e-6);
        EXPECT_EQ(first.scales, std::vector<float>(4, chosen.scales[0]));
    }
}

// A similarity of the target multiplies scales, one of the style divides them; the order of curves does not matter.
TEST(AutomaticScale, IsEquivariantUnderSimilarities) {
    Host host;
    const Curves target = arcs(5, 60, 7);
    const std::vector<float> expected = sized(host, coil_style(host), target).scales;
    const auto turned = [](double x, double y, double z) -> std::array<double, 3> {
        return {7 * (0.36 * x + 0.48 * y - 0.8 * z) + 5, 7 * (-0.8 * x + 0.6 * y) - 90,
                7 * (0.48 * x + 0.64 * y + 0.6 * z)};
    };
    const std::vector<float> larger = sized(host, coil_style(host), moved(target, turned, 7)).scales;
    const std::vector<float> smaller = sized(host, coil_style(host, 4), target).scales;
    Curves reversed;
    for (uint32_t c = 5; c-- > 0;) {
        for (uint32_t i = target.offsets[c]; i < target.offsets[c + 1]; ++i) {
            reversed.add_point(target.positions[3 * i], target.positions[3 * i + 1], target.positions[3 * i + 2]);
            reversed.radii.push_back(target.radii[i]);
        }
        reversed.end_curve();
    }
    const std::vector<float> backwards = sized(host, coil_style(host), reversed).scales;
    for (size_t c = 0; c < 5; ++c) {
        EXPECT_NEAR(larger[c], 7 * expected[c], 1e-4 * larger[c]);
        EXPECT_NEAR(smaller[c], expected[c] / 4, 1e-4 * smaller[c]);
        EXPECT_EQ(backwards[4 - c], expected[c]);
    }
}

TEST(AutomaticScale, IsFiniteForDegenerateTargets) {
    Host host;
    Curves target;
    target.add_point(1, 2, 3);
    target.end_curve();
    for (int i = 0; i < 5; ++i) target.add_point(1, 1, 1);
    target.end_curve();
    for (double x : {0.0, 1e-38, 3e-38}) target.add_point(x, 0, 0);
    target.end_curve();
    for (double x : {0.0, 1e29, 5e29}) target.add_point(x, 0, 0);
    target.end_curve();
    for (double x : {0.0, 1.0, 0.0}) target.add_point(x, 0, 0);
    target.end_curve(FLG_CURVE_CLOSED);
    target.radii.assign(target.positions.size() / 3, 0.01f);
    target.radii[0] = 0;
    for (const auto& style : {coil_style(host), prepared(host, line(6), line(6))}) {
        for (const float scale : sized(host, style, target).scales) {
            EXPECT_TRUE(std::isfinite(scale) && scale > 0) << scale;
        }
    }
    EXPECT_EQ(sized(host, coil_style(host), target).scales[1], 1.0f);
}

// A sketch as painting programs have it: broad dabs, thin outlines, a lettered flourish.
TEST(AutomaticScale, KeepsPaintedSketchesLegible) {
    Host host;
    const FlgStyle style = coil_style(host);
    Curves sketch;
    add_line(sketch, 0.12, 0, 0.02);  // a dab
    add_line(sketch, 2.0, 1, 0.004);  // an outline
    add_line(sketch, 0.8, 2, 0.05);   // a broad stroke
    const Sized result = sized(host, style, sketch);
    const FlgStyleInfo info = style_info(host, style);
    for (uint32_t c = 0; c < 3; ++c) {
        const double radius = sketch.radii[sketch.offsets[c]];
        const double length = sketch.positions[3 * (sketch.offsets[c + 1] - 1)];
        const double swing = static_cast<double>(result.scales[c]) * static_cast<double>(info.displacement_rms);
        EXPECT_LE(swing, 4 * radius) << "curve " << c << " leaves its stroke";
        EXPECT_GE(swing, 0.2 * std::min(radius, 0.05 * length)) << "curve " << c << " has turns too small to see";
        const double turns = length / (static_cast<double>(result.scales[c]) * 6 / 12);
        EXPECT_GE(turns, 5) << "curve " << c << " shows nothing of the style";
        EXPECT_LE(turns, 100) << "curve " << c;
        const float* drawn = find_column(result.view, FLG_ATTRIBUTE_RADIUS)->data;
        EXPECT_LE(drawn[result.view.curve_offsets[c]], 0.15 * swing) << "curve " << c << ": turns touch";
    }
}

TEST(AutomaticScale, SetsWithoutAStyleHaveNone) {
    Host host;
    FlgCurveSetScales scales = flgCurveSetScalesDefaults();
    EXPECT_EQ(flgCurveSetGetScales(host.context, host.create(line(1)), &scales), FLG_OK);
    EXPECT_EQ(scales.curve_count, 0u);
    EXPECT_EQ(scales.scales, nullptr);
    EXPECT_EQ(flgCurveSetGetScales(host.context, {}, &scales), FLG_ERROR_INVALID_HANDLE);
    EXPECT_EQ(flgCurveSetGetScales(host.context, host.create(line(1)), nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

TEST(AutomaticScale, LiveStrokesTakeItFromTheirRadii) {
    Host host;
    const FlgStyle style = coil_style(host);
    EXPECT_EQ(flgStyleWarm(host.context, style, 0, nullptr, nullptr), FLG_OK);
    host.finish();
    const FlgStyleInfo style_info_now = style_info(host, style);
    const auto scale = [&](float least, float most, float given) {
        FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
        desc.style = style;
        desc.scale = given;
        desc.min_radius = least;
        desc.max_radius = most;
        FlgLiveStroke stroke{};
        EXPECT_EQ(flgLiveStrokeBegin(host.context, &desc, &stroke), FLG_OK) << flgErrorGetMessage();
        FlgLiveStrokeInfo info = flgLiveStrokeInfoDefaults();
        EXPECT_EQ(flgLiveStrokeGetInfo(host.context, stroke, &info), FLG_OK);
        EXPECT_NEAR(info.spacing, info.scale * style_info_now.spacing, 1e-6f);
        EXPECT_EQ(flgLiveStrokeRelease(host.context, stroke), FLG_OK);
        return info.scale;
    };
    EXPECT_NEAR(scale(0.01f, 0.03f, 0), 0.02f / (0.14f * style_info_now.displacement_rms), 1e-5f);
    EXPECT_EQ(scale(0, 0, 0), 1.0f);
    EXPECT_EQ(scale(0.01f, 0.03f, 0.7f), 0.7f);
}

}  // namespace
}  // namespace flg::test
