// SPDX-License-Identifier: MIT
// Curves with fewer points: what stays within the tolerances, what is kept, what is refused.
#include <algorithm>

#include "api/host.h"
#include "filigree/filigree.h"

namespace flg::test {
namespace {

// `set` is released.
FlgCurveSetView simplify(Host& host, FlgCurveSet set, const std::vector<float>& tolerances, uint32_t ribbons = 0) {
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    desc.curves = set;
    desc.level_count = static_cast<uint32_t>(tolerances.size());
    desc.tolerances = tolerances.data();
    desc.ribbons = ribbons;
    FlgCurveSet out{};
    EXPECT_EQ(flgCurveSetSimplify(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(flgCurveSetRelease(host.context, set), FLG_OK);
    host.finish();
    return host.view_of(out);
}

const float* point(const FlgCurveSetView& view, uint32_t row) {
    return find_column(view, FLG_ATTRIBUTE_POSITION)->data + size_t{3} * row;
}

double distance(const float* a, const float* b) {
    return std::hypot(double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]);
}

// The largest distance of a given point from the line that is left, in space. `closed`: both lines are.
double deviation(const Curves& given, const FlgCurveSetView& view, uint32_t curve, bool closed) {
    const uint32_t first = view.curve_offsets[curve], end = view.curve_offsets[curve + 1];
    double most = 0;
    for (size_t i = 0; i < given.positions.size() / 3; ++i) {
        const float* const p = &given.positions[3 * i];
        double least = 1e30;
        for (uint32_t k = first; k + (closed ? 0 : 1) < end; ++k) {
            const float *a = point(view, k), *b = point(view, k + 1 < end ? k + 1 : first);
            double along = 0, length = 0;
            for (int c = 0; c < 3; ++c) {
                along += (double{p[c]} - a[c]) * (double{b[c]} - a[c]);
                length += (double{b[c]} - a[c]) * (double{b[c]} - a[c]);
            }
            const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
            const auto at = [&](int c) { return a[c] + t * (double{b[c]} - a[c]) - p[c]; };
            least = std::min(least, std::hypot(at(0), at(1), at(2)));
        }
        most = std::max(most, least);
    }
    return most;
}

Curves circle(uint32_t count, double radius) {
    Curves curves;
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        curves.add_point(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    curves.end_curve(FLG_CURVE_CLOSED);
    return curves;
}

TEST(Simplify, OfAStraightLineOnlyTheEndsStay) {
    Host host;
    Curves curves;
    for (int i = 0; i <= 512; ++i) curves.add_point(0.25 * i, 0, 0);
    curves.end_curve();
    const FlgCurveSetView view = simplify(host, host.create(curves), {0});
    ASSERT_EQ(view.curve_offsets[1], 2u);
    EXPECT_EQ(point(view, 0)[0], 0);
    EXPECT_EQ(point(view, 1)[0], 128);
}

TEST(Simplify, ACircleGetsThePointsThatItsSagittaAsks) {
    Host host;
    const Curves curves = circle(1000, 1);
    for (const float tolerance : {1e-1f, 1e-2f, 1e-3f}) {
        const FlgCurveSetView view = simplify(host, host.create(curves), {tolerance});
        EXPECT_LE(deviation(curves, view, 0, true), tolerance);
        // A chord of angle a strays by 1 - cos(a / 2). Halving takes at most twice as many, thirds rounded up.
        const double least = M_PI / std::acos(1 - double{tolerance});
        EXPECT_GE(view.curve_offsets[1], std::floor(least));
        EXPECT_LE(view.curve_offsets[1], 2 * least + 6);
    }
}

TEST(Simplify, LevelsAreRangesOfOneResult) {
    Host host(2);
    Curves curves;
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < 3000; ++i)
            curves.add_point(0.01 * i, std::sin(0.02 * (c + 1) * i), 0.1 * std::cos(0.13 * i) + 5 * c);
        curves.end_curve();
    }
    const std::vector<float> tolerances = {0, 0.002f, 0.02f, 0.2f};
    const FlgCurveSetView view = simplify(host, host.create(curves), tolerances);
    ASSERT_EQ(view.curve_count, 12u);
    for (uint32_t c = 0; c < 3; ++c) {
        Curves one;
        one.positions.assign(curves.positions.begin() + 9000 * c, curves.positions.begin() + 9000 * (c + 1));
        uint32_t before = UINT32_MAX;
        for (uint32_t level = 0; level < 4; ++level) {
            const uint32_t out = 3 * level + c;
            const uint32_t count = view.curve_offsets[out + 1] - view.curve_offsets[out];
            EXPECT_LT(count, before);
            before = count;
            EXPECT_LE(deviation(one, view, out, false), tolerances[level] + 1e-6);
            EXPECT_EQ(distance(point(view, view.curve_offsets[out]), &one.positions[0]), 0);
            EXPECT_EQ(distance(point(view, view.curve_offsets[out + 1] - 1), &one.positions[8997]), 0);
        }
    }
}

TEST(Simplify, RadiiColoursAndRimsAreKeptToo) {
    Host host;
    Curves curves;
    std::vector<float> colors, tangents, normals;
    for (int i = 0; i <= 100; ++i) {
        curves.add_point(i, 0, 0);
        curves.radii.push_back(i == 30 ? 2.0f : 1.0f);
        for (const float v : {i == 60 ? 0.5f : 0.0f, 0.0f, 0.0f, 1.0f}) colors.push_back(v);
        for (const float v : {1.0f, 0.0f, 0.0f}) tangents.push_back(v);
        const double turn = i > 80 ? M_PI / 2 : 0;
        for (const double v : {0.0, std::cos(turn), std::sin(turn)}) normals.push_back(static_cast<float>(v));
    }
    curves.end_curve();
    FlgCurveSetView in = curves.view();
    curves.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0});
    curves.columns.push_back({FLG_ATTRIBUTE_TANGENT, 3, tangents.data(), 0, 0});
    curves.columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0});
    in.columns = curves.columns.data();
    in.column_count = static_cast<uint32_t>(curves.columns.size());
    const auto kept = [&](uint32_t ribbons) {
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &in, &set), FLG_OK) << flgErrorGetMessage();
        const FlgCurveSetView view = simplify(host, set, {0.01f}, ribbons);
        std::vector<int> places;
        for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) places.push_back(static_cast<int>(point(view, i)[0]));
        EXPECT_EQ(view.column_count, 5u);
        const float* const radii = find_column(view, FLG_ATTRIBUTE_RADIUS)->data;
        const float* const reds = find_column(view, FLG_ATTRIBUTE_COLOR)->data;
        for (size_t i = 0; i < places.size(); ++i) {
            EXPECT_EQ(radii[i], places[i] == 30 ? 2.0f : 1.0f);
            EXPECT_EQ(reds[4 * i], places[i] == 60 ? 0.5f : 0.0f);
        }
        return places;
    };
    EXPECT_EQ(kept(0), (std::vector<int>{0, 29, 30, 31, 59, 60, 61, 100}));
    EXPECT_EQ(kept(1), (std::vector<int>{0, 29, 30, 31, 59, 60, 61, 80, 81, 100}));
}

