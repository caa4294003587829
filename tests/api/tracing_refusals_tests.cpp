// SPDX-License-Identifier: MIT
// What tracing, lifting and cutting refuse.
#include "api/surface_refusals.h"

namespace flg::test {
namespace {

// The levels of isolines and of cuts are checked alike.
template <class Desc, class Out>
void expect_levels_checked(const Refusal<Desc, Out>& refused) {
    static const float falling[] = {0.5f, 0.4f}, same[] = {0.5f, 0.5f}, bad[] = {0.1f, nan};
    const auto values = [](Desc& d, const float* levels) {
        d.levels = levels;
        d.level_count = 2;
    };
    refused([&](Desc& d) { values(d, falling); }, "desc.levels[1] is 0.4, must be finite and rise");
    refused([&](Desc& d) { values(d, same); }, "desc.levels[1] is 0.5, must be finite and rise");
    refused([&](Desc& d) { values(d, bad); }, "desc.levels[1] is nan");
    refused([&](Desc& d) { values(d, falling), d.level_count = 0; }, "desc.level_count is 0, must be at least 1");
    refused(
        [](Desc& d) {
            d.level_count = 3;
            d.level_first = 0;
            d.level_every = 0;
        },
        "desc.level_every is 0, must be finite and above 0");
    refused(
        [](Desc& d) {
            d.level_count = 3;
            d.level_first = 0;
            d.level_every = -1;
        },
        "desc.level_every is -1");
    refused(
        [](Desc& d) {
            d.level_count = 3;
            d.level_first = nan;
            d.level_every = 1;
        },
        "desc.level_first is nan");
    refused(
        [](Desc& d) {
            d.level_count = 3;
            d.level_first = 0;
            d.level_every = inf;
        },
        "desc.level_every is inf");
    refused(
        [](Desc& d) {
            d.level_count = 70000;
            d.level_first = 0;
            d.level_every = 1;
        },
        "desc.level_count is 70000");
}

TEST(SurfaceRefusals, Isolines) {
    const Things things;
    const uint32_t label = FLG_REGION_MAX + 1;
    FlgFieldTraceIsolinesDesc good = flgFieldTraceIsolinesDefaults();
    good.field = things.field;
    good.level_every = 0.3f;
    const Refusal refused{things.host, &flgFieldTraceIsolines, good};
    refused.common();
    expect_levels_checked(refused);
    using D = FlgFieldTraceIsolinesDesc;
    refused([](D& d) { d.field = {}; }, "desc.field is null", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.field.id = things.surface.id; }, "not a living field", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.regions = &label, d.region_count = 1; }, "desc.regions[0] is 16777216");
    things.cut();
    refused([](D&) {}, "desc.field belongs to revision 0 of its surface, which is at 1 now");
}

TEST(SurfaceRefusals, TooManyLevels) {
    const Things things;
    FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
    desc.field = things.field;
    for (const auto& [first, every] : {std::pair{0.0f, 1e-5f}, {-1e6f, 1e-5f}, {-1e9f, 1e-5f}}) {
        desc.level_first = first;
        desc.level_every = every;
        FlgSurfaceCurves curves{};
        FlgJob job{};
        ASSERT_EQ(flgFieldTraceIsolines(things.host.context, &desc, &curves, &job), FLG_OK);
        things.host.finish();
        EXPECT_EQ(things.host.result_of(job), FLG_ERROR_LIMIT) << first;
    }
}

TEST(SurfaceRefusals, Streams) {
    const Things things;
    const FlgSurfacePoint start = {0, 0.2f, 0.2f};
    FlgFieldTraceStreamsDesc good = flgFieldTraceStreamsDefaults();
    good.field = things.field;
    good.starts = &start;
    good.start_count = 1;
    const Refusal refused{things.host, &flgFieldTraceStreams, good};
    refused.common();
    using D = FlgFieldTraceStreamsDesc;
    refused([](D& d) { d.field = {}; }, "desc.field is null", FLG_ERROR_INVALID_HANDLE);
    refused([](D& d) { d.starts = nullptr; }, "desc.starts is null");
    refused([](D& d) { d.end_value = nan; }, "desc.end_value is nan");
    refused([](D& d) { d.region_count = 1; }, "desc.regions is null, but region_count is 1");
    refused([&](D& d) { d.border_samples = things.stale_curves; }, "desc.border_samples", FLG_ERROR_INVALID_HANDLE);
    refused([&](D& d) { d.border_samples = things.curves_of_other; }, "desc.border_samples belongs to another surface");
    const FlgSurfacePoint outside = {0, 0.8f, 0.8f};
    refused([&](D& d) { d.starts = &outside; }, "desc.starts[0] has the weights u = 0.8, v = 0.8");
    things.cut();
    refused([](D&) {}, "desc.field belongs to revision 0 of its surface, which is at 1 now");
}

