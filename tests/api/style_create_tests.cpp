// SPDX-License-Identifier: MIT
// Styles with attributes, several patch sizes, and several curves, through the C ABI.
#include "api/style_inputs.h"

namespace flg::test {
namespace {

constexpr FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;

TEST(StyleCreate, RefusesEachBadArgument) {
    Host host;
    const FlgCurveSet example = host.create(coil());
    const auto refused = [&](auto change, const char* words, FlgResult expected = invalid) {
        std::vector<FlgPatchSize> sizes = {{10, 1}, {20, 1}};
        std::vector<FlgStyleAttribute> attributes = {{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 1, 0},
                                                     {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 1, 0}};
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = example;
        desc.patch_sizes = sizes.data();
        desc.patch_size_count = 2;
        desc.attributes = attributes.data();
        desc.attribute_count = 2;
        change(desc, sizes, attributes);
        FlgStyle style{5};
        expect_failure(flgStyleCreate(host.context, &desc, &style, nullptr), expected, words);
        EXPECT_EQ(style.id, 0u);
    };
    refused([](auto& d, auto&, auto&) { d.patch_sizes = nullptr; }, "desc.patch_sizes is null");
    refused([](auto& d, auto&, auto&) { d.patch_size_count = 9; }, "desc.patch_size_count is 9");
    refused([](auto&, auto& s, auto&) { s[1].patch = 0; }, "desc.patch_sizes[1].patch is 0");
    refused([](auto&, auto& s, auto&) { s[0].patch = 1025; }, "desc.patch_sizes[0].patch is 1025");
    refused([](auto&, auto& s, auto&) { s[0].weight = 0; }, "desc.patch_sizes[0].weight is 0");
    refused([](auto&, auto& s, auto&) { s[1].weight = -1; }, "desc.patch_sizes[1].weight is -1");
    refused([](auto&, auto& s, auto&) { s[1].weight = INFINITY; }, "desc.patch_sizes[1].weight is inf");
    refused([](auto&, auto& s, auto&) { s[1].weight = NAN; }, "desc.patch_sizes[1].weight is nan");
    refused([](auto& d, auto&, auto&) { d.point_count = 41; }, "the largest patch in desc.patch_sizes is 20");
    refused([](auto& d, auto&, auto&) { d.attributes = nullptr; }, "desc.attributes is null");
    refused([](auto& d, auto&, auto&) { d.attribute_count = 9; }, "desc.attribute_count is 9");
    for (const FlgAttribute attribute :
         {FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL, FLG_ATTRIBUTE_TIME,
          FLG_ATTRIBUTE_PRESSURE, FLG_ATTRIBUTE_ORIENTATION, FLG_ATTRIBUTE_STYLE_INDEX, FLG_ATTRIBUTE_DISPLACEMENT,
          static_cast<FlgAttribute>(63)}) {
        refused([&](auto&, auto&, auto& a) { a[1].attribute = attribute; }, "desc.attributes[1].attribute is");
    }
    refused([](auto&, auto&, auto& a) { a[1].attribute = FLG_ATTRIBUTE_RADIUS; },
            "desc.attributes[1].attribute is 1, as is that of 0");
    refused([](auto&, auto&, auto& a) { a[0].metric = static_cast<FlgMetric>(4); }, "desc.attributes[0].metric is 4");
    refused([](auto&, auto&, auto& a) { a[0].metric = FLG_METRIC_CIRCLE; }, "desc.attributes[0].metric is 2");
    refused(
        [](auto&, auto&, auto& a) {
            a[0] = {FLG_ATTRIBUTE_COLOR, FLG_METRIC_PROJECTIVE, 1, 0};
        },
        "desc.attributes[0].metric is 3");
    refused([](auto&, auto&, auto& a) { a[0].weight = -1; }, "desc.attributes[0].weight is -1");
    refused([](auto&, auto&, auto& a) { a[1].weight = NAN; }, "desc.attributes[1].weight is nan");
    refused([](auto&, auto&, auto& a) { a[1].weight = INFINITY; }, "desc.attributes[1].weight is inf");
}

TEST(StyleCreate, AttributesThatTheStyleLacksAreRefused) {
    Host host;
    const auto expect_refused = [&](const FlgStyleDesc& desc, const char* words) {
        FlgStyle style{5};
        FlgJob job{5};
        expect_failure(flgStyleCreate(host.context, &desc, &style, &job), invalid, words);
        EXPECT_EQ(style.id, 0u);
        EXPECT_EQ(job.id, 0u);
    };
    FlgStyleAttribute attribute{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 1, 0};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil());
    desc.attributes = &attribute;
    desc.attribute_count = 1;
    expect_refused(desc, "desc.style has no column for desc.attributes[0]: ANGLE");
    const auto user = static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 3);
    attribute.attribute = user;
    expect_refused(desc, "desc.style has no column for desc.attributes[0]: USER + 3");
    // Curves that a job still makes: the job finds out.
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.curves = desc.style;
    resample.spacing = 0.1f;
    ASSERT_EQ(flgCurveSetResample(host.context, &resample, &desc.style, nullptr), FLG_OK) << flgErrorGetMessage();
    expect_failing_job(host, desc, invalid, "desc.style has no column for desc.attributes[0]: USER + 3");
    desc.style = Columns{coil()}.with(user, 2, [](auto i, auto) { return i; }).create(host);
    attribute.metric = FLG_METRIC_CIRCLE;
    expect_refused(desc, "desc.attributes[0]: metric 2 does not fit USER + 3 of 2 components");
}

