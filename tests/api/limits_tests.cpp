// SPDX-License-Identifier: MIT
// Arguments at the ends of their ranges.
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <string>

#include "api/host.h"

namespace flg::test {
namespace {

TEST(StylizeApi, AnyTemperatureGivesAWalkOnTheStyle) {
    for (float size : {1.0f, 1e6f}) {
        for (uint32_t patch : {1u, 100u}) {
            for (float temperature : {1e30f, FLT_MAX}) {
                Host host;
                Curves example = coil(), target = arcs(1);
                for (float& v : example.positions) v *= size;
                for (float& v : target.positions) v *= size;
                FlgStyleDesc style = flgStyleDefaults();
                style.style = host.create(example);
                style.patch = patch;
                FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
                ASSERT_EQ(flgStyleCreate(host.context, &style, &desc.style, nullptr), FLG_OK);
                desc.target = host.create(target);
                desc.temperature = temperature;
                FlgCurveSet out{};
                FlgJob job{};
                ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
                host.finish();
                ASSERT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
                FlgStyleInfo info{};
                info.struct_size = sizeof info;
                ASSERT_EQ(flgStyleGetInfo(host.context, desc.style, &info), FLG_OK);
                const FlgCurveSetView view = host.view_of(out);
                const float* indices = find_column(view, FLG_ATTRIBUTE_STYLE_INDEX)->data;
                for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
                    ASSERT_GE(indices[i], 0.0f);
                    ASSERT_LT(indices[i], static_cast<float>(info.point_count));
                }
            }
        }
    }
}

struct Ready {
    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();

    explicit Ready(float size = 1, FlgAttribute attribute = FLG_ATTRIBUTE_WIDTH, float value = 1) {
        Curves example = coil(), target = arcs(1);
        for (float& v : example.positions) v *= size;
        std::vector<float> values(example.positions.size() / 3, value);
        FlgCurveSetView view = example.view();
        const FlgColumn columns[] = {view.columns[0], {attribute, 1, values.data(), 0, 0}};
        view.columns = columns;
        view.column_count = 2;
        const FlgStyleAttribute transferred{attribute, FLG_METRIC_AUTO, 0, 0};
        FlgStyleDesc style = flgStyleDefaults();
        style.attributes = &transferred;
        style.attribute_count = 1;
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &style.style), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(flgStyleCreate(host.context, &style, &desc.style, nullptr), FLG_OK) << flgErrorGetMessage();
        desc.target = host.create(target);
    }
    void expect_failing(FlgResult result, const char* words) {
        FlgCurveSet out{};
        FlgJob job{};
        ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), result);
        EXPECT_NE(std::string(host.status_of(job).error).find(words), std::string::npos) << host.status_of(job).error;
    }
    FlgCurveSetView done() {
        FlgCurveSet out{};
        FlgJob job{};
        EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
        return host.view_of(out);
    }
};

TEST(StylizeLimits, FactorsBeyondCoordinatesAreRefused) {
    Ready ready;
    const auto refused = [&](auto change, const char* words) {
        FlgCurveSetStylizeDesc desc = ready.desc;
        change(desc);
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetStylize(ready.host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
    };
    refused([](auto& d) { d.magnitude = -2e30f; }, "desc.magnitude is -2e+30, must be finite and at most 1e30 in size");
    refused([](auto& d) { d.scale = FLT_MAX; }, "desc.scale is 3.4");
    refused([](auto& d) { d.basis[7] = 1.5e30f; }, "desc.basis[7] is 1.5e+30, must be finite and at most 1e30 in size");
    refused([](auto& d) { d.max_points = (1u << 31) + 1; }, "must be at most 2^31");
}

// What each is allowed, and together is not.
TEST(StylizeLimits, ResultsBeyondCoordinatesFailTheJob) {
    constexpr FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;
    for (const bool pinned : {false, true}) {
        Ready ready(1e3f);
        ready.desc.pin_ends = pinned;
        ready.desc.magnitude = 1e30f;
        ready.expect_failing(invalid, "desc.magnitude is 1e+30: the result would have a coordinate of");
        ready.desc.magnitude = 1e25f;
        for (uint32_t i = 0; i < 3; ++i) ready.desc.basis[i] = 0;
        for (const float value : [&] {
                 const FlgCurveSetView view = ready.done();
                 const FlgColumn* positions = find_column(view, FLG_ATTRIBUTE_POSITION);
                 return std::vector<float>(positions->data, positions->data + 3 * size_t{view.curve_offsets[1]});
             }()) {
            ASSERT_LE(std::abs(value), 1e30f);
        }
    }
    Ready basis(1e3f);
    for (float& value : basis.desc.basis) value = 1e30f;
    basis.desc.magnitude = 0;
    basis.desc.keep_displacement = 1;
    basis.expect_failing(invalid, "with desc.basis the style's displacement would be");
    Ready widths(1, FLG_ATTRIBUTE_WIDTH, 1e30f);
    widths.desc.scale = 2;
    widths.expect_failing(invalid, "desc.scale is 2: attribute 11 of the style would be 2e+30 m");
    Ready slow(1e3f, FLG_ATTRIBUTE_SPEED, 2e-38f);
    slow.expect_failing(invalid, "the style's SPEED is as low as 2e-38 m/s");
}

TEST(StylizeLimits, ColumnsBeyondCoordinatesAreRefused) {
    Host host;
    Curves curves = arcs(1);
    for (const FlgAttribute attribute :
         {FLG_ATTRIBUTE_RADIUS, FLG_ATTRIBUTE_WIDTH, FLG_ATTRIBUTE_SPEED, FLG_ATTRIBUTE_ANGLE, FLG_ATTRIBUTE_USER}) {
        std::vector<float> values(curves.positions.size() / 3, 1e30f);
        FlgCurveSetView view = curves.view();
        const FlgColumn columns[] = {view.columns[0], {attribute, 1, values.data(), 0, 0}};
        view.columns = columns;
        view.column_count = 2;
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
        values[1] = 1.1e30f;
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find("at most 1e30 in size"), std::string::npos)
            << flgErrorGetMessage();
    }
}

TEST(StylizeLimits, MorePointsThanTheHostWantsAreRefused) {
    Ready ready;
    const uint32_t points = ready.done().curve_offsets[1];
    ASSERT_GT(points, 100u);
    ready.desc.max_points = points;
    EXPECT_EQ(ready.done().curve_offsets[1], points);
    ready.desc.max_points = points - 1;
    char words[64];
    std::snprintf(words, sizeof words, "desc.max_points is %u", points - 1);
    ready.expect_failing(FLG_ERROR_LIMIT, words);
    ready.desc.strokes = 3;
    ready.desc.max_points = 3 * points - 1;
    ready.expect_failing(FLG_ERROR_LIMIT, "desc.max_points is");
    ready.desc.max_points = 0;
    ready.desc.strokes = 1;
    ready.desc.scale = 1e-12f;
    ready.expect_failing(FLG_ERROR_LIMIT, "the limit is 2^31");
    // A point far away, by the descriptor as it comes.
    ready.desc.max_points = flgCurveSetStylizeDefaults().max_points;
    EXPECT_EQ(ready.desc.max_points, 1u << 26);
    ready.desc.scale = 1e-6f;
    ready.expect_failing(FLG_ERROR_LIMIT, "desc.max_points is 67108864");
}

}  // namespace
}  // namespace flg::test