TEST(Simplify, SmallAndDegenerateCurvesStayWhole) {
    Host host;
    Curves curves;
    curves.add_point(1, 2, 3);
    curves.end_curve();
    curves.add_point(1, 2, 3);
    curves.end_curve(FLG_CURVE_CLOSED);
    for (int i = 0; i < 2; ++i) curves.add_point(i, 0, 0);
    curves.end_curve(FLG_CURVE_CLOSED);
    for (int i = 0; i < 3; ++i) curves.add_point(i, 0, 0);
    curves.end_curve(FLG_CURVE_CLOSED);
    for (int i = 0; i < 9; ++i) curves.add_point(4, 4, 4);
    curves.end_curve();
    const FlgCurveSetView view = simplify(host, host.create(curves), {1});
    const std::vector<uint32_t> offsets(view.curve_offsets, view.curve_offsets + 6);
    EXPECT_EQ(offsets, (std::vector<uint32_t>{0, 1, 2, 4, 7, 9}));
    EXPECT_EQ(view.curve_flags[2], FLG_CURVE_CLOSED);
}

TEST(Simplify, SameBitsUnderAnyNumberOfWorkers) {
    std::vector<float> first;
    for (const uint32_t workers : {0u, 1u, 3u}) {
        Host host(workers);
        Curves curves;
        for (int c = 0; c < 40; ++c) {
            for (int i = 0; i < 700; ++i) curves.add_point(0.1 * i, std::sin(0.3 * i * (1 + 0.1 * c)), c);
            curves.end_curve(c % 3 == 0 ? FLG_CURVE_CLOSED : 0);
        }
        const FlgCurveSetView view = simplify(host, host.create(curves), {0.01f, 0.1f});
        const float* const positions = point(view, 0);
        std::vector<float> made(positions, positions + size_t{3} * view.curve_offsets[80]);
        if (first.empty()) first = made;
        EXPECT_EQ(made, first) << workers;
    }
}

