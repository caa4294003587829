// SPDX-License-Identifier: MIT
// Every allocation of every entry point fails once: what needed it says so, surfaces stay valid, nothing is lost.
#include "api/surface_inputs.h"
#include "filigree/filigree_project.h"

namespace flg::test {
namespace {

// What a step works on, made while memory lasts.
struct Bench {
    SurfaceHost host;
    FlgSurface surface{};
    FlgField field{};
    FlgSurfaceCurves curves{};
    FlgCurveSet lifted{};
    std::string before;
    std::vector<float> zeros;

    Bench() : surface(host.surface(plane(5))) {
        field = host.field(surface, [](const Point& p) { return distance(p, {0.1, 0.05, 0}); });
        curves = host.isolines(field, {0.5f});
        FlgSurfaceCurvesLiftDesc lift = flgSurfaceCurvesLiftDefaults();
        lift.curves = curves;
        EXPECT_EQ(flgSurfaceCurvesLift(host.context, &lift, &lifted, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        before = bits(host.view(surface));
        zeros.resize(36);
    }
};

using Step = FlgResult (*)(Bench&, FlgJob*);

// Fails each allocation in turn, or every few if there are many; returns how many there are.
int64_t fail_each(Step step) {
    const auto run = [&](int64_t fail_at) {
        Bench bench;
        HostAllocator& allocator = bench.host.allocator;
        // flgContextDestroy has to give everything back, see ~Host.
        allocator.calls = 0;
        allocator.fail_at = fail_at;
        FlgJob job{};
        FlgResult result = step(bench, &job);
        if (result == FLG_OK) {
            bench.host.finish();
            if (job.id != 0) result = bench.host.result_of(job);
        } else {
            EXPECT_EQ(job.id, 0u);
        }
        bench.host.finish();
        const int64_t calls = allocator.calls;
        allocator.fail_at = -1;
        if (fail_at < 0) {
            EXPECT_EQ(result, FLG_OK) << flgErrorGetMessage();
        } else {
            // Also where memory ran out in what is built for a job, which is a job of its own.
            EXPECT_TRUE(result == FLG_OK || result == FLG_ERROR_OUT_OF_MEMORY)
                << fail_at << ": " << flgResultGetName(result);
        }
        const FlgSurfaceView view = bench.host.view(bench.surface);
        expect_valid(view);
        EXPECT_TRUE(result == FLG_OK || bits(view) == bench.before) << "allocation " << fail_at;
        // The surface is as good as ever, and once more after a cut.
        for (int round = 0; round < 2; ++round) {
            FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
            const uint32_t vertex = 0;
            desc.surface = bench.surface;
            desc.vertices = &vertex;
            desc.vertex_count = 1;
            const FlgFieldView field = bench.host.view(bench.host.solve(desc));
            const FlgSurfaceView now = bench.host.view(bench.surface);
            for (uint32_t v = 0; v < field.vertex_count; ++v) {
                const double exact = distance(vertex_at(now, v), {});
                EXPECT_NEAR(field.values[v], exact, 0.1 * exact) << "allocation " << fail_at;
            }
            FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
            cut.field = bench.host.solve(desc);
            cut.level_first = 0.33f;
            cut.level_every = 9;
            EXPECT_EQ(flgSurfaceCutIsolines(bench.host.context, &cut, nullptr, nullptr), FLG_OK)
                << flgErrorGetMessage();
            bench.host.finish();
            expect_valid(bench.host.view(bench.surface));
            if (::testing::Test::HasFailure()) return calls;
        }
        return calls;
    };
    const int64_t calls = run(-1);
    const int64_t stride = std::max<int64_t>(1, calls / 120);
    for (int64_t at = 0; at < calls && !::testing::Test::HasFailure(); at += stride) run(at);
    return calls;
}

TEST(SurfaceMemory, SurfacesAreMadeOrRefused) {
    EXPECT_GT(fail_each([](Bench& bench, FlgJob* job) {
                  FlgSurfaceDesc desc = flgSurfaceDefaults();
                  MeshArrays mesh = cube(2);
                  mesh.add_triangle(0, 0, 1);
                  mesh.set_regions([](const Point&) { return 4u; });
                  const FlgMeshView input = mesh.view();
                  desc.mesh = &input;
                  FlgSurface made{};
                  return flgSurfaceCreate(bench.host.context, &desc, &made, job);
              }),
              20);
    fail_each([](Bench& bench, FlgJob* job) {
        FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
        desc.surface = bench.surface;
        desc.scheme = FLG_SUBDIVISION_LOOP;
        FlgSurface made{};
        return flgSurfaceRefine(bench.host.context, &desc, &made, job);
    });
}

TEST(SurfaceMemory, FieldsAreMadeOrRefused) {
    fail_each([](Bench& bench, FlgJob*) {
        FlgField made{};
        return flgFieldCreate(bench.host.context, bench.surface, bench.zeros.data(), 36, &made);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        FlgFieldBlendDesc desc = flgFieldBlendDefaults();
        desc.from = desc.to = bench.field;
        FlgField made{};
        return flgFieldBlend(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
        desc.surface = bench.surface;
        desc.radius = 0.3f;
        FlgField made{};
        return flgSurfaceSample(bench.host.context, &desc, &made, job);
    });
}

template <bool perturbed>
FlgResult measure(Bench& bench, FlgJob* job) {
    const uint32_t zero = 0;
    const FlgSurfacePoint point = {7, 0.2f, 0.2f};
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = bench.surface;
    desc.vertices = desc.targets = desc.regions = desc.border_regions = &zero;
    desc.vertex_count = desc.target_count = desc.region_count = desc.border_region_count = 1;
    desc.points = &point;
    desc.point_count = 1;
    desc.curves = bench.curves;
    desc.labels = 1;
    desc.perturbation = perturbed ? 0.01f : 0.0f;
    FlgField made{};
    return flgFieldCreateGeodesic(bench.host.context, &desc, &made, job);
}

TEST(SurfaceMemory, DistancesAreMeasuredOrRefused) {
    EXPECT_GT(fail_each(measure<false>), 30);
    fail_each(measure<true>);
}

TEST(SurfaceMemory, CurvesAreTracedOrRefused) {
    fail_each([](Bench& bench, FlgJob* job) {
        FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
        desc.field = bench.field;
        desc.level_every = 0.2f;
        FlgSurfaceCurves made{};
        return flgFieldTraceIsolines(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        const FlgSurfacePoint start = {20, 0.2f, 0.2f};
        FlgFieldTraceStreamsDesc desc = flgFieldTraceStreamsDefaults();
        desc.field = bench.field;
        desc.starts = &start;
        desc.start_count = 1;
        desc.border_samples = bench.curves;
        FlgSurfaceCurves made{};
        return flgFieldTraceStreams(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        const FlgSurfacePoint points[] = {{0, 0.2f, 0.2f}, {48, 0.2f, 0.2f}, {9, 0.5f, 0}};
        const uint32_t offsets[] = {0, 3};
        FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
        desc.surface = bench.surface;
        desc.points = points;
        desc.path_offsets = offsets;
        desc.path_count = 1;
        desc.closed = 1;
        FlgSurfaceCurves made{};
        return flgFieldTracePaths(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        FlgSurfaceSampleBordersDesc desc = flgSurfaceSampleBordersDefaults();
        desc.surface = bench.surface;
        desc.spacing = 0.1f;
        FlgSurfaceCurves made{};
        return flgSurfaceSampleBorders(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        FlgSurfaceCurvesLiftDesc desc = flgSurfaceCurvesLiftDefaults();
        desc.curves = bench.curves;
        FlgCurveSet made{};
        return flgSurfaceCurvesLift(bench.host.context, &desc, &made, job);
    });
    fail_each([](Bench& bench, FlgJob* job) {
        FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
        desc.surface = bench.surface;
        desc.curves = bench.lifted;
        FlgSurfaceCurves made{};
        return flgCurveSetProject(bench.host.context, &desc, &made, job);
    });
}

// With what the solver keeps there, so that a cut has it to update.
void build_solver(Bench& bench) {
    const int64_t fail_at = bench.host.allocator.fail_at.exchange(-1);
    EXPECT_EQ(measure<false>(bench, nullptr), FLG_OK) << flgErrorGetMessage();
    bench.host.finish();
    bench.host.allocator.calls = 0;
    bench.host.allocator.fail_at = fail_at;
}

TEST(SurfaceMemory, CutsAreMadeWholeOrNotAtAll) {
    EXPECT_GT(fail_each([](Bench& bench, FlgJob* job) {
                  build_solver(bench);
                  FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
                  desc.field = bench.field;
                  desc.level_first = 0.2f;
                  desc.level_every = 0.13f;
                  desc.first_label = 3;
                  FlgField made{};
                  return flgSurfaceCutIsolines(bench.host.context, &desc, &made, job);
              }),
              30);
    EXPECT_GT(fail_each([](Bench& bench, FlgJob* job) {
                  build_solver(bench);
                  FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
                  desc.curves = bench.curves;
                  desc.first_label = 3;
                  return flgSurfaceCutCurves(bench.host.context, &desc, job);
              }),
              30);
}

// A refused reader leaves no trace, an accepted one is waited for: however many there are, and wherever memory runs
// out.
TEST(SurfaceMemory, ReadersAreWaitedForOrRefused) {
    int64_t calls = 0;
    for (int64_t fail_at = -1; fail_at < calls; fail_at += 7) {
        Bench bench;
        bench.host.allocator.calls = 0;
        bench.host.allocator.fail_at = fail_at;
        std::vector<FlgSurfaceCurves> traced;
        for (int i = 0; i < 20; ++i) {
            FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
            desc.field = bench.field;
            desc.level_every = 0.1f;
            FlgSurfaceCurves curves{};
            const FlgResult result = flgFieldTraceIsolines(bench.host.context, &desc, &curves, nullptr);
            EXPECT_TRUE(result == FLG_OK || result == FLG_ERROR_OUT_OF_MEMORY) << flgResultGetName(result);
            EXPECT_EQ(curves.id != 0, result == FLG_OK);
            if (result == FLG_OK) traced.push_back(curves);
        }
        calls = bench.host.allocator.calls;
        bench.host.allocator.fail_at = -1;
        EXPECT_GE(traced.size(), 19u);
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        EXPECT_EQ(flgContextTick(bench.host.context, 1, &report), FLG_OK);
        EXPECT_EQ(report.jobs_pending + report.jobs_finished, traced.size()) << "allocation " << fail_at;
        FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
        cut.field = bench.field;
        cut.level_every = 0.21f;
        ASSERT_EQ(flgSurfaceCutIsolines(bench.host.context, &cut, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
        bench.host.finish();
        for (FlgSurfaceCurves curves : traced) {
            EXPECT_TRUE(bits(bench.host.view(curves)) == bits(bench.host.view(traced[0]))) << "allocation " << fail_at;
        }
    }
    EXPECT_GT(calls, 100);
}

}  // namespace
}  // namespace flg::test
