// SPDX-License-Identifier: MIT
#include "api/host.h"

namespace flg::test {
namespace {

TEST(ContextApi, DefaultsRoundTrip) {
    const FlgContextDesc desc = flgContextDefaults();
    EXPECT_EQ(desc.struct_size, sizeof desc);
    EXPECT_EQ(desc.version, static_cast<uint32_t>(FLG_VERSION));
    EXPECT_EQ(flgVersionGet(), static_cast<uint32_t>(FLG_VERSION));
    FlgContext context{};
    ASSERT_EQ(flgContextCreate(nullptr, &context), FLG_OK);
    EXPECT_EQ(flgContextDestroy(context), FLG_OK);
    EXPECT_EQ(flgContextDestroy({}), FLG_OK);
}

TEST(ContextApi, RefusesWhatItCantUse) {
    FlgContext context{};
    expect_failure(flgContextCreate(nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT, "out_context is null");
    const auto refused = [&](auto change, FlgResult expected, const char* words) {
        FlgContextDesc desc = flgContextDefaults();
        change(desc);
        context = {5};
        expect_failure(flgContextCreate(&desc, &context), expected, words);
        EXPECT_EQ(context.id, 0u);
    };
    refused([](auto& d) { d.struct_size = 0; }, FLG_ERROR_INVALID_ARGUMENT, "struct_size is 0");
    refused([](auto& d) { d.struct_size += 8; }, FLG_ERROR_INVALID_ARGUMENT, "desc: struct_size");
    refused([](auto& d) { d.version += 1u << 12; }, FLG_ERROR_VERSION, "compiled for filigree 0.2");
    refused([](auto& d) { d.version += 1u << 22; }, FLG_ERROR_VERSION, "compiled for filigree 1.1");
    refused([](auto& d) { d.worker_count = 257; }, FLG_ERROR_INVALID_ARGUMENT, "worker_count is 257");
    FlgAllocator allocator = flgAllocatorDefaults();
    allocator.free = [](void*, void*, size_t, size_t) {};
    refused([&](auto& d) { d.allocator = &allocator; }, FLG_ERROR_INVALID_ARGUMENT, "only one of allocate and free");
    allocator.struct_size = 4;
    refused([&](auto& d) { d.allocator = &allocator; }, FLG_ERROR_INVALID_ARGUMENT, "desc.allocator: struct_size is 4");
    FlgProfiler profiler = flgProfilerDefaults();
    profiler.end = [](void*) {};
    refused([&](auto& d) { d.profiler = &profiler; }, FLG_ERROR_INVALID_ARGUMENT, "only one of begin and end");
    FlgJobSystem system = flgJobSystemDefaults();
    system.submit = [](void*, void (*)(void*), void*) {};
    system.concurrency = 0;
    refused([&](auto& d) { d.job_system = &system; }, FLG_ERROR_INVALID_ARGUMENT, "job_system.concurrency is 0");
}

TEST(ContextApi, PatchVersionsFit) {
    FlgContextDesc desc = flgContextDefaults();
    desc.version += 5;
    FlgContext context{};
    ASSERT_EQ(flgContextCreate(&desc, &context), FLG_OK);
    flgContextDestroy(context);
}

TEST(ContextApi, TickNeedsAContextAndASizedReport) {
    expect_failure(flgContextTick({}, FLG_UNLIMITED, nullptr), FLG_ERROR_INVALID_HANDLE, "context is null");
    Host host;
    FlgFrameReport report{};
    expect_failure(flgContextTick(host.context, FLG_UNLIMITED, &report), FLG_ERROR_INVALID_ARGUMENT,
                   "report: struct_size is 0");
    EXPECT_EQ(flgContextTick(host.context, FLG_UNLIMITED, nullptr), FLG_OK);
    report.struct_size = sizeof report;
    EXPECT_EQ(flgContextTick(host.context, FLG_UNLIMITED, &report), FLG_OK);
    EXPECT_EQ(report.frame, 2u);
    EXPECT_STREQ(report.max_slice_stage, "");
}

TEST(ContextApi, CallbacksMayStartJobsButNotTick) {
    Host host;
    struct State {
        FlgContext context;
        FlgCurveSet curves;
        FlgResult tick, wait, destroy;
        FlgCurveSet second{};
    } state{host.context, host.create(arcs(1)), FLG_OK, FLG_OK, FLG_OK};
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = state.curves;
    desc.spacing = 0.5f;
    FlgJobOptions options = flgJobOptionsDefaults();
    desc.job = &options;
    options.user_data = &state;
    options.on_finished = [](void* user, FlgJob, FlgResult result) {
        auto& s = *static_cast<State*>(user);
        EXPECT_EQ(result, FLG_OK);
        s.tick = flgContextTick(s.context, FLG_UNLIMITED, nullptr);
        s.wait = flgContextWait(s.context, 0);
        s.destroy = flgContextDestroy(s.context);
        FlgCurveSetResampleDesc again = flgCurveSetResampleDefaults();
        again.curves = s.curves;
        again.spacing = 1;
        EXPECT_EQ(flgCurveSetResample(s.context, &again, &s.second, nullptr), FLG_OK);
    };
    FlgCurveSet first{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &first, nullptr), FLG_OK);
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
    const FlgLog log = {sizeof log, &lines, [](void* user, FlgLogLevel, const char* message) {
                            static_cast<std::vector<std::string>*>(user)->push_back(message);
                        }};
    desc.log = &log;
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
    const FlgProfiler profiler = {sizeof profiler, &zones,
                                  [](void* user, const char* name) {
                                      auto& z = *static_cast<Zones*>(user);
                                      ++z.depth;
                                      ++z.count;
                                      z.names += std::string(name) + ";";
                                  },
                                  [](void* user) { --static_cast<Zones*>(user)->depth; }};
    desc.profiler = &profiler;
    Host host(desc);
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.curves = host.create(arcs(3));
    resample.spacing = 0.001f;
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetResample(host.context, &resample, &out, nullptr), FLG_OK);
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
    FlgContext context{};
    expect_failure(flgContextCreate(&newer.desc, &context), FLG_ERROR_VERSION, "compiled for filigree 0.2");
}

TEST(ContextApi, AFailingTickWritesItsReport) {
    FlgFrameReport report;
    std::memset(static_cast<void*>(&report), 0xcd, sizeof report);
    report.struct_size = sizeof report;
    expect_failure(flgContextTick({}, FLG_UNLIMITED, &report), FLG_ERROR_INVALID_HANDLE, "context is null");
    EXPECT_EQ(report.frame, 0u);
    EXPECT_EQ(report.jobs_pending, 0u);
    EXPECT_STREQ(report.max_slice_stage, "");
}

TEST(ContextApi, ACallbackThatThrowsDoesNotLockTheContext) {
    Host host;
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = host.create(arcs(1));
    desc.spacing = 1;
    FlgJobOptions options = flgJobOptionsDefaults();
    desc.job = &options;
    options.on_finished = [](void*, FlgJob, FlgResult) { throw std::string("the host's own"); };
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &out, nullptr), FLG_OK);
    expect_failure(flgContextTick(host.context, FLG_UNLIMITED, nullptr), FLG_ERROR_INTERNAL, "unknown exception");
    EXPECT_EQ(flgContextTick(host.context, FLG_UNLIMITED, nullptr), FLG_OK);
    EXPECT_EQ(host.view_of(out).curve_count, 1u);
}