TEST(StyleCreate, WeightsSteerTheGraphAndNoneLeavesItAlone) {
    Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style =
        Columns{coil()}.with(FLG_ATTRIBUTE_WIDTH, 1, [](auto i, auto) { return 1 + std::sin(0.9 * i); }).create(host);
    const FlgStyleInfo plain = style_info(host, prepare(host, desc));
    FlgStyleAttribute attribute{FLG_ATTRIBUTE_WIDTH, FLG_METRIC_AUTO, 0, 0};
    desc.attributes = &attribute;
    desc.attribute_count = 1;
    EXPECT_EQ(style_info(host, prepare(host, desc)).temperature_unit, plain.temperature_unit);
    attribute.weight = 1;
    EXPECT_GT(style_info(host, prepare(host, desc)).temperature_unit, 2 * plain.temperature_unit);
}

// Attributes that tell where on the style they are: they come back as the matching says.
TEST(StyleCreate, AttributesComeBackOnTheStylesOwnGuide) {
    Host host;
    Columns columns{coil(600)};
    std::vector<double> arc_lengths{0};
    const std::vector<float>& p = columns.curves.positions;
    for (size_t i = 3; i < p.size(); i += 3) {
        const double step = std::hypot(p[i] - p[i - 3], p[i + 1] - p[i - 2], p[i + 2] - p[i - 1]);
        arc_lengths.push_back(arc_lengths.back() + step);
    }
    columns.with(FLG_ATTRIBUTE_WIDTH, 1, [&](auto i, auto) { return arc_lengths[i]; })
        .with(FLG_ATTRIBUTE_ANGLE, 1, [&](auto i, auto) { return std::remainder(2 * arc_lengths[i], 2 * M_PI); })
        .with(FLG_ATTRIBUTE_COLOR, 4, [&](auto i, auto k) { return k * arc_lengths[i]; });
    const FlgStyleAttribute attributes[3] = {{FLG_ATTRIBUTE_WIDTH, FLG_METRIC_AUTO, 0, 0},
                                             {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 0.1f, 0},
                                             {FLG_ATTRIBUTE_COLOR, FLG_METRIC_AUTO, 0, 0}};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = columns.create(host);
    desc.attributes = attributes;
    desc.attribute_count = 3;
    FlgCurveSetStylizeDesc stylize_desc = flgCurveSetStylizeDefaults();
    stylize_desc.style = prepare(host, desc);
    ASSERT_EQ(flgStyleGetGuide(host.context, stylize_desc.style, &stylize_desc.target), FLG_OK);
    const FlgCurveSetView view = host.view_of(stylize(host, stylize_desc));
    const FlgStyleInfo info = style_info(host, stylize_desc.style);
    ASSERT_EQ(view.curve_offsets[1], info.point_count);
    const FlgColumn* width = find_column(view, FLG_ATTRIBUTE_WIDTH);
    const FlgColumn* angle = find_column(view, FLG_ATTRIBUTE_ANGLE);
    const FlgColumn* color = find_column(view, FLG_ATTRIBUTE_COLOR);
    ASSERT_TRUE(width && angle && color);
    for (uint32_t i = 0; i < info.point_count; ++i) {
        // The polyline is shorter than the smooth curve, by the same share everywhere but for the coil's wobble.
        const double s = info.matching[i] * (arc_lengths.back() / info.style_length);
        EXPECT_NEAR(width->data[i], s, 1e-3) << i;
        EXPECT_NEAR(std::remainder(angle->data[i] - 2 * width->data[i], 2 * M_PI), 0, 1e-4) << i;
        for (uint32_t k = 0; k < 4; ++k) EXPECT_NEAR(color->data[4 * i + k], k * width->data[i], 1e-4) << i;
    }
}

