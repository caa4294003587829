// SPDX-License-Identifier: MIT
#include "api/host.h"

namespace flg::test {
namespace {

TEST(ContextApi, DefaultsRoundTrip) {
    const FlgContextDesc desc = flgContextDefaults();
    EXPECT_EQ(desc.struct_size, sizeof desc);
    EXPECT_EQ(desc.version, static_cast<uint32_t>(FLG_VERSION));
    EXPECT_EQ(flgVersion(), static_cast<uint32_t>(FLG_VERSION));
    FlgContext context = nullptr;
    ASSERT_EQ(flgContextCreate(nullptr, &context), FLG_OK);
    EXPECT_EQ(flgContextDestroy(context), FLG_OK);
    EXPECT_EQ(flgContextDestroy(nullptr), FLG_OK);
}

TEST(ContextApi, RefusesWhatItCantUse) {
    FlgContext context = nullptr;
    expect_failure(flgContextCreate(nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT, "out_context is null");
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgContextDesc desc = flgContextDefaults();
        change(desc);
        context = reinterpret_cast<FlgContext>(&desc);
        expect_failure(flgContextCreate(&desc, &context), expected, words);
        EXPECT_EQ(context, nullptr);
    };
    refused([](auto& d) { d.struct_size = 0; }, FLG_ERROR_INVALID_ARGUMENT, "struct_size is 0");
    refused([](auto& d) { d.struct_size += 8; }, FLG_ERROR_INVALID_ARGUMENT, "desc: struct_size");
    refused([](auto& d) { d.version += 1u << 12; }, FLG_ERROR_VERSION, "compiled for filigree 0.2");
    refused([](auto& d) { d.version += 1u << 22; }, FLG_ERROR_VERSION, "compiled for filigree 1.1");
    refused([](auto& d) { d.worker_count = 257; }, FLG_ERROR_INVALID_ARGUMENT, "worker_count is 257");
    refused([](auto& d) { d.allocator.free = [](void*, void*, size_t, size_t) {}; }, FLG_ERROR_INVALID_ARGUMENT,
            "only one of allocate and free");
    refused([](auto& d) { d.profiler.end = [](void*) {}; }, FLG_ERROR_INVALID_ARGUMENT, "only one of begin and end");
    refused([](auto& d) { d.job_system.submit = [](void*, void (*)(void*), void*) {}; }, FLG_ERROR_INVALID_ARGUMENT,
            "job_system.concurrency is 0");
}

TEST(ContextApi, PatchVersionsFit) {
    FlgContextDesc desc = flgContextDefaults();
    desc.version += 5;
    FlgContext context = nullptr;
    ASSERT_EQ(flgContextCreate(&desc, &context), FLG_OK);
    flgContextDestroy(context);
}

TEST(ContextApi, TickNeedsAContextAndASizedReport) {
    expect_failure(flgTick(nullptr, 0, nullptr), FLG_ERROR_INVALID_HANDLE, "context is null");
    Host host;
    FlgFrameReport report{};
    expect_failure(flgTick(host.context, 0, &report), FLG_ERROR_INVALID_ARGUMENT, "report: struct_size is 0");
    EXPECT_EQ(flgTick(host.context, 0, nullptr), FLG_OK);
    report.struct_size = sizeof report;
    EXPECT_EQ(flgTick(host.context, 0, &report), FLG_OK);
    EXPECT_EQ(report.frame, 2u);
    EXPECT_STREQ(report.longest_chunk_stage, "");
}

TEST(ContextApi, CallbacksMayStartJobsButNotTick) {
    Host host;
    struct State {
        FlgContext context;
        FlgCurveSet curves;
        FlgResult tick, wait, destroy;
        FlgCurveSet second{};
    } state{host.context, host.create(arcs(1)), FLG_OK, FLG_OK, FLG_OK};
    FlgResampleDesc desc = flgResampleDefaults();
    desc.curves = state.curves;
    desc.spacing = 0.5f;
    desc.job.user_data = &state;
    desc.job.on_finished = [](void* user, FlgJob, FlgResult result) {
        auto& s = *static_cast<State*>(user);
        EXPECT_EQ(result, FLG_OK);
        s.tick = flgTick(s.context, 0, nullptr);
        s.wait = flgContextWait(s.context, 0);
        s.destroy = flgContextDestroy(s.context);
        FlgResampleDesc again = flgResampleDefaults();
        again.curves = s.curves;
        again.spacing = 1;
        EXPECT_EQ(flgResample(s.context, &again, &s.second, nullptr), FLG_OK);
    };
    FlgCurveSet first{};
    ASSERT_EQ(flgResample(host.context, &desc, &first, nullptr), FLG_OK);
    host.finish();
    EXPECT_EQ(state.tick, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(state.wait, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(state.destroy, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(host.view_of(state.second).curve_offsets[1], 22u);  // 20.9 m in steps nearest to 1 m
}

TEST(ContextApi, TheLogHearsOfFailedJobs) {
    std::vector<std::string> lines;
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.log = {&lines, [](void* user, FlgLogLevel, const char* message) {
                    static_cast<std::vector<std::string>*>(user)->push_back(message);
                }};
    Host host(desc);
    Curves point;
    point.add_point(1, 2, 3);
    point.end_curve();
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = host.create(point);
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, nullptr), FLG_OK);
    host.finish();
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("has no length"), std::string::npos) << lines[0];
}

TEST(ContextApi, ProfilerZonesNestAndAreNamed) {
    struct Zones {
        int depth = 0, count = 0;
        std::string names;
    } zones;
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.profiler = {&zones,
                     [](void* user, const char* name) {
                         auto& z = *static_cast<Zones*>(user);
                         ++z.depth;
                         ++z.count;
                         z.names += std::string(name) + ";";
                     },
                     [](void* user) { --static_cast<Zones*>(user)->depth; }};
    Host host(desc);
    FlgResampleDesc resample = flgResampleDefaults();
    resample.curves = host.create(arcs(3));
    resample.spacing = 0.001f;
    FlgCurveSet out{};
    ASSERT_EQ(flgResample(host.context, &resample, &out, nullptr), FLG_OK);
    host.finish(100);
    EXPECT_EQ(zones.depth, 0);
    EXPECT_GT(zones.count, 1);
    EXPECT_NE(zones.names.find("resample;"), std::string::npos) << zones.names;
}

TEST(ContextApi, HandlesOfADestroyedContextDoNotFitTheNext) {
    for (int round = 0; round < 5; ++round) {
        FlgCurveSet old{};
        {
            Host host;
            old = host.create(arcs(1));
        }
        Host host;
        host.create(arcs(1));
        FlgCurveSetView view = flgCurveSetViewDefaults();
        expect_failure(flgCurveSetGetView(host.context, old, &view), FLG_ERROR_INVALID_HANDLE,
                       "not a living curve set");
    }
}

TEST(ContextApi, ANewerHeaderGetsZerosAndIsToldItsVersion) {
    struct Newer {
        FlgContextDesc desc;
        uint64_t later[4];
    } newer;
    std::memset(static_cast<void*>(&newer), 0xab, sizeof newer);
    ASSERT_EQ(flgContextDescInit(&newer.desc, sizeof newer), FLG_OK);
    EXPECT_EQ(newer.desc.struct_size, sizeof newer);
    EXPECT_EQ(newer.desc.worker_count, 1u);
    for (uint64_t later : newer.later) EXPECT_EQ(later, 0u);
    newer.desc.version += 1u << 12;
    FlgContext context = nullptr;
    expect_failure(flgContextCreate(&newer.desc, &context), FLG_ERROR_VERSION, "compiled for filigree 0.2");
}

TEST(ContextApi, AFailingTickWritesItsReport) {
    FlgFrameReport report;
    std::memset(static_cast<void*>(&report), 0xcd, sizeof report);
    report.struct_size = sizeof report;
    expect_failure(flgTick(nullptr, 0, &report), FLG_ERROR_INVALID_HANDLE, "context is null");
    EXPECT_EQ(report.frame, 0u);
    EXPECT_EQ(report.jobs_pending, 0u);
    EXPECT_STREQ(report.longest_chunk_stage, "");
}

TEST(ContextApi, ACallbackThatThrowsDoesNotLockTheContext) {
    Host host;
    FlgResampleDesc desc = flgResampleDefaults();
    desc.curves = host.create(arcs(1));
    desc.spacing = 1;
    desc.job.on_finished = [](void*, FlgJob, FlgResult) { throw std::string("the host's own"); };
    FlgCurveSet out{};
    ASSERT_EQ(flgResample(host.context, &desc, &out, nullptr), FLG_OK);
    expect_failure(flgTick(host.context, 0, nullptr), FLG_ERROR_INTERNAL, "unknown exception");
    EXPECT_EQ(flgTick(host.context, 0, nullptr), FLG_OK);
    EXPECT_EQ(host.view_of(out).curve_count, 1u);
}

TEST(ContextApi, AContextThatIsBeingDestroyedTakesNoMoreWork) {
    std::vector<std::pair<void (*)(void*), void*>> tasks;
    FlgContextDesc desc = flgContextDefaults();
    desc.job_system = {&tasks, 1, [](void* user, void (*run)(void*), void* task) {
                           static_cast<decltype(tasks)*>(user)->push_back({run, task});
                       }};
    FlgContext context = nullptr;
    ASSERT_EQ(flgContextCreate(&desc, &context), FLG_OK);
    Curves curves = arcs(1);
    const FlgCurveSetView view = curves.view();
    FlgResampleDesc resample = flgResampleDefaults();
    resample.spacing = 1;
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetCreate(context, &view, &resample.curves), FLG_OK);
    ASSERT_EQ(flgResample(context, &resample, &out, nullptr), FLG_OK);
    ASSERT_EQ(tasks.size(), 1u);
    EXPECT_EQ(flgContextDestroy(context), FLG_NOT_READY);
    expect_failure(flgResample(context, &resample, &out, nullptr), FLG_ERROR_INVALID_HANDLE, "being destroyed");
    expect_failure(flgTick(context, 0, nullptr), FLG_ERROR_INVALID_HANDLE, "being destroyed");
    tasks[0].first(tasks[0].second);
    EXPECT_EQ(flgContextDestroy(context), FLG_OK);
}

TEST(ContextApi, ContextsSideBySideShareNothing) {
    Host a, b(2);
    const FlgCurveSet in_a = a.create(arcs(1));
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(flgCurveSetGetView(b.context, in_a, &view), FLG_ERROR_INVALID_HANDLE, "not a living curve set");
    EXPECT_EQ(view.curve_count, 0u);
}

}  // namespace
}  // namespace flg::test