TEST(ContextApi, AContextThatIsBeingDestroyedTakesNoMoreWork) {
    std::vector<std::pair<void (*)(void*), void*>> tasks;
    FlgContextDesc desc = flgContextDefaults();
    const FlgJobSystem system = {sizeof system, 1, &tasks, [](void* user, void (*run)(void*), void* task) {
                                     static_cast<decltype(tasks)*>(user)->push_back({run, task});
                                 }};
    desc.job_system = &system;
    FlgContext context{};
    ASSERT_EQ(flgContextCreate(&desc, &context), FLG_OK);
    Curves curves = arcs(1);
    const FlgCurveSetView view = curves.view();
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.spacing = 1;
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetCreate(context, &view, &resample.curves), FLG_OK);
    ASSERT_EQ(flgCurveSetResample(context, &resample, &out, nullptr), FLG_OK);
    ASSERT_EQ(tasks.size(), 1u);
    EXPECT_EQ(flgContextDestroy(context), FLG_NOT_READY);
    expect_failure(flgCurveSetResample(context, &resample, &out, nullptr), FLG_ERROR_INVALID_HANDLE, "being destroyed");
    expect_failure(flgContextTick(context, FLG_UNLIMITED, nullptr), FLG_ERROR_INVALID_HANDLE, "being destroyed");
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
