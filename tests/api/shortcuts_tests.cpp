// SPDX-License-Identifier: MIT
// The commonest things in one call: the same as by descriptors and loops.
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

TEST(CurveSetFromPoints, IsTheSetOfAView) {
    Curves curves = arcs(1, 40);
    curves.radii.clear();
    curves.flags[0] = FLG_CURVE_CLOSED;
    Host host;
    FlgCurveSet set{};
    ASSERT_EQ(flgCurveSetCreateFromPoints(host.context, curves.positions.data(), 40, FLG_CURVE_CLOSED, &set), FLG_OK)
        << flgErrorGetMessage();
    const FlgCurveSetView made = host.view_of(set), expected = host.view_of(host.create(curves));
    ASSERT_EQ(made.curve_count, 1u);
    EXPECT_EQ(made.curve_offsets[0], 0u);
    EXPECT_EQ(made.curve_offsets[1], 40u);
    EXPECT_EQ(made.curve_flags[0], FLG_CURVE_CLOSED);
    ASSERT_EQ(made.column_count, expected.column_count);
    EXPECT_EQ(std::memcmp(made.columns[0].data, expected.columns[0].data, 120 * sizeof(float)), 0);
}

TEST(CurveSetFromPoints, RefusesEachBadInputByName) {
    Host host;
    const float points[] = {0, 0, 0, 1, NAN, 0};
    const auto refused = [&](const float* from, uint32_t count, uint8_t flags, const char* words) {
        FlgCurveSet set{77};
        expect_failure(flgCurveSetCreateFromPoints(host.context, from, count, flags, &set), FLG_ERROR_INVALID_ARGUMENT,
                       words);
        EXPECT_EQ(set.id, 0u);
    };
    refused(nullptr, 2, 0, "points is null");
    refused(points, 0, 0, "count is 0, must be at least 1");
    refused(points, 1, 2, "flags is 2");
    refused(points, 2, 0, "points holds nan at point 1, must be finite");
    expect_failure(flgCurveSetCreateFromPoints(host.context, points, 1, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_set is null");
    FlgCurveSet set{};
    expect_failure(flgCurveSetCreateFromPoints({}, points, 1, 0, &set), FLG_ERROR_INVALID_HANDLE, "context is null");
}

TEST(SurfaceFromTriangles, IsTheSurfaceOfADescriptor) {
    MeshArrays mesh;
    for (int i = 0; i < 4; ++i) mesh.add_vertex(i % 2, i / 2, 0.25 * i);
    mesh.add_triangle(0, 1, 3);
    mesh.add_triangle(0, 3, 2);
    Host host;
    FlgSurface made{}, expected{};
    FlgJob job{};
    ASSERT_EQ(flgSurfaceCreateFromTriangles(host.context, mesh.positions.data(), 4, mesh.triangles.data(), 2, nullptr,
                                            &made, &job),
              FLG_OK)
        << flgErrorGetMessage();
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    ASSERT_EQ(flgSurfaceCreate(host.context, &desc, &expected, nullptr), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgContextRun(host.context, &job, 1, 60), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSurfaceView a = flgSurfaceViewDefaults(), b = flgSurfaceViewDefaults();
    ASSERT_EQ(flgSurfaceGetView(host.context, made, &a), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgSurfaceGetView(host.context, expected, &b), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(a.mesh->vertex_count, b.mesh->vertex_count);
    ASSERT_EQ(a.mesh->triangle_count, 2u);
    EXPECT_EQ(std::memcmp(a.mesh->triangles, b.mesh->triangles, 6 * sizeof(uint32_t)), 0);
    EXPECT_EQ(std::memcmp(a.mesh->columns[0].data, b.mesh->columns[0].data, 12 * sizeof(float)), 0);
}

TEST(SurfaceFromTriangles, RefusesEachBadInputByName) {
    Host host;
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, INFINITY, 0};
    const uint32_t triangles[] = {0, 1, 2};
    const auto refused = [&](const float* p, const uint32_t* t, const char* words) {
        FlgSurface surface{77};
        expect_failure(flgSurfaceCreateFromTriangles(host.context, p, 3, t, 1, nullptr, &surface, nullptr),
                       FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(surface.id, 0u);
    };
    refused(nullptr, triangles, "positions is null");
    refused(positions, nullptr, "triangles is null");
    refused(positions, triangles, "positions holds inf at vertex 2");
    FlgFrameReport report{};
    report.struct_size = sizeof report;
    ASSERT_EQ(flgContextTick(host.context, FLG_UNLIMITED, &report), FLG_OK);
    EXPECT_EQ(report.jobs_pending, 0u);
}

TEST(ViewColumn, IsTheOneOfItsAttribute) {
    Curves curves = arcs(1, 5);
    FlgCurveSetView view = curves.view();
    EXPECT_EQ(flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_RADIUS), view.columns + 1);
    EXPECT_EQ(flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_POSITION), view.columns);
    EXPECT_EQ(flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_COLOR), nullptr);
    EXPECT_EQ(flgCurveSetViewGetColumn(nullptr, FLG_ATTRIBUTE_POSITION), nullptr);
    view.columns = nullptr;
    EXPECT_EQ(flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_POSITION), nullptr);
    MeshArrays mesh;
    FlgMeshView of_mesh = mesh.view();
    EXPECT_EQ(flgMeshViewGetColumn(&of_mesh, FLG_ATTRIBUTE_POSITION), of_mesh.columns);
    EXPECT_EQ(flgMeshViewGetColumn(&of_mesh, FLG_ATTRIBUTE_NORMAL), nullptr);
    EXPECT_EQ(flgMeshViewGetColumn(nullptr, FLG_ATTRIBUTE_NORMAL), nullptr);
}