TEST(SurfaceRefusals, Paths) {
    const Things things;
    const FlgSurfacePoint points[] = {{0, 0.2f, 0.2f}, {7, 0.2f, 0.2f}};
    const uint32_t offsets[] = {0, 2}, late[] = {1, 2}, single[] = {0, 1}, falling[] = {0, 2, 1};
    FlgFieldTracePathsDesc good = flgFieldTracePathsDefaults();
    good.surface = things.surface;
    good.points = points;
    good.path_offsets = offsets;
    good.path_count = 1;
    const Refusal refused{things.host, &flgFieldTracePaths, good};
    refused.common();
    using D = FlgFieldTracePathsDesc;
    refused([](D& d) { d.surface = {}; }, "desc.surface", FLG_ERROR_INVALID_HANDLE);
    refused([](D& d) { d.points = nullptr; }, "desc.points is null");
    refused([](D& d) { d.path_offsets = nullptr; }, "desc.path_offsets is null");
    refused([](D& d) { d.path_count = 0; }, "desc.path_count is 0, must be at least 1");
    refused([&](D& d) { d.path_offsets = late; }, "desc.path_offsets[0] is 1, must be 0");
    refused([&](D& d) { d.path_offsets = single; }, "desc.path_offsets[1] is 1 after 0");
    refused([&](D& d) { d.path_offsets = falling, d.path_count = 2; }, "desc.path_offsets[2] is 1 after 2");
    refused([](D& d) { d.region_count = 2; }, "desc.regions is null, but region_count is 2");
}

TEST(SurfaceRefusals, Lifting) {
    const Things things;
    FlgSurfaceCurvesLiftDesc good = flgSurfaceCurvesLiftDefaults();
    good.curves = things.curves;
    const Refusal refused{things.host, &flgSurfaceCurvesLift, good};
    refused.common();
    using D = FlgSurfaceCurvesLiftDesc;
    for (float bad : {inf, nan}) refused([&](D& d) { d.height = bad; }, "desc.height is");
    refused([](D& d) { d.curves = {}; }, "desc.curves is null", FLG_ERROR_INVALID_HANDLE);
    things.cut();
    refused([](D&) {}, "desc.curves belongs to revision 0 of its surface, which is at 1 now");
}

TEST(SurfaceRefusals, Cuts) {
    const Things things;
    const uint32_t regions[] = {2, 2}, label = FLG_REGION_MAX + 1;
    FlgSurfaceCutIsolinesDesc good = flgSurfaceCutIsolinesDefaults();
    good.field = things.field;
    good.level_every = 7;
    const Refusal refused{things.host, &flgSurfaceCutIsolines, good};
    expect_levels_checked(refused);
    using D = FlgSurfaceCutIsolinesDesc;
    refused([](D& d) { d.field = {}; }, "desc.field is null", FLG_ERROR_INVALID_HANDLE);
    refused([](D& d) { d.first_label = FLG_REGION_MAX + 1; }, "desc.first_label is 16777216, the largest label is");
    refused([](D& d) { d.region_count = 1; }, "desc.regions is null, but region_count is 1");
    refused([&](D& d) { d.regions = regions; }, "desc.region_count is 0, must be above 0 with regions");
    refused([&](D& d) { d.regions = regions, d.region_count = 2; }, "desc.regions[1] is 2 after 2, must rise");
    refused([&](D& d) { d.regions = &label, d.region_count = 1; }, "desc.regions[0] is 16777216");
    EXPECT_EQ(things.host.view(things.surface).revision, 0u) << "what is refused is no change";
    refused.common();
    refused([](D&) {}, "desc.field belongs to revision 0 of its surface, which is at 1 now");

    // flgSurfaceCutCurves makes a job only; the handle it would return is not there to be checked.
    const FlgContext context = things.host.context;
    FlgSurfaceCutCurvesDesc curves = flgSurfaceCutCurvesDefaults();
    FlgJob job{7};
    curves.curves = things.curves_of_other;
    expect_failure(flgSurfaceCutCurves(context, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT, "desc is null");
    expect_failure(flgSurfaceCutCurves({}, &curves, &job), FLG_ERROR_INVALID_HANDLE, "context is null");
    curves.first_label = FLG_REGION_MAX + 1;
    expect_failure(flgSurfaceCutCurves(context, &curves, &job), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.first_label is 16777216");
    curves = flgSurfaceCutCurvesDefaults();
    expect_failure(flgSurfaceCutCurves(context, &curves, &job), FLG_ERROR_INVALID_HANDLE, "desc.curves is null");
    EXPECT_EQ(job.id, 0u);
    curves.curves = things.curves;
    expect_failure(flgSurfaceCutCurves(context, &curves, &job), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.curves belongs to revision 0 of its surface, which is at 1 now");
    curves.curves = things.curves_of_other;
    EXPECT_EQ(flgSurfaceCutCurves(context, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
    things.host.finish();
}

}  // namespace
}  // namespace flg::test
