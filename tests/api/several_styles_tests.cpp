// SPDX-License-Identifier: MIT
// Several styles along one target, and how one turns into the next.
#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

constexpr auto chooser = static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 3);
constexpr double target_length = 20;

Curves straight(double over = 1) {
    Curves curves;
    curves.add_point(0, 0, 0);
    curves.add_point(6 * over, 0, 0);
    curves.end_curve();
    return curves;
}

class SeveralStyles : public testing::Test {
protected:
    SeveralStyles() {
        for (const double radius : {0.1, 0.3}) styles.push_back(learn(radius, radius < 0.2 ? 512 : 300));
        desc.style = styles[0];
        desc.further_styles = &styles[1];
        desc.further_style_count = 1;
        desc.keep_displacement = 1;
        desc.drives = &choice;
        desc.drive_count = 1;
    }
    FlgStyle learn(double radius, uint32_t points, bool with_radius = false) {
        FlgStyleDesc style = flgStyleDefaults();
        style.point_count = points;
        Columns example{coil(400, 12, 6, radius)};
        if (with_radius) example.with(FLG_ATTRIBUTE_RADIUS, 1, [=](uint32_t, uint32_t) { return radius; });
        style.style = example.create(host);
        style.guide = host.create(straight());
        const FlgStyleAttribute attribute{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 0.1f, 0};
        style.attributes = &attribute;
        style.attribute_count = with_radius ? 1 : 0;
        return prepare(host, style);
    }
    // The chooser column goes evenly from one value to the other; a line, or once around.
    Columns target(double from, double to, bool closed = false) const {
        Columns columns;
        const uint32_t count = 101;
        for (uint32_t i = 0; i < count; ++i) {
            const double s = target_length * i / (count - (closed ? 0 : 1));
            const double r = target_length / (2 * M_PI);
            if (closed) {
                columns.curves.add_point(r * std::cos(s / r), r * std::sin(s / r), 0);
            } else {
                columns.curves.add_point(s, 0, 0);
            }
        }
        columns.curves.end_curve(closed ? FLG_CURVE_CLOSED : 0);
        return columns.with(chooser, 1, [=](uint32_t i, uint32_t) { return from + (to - from) * i / (count - 1); });
    }
    Heard along(Columns columns) {
        desc.target = columns.create(host);
        return heard_of(host.view_of(stylize(host, desc)));
    }
    Heard alone(Columns columns, uint32_t style) {
        FlgCurveSetStylizeDesc one = desc;
        one.style = styles[style];
        one.further_styles = nullptr;
        one.further_style_count = one.drive_count = 0;
        one.target = columns.create(host);
        return heard_of(host.view_of(stylize(host, one)));
    }

    Host host;
    std::vector<FlgStyle> styles;
    FlgStyleDrive choice{chooser, FLG_STYLE_DRIVEN_STYLE, 0, 1, 0, 1};
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
};

// Where one style is chosen all along, the result is that style's: its points, or what lies between them.
TEST_F(SeveralStyles, OneThatIsAloneIsItself) {
    for (const bool closed : {false, true}) {
        EXPECT_TRUE(along(target(0, 0, closed)) == alone(target(0, 0, closed), 0));
        const Heard second = along(target(1, 1, closed)), own = alone(target(1, 1, closed), 1);
        const double ratio =
            static_cast<double>(own.points() - (closed ? 0 : 1)) / (second.points() - (closed ? 0 : 1));
        const auto &p = second.of(FLG_ATTRIBUTE_POSITION), &q = own.of(FLG_ATTRIBUTE_POSITION);
        for (size_t i = 0; i < second.points(); ++i) {
            const double at = static_cast<double>(i) * ratio;
            const auto j = std::min(static_cast<size_t>(at), own.points() - 1);
            const size_t next = closed ? (j + 1) % own.points() : std::min(j + 1, own.points() - 1);
            for (size_t c = 0; c < 3; ++c) {
                const double expected = q[3 * j + c] + (at - static_cast<double>(j)) * (q[3 * next + c] - q[3 * j + c]);
                ASSERT_NEAR(p[3 * i + c], expected, 1e-5) << i;
            }
        }
    }
}

// Half of the stretch before the middle, half behind: in between the weights are those of the cubic.
TEST_F(SeveralStyles, OneTurnsIntoTheNextOverTheBlend) {
    desc.style_blend = 4;
    const Heard mixed = along(target(0, 1)), first = along(target(0, 0)), second = along(target(1, 1));
    ASSERT_EQ(mixed.points(), first.points());
    ASSERT_EQ(mixed.points(), second.points());
    for (size_t i = 0; i < mixed.points(); ++i) {
        const double s = target_length * static_cast<double>(i) / static_cast<double>(mixed.points() - 1);
        const double r = std::clamp((s - 8) / 4, 0.0, 1.0), weight = r * r * (3 - 2 * r);
        for (const FlgAttribute column : {FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_DISPLACEMENT}) {
            for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
                const double expected = (1 - weight) * first.of(column)[c] + weight * second.of(column)[c];
                ASSERT_NEAR(mixed.of(column)[c], expected, 1e-4) << i;
            }
        }
        const float points = static_cast<float>(style_info(host, styles[0]).point_count);
        const float index = mixed.of(FLG_ATTRIBUTE_STYLE_INDEX)[i];
        if (weight < 0.45) {
            EXPECT_LT(index, points);
        }
        if (weight > 0.55) {
            EXPECT_GE(index, points);
        }
    }
}

