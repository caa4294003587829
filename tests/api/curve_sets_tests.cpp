// SPDX-License-Identifier: MIT
#include "api/host.h"

namespace flg::test {
namespace {

TEST(CurveSetApi, KeepsWhatItIsGiven) {
    Host host;
    Curves curves = arcs(3, 10);
    curves.flags[1] = FLG_CURVE_CLOSED;
    const FlgCurveSetView view = host.view_of(host.create(curves));
    ASSERT_EQ(view.curve_count, 3u);
    EXPECT_EQ(view.curve_offsets[3], 30u);
    EXPECT_EQ(view.curve_flags[1], FLG_CURVE_CLOSED);
    ASSERT_EQ(view.column_count, 2u);
    EXPECT_EQ(std::memcmp(view.columns[0].data, curves.positions.data(), curves.positions.size() * sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(view.columns[1].data, curves.radii.data(), curves.radii.size() * sizeof(float)), 0);
}

TEST(CurveSetApi, ReadsStridedInputInAnyOrder) {
    struct Vertex {
        float radius;
        float position[3];
        float unrelated;
    };
    const Vertex vertices[] = {{0.5f, {1, 2, 3}, NAN}, {0.25f, {4, 5, 6}, NAN}};
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_RADIUS, 1, &vertices[0].radius, sizeof(Vertex), 0},
                                 {FLG_ATTRIBUTE_POSITION, 3, vertices[0].position, sizeof(Vertex), 0}};
    const uint32_t offsets[] = {0, 2};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = columns;
    view.column_count = 2;
    Host host;
    FlgCurveSet set{};
    ASSERT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
    const FlgCurveSetView out = host.view_of(set);
    EXPECT_EQ(out.columns[0].attribute, FLG_ATTRIBUTE_POSITION);
    EXPECT_EQ(std::vector<float>(out.columns[0].data, out.columns[0].data + 6), (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(out.columns[1].data[1], 0.25f);
    EXPECT_EQ(out.curve_flags[0], 0);
}

TEST(CurveSetApi, RefusesEachBadInputByName) {
    Host host;
    const auto refused = [&](auto change, const char* words) {
        Curves curves = arcs(2, 5);
        FlgCurveSetView view = curves.view();
        change(curves, view);
        FlgCurveSet set{77};
        expect_failure(flgCurveSetCreate(host.context, &view, &set), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(set.id, 0u);
    };
    using C = Curves;
    using V = FlgCurveSetView;
    refused([](C&, V& v) { v.struct_size = 4; }, "struct_size is 4");
    refused([](C&, V& v) { v.curve_count = 0; }, "curve_count is 0");
    refused([](C&, V& v) { v.curve_offsets = nullptr; }, "curve_offsets is null");
    refused([](C& c, V&) { c.offsets[0] = 1; }, "curve_offsets[0] is 1");
    refused([](C& c, V&) { c.offsets[1] = 0; }, "every curve needs at least one point");
    refused([](C& c, V&) { c.flags[1] = 2; }, "curve_flags[1] is 2");
    refused([](C&, V& v) { v.column_count = 0; }, "column_count is 0");
    refused([](C&, V& v) { v.column_count = 17; }, "column_count is 17");
    refused([](C&, V& v) { v.columns = nullptr; }, "columns is null");
    refused([](C& c, V&) { c.columns[0].attribute = FLG_ATTRIBUTE_NORMAL; }, "no FLG_ATTRIBUTE_POSITION");
    refused([](C& c, V&) { c.columns[1] = c.columns[0]; }, "both attribute 0");
    refused([](C& c, V&) { c.columns[1].attribute = static_cast<FlgAttribute>(40); }, "attribute is 40");
    refused([](C& c, V&) { c.columns[0].components = 2; }, "components is 2");
    refused(
        [](C& c, V&) {
            c.columns[1].attribute = FLG_ATTRIBUTE_USER;
            c.columns[1].components = 17;
        },
        "components is 17");
    refused([](C& c, V&) { c.columns[1].data = nullptr; }, "data is null");
    refused([](C& c, V&) { c.columns[0].stride = 8; }, "stride is 8");
    refused([](C& c, V&) { c.columns[0].stride = 14; }, "stride is 14");
    refused([](C& c, V&) { c.positions[17] = NAN; }, "nan at point 0 of curve 1, must be finite");
    refused([](C& c, V&) { c.positions[3] = INFINITY; }, "inf at point 1 of curve 0");
    refused([](C& c, V&) { c.positions[3] = 2e30f; }, "at most 1e30");
    refused([](C& c, V&) { c.radii[9] = -1; }, "-1 at point 4 of curve 1, must not be negative");
    const auto with_column = [&](FlgAttribute attribute, uint32_t components, std::vector<float> value,
                                 const char* words) {
        std::vector<float> values;
        for (int i = 0; i < 10; ++i) values.insert(values.end(), value.begin(), value.end());
        refused([&](C& c, V&) { c.columns[1] = {attribute, components, values.data(), 0, 0}; }, words);
    };
    with_column(FLG_ATTRIBUTE_WIDTH, 1, {-1}, "must not be negative");
    with_column(FLG_ATTRIBUTE_SPEED, 1, {0}, "must be above 0");
    with_column(FLG_ATTRIBUTE_RADII, 3, {1, -2, 0}, "holds -2 at point 0 of curve 0, must not be negative");
    with_column(FLG_ATTRIBUTE_RADII, 2, {1, 1}, "components is 2");
    with_column(FLG_ATTRIBUTE_ANGLE, 1, {NAN}, "must be finite");
    expect_failure(flgCurveSetCreate(host.context, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT, "out_set is null");
    FlgCurveSet set{};
    expect_failure(flgCurveSetCreate(host.context, nullptr, &set), FLG_ERROR_INVALID_ARGUMENT, "view is null");
}

TEST(CurveSetApi, StaleHandlesAreErrors) {
    Host host;
    const FlgCurveSet set = host.create(arcs(1));
    FlgCurveSetView view = flgCurveSetViewDefaults();
    ASSERT_EQ(flgCurveSetRelease(host.context, set), FLG_OK);
    expect_failure(flgCurveSetGetView(host.context, set, &view), FLG_ERROR_INVALID_HANDLE, "set (0x");
    expect_failure(flgCurveSetRelease(host.context, set), FLG_ERROR_INVALID_HANDLE, "not a living curve set");
    const FlgCurveSet reused = host.create(arcs(2));
    EXPECT_NE(reused.id, set.id);
    expect_failure(flgCurveSetGetView(host.context, set, &view), FLG_ERROR_INVALID_HANDLE, "not a living curve set");
    expect_failure(flgCurveSetGetView(host.context, {0}, &view), FLG_ERROR_INVALID_HANDLE, "set is null");
    expect_failure(flgCurveSetGetView(host.context, {~uint64_t{0}}, &view), FLG_ERROR_INVALID_HANDLE, "not a living");
    // A handle of another kind.
    FlgJobStatus status{};
    status.struct_size = sizeof status;
    expect_failure(flgJobGetStatus(host.context, {reused.id}, &status), FLG_ERROR_INVALID_HANDLE, "not a living job");
}

TEST(ResampleApi, EvenPointsWithFramesAndCarriedColumns) {
    Host host(1);
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = host.create(arcs(4));
    desc.spacing = 0.1f;
    FlgCurveSet out{};
    FlgJob job{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK);
    const FlgCurveSetView view = host.view_of(out);
    ASSERT_EQ(view.column_count, 4u);
    const float* p = find_column(view, FLG_ATTRIBUTE_POSITION)->data;
    const float* t = find_column(view, FLG_ATTRIBUTE_TANGENT)->data;
    const float* n = find_column(view, FLG_ATTRIBUTE_NORMAL)->data;
    for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
        EXPECT_NEAR(t[3 * i] * n[3 * i] + t[3 * i + 1] * n[3 * i + 1] + t[3 * i + 2] * n[3 * i + 2], 0, 1e-6);
        EXPECT_NEAR(std::hypot(n[3 * i], n[3 * i + 1], n[3 * i + 2]), 1, 1e-6);
        if (i > 0) {
            const float step =
                std::hypot(p[3 * i] - p[3 * i - 3], p[3 * i + 1] - p[3 * i - 2], p[3 * i + 2] - p[3 * i - 1]);
            EXPECT_NEAR(step, 0.1f, 0.0005f);
        }
    }
    FlgStageTime stages[4];
    uint32_t count = 0;
    ASSERT_EQ(flgJobGetStages(host.context, job, stages, 4, &count), FLG_OK);
    ASSERT_EQ(count, 2u);
    EXPECT_STREQ(stages[0].name, "measure");
    EXPECT_STREQ(stages[1].name, "resample");
}

TEST(ResampleApi, RefusesEachBadArgument) {
    Host host;
    const FlgCurveSet curves = host.create(arcs(1));
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
        desc.curves = curves;
        desc.spacing = 1;
        change(desc);
        FlgCurveSet out{5};
        FlgJob job{5};
        expect_failure(flgCurveSetResample(host.context, &desc, &out, &job), expected, words);
        EXPECT_EQ(out.id, 0u);
        EXPECT_EQ(job.id, 0u);
    };
    refused([](auto& d) { d.spacing = 0; }, FLG_ERROR_INVALID_ARGUMENT, "desc.spacing is 0");
    refused([](auto& d) { d.spacing = NAN; }, FLG_ERROR_INVALID_ARGUMENT, "desc.spacing is nan");
    refused([](auto& d) { d.frame = static_cast<FlgFrameMethod>(7); }, FLG_ERROR_INVALID_ARGUMENT, "desc.frame is 7");
    refused([](auto& d) { d.curves = {}; }, FLG_ERROR_INVALID_HANDLE, "desc.curves is null");
    FlgJobOptions options = flgJobOptionsDefaults();
    const auto use = [&](auto& d) { d.job = &options; };
    for (const int priority : {-2, 2, 9}) {
        options.priority = static_cast<FlgPriority>(priority);
        refused(use, FLG_ERROR_INVALID_ARGUMENT, ("job.priority is " + std::to_string(priority)).c_str());
    }
    options = flgJobOptionsDefaults();
    options.struct_size = 0;
    refused(use, FLG_ERROR_INVALID_ARGUMENT, "job: struct_size is 0");
    options = flgJobOptionsDefaults();
    options.dependency_count = 1;
    refused(use, FLG_ERROR_INVALID_ARGUMENT, "job.dependencies is null");
    const FlgJob stale{123};
    options.dependencies = &stale;
    refused(use, FLG_ERROR_INVALID_HANDLE, "job.dependencies");
}

TEST(ResampleApi, TooManyPointsAreALimitNotACrash) {
    Host host;
    Curves curves;
    curves.add_point(0, 0, 0);
    curves.add_point(1e12, 0, 0);
    curves.end_curve();
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = host.create(curves);
    desc.spacing = 1e-3f;
    FlgCurveSet out{};
    FlgJob job{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &out, &job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_LIMIT);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(flgCurveSetGetView(host.context, out, &view), FLG_ERROR_LIMIT, "the limit is 2^31");
    // What depends on it is refused with its reason.
    desc.curves = out;
    FlgCurveSet second{};
    expect_failure(flgCurveSetResample(host.context, &desc, &second, nullptr), FLG_ERROR_DEPENDENCY,
                   "the limit is 2^31");
}

TEST(ResampleApi, JobsTakeOutputsOfUnfinishedJobs) {
    Host host;
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = host.create(arcs(2));
    desc.spacing = 0.1f;
    FlgCurveSet first{}, second{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &first, nullptr), FLG_OK);
    desc.curves = first;
    desc.spacing = 0.5f;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.priority = FLG_PRIORITY_HIGH;
    desc.job = &options;
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &second, nullptr), FLG_OK);
    ASSERT_EQ(flgCurveSetRelease(host.context, first), FLG_OK);  // its job and its reader keep it
    FlgCurveSetView view = flgCurveSetViewDefaults();
    EXPECT_EQ(flgCurveSetGetView(host.context, second, &view), FLG_NOT_READY);
    host.finish(50);
    EXPECT_GT(host.view_of(second).curve_offsets[2], 80u);
}

TEST(ResampleApi, PartialResultsGrowFromTheFront) {
    Host host;
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = host.create(arcs(300));
    desc.spacing = 0.01f;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    FlgCurveSet out{};
    FlgJob job{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &out, &job), FLG_OK);
    std::string first_curve;
    uint32_t last = 0;
    bool partial = false;
    while (host.status_of(job).state != FLG_JOB_STATE_FINISHED) {
        ASSERT_EQ(flgContextTick(host.context, 500, nullptr), FLG_OK);
        FlgCurveSetView view = flgCurveSetViewDefaults();
        if (flgCurveSetGetView(host.context, out, &view) != FLG_OK) continue;
        EXPECT_GE(view.curve_count, last);
        last = view.curve_count;
        partial = partial || view.curve_count < 300;
        const std::string now(reinterpret_cast<const char*>(view.columns[0].data), view.curve_offsets[1] * 12);
        if (first_curve.empty()) first_curve = now;
        EXPECT_EQ(now, first_curve);
    }
    EXPECT_EQ(last, 300u);
    EXPECT_TRUE(partial);
}

}  // namespace
}  // namespace flg::test