// A style's preparation and what waits for it.
struct Stylization {
    explicit Stylization(const Host& host) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(coil());
        FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
        stylize.target = host.create(arcs(1));
        EXPECT_EQ(flgStyleCreate(host.context, &style, &stylize.style, &jobs[0]), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(flgCurveSetStylize(host.context, &stylize, &result, &jobs[1]), FLG_OK) << flgErrorGetMessage();
    }
    FlgCurveSet result{};
    FlgJob jobs[2] = {};
};

TEST(ContextRun, RunsJobsToTheirEnd) {
    for (const uint32_t workers : {0u, 2u}) {
        Host host(workers);
        const Stylization made(host);
        ASSERT_EQ(flgContextRun(host.context, made.jobs, 2, 60), FLG_OK) << flgErrorGetMessage();
        EXPECT_GT(host.view_of(made.result).curve_offsets[1], 60u);
        const Stylization again(host);
        ASSERT_EQ(flgContextRun(host.context, nullptr, 0, 60), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(flgContextRun(host.context, nullptr, 0, 0), FLG_OK);
        FlgCurveSetView view = flgCurveSetViewDefaults();
        EXPECT_EQ(flgCurveSetGetView(host.context, again.result, &view), FLG_OK);
    }
}

TEST(ContextRun, SaysWhenTheTimeIsOver) {
    Host host;
    const Stylization made(host);
    EXPECT_EQ(flgContextRun(host.context, made.jobs, 2, 0), FLG_NOT_READY);
    EXPECT_EQ(flgContextRun(host.context, made.jobs, 2, 60), FLG_OK) << flgErrorGetMessage();
}

TEST(ContextRun, GivesTheErrorOfAJob) {
    Host host;
    const Stylization made(host);
    ASSERT_EQ(flgJobCancel(host.context, made.jobs[0]), FLG_OK);
    EXPECT_EQ(flgContextRun(host.context, made.jobs, 2, 60), FLG_ERROR_CANCELLED);
    EXPECT_EQ(flgContextRun(host.context, made.jobs + 1, 1, 60), FLG_ERROR_DEPENDENCY);
    EXPECT_NE(std::string(flgErrorGetMessage()), "");
}

TEST(ContextRun, RefusesEachBadInputByName) {
    Host host;
    expect_failure(flgContextRun({}, nullptr, 0, 1), FLG_ERROR_INVALID_HANDLE, "context is null");
    expect_failure(flgContextRun(host.context, nullptr, 1, 1), FLG_ERROR_INVALID_ARGUMENT, "jobs is null");
    expect_failure(flgContextRun(host.context, nullptr, 0, -1), FLG_ERROR_INVALID_ARGUMENT, "seconds is -1");
    expect_failure(flgContextRun(host.context, nullptr, 0, NAN), FLG_ERROR_INVALID_ARGUMENT, "seconds is nan");
    const FlgJob unknown = {77};
    expect_failure(flgContextRun(host.context, &unknown, 1, 1), FLG_ERROR_INVALID_HANDLE, "jobs");
}

TEST(ContextRun, IsNotForCallbacks) {
    Host host;
    struct Seen {
        FlgContext context;
        FlgResult result = FLG_OK;
    } seen{host.context};
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(coil());
    FlgJobOptions options = flgJobOptionsDefaults();
    style.job = &options;
    options.on_finished = [](void* user_data, FlgJob, FlgResult) {
        Seen& self = *static_cast<Seen*>(user_data);
        self.result = flgContextRun(self.context, nullptr, 0, 1);
    };
    options.user_data = &seen;
    FlgStyle made{};
    ASSERT_EQ(flgStyleCreate(host.context, &style, &made, nullptr), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(flgContextRun(host.context, nullptr, 0, 60), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(seen.result, FLG_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace flg::test
