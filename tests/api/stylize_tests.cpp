// SPDX-License-Identifier: MIT
// Styles and stylization through the C ABI: the whole of Algorithm 1.
#include "api/host.h"

namespace flg::test {
namespace {

struct Made {
    FlgStyle style{};
    FlgCurveSet result{};
    FlgJob style_job{}, job{};
};

Made start(const Host& host, Curves example, Curves target,
           FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults()) {
    Made made;
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = host.create(std::move(example));
    EXPECT_EQ(flgStyleCreate(host.context, &style_desc, &made.style, &made.style_job), FLG_OK) << flgErrorGetMessage();
    desc.style = made.style;
    desc.target = host.create(std::move(target));
    EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &made.result, &made.job), FLG_OK) << flgErrorGetMessage();
    return made;
}

FlgStyleInfo info_of(const Host& host, FlgStyle style) {
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_OK) << flgErrorGetMessage();
    return info;
}

TEST(StylizeApi, SameBitsUnderAnyWorkersAndBudgets) {
    std::string expected;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.temperature = 0.7f;
    for (uint32_t workers : {0u, 1u, 2u, 4u}) {
        for (uint32_t budget_us : {FLG_UNLIMITED, 300u, 2000u}) {
            Host host(workers);
            const Made made = start(host, coil(), arcs(40), desc);
            host.finish(budget_us);
            EXPECT_EQ(host.status_of(made.job).result, FLG_OK) << host.status_of(made.job).error;
            const std::string now = bits(host.view_of(made.result));
            if (expected.empty()) expected = now;
            ASSERT_EQ(now.size(), expected.size());
            EXPECT_TRUE(now == expected) << workers << " workers, budget " << budget_us;
        }
    }
}

TEST(StylizeApi, StyleOnItsOwnGuideGivesTheStyleBack) {
    Host host;
    const Curves example = coil(600);
    const Made made = start(host, example, arcs(1));
    host.finish();
    const FlgStyleInfo info = info_of(host, made.style);
    EXPECT_EQ(info.point_count, 600u);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = made.style;
    ASSERT_EQ(flgStyleGetGuide(host.context, made.style, &desc.target), FLG_OK);
    FlgCurveSet back{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &back, nullptr), FLG_OK);
    host.finish();
    const FlgCurveSetView view = host.view_of(back);
    ASSERT_EQ(view.curve_offsets[1], info.point_count);
    // Where the matching says each guide point went, on the example as a polyline.
    std::vector<double> along{0};
    const auto point = [&](size_t i, int k) { return static_cast<double>(example.positions[3 * i + k]); };
    for (size_t i = 1; i < 600; ++i) {
        along.push_back(along.back() + std::hypot(point(i, 0) - point(i - 1, 0), point(i, 1) - point(i - 1, 1),
                                                  point(i, 2) - point(i - 1, 2)));
    }
    double sum_sq = 0;
    const uint32_t ends = info.patch;
    for (uint32_t i = ends; i + ends < info.point_count; ++i) {
        const double s = info.matching[i] * along.back() / info.style_length;
        const size_t k = std::min<size_t>(std::upper_bound(along.begin(), along.end(), s) - along.begin(), 599);
        const double t = (s - along[k - 1]) / (along[k] - along[k - 1]);
        for (int c = 0; c < 3; ++c) {
            const double expected = (1 - t) * point(k - 1, c) + t * point(k, c);
            const double error = view.columns[0].data[3 * i + c] - expected;
            sum_sq += error * error;
        }
    }
    const double rms = std::sqrt(sum_sq / (info.point_count - 2 * ends));
    EXPECT_LT(rms, 0.01 * info.displacement_rms);
}

TEST(StylizeApi, StagesProgressAndInfo) {
    Host host;
    const Made made = start(host, coil(), arcs(5));
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgStyleGetInfo(host.context, made.style, &info), FLG_NOT_READY);
    FlgCurveSet guide{};
    EXPECT_EQ(flgStyleGetGuide(host.context, made.style, &guide), FLG_NOT_READY);
    uint32_t count = 0;
    EXPECT_EQ(flgJobGetStages(host.context, made.job, nullptr, 0, &count), FLG_NOT_READY);
    host.finish();
    FlgStageTime stages[16];
    ASSERT_EQ(flgJobGetStages(host.context, made.style_job, stages, 16, &count), FLG_OK);
    std::string names;
    for (uint32_t i = 0; i < count; ++i) names += std::string(stages[i].name) + " ";
    EXPECT_EQ(names, "resample guide_flow matching displacement patch_graph ");
    info = info_of(host, made.style);
    EXPECT_GT(info.displacement_rms, 0.15f);  // the coil's radius is about 0.25
    EXPECT_LT(info.displacement_rms, 0.35f);
    EXPECT_NEAR(info.guide_length, 6.0f, 1.0f);
    EXPECT_NEAR(info.spacing, info.guide_length / static_cast<float>(info.point_count - 1), 1e-6);
    EXPECT_EQ(info.matching[0], 0.0f);
    EXPECT_NEAR(info.matching[info.point_count - 1], info.style_length, 1e-5 * info.style_length);
    const FlgCurveSetView view = host.view_of(made.result);
    EXPECT_EQ(view.curve_count, 5u);
    EXPECT_NE(find_column(view, FLG_ATTRIBUTE_STYLE_INDEX), nullptr);
    EXPECT_NE(find_column(view, FLG_ATTRIBUTE_RADIUS), nullptr);
}