TEST_F(SeveralStyles, AClosedTargetBlendsOverItsStart) {
    desc.style_blend = 2;
    // Style 1 on the first half: one change in the middle, one at the start.
    const Heard mixed = along(target(1, 0, true));
    const auto& p = mixed.of(FLG_ATTRIBUTE_POSITION);
    const auto distance = [&](size_t i, size_t j) {
        return std::hypot(double{p[3 * i]} - p[3 * j], double{p[3 * i + 1]} - p[3 * j + 1],
                          double{p[3 * i + 2]} - p[3 * j + 2]);
    };
    double longest = 0;
    for (size_t i = 1; i < mixed.points(); ++i) longest = std::max(longest, distance(i, i - 1));
    EXPECT_LT(distance(0, mixed.points() - 1), 1.5 * longest);
    // The change is half of an edge before the first point.
    const double r = 0.5 + 0.5 * target_length / 101 / 2, weight = r * r * (3 - 2 * r);
    const Heard first = along(target(0, 0, true)), second = along(target(1, 1, true));
    for (size_t c = 0; c < 3; ++c) {
        const double expected =
            (1 - weight) * first.of(FLG_ATTRIBUTE_POSITION)[c] + weight * second.of(FLG_ATTRIBUTE_POSITION)[c];
        EXPECT_NEAR(p[c], expected, 1e-4);
    }
}

TEST_F(SeveralStyles, AttributesBlendToo) {
    styles = {learn(0.1, 512, true), learn(0.3, 300, true)};
    desc.style = styles[0];
    desc.further_styles = &styles[1];
    desc.style_blend = 4;
    const Heard mixed = along(target(0, 1));
    for (size_t i = 0; i < mixed.points(); ++i) {
        const double s = target_length * static_cast<double>(i) / static_cast<double>(mixed.points() - 1);
        const double r = std::clamp((s - 8) / 4, 0.0, 1.0), weight = r * r * (3 - 2 * r);
        EXPECT_NEAR(mixed.of(FLG_ATTRIBUTE_RADIUS)[i], 0.1 + 0.2 * weight, 1e-3) << i;
    }
}

TEST_F(SeveralStyles, OtherOptionsGoOnWorking) {
    const FlgStyleDrive drives[] = {choice, {chooser, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 0.5f}};
    desc.drives = drives;
    desc.drive_count = 2;
    desc.strokes = 2;
    desc.pin_ends = desc.smooth_junctions = 1;
    const Heard pinned = along(target(0, 1));
    EXPECT_EQ(pinned.of(FLG_ATTRIBUTE_POSITION)[0], 0);
    desc.scale = 0;
    desc.fit = 0.5f;
    EXPECT_GT(along(target(0, 1)).points(), 10u);
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    EXPECT_GT(along(target(0, 1, true)).points(), 10u);
}

TEST_F(SeveralStyles, SameBitsUnderAnyWorkersAndBudgets) {
    expect_same_bits([&](const Host& other) {
        FlgStyle own[2];
        for (int k = 0; k < 2; ++k) {
            FlgStyleDesc style = flgStyleDefaults();
            style.style = other.create(coil(300, 10 + 4 * k, 6, 0.2));
            EXPECT_EQ(flgStyleCreate(other.context, &style, &own[k], nullptr), FLG_OK);
        }
        FlgCurveSetStylizeDesc wanted = flgCurveSetStylizeDefaults();
        wanted.style = own[0];
        wanted.further_styles = &own[1];
        wanted.further_style_count = 1;
        Columns targets{arcs(40)};
        wanted.target = targets.with(chooser, 1, [](uint32_t i, uint32_t) { return 0.02 * (i % 60); }).create(other);
        wanted.drives = &choice;
        wanted.drive_count = 1;
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetStylize(other.context, &wanted, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        return out;
    });
}

TEST_F(SeveralStyles, Refusals) {
    desc.target = target(0, 1).create(host);
    FlgCurveSet out{};
    const auto expect_refused = [&](const char* words) {
        expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, words);
    };
    desc.style_blend = -1;
    expect_refused("desc.style_blend");
    desc.style_blend = 0;
    desc.further_style_count = 8;
    expect_refused("desc.further_style_count");
    desc.further_style_count = 0;
    expect_refused("drives the style");
    desc.further_style_count = 1;
    desc.drive_count = 0;
    expect_refused("none of desc.drives drives the style");
    const FlgStyleDrive twice[] = {choice, choice};
    desc.drives = twice;
    desc.drive_count = 2;
    expect_refused("desc.drives[1] drives the style");
    desc.drive_count = 1;
    FlgStyleDrive beyond = choice;
    desc.drives = &beyond;
    beyond.at_to = 4;
    expect_refused("desc.drives[0].at_to is 4, must be the number of a style, 0 to desc.further_style_count, 1");
    beyond = choice;
    beyond.at_from = 1.5f;
    expect_refused("desc.drives[0].at_from");
    desc.drives = twice;
    desc.further_styles = nullptr;
    expect_refused("desc.further_styles");
    const FlgStyle other = learn(0.2, 300, true);
    desc.further_styles = &other;
    FlgJob job{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::strstr(host.status_of(job).error, "other attributes"), nullptr);
}

}  // namespace
}  // namespace flg::test