TEST(Simplify, ASpiralOfAHundredThousandPointsEnds) {
    Host host;
    Curves curves;
    for (int i = 0; i < 100'000; ++i) curves.add_point(1e-3 * i * std::cos(0.05 * i), 1e-3 * i * std::sin(0.05 * i), 0);
    curves.end_curve();
    const FlgCurveSetView view = simplify(host, host.create(curves), {0, 1e-3f, 1e3f});
    EXPECT_EQ(view.curve_offsets[1], 100'000u);
    EXPECT_EQ(view.curve_offsets[3] - view.curve_offsets[2], 99u);  // the ends, and every 1024th
}

TEST(Simplify, RefusesEachBadArgument) {
    Host host;
    const FlgCurveSet curves = host.create(circle(10, 1));
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
        const float tolerances[] = {1, 2};
        desc.curves = curves;
        desc.tolerances = tolerances;
        change(desc);
        FlgCurveSet out{5};
        FlgJob job{5};
        expect_failure(flgCurveSetSimplify(host.context, &desc, &out, &job), expected, words);
        EXPECT_EQ(out.id, 0u);
        EXPECT_EQ(job.id, 0u);
    };
    static const float bad[] = {1, -1};
    refused([](auto& d) { d.level_count = 0; }, FLG_ERROR_INVALID_ARGUMENT, "desc.level_count is 0");
    refused([](auto& d) { d.level_count = 17; }, FLG_ERROR_INVALID_ARGUMENT, "desc.level_count is 17");
    refused([](auto& d) { d.tolerances = nullptr; }, FLG_ERROR_INVALID_ARGUMENT, "desc.tolerances is null");
    refused([](auto& d) { d.tolerances = bad, d.level_count = 2; }, FLG_ERROR_INVALID_ARGUMENT,
            "desc.tolerances[1] is -1");
    refused([](auto& d) { d.color_tolerance = NAN; }, FLG_ERROR_INVALID_ARGUMENT, "desc.color_tolerance is nan");
    refused([](auto& d) { d.reserved = 1; }, FLG_ERROR_INVALID_ARGUMENT, "desc.reserved is 1");
    refused([](auto& d) { d.curves = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.curves is null");
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    const float tolerance = 1;
    desc.curves = curves;
    desc.tolerances = &tolerance;
    desc.ribbons = 1;
    FlgCurveSet out{};
    FlgJob job{};
    ASSERT_EQ(flgCurveSetSimplify(host.context, &desc, &out, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(flgCurveSetGetView(host.context, out, &view), FLG_ERROR_INVALID_ARGUMENT,
                   "the curves lack a column of RADIUS, TANGENT and NORMAL");
}

}  // namespace
}  // namespace flg::test