TEST(StylizeApi, MagnitudeScalesTheDisplacement) {
    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    std::vector<std::vector<float>> results;
    for (float magnitude : {0.0f, 1.0f, 2.0f}) {
        desc.magnitude = magnitude;
        const Made made = start(host, coil(), arcs(1), desc);
        host.finish();
        const FlgCurveSetView view = host.view_of(made.result);
        results.emplace_back(view.columns[0].data, view.columns[0].data + 3 * view.curve_offsets[1]);
    }
    for (size_t i = 0; i < results[0].size(); ++i) {
        EXPECT_NEAR(results[2][i] - results[0][i], 2 * (results[1][i] - results[0][i]), 1e-5);
    }
}

TEST(StylizeApi, RigidMotionOfTheTargetMovesTheResult) {
    // A rotation by a about z, then x -> (y, z, x), then a shift.
    const auto moved = [](const float* p, float* out) {
        const double a = 0.7;
        const double x = std::cos(a) * p[0] - std::sin(a) * p[1], y = std::sin(a) * p[0] + std::cos(a) * p[1];
        out[0] = static_cast<float>(y + 3);
        out[1] = static_cast<float>(p[2] - 5.0);
        out[2] = static_cast<float>(x + 11);
    };
    Host host;
    Curves target = arcs(2);
    Curves target_moved = target;
    for (size_t i = 0; i < target.positions.size(); i += 3) moved(&target.positions[i], &target_moved.positions[i]);
    const Made here = start(host, coil(), target);
    const Made there = start(host, coil(), target_moved);
    host.finish();
    const FlgCurveSetView a = host.view_of(here.result), b = host.view_of(there.result);
    ASSERT_EQ(a.curve_offsets[2], b.curve_offsets[2]);
    for (uint32_t i = 0; i < a.curve_offsets[2]; ++i) {
        float expected[3];
        moved(a.columns[0].data + 3 * i, expected);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(b.columns[0].data[3 * i + k], expected[k], 2e-4) << i;
    }
}