TEST(StyleCreate, SeveralCurvesShareOneSpacingAndOneGraph) {
    Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coils({3, 6, 1.5}));
    desc.point_count = 700;
    const FlgStyle style = prepare(host, desc);
    const FlgStyleInfo info = style_info(host, style);
    EXPECT_EQ(info.point_count, 700u);
    EXPECT_NEAR(info.spacing, info.guide_length / 697, 1e-6);
    FlgCurveSet guide{};
    ASSERT_EQ(flgStyleGetGuide(host.context, style, &guide), FLG_OK);
    const FlgCurveSetView view = host.view_of(guide);
    ASSERT_EQ(view.curve_count, 3u);
    for (uint32_t c = 0; c < 3; ++c) {
        const uint32_t first = view.curve_offsets[c], end = view.curve_offsets[c + 1];
        for (uint32_t i = first + 1; i < end; ++i) {
            const float* p = view.columns[0].data + 3 * size_t{i};
            const double step = std::hypot(p[0] - p[-3], p[1] - p[-2], p[2] - p[-1]);
            EXPECT_NEAR(step, info.spacing, info.spacing * 1.5 / (end - first));
            EXPECT_GE(info.matching[i], info.matching[i - 1]);
        }
        EXPECT_EQ(info.matching[first], 0);
    }
    // Long results come by all three.
    FlgCurveSetStylizeDesc stylize_desc = flgCurveSetStylizeDefaults();
    stylize_desc.style = style;
    stylize_desc.temperature = 1;
    stylize_desc.target = host.create(arcs(20, 60, 60));
    const FlgCurveSetView result = host.view_of(stylize(host, stylize_desc));
    const FlgColumn* index = find_column(result, FLG_ATTRIBUTE_STYLE_INDEX);
    std::vector<int> visits(3);
    for (uint32_t i = 0; i < result.curve_offsets[20]; ++i) {
        uint32_t c = 0;
        while (index->data[i] >= static_cast<float>(view.curve_offsets[c + 1])) ++c;
        ++visits[c];
    }
    for (const int count : visits) EXPECT_GT(count, 100);
}

TEST(StyleCreate, GuidesOfSeveralCurvesCanBeGiven) {
    Host host;
    Curves lines;
    for (const double length : {3.0, 6.0}) {
        for (int i = 0; i < 5; ++i) lines.add_point(length * i / 4, lines.flags.empty() ? 0 : 2, 0);
        lines.end_curve();
    }
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coils({3, 6}));
    desc.guide = host.create(lines);
    desc.point_count = 302;
    const FlgStyle style = prepare(host, desc);
    EXPECT_NEAR(style_info(host, style).guide_length, 9, 1e-5);
    FlgCurveSet guide{};
    ASSERT_EQ(flgStyleGetGuide(host.context, style, &guide), FLG_OK);
    const FlgCurveSetView view = host.view_of(guide);
    EXPECT_EQ(view.curve_offsets[1], 101u);
    EXPECT_EQ(view.curve_offsets[2], 302u);
    EXPECT_NEAR(view.columns[0].data[3 * 301], 6, 1e-5);
    EXPECT_NEAR(view.columns[0].data[3 * 301 + 1], 2, 1e-5);
}