TEST(StylizeApi, OddTargetsHaveStatedResults) {
    Host host;
    Curves odd;
    odd.add_point(1, 2, 3);  // one point
    odd.end_curve();
    for (int i = 0; i < 4; ++i) odd.add_point(5, 5, 5);  // no length
    odd.end_curve();
    odd.add_point(0, 0, 0);  // shorter than one step
    odd.add_point(0.001, 0, 0);
    odd.end_curve();
    for (int i = 0; i < 30; ++i)
        odd.add_point(0.02 * (i / 3), 0, 0);  // every point three times; shorter than the style
    odd.end_curve();
    const Made made = start(host, coil(), odd);
    host.finish();
    const FlgCurveSetView view = host.view_of(made.result);
    ASSERT_EQ(view.curve_count, 4u);
    const float* p = view.columns[0].data;
    EXPECT_EQ(view.curve_offsets[1], 1u);
    EXPECT_EQ(std::vector<float>(p, p + 3), (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(view.curve_offsets[2], 2u);
    EXPECT_EQ(std::vector<float>(p + 3, p + 6), (std::vector<float>{5, 5, 5}));
    EXPECT_EQ(view.curve_offsets[3], 4u);
    const FlgStyleInfo info = info_of(host, made.style);
    EXPECT_EQ(view.curve_offsets[4] - view.curve_offsets[3], std::lround(0.18 / info.spacing) + 1);
    for (uint32_t i = 0; i < 3 * view.curve_offsets[4]; ++i) EXPECT_TRUE(std::isfinite(p[i]));
}

TEST(StylizeApi, HugeCoordinatesStayFinite) {
    Host host;
    Curves target = arcs(1), example = coil();
    for (float& v : target.positions) v *= 1e12f;
    for (float& v : example.positions) v *= 1e12f;
    const Made made = start(host, example, target);
    const Made unit = start(host, coil(), arcs(1));
    host.finish();
    ASSERT_EQ(host.status_of(made.job).result, FLG_OK) << host.status_of(made.job).error;
    const FlgCurveSetView huge = host.view_of(made.result), small = host.view_of(unit.result);
    ASSERT_EQ(huge.curve_offsets[1], small.curve_offsets[1]);
    for (uint32_t i = 0; i < 3 * huge.curve_offsets[1]; ++i) {
        ASSERT_NEAR(huge.columns[0].data[i] * 1e-12, small.columns[0].data[i], 1e-3);
    }
}

TEST(StyleApi, RefusesEachBadArgument) {
    Host host;
    const FlgCurveSet example = host.create(coil());
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = example;
        change(desc);
        FlgStyle style{5};
        expect_failure(flgStyleCreate(host.context, &desc, &style, nullptr), expected, words);
        EXPECT_EQ(style.id, 0u);
    };
    const FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;
    refused([](auto& d) { d.struct_size = 1; }, invalid, "struct_size is 1");
    refused([](auto& d) { d.point_count = 15; }, invalid, "desc.point_count is 15");
    refused([](auto& d) { d.point_count = 16385; }, invalid, "desc.point_count is 16385");
    refused([](auto& d) { d.alpha = -0.1f; }, invalid, "desc.alpha is -0.1");
    refused([](auto& d) { d.alpha = NAN; }, invalid, "desc.alpha is nan");
    refused([](auto& d) { d.smoothing = 0; }, invalid, "desc.smoothing is 0");
    refused([](auto& d) { d.beta = 0; }, invalid, "desc.beta is 0");
    refused([](auto& d) { d.beta = 1; }, invalid, "desc.beta is 1");
    refused([](auto& d) { d.patch = 0; }, invalid, "desc.patch is 0");
    refused([](auto& d) { d.patch = 1025; }, invalid, "desc.patch is 1025");
    refused(
        [](auto& d) {
            d.point_count = 40;
            d.patch = 20;
        },
        invalid, "desc.patch is 20");
    refused([](auto& d) { d.style = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.style is null");
    refused([](auto& d) { d.guide = {99}; }, FLG_ERROR_INVALID_HANDLE, "desc.guide");
}

TEST(StyleApi, ExamplesThatAreNoStyleFailTheirJob) {
    Host host;
    const auto fails = [&](Curves example, const char* words, Curves guide = {}, uint32_t patch = 10) {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = host.create(std::move(example));
        desc.patch = patch;
        if (!guide.positions.empty()) desc.guide = host.create(std::move(guide));
        FlgStyle style{};
        FlgJob job{};
        ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::strstr(host.status_of(job).error, words), nullptr) << host.status_of(job).error;
        FlgStyleInfo info{};
        info.struct_size = sizeof info;
        expect_failure(flgStyleGetInfo(host.context, style, &info), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(info.point_count, 0u);
        FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
        stylize.style = style;
        stylize.target = desc.style;
        FlgCurveSet out{};
        expect_failure(flgCurveSetStylize(host.context, &stylize, &out, nullptr), FLG_ERROR_DEPENDENCY, words);
    };
    Curves point;
    point.add_point(1, 1, 1);
    point.end_curve();
    fails(point, "desc.style has no length: its 1 point is the same place");
    Curves same;
    for (int i = 0; i < 5; ++i) same.add_point(1, 1, 1);
    same.end_curve();
    fails(same, "desc.style has no length: its 5 points are the same place");
    Curves closed = coil();
    closed.flags[0] = FLG_CURVE_CLOSED;
    fails(closed, "desc.style is a closed curve");
    fails(coil(), "desc.guide has 3 curves", arcs(3));
    fails(coil(100, 2), "desc.patch is 150: its 301 points must be fewer than the style's 256", {}, 150);
}

TEST(StyleApi, AStraightStyleChangesNothing) {
    Host host;
    Curves line;
    for (int i = 0; i < 50; ++i) line.add_point(0.1 * i, 0, 0);
    line.end_curve();
    const Made made = start(host, line, arcs(1));
    FlgCurveSetStylizeDesc none = flgCurveSetStylizeDefaults();
    none.magnitude = 0;
    const Made reference = start(host, line, arcs(1), none);
    host.finish();
    const FlgCurveSetView a = host.view_of(made.result), b = host.view_of(reference.result);
    for (uint32_t i = 0; i < 3 * a.curve_offsets[1]; ++i) EXPECT_NEAR(a.columns[0].data[i], b.columns[0].data[i], 1e-5);
}

TEST(StyleApi, AGuideCanBeGiven) {
    Host host;
    Curves axis;
    axis.add_point(0, 0, 0);
    axis.add_point(6, 0, 0);
    axis.end_curve();
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil());
    desc.guide = host.create(axis);
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK);
    host.finish();
    const FlgStyleInfo info = info_of(host, style);
    EXPECT_NEAR(info.guide_length, 6.0f, 1e-5);
    EXPECT_EQ(info.flow_steps, 0u);
    EXPECT_NEAR(info.displacement_rms, 0.25f, 0.03f);
}

TEST(StylizeApi, RefusesEachBadArgument) {
    Host host;
    const Made made = start(host, coil(), arcs(1));
    const FlgCurveSet target = host.create(arcs(1));
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = made.style;
        desc.target = target;
        change(desc);
        FlgCurveSet out{5};
        expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), expected, words);
        EXPECT_EQ(out.id, 0u);
    };
    const FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;
    refused([](auto& d) { d.magnitude = INFINITY; }, invalid, "desc.magnitude is inf");
    refused([](auto& d) { d.temperature = -1; }, invalid, "desc.temperature is -1");
    refused([](auto& d) { d.temperature = NAN; }, invalid, "desc.temperature is nan");
    refused([](auto& d) { d.scale = NAN; }, invalid, "desc.scale is nan");
    refused([](auto& d) { d.scale = -2; }, invalid, "desc.scale is -2");
    refused([](auto& d) { d.start = static_cast<FlgStyleStart>(3); }, invalid, "desc.start is 3");
    refused([](auto& d) { d.frame = static_cast<FlgFrameMethod>(3); }, invalid, "desc.frame is 3");
    refused([](auto& d) { d.style = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.style is null");
    refused([](auto& d) { d.target = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.target is null");
    host.finish();
}

TEST(StylizeApi, RandomCancellationLeaksNothing) {
    uint32_t state = 12345;
    const auto random = [&](uint32_t below) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % below;
    };
    for (uint32_t workers : {0u, 1u, 2u, 4u}) {
        Host host(workers);  // checks at its end that all memory came back
        std::vector<FlgJob> jobs;
        for (int round = 0; round < 12; ++round) {
            const Made made = start(host, coil(200 + random(200)), arcs(1 + random(30)));
            jobs.push_back(made.style_job);
            jobs.push_back(made.job);
            flgContextTick(host.context, 1 + random(3000), nullptr);
            ASSERT_EQ(flgJobCancel(host.context, jobs[random(static_cast<uint32_t>(jobs.size()))]), FLG_OK);
            const bool release_result = random(2) == 0, release_style = random(2) == 0;
            ASSERT_EQ(release_result ? flgCurveSetRelease(host.context, made.result) : FLG_OK, FLG_OK);
            ASSERT_EQ(release_style ? flgStyleRelease(host.context, made.style) : FLG_OK, FLG_OK);
        }
        if (random(2) == 0) {
            host.finish(1000);
            for (FlgJob job : jobs) {
                const FlgResult result = host.result_of(job);
                EXPECT_TRUE(result == FLG_OK || result == FLG_ERROR_CANCELLED || result == FLG_ERROR_DEPENDENCY);
            }
        }
    }
}

TEST(StylizeApi, MemoryThatRunsOutAnywhereFailsCleanly) {
    // Allocations of the whole path fail, one in each round, until a round has none left to fail; the context stays
    // usable and nothing leaks.
    int64_t failed_rounds = 0;
    for (int64_t fail = 0;; fail += 1 + fail / 40) {
        HostAllocator allocator;
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = 0;
        desc.allocator = allocator.hook();
        allocator.fail_at = fail;
        FlgContext context{};
        FlgResult result = flgContextCreate(&desc, &context);
        if (result == FLG_OK) {
            Curves example = coil(64, 3), target = arcs(3);
            const FlgCurveSetView example_view = example.view(), target_view = target.view();
            FlgCurveSet out{};
            FlgStyleDesc style = flgStyleDefaults();
            FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
            style.point_count = 64;
            FlgJob job{};
            result = flgCurveSetCreate(context, &example_view, &style.style);
            if (result == FLG_OK) result = flgCurveSetCreate(context, &target_view, &stylize.target);
            if (result == FLG_OK) result = flgStyleCreate(context, &style, &stylize.style, nullptr);
            if (result == FLG_OK) result = flgCurveSetStylize(context, &stylize, &out, &job);
            if (result == FLG_OK) {
                EXPECT_EQ(flgContextTick(context, FLG_UNLIMITED, nullptr), FLG_OK);
                FlgJobStatus status{};
                status.struct_size = sizeof status;
                EXPECT_EQ(flgJobGetStatus(context, job, &status), FLG_OK);
                result = status.result;
            }
            EXPECT_EQ(flgContextDestroy(context), FLG_OK);
        }
        EXPECT_EQ(allocator.live_bytes, 0) << "allocation " << fail;
        if (result == FLG_OK) break;
        ++failed_rounds;
        EXPECT_TRUE(result == FLG_ERROR_OUT_OF_MEMORY || result == FLG_ERROR_DEPENDENCY)
            << flgResultGetName(result) << " when allocation " << fail << " fails";
    }
    EXPECT_GT(failed_rounds, 50);
}

}  // namespace
}  // namespace flg::test