TEST(StyleCreate, ScenesThatAreNoStyleFailTheirJob) {
    Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    Curves curves = coils({3, 3});
    curves.flags[1] = FLG_CURVE_CLOSED;
    desc.style = host.create(curves);
    expect_failing_job(host, desc, invalid, "curve 1 of desc.style is closed");
    curves = coils({3});
    curves.add_point(1, 1, 1);
    curves.end_curve();
    desc.style = host.create(curves);
    expect_failing_job(host, desc, invalid, "curve 1 of desc.style has no length: its 1 point is the same place");
    desc.style = host.create(coils({3, 3}));
    desc.guide = host.create(coils({3}));
    expect_failing_job(host, desc, invalid, "desc.guide has 1 curves");
    desc.guide = {};
    desc.patch = 100;
    desc.point_count = 300;
    expect_failing_job(host, desc, invalid, "desc.patch is 100: its 201 points must be fewer than the style's longest");
    desc.patch = 1;
    desc.point_count = 16;
    desc.style = host.create(coils(std::vector<double>(9, 1.0)));
    expect_failing_job(host, desc, invalid, "desc.point_count is 16, too few for the 9 curves");
    Curves many;
    for (int c = 0; c < 257; ++c) {
        many.add_point(0, c, 0);
        many.add_point(1, c, 0);
        many.end_curve();
    }
    desc.style = host.create(many);
    expect_failing_job(host, desc, FLG_ERROR_LIMIT, "desc.style has 257 curves, may have 256");
}

// Neither shape nor attribute varies, on one curve and on two, the first of which is too short for a patch.
TEST(StyleCreate, StylesWithoutVariationWork) {
    Host host;
    for (const bool two : {false, true}) {
        Columns lines;
        if (two) {
            lines.curves.add_point(0, 1, 0);
            lines.curves.add_point(0.1, 1, 0);
            lines.curves.end_curve();
        }
        lines.curves.add_point(0, 0, 0);
        lines.curves.add_point(5, 0, 0);
        lines.curves.end_curve();
        lines.with(FLG_ATTRIBUTE_ANGLE, 1, [](auto, auto) { return 0.5; });
        FlgStyleAttribute attribute{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_PROJECTIVE, 1, 0};
        const FlgPatchSize sizes[2] = {{10, 1}, {3, 1}};
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = lines.create(host);
        desc.attributes = &attribute;
        desc.attribute_count = 1;
        desc.patch_sizes = sizes;
        desc.patch_size_count = 2;
        FlgCurveSetStylizeDesc stylize_desc = flgCurveSetStylizeDefaults();
        stylize_desc.style = prepare(host, desc);
        EXPECT_NEAR(style_info(host, stylize_desc.style).displacement_rms, 0, 1e-6);
        EXPECT_NEAR(style_info(host, stylize_desc.style).temperature_unit, 0, 1e-6);
        for (const FlgStyleStart start : {FLG_STYLE_START_STYLE, FLG_STYLE_START_RANDOM}) {
            stylize_desc.start = start;
            stylize_desc.target = host.create(arcs(1));
            const FlgCurveSetView result = host.view_of(stylize(host, stylize_desc));
            EXPECT_GT(result.curve_offsets[1], 100u);
            // The short curve is not used.
            const FlgColumn* index = find_column(result, FLG_ATTRIBUTE_STYLE_INDEX);
            for (uint32_t i = 0; i < result.curve_offsets[1]; ++i) {
                ASSERT_LT(index->data[i], 256);
                ASSERT_GE(index->data[i], two ? 5 : 0);
            }
        }
    }
}

TEST(StyleCreate, SameBitsUnderAnyBudgetWithEverythingOn) {
    Host host;
    Columns curves{coils({3, 6, 1.5, 2})};
    curves.with(FLG_ATTRIBUTE_COLOR, 4, [](auto i, auto k) { return std::sin(0.1 * i + k); })
        .with(FLG_ATTRIBUTE_ANGLE, 1, [](auto i, auto) { return 0.1 * i; });
    const FlgStyleAttribute attributes[2] = {{FLG_ATTRIBUTE_COLOR, FLG_METRIC_AUTO, 0.1f, 0},
                                             {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_AUTO, 0.1f, 0}};
    const FlgPatchSize sizes[2] = {{10, 1}, {3, 1}};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curves.create(host);
    desc.attributes = attributes;
    desc.attribute_count = 2;
    desc.patch_sizes = sizes;
    desc.patch_size_count = 2;
    std::string expected;
    for (const uint32_t budget_us : {FLG_UNLIMITED, 100u}) {
        FlgStyle style{};
        ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK);
        host.finish(budget_us);
        size_t size = 0;
        ASSERT_EQ(flgStyleGetData(host.context, style, nullptr, 0, &size), FLG_OK);
        std::string data(size, 0);
        ASSERT_EQ(flgStyleGetData(host.context, style, data.data(), size, &size), FLG_OK);
        if (expected.empty()) expected = data;
        EXPECT_TRUE(data == expected);
    }
}

}  // namespace
}  // namespace flg::test
