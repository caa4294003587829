// SPDX-License-Identifier: MIT
// Large worlds behind the C ABI: whatever an ability makes of input with an origin has the same bits wherever that is,
// and says where. Inputs of different origins meet where they are. Meshes that floats cannot hold are refused.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "api/live_inputs.h"
#include "api/part_inputs.h"
#include "api/spline_inputs.h"
#include "api/style_inputs.h"
#include "filigree/filigree_brush.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_motion.h"
#include "filigree/filigree_project.h"
#include "filigree/filigree_tangle.h"

namespace flg::test {
namespace {

using Place = std::array<double, 3>;

constexpr Place home = {0, 0, 0};
// A thousand kilometres away, and odd numbers that floats do not hold.
constexpr Place far_places[] = {{1e6, 1e6, 1e6}, {-123456789.01234567, 3.3e12, 0.1}};

void set_origin(double (&out)[3], const Place& place) {
    std::copy(place.begin(), place.end(), out);
}

// What an ability made, and where it says it is.
class World {
public:
    explicit World(const Place& at) : place(at) {}

    const Place place;
    SurfaceHost host;
    std::string made;

    // ---- inputs, all at the place ----

    FlgCurveSet curves(Curves curves) const {
        FlgCurveSetView view = curves.view();
        set_origin(view.origin, place);
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
        return set;
    }
    FlgSurface surface(MeshArrays mesh) const {
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        FlgMeshView view = mesh.view();
        set_origin(view.origin, place);
        desc.mesh = &view;
        FlgSurface surface{};
        EXPECT_EQ(flgSurfaceCreate(host.context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        return surface;
    }

    // ---- what comes of them ----

    void expect_here(const double (&origin)[3]) const {
        for (int c = 0; c < 3; ++c) EXPECT_EQ(origin[c], place[c]);
    }
    void add(const FlgCurveSetView& view) {
        expect_here(view.origin);
        ASSERT_GT(view.curve_count, 0u);
        made += bits(view);
    }
    void add(FlgCurveSet set) {
        host.finish();
        add(host.view_of(set));
    }
    void add(FlgSurface surface) {
        host.finish();
        const FlgSurfaceView view = host.view(surface);
        expect_here(view.mesh->origin);
        made += bits(view);
        const FlgSurfaceReport report = host.report(surface);
        expect_here(report.origin);
        append(made, report.box_min, 3);
        append(made, &report.area, 1);
    }
    void add(FlgField field) {
        host.finish();
        made += bits(host.view(field));
    }
    void add(FlgSurfaceCurves curves) {
        host.finish();
        const FlgSurfaceCurvesView view = host.view(curves);
        EXPECT_GT(view.curve_count, 0u);
        made += bits(view);
    }
    void add(const MadeSpline& spline) {
        ASSERT_EQ(spline.result, FLG_OK) << spline.error;
        expect_here(spline.view.origin);
        append(made, spline.view.nodes, size_t{spline.view.ambient} * spline.view.node_count);
        append(made, spline.view.parameters, spline.view.node_count);
        append(made, spline.view.normals, spline.view.normals ? size_t{3} * spline.view.node_count : 0);
    }
};

// The same bits, at home and far away.
void expect_same_everywhere(const std::function<void(World&)>& ability) {
    World at_home(home);
    ability(at_home);
    ASSERT_FALSE(at_home.made.empty());
    for (const Place& place : far_places) {
        World far(place);
        ability(far);
        EXPECT_TRUE(far.made == at_home.made) << "other bits at " << place[0] << ", " << place[1] << ", " << place[2];
    }
}

MeshArrays bumpy_sphere() {
    MeshArrays mesh = sphere(8);
    for (size_t i = 0; i < mesh.positions.size(); i += 3) mesh.positions[i + 2] *= 1 + 0.2f * mesh.positions[i];
    return mesh;
}

// ---- The same bits everywhere

TEST(Origin, CurvesAreResampledAlike) {
    expect_same_everywhere([](World& world) {
        FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
        desc.curves = world.curves(arcs(3));
        desc.spacing = 0.13f;
        FlgCurveSet out{};
        ASSERT_EQ(flgCurveSetResample(world.host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(out);
    });
}

TEST(Origin, StylesAndTheirTargetsAreAlike) {
    expect_same_everywhere([](World& world) {
        FlgStyleDesc style = flgStyleDefaults();
        style.point_count = 256;
        style.style = world.curves(coil());
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = prepare(world.host, style);
        desc.target = world.curves(arcs(2));
        desc.strokes = 2;
        world.add(stylize(world.host, desc));
        FlgCurveSet guide{};
        ASSERT_EQ(flgStyleGetGuide(world.host.context, desc.style, &guide), FLG_OK) << flgErrorGetMessage();
        world.add(guide);
        Curves axis;
        for (int i = 0; i < 60; ++i) axis.add_point(0.1 * i, 0, 0);
        axis.end_curve();
        style.guide = world.curves(axis);
        desc.style = prepare(world.host, style);
        world.add(stylize(world.host, desc));
    });
}

TEST(Origin, LiveStrokesAreAlike) {
    expect_same_everywhere([](World& world) {
        LiveHost host;
        set_origin(host.live.origin, world.place);
        const FlgLiveStroke stroke = host.begin();
        const Samples samples = drawn(90);
        world.add(host.push(stroke, samples.data(), samples.size()));
        FlgCurveSetView view = flgCurveSetViewDefaults();
        ASSERT_EQ(flgLiveStrokeGetTip(host.context, stroke, &view), FLG_OK) << flgErrorGetMessage();
        world.add(view);
        ASSERT_EQ(flgLiveStrokeGetPoints(host.context, stroke, &view), FLG_OK) << flgErrorGetMessage();
        world.add(view);
        FlgCurveSet stylized{}, kept{}, first{}, second{}, replayed{};
        ASSERT_EQ(flgLiveStrokeEnd(host.context, stroke, nullptr, &stylized, &kept, nullptr), FLG_OK);
        host.finish();
        ASSERT_EQ(flgLiveStrokeSplit(host.context, stroke, 20, nullptr, &first, &second, nullptr), FLG_OK);
        FlgLiveStrokeDesc again = host.live;
        set_origin(again.origin, home);
        ASSERT_EQ(flgLiveStrokeReplay(host.context, &again, kept, nullptr, &replayed, nullptr), FLG_OK);
        host.finish();
        for (const FlgCurveSet set : {stylized, kept, first, second, replayed}) world.add(host.view_of(set));
    });
}

TEST(Origin, SurfacesAreAlike) {
    expect_same_everywhere([](World& world) {
        const FlgContext context = world.host.context;
        const FlgSurface surface = world.surface(bumpy_sphere());
        world.add(surface);
        FlgSurfaceRefineDesc refine = flgSurfaceRefineDefaults();
        refine.surface = surface;
        refine.scheme = FLG_SUBDIVISION_LOOP;
        FlgSurface fine{};
        ASSERT_EQ(flgSurfaceRefine(context, &refine, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(fine);

        const FlgField field = world.host.start_distances(fine, 0);
        world.add(field);
        const FlgSurfaceCurves isolines = world.host.start_isolines(field, {0.4f, 1.1f});
        world.add(isolines);
        FlgSurfaceCurvesLiftDesc lift = flgSurfaceCurvesLiftDefaults();
        lift.curves = isolines;
        lift.height = 0.01f;
        FlgCurveSet lifted{};
        ASSERT_EQ(flgSurfaceCurvesLift(context, &lift, &lifted, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(lifted);
        FlgCurveSetProjectDesc project = flgCurveSetProjectDefaults();
        project.surface = fine;
        project.curves = lifted;
        FlgSurfaceCurves projected{};
        ASSERT_EQ(flgCurveSetProject(context, &project, &projected, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(projected);
        FlgSurfaceSampleDesc sample = flgSurfaceSampleDefaults();
        sample.surface = fine;
        sample.radius = 0.4f;
        FlgField samples{};
        ASSERT_EQ(flgSurfaceSample(context, &sample, &samples, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(samples);
        const uint32_t points[] = {3, 40};
        const FlgSurfacePoint ends[] = {{points[0], 0.2f, 0.3f}, {points[1], 0.4f, 0.1f}};
        const uint32_t offsets[] = {0, 2};
        FlgFieldTracePathsDesc paths = flgFieldTracePathsDefaults();
        paths.surface = fine;
        paths.points = ends;
        paths.path_offsets = offsets;
        paths.path_count = 1;
        FlgSurfaceCurves path{};
        ASSERT_EQ(flgFieldTracePaths(context, &paths, &path, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(path);

        FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
        cut.field = field;
        const float level = 0.7f;
        cut.levels = &level;
        cut.level_count = 1;
        cut.first_label = 0;
        ASSERT_EQ(flgSurfaceCutIsolines(context, &cut, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(fine);
    });
}

TEST(Origin, TanglesAreAlike) {
    expect_same_everywhere([](World& world) {
        const FlgContext context = world.host.context;
        const FlgSurface surface = world.surface(bumpy_sphere());
        FlgTangle tangle{};
        ASSERT_EQ(flgTangleCreate(context, surface, nullptr, &tangle, nullptr), FLG_OK) << flgErrorGetMessage();
        const uint32_t root = 0;
        FlgTangleDivideDesc divide = flgTangleDivideDefaults();
        divide.tangle = tangle;
        divide.regions = &root;
        divide.region_count = 1;
        const FlgSurfacePoint seed = {7, 0.3f, 0.3f};
        FlgTangleSeeds seeds = flgTangleSeedsDefaults();
        seeds.points = &seed;
        seeds.point_count = 1;
        divide.a = &seeds;
        divide.delta = 0.5f;
        divide.count = 3;
        ASSERT_EQ(flgTangleDivide(context, &divide, nullptr), FLG_OK) << flgErrorGetMessage();
        FlgTangleDisplaceDesc displace = flgTangleDisplaceDefaults();
        displace.tangle = tangle;
        displace.regions = &root;
        displace.region_count = 1;
        displace.amount = 0.05f;
        ASSERT_EQ(flgTangleDisplace(context, &displace, nullptr), FLG_OK) << flgErrorGetMessage();
        FlgSurfaceCurves borders{};
        ASSERT_EQ(flgTangleTraceBorders(context, tangle, nullptr, &borders, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(borders);
        world.add(surface);
        FlgTangleHistory history = flgTangleHistoryDefaults();
        ASSERT_EQ(flgTangleGetHistory(context, tangle, &history), FLG_OK) << flgErrorGetMessage();
        append(world.made, &history.base, 1);
        append(world.made, history.steps[0]->made, size_t{3} * history.steps[0]->made_count);
        EXPECT_EQ(flgTangleRelease(context, tangle), FLG_OK);
    });
}

// Of a manifold of the world: through points near it.
void add_spline(World& world, FlgManifold manifold, const std::vector<double>& points, FlgObstacles obstacles = {}) {
    FlgSplineDesc desc = spline_desc(manifold, points);
    set_origin(desc.origin, world.place);
    desc.obstacles = obstacles;
    const MadeSpline made = make_spline(world.host, desc);
    world.add(made);
    FlgSplineSampleDesc sample = flgSplineSampleDefaults();
    sample.spline = made.spline;
    sample.height = 0.01f;
    FlgCurveSet set{};
    ASSERT_EQ(flgSplineSample(world.host.context, &sample, &set, nullptr), FLG_OK) << flgErrorGetMessage();
    world.add(set);
}

TEST(Origin, SplinesOnMeshesCloudsAndGridsAreAlike) {
    expect_same_everywhere([](World& world) {
        const FlgContext context = world.host.context;
        const MeshArrays torus = torus_mesh(48, 20, 1, 0.3);
        const std::vector<double> points = torus_points(5, 1, 0.3);
        const FlgManifold on_mesh = mesh_manifold(world.host, world.surface(torus));
        add_spline(world, on_mesh, points);
        FlgManifoldView view = flgManifoldViewDefaults();
        ASSERT_EQ(flgManifoldGetView(context, on_mesh, &view), FLG_OK);
        world.expect_here(view.origin);
        double point[] = {1.2, 0.3, 0.4};
        ASSERT_EQ(flgManifoldProject(context, on_mesh, point, 1, nullptr), FLG_OK);
        append(world.made, point, 3);

        FlgManifoldFromPointsDesc cloud = flgManifoldFromPointsDefaults();
        cloud.points = torus.positions.data();
        cloud.point_count = torus.vertex_count();
        set_origin(cloud.origin, world.place);
        FlgManifold on_cloud{};
        ASSERT_EQ(flgManifoldCreateFromPoints(context, &cloud, &on_cloud, nullptr), FLG_OK) << flgErrorGetMessage();
        add_spline(world, on_cloud, points);

        FlgManifoldFromGridDesc grid = flgManifoldFromGridDefaults();
        std::vector<float> values;
        for (uint32_t& count : grid.counts) count = 24;
        for (double& x : grid.corner) x = -1.5;
        grid.spacing = 3.0 / 23;
        for (int k = 0; k < 24; ++k) {
            for (int j = 0; j < 24; ++j) {
                for (int i = 0; i < 24; ++i) {
                    values.push_back(static_cast<float>(
                        std::hypot(i * grid.spacing - 1.5, j * grid.spacing - 1.5, k * grid.spacing - 1.5) - 1));
                }
            }
        }
        grid.values = values.data();
        set_origin(grid.origin, world.place);
        FlgManifold on_grid{};
        ASSERT_EQ(flgManifoldCreateFromGrid(context, &grid, &on_grid, nullptr), FLG_OK) << flgErrorGetMessage();
        add_spline(world, on_grid, {1, 0, 0, 0, 1, 0, 0, 0.1, 1});
    });
}

TEST(Origin, SplinesOnShapesAreAlike) {
    expect_same_everywhere([](World& world) {
        FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
        set_origin(desc.origin, world.place);
        const std::vector<double> points = {1, 0.1, 0, 0.2, 1, 0.1, 0, 0.1, 1};
        for (const FlgManifoldShape shape :
             {FLG_MANIFOLD_SHAPE_PLANE, FLG_MANIFOLD_SHAPE_SPHERE, FLG_MANIFOLD_SHAPE_TORUS}) {
            desc.shape = shape;
            FlgManifold manifold{};
            ASSERT_EQ(flgManifoldCreateShape(world.host.context, &desc, &manifold), FLG_OK) << flgErrorGetMessage();
            add_spline(world, manifold, points);
            if (shape != FLG_MANIFOLD_SHAPE_SPHERE) continue;
            FlgManifold image{};
            ASSERT_EQ(flgManifoldCreateImage(world.host.context, manifold, 0.5, &image), FLG_OK);
            add_spline(world, image, points);
        }
        FlgPatchFunctions patch = flgPatchFunctionsDefaults();
        patch.low[0] = patch.low[1] = -2;
        patch.high[0] = patch.high[1] = 2;
        patch.evaluate = [](void*, double u, double v, double* out) {
            const double all[18] = {u, v, 0.1 * u * v, 1, 0, 0.1 * v, 0, 1, 0.1 * u, 0, 0, 0, 0, 0, 0.1, 0, 0, 0};
            std::copy(all, all + 18, out);
        };
        set_origin(patch.origin, world.place);
        FlgManifold manifold{};
        ASSERT_EQ(flgManifoldCreatePatch(world.host.context, &patch, &manifold), FLG_OK) << flgErrorGetMessage();
        add_spline(world, manifold, points);
    });
}

FlgObstacles obstacles_at(const World& world, std::vector<FlgObstacle> solids) {
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.obstacles = solids.data();
    desc.obstacle_count = static_cast<uint32_t>(solids.size());
    set_origin(desc.origin, world.place);
    FlgObstacles out{};
    EXPECT_EQ(flgObstaclesCreate(world.host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    return out;
}

// A ball and a mesh of one.
std::vector<FlgObstacle> two_balls(const World& world) {
    std::vector<FlgObstacle> solids(2, flgObstacleDefaults());
    solids[0].radius = 0.5;
    solids[0].centre[1] = 0.1;
    MeshArrays ball = sphere(6);
    for (size_t i = 0; i < ball.positions.size(); ++i) ball.positions[i] = 0.4f * ball.positions[i] + (i % 3 ? 0.f : 3);
    solids[1].kind = FLG_OBSTACLE_KIND_MESH;
    solids[1].cells = 24;
    solids[1].surface = world.surface(ball);
    return solids;
}

TEST(Origin, SplinesAndMotionsAmongObstaclesAreAlike) {
    expect_same_everywhere([](World& world) {
        const FlgObstacles obstacles = obstacles_at(world, two_balls(world));
        const FlgManifold space = shape_manifold(world.host, FLG_MANIFOLD_SHAPE_SPACE);
        add_spline(world, space, {-2, 0, 0, 1.5, 0.1, 0, 5, 0, 0.2}, obstacles);
        FlgMotionDesc motion = flgMotionDefaults();
        const double times[] = {0, 1, 2.5};
        const double poses[] = {1, 0, 0, -2,  0, 1, 0,  0, 0, 0, 1, 0,  //
                                1, 0, 0, 1.5, 0, 0, -1, 0, 0, 1, 0, 0,  //
                                0, 0, 1, 5,   1, 0, 0,  0, 0, 1, 0, 0.2};
        motion.key_count = 3;
        motion.times = times;
        motion.poses = poses;
        motion.obstacles = obstacles;
        set_origin(motion.origin, world.place);
        FlgMotion made{};
        ASSERT_EQ(flgMotionCreate(world.host.context, &motion, &made, nullptr), FLG_OK) << flgErrorGetMessage();
        world.host.finish();
        FlgMotionView view = flgMotionViewDefaults();
        ASSERT_EQ(flgMotionGetView(world.host.context, made, &view), FLG_OK) << flgErrorGetMessage();
        world.expect_here(view.origin);
        append(world.made, view.poses, size_t{12} * view.position_count);
    });
}

TEST(Origin, ModelsAreAlike) {
    expect_same_everywhere([](World& world) {
        const FlgContext context = world.host.context;
        FlgOutlineDesc outline = flgOutlineDefaults();
        outline.surface = world.surface(bumpy_sphere());
        outline.direction[2] = 1;
        FlgOutline seen{};
        ASSERT_EQ(flgOutlineCreate(context, &outline, &seen, nullptr), FLG_OK) << flgErrorGetMessage();
        world.host.finish();
        FlgOutlineView view = flgOutlineViewDefaults();
        ASSERT_EQ(flgOutlineGetView(context, seen, &view), FLG_OK) << flgErrorGetMessage();
        world.expect_here(view.origin);
        append(world.made, view.contour->points, size_t{2} * view.contour->point_count);
        append(world.made, view.placement, 12);

        FlgPartDesc part = flgPartDefaults();
        part.contour = view.contour;
        FlgModelPart placed = flgModelPartDefaults();
        ASSERT_EQ(flgPartCreate(context, &part, &placed.part, nullptr), FLG_OK) << flgErrorGetMessage();
        std::copy(view.placement, view.placement + 12, placed.placement);
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = &placed;
        desc.part_count = 1;
        std::copy(view.origin, view.origin + 3, desc.origin);
        FlgModel model{};
        ASSERT_EQ(flgModelCreate(context, &desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
        FlgSkinDesc skin = flgSkinDefaults();
        skin.model = model;
        skin.vertex_count = 500;
        FlgSkin made{};
        ASSERT_EQ(flgSkinCreate(context, &skin, &made, nullptr), FLG_OK) << flgErrorGetMessage();
        world.host.finish();
        FlgModelView joints = flgModelViewDefaults();
        ASSERT_EQ(flgModelGetView(context, model, &joints), FLG_OK) << flgErrorGetMessage();
        world.expect_here(joints.origin);
        append(world.made, joints.joint_positions, size_t{3} * joints.joint_count);
        FlgSkinView bound = flgSkinViewDefaults();
        ASSERT_EQ(flgSkinGetView(context, made, &bound), FLG_OK) << flgErrorGetMessage();
        world.expect_here(bound.origin);
        append(world.made, bound.positions, size_t{3} * bound.vertex_count);
        append(world.made, bound.vertex_weights, size_t{4} * bound.vertex_count);
    });
}

TEST(Origin, BrushMeshesAreAlike) {
    expect_same_everywhere([](World& world) {
        Curves curves = coil();
        FlgCurveSetView view = curves.view();
        set_origin(view.origin, world.place);
        FlgBrushMeshDesc desc = flgBrushMeshDefaults();
        desc.curves = &view;
        FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
        ASSERT_EQ(flgBrushMeshGetSizes(&desc, nullptr, &sizes), FLG_OK) << flgErrorGetMessage();
        std::vector<float> positions(3 * sizes.vertex_count);
        const FlgBufferColumn column = {
            FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0};
        FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
        output.columns = &column;
        output.column_count = 1;
        output.vertex_capacity = sizes.vertex_count;
        ASSERT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, nullptr), FLG_OK) << flgErrorGetMessage();
        append(world.made, positions.data(), positions.size());
    });
}

// ---- Inputs of different origins

// Far away, and half a metre, a quarter and an eighth further: sums of these are exact.
constexpr Place near_by = {1e6 + 0.5, 1e6 - 0.25, 1e6 + 0.125};

Curves moved(Curves curves, const Place& from, const Place& to) {
    for (size_t i = 0; i < curves.positions.size(); ++i)
        curves.positions[i] = static_cast<float>(curves.positions[i] + (from[i % 3] - to[i % 3]));
    return curves;
}

TEST(Origin, CurvesAreProjectedFromTheirOwnOrigin) {
    const auto project = [](const Place& origin_of_curves) {
        World world(far_places[0]);
        const World other(origin_of_curves);
        Curves line;
        for (int i = 0; i < 12; ++i) line.add_point(-0.5 + 0.0625 * i, 0.25, 1 + 0.125 * (i % 2));
        line.end_curve();
        line = moved(line, world.place, other.place);
        FlgCurveSetView view = line.view();
        set_origin(view.origin, other.place);
        FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
        desc.surface = world.surface(bumpy_sphere());
        EXPECT_EQ(flgCurveSetCreate(world.host.context, &view, &desc.curves), FLG_OK) << flgErrorGetMessage();
        FlgSurfaceCurves curves{};
        EXPECT_EQ(flgCurveSetProject(world.host.context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
        world.add(curves);
        return world.made;
    };
    EXPECT_TRUE(project(far_places[0]) == project(near_by));
}

TEST(Origin, AGuideLiesBesideItsStyleWhereverTheirOrigins) {
    const auto make = [](const Place& origin_of_guide) {
        World world(far_places[0]);
        Curves axis;
        for (int i = 0; i < 60; ++i) axis.add_point(0.125 * i, 0, 0);
        axis.end_curve();
        axis = moved(axis, world.place, origin_of_guide);
        FlgCurveSetView view = axis.view();
        set_origin(view.origin, origin_of_guide);
        FlgStyleDesc style = flgStyleDefaults();
        style.point_count = 256;
        style.style = world.curves(coil());
        EXPECT_EQ(flgCurveSetCreate(world.host.context, &view, &style.guide), FLG_OK) << flgErrorGetMessage();
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = prepare(world.host, style);
        desc.target = world.curves(arcs(1));
        world.add(stylize(world.host, desc));
        return world.made;
    };
    EXPECT_TRUE(make(far_places[0]) == make(near_by));
}

using MadeNodes = std::vector<double>;

TEST(Origin, SplinesMeetManifoldsAndObstaclesOfOtherOrigins) {
    const auto make = [](const Place& origin_of_points, const Place& origin_of_obstacles) {
        World world(far_places[0]);
        const FlgManifold manifold = mesh_manifold(world.host, world.surface(torus_mesh(48, 20, 1, 0.3)));
        std::vector<FlgObstacle> solids(1, flgObstacleDefaults());
        solids[0].radius = 0.25;
        const double centre[3] = {1.25, 0, 0.25};
        for (int c = 0; c < 3; ++c) solids[0].centre[c] = centre[c] + (world.place[c] - origin_of_obstacles[c]);
        FlgObstaclesDesc desc = flgObstaclesDefaults();
        desc.obstacles = solids.data();
        desc.obstacle_count = 1;
        set_origin(desc.origin, origin_of_obstacles);
        FlgSplineDesc spline = flgSplineDefaults();
        EXPECT_EQ(flgObstaclesCreate(world.host.context, &desc, &spline.obstacles, nullptr), FLG_OK);
        std::vector<double> points = {0, 1.25, 0.25, 1.25, -0.75, 0.125, -1, -0.5, 0.25};
        for (size_t i = 0; i < points.size(); ++i) points[i] += world.place[i % 3] - origin_of_points[i % 3];
        spline.manifold = manifold;
        spline.points = points.data();
        spline.point_count = 3;
        set_origin(spline.origin, origin_of_points);
        const MadeSpline made = make_spline(world.host, spline);
        EXPECT_EQ(made.result, FLG_OK) << made.error;
        world.expect_here(made.view.origin);
        return MadeNodes(made.view.nodes, made.view.nodes + size_t{3} * made.view.node_count);
    };
    const MadeNodes alike = make(far_places[0], far_places[0]);
    EXPECT_TRUE(alike == make(near_by, far_places[0]));
    EXPECT_TRUE(alike == make(home, far_places[0])) << "points in doubles, from the world's own origin";
    // Obstacles are seen from elsewhere: what rounds there rounds otherwise.
    const MadeNodes moved = make(far_places[0], near_by);
    ASSERT_EQ(moved.size(), alike.size());
    for (size_t i = 0; i < alike.size(); ++i) EXPECT_NEAR(moved[i], alike[i], 1e-9);
}

TEST(Origin, MeshesAsObstaclesStandWhereTheirSurfaceIs) {
    const auto make = [](const Place& origin_of_obstacles) {
        World world(far_places[0]);
        std::vector<FlgObstacle> solids(1, flgObstacleDefaults());
        solids[0].kind = FLG_OBSTACLE_KIND_MESH;
        solids[0].cells = 24;
        solids[0].surface = world.surface(sphere(6));
        FlgObstaclesDesc desc = flgObstaclesDefaults();
        desc.obstacles = solids.data();
        desc.obstacle_count = 1;
        set_origin(desc.origin, origin_of_obstacles);
        const std::vector<double> points = {-2, 0.1, 0, 2, 0, 0.1};
        FlgSplineDesc spline = spline_desc(shape_manifold(world.host, FLG_MANIFOLD_SHAPE_SPACE), points);
        EXPECT_EQ(flgObstaclesCreate(world.host.context, &desc, &spline.obstacles, nullptr), FLG_OK);
        set_origin(spline.origin, world.place);
        const MadeSpline made = make_spline(world.host, spline);
        EXPECT_EQ(made.result, FLG_OK) << made.error;
        double nearest = HUGE_VAL;
        for (uint32_t i = 0; i < made.view.node_count; ++i) nearest = std::min(nearest, distance(made.node(i), {}));
        return nearest;
    };
    EXPECT_NEAR(make(far_places[0]), 1, 0.05);
    EXPECT_NEAR(make(near_by), make(far_places[0]), 1e-6);
}

// ---- What is refused

TEST(Origin, MustBeFiniteAndOfASizeThatDoublesSubtract) {
    const Host host;
    for (const double bad : {HUGE_VAL, std::nan(""), 2e30}) {
        Curves curves = arcs(1);
        FlgCurveSetView view = curves.view();
        view.origin[1] = bad;
        FlgCurveSet set{};
        expect_failure(flgCurveSetCreate(host.context, &view, &set), FLG_ERROR_INVALID_ARGUMENT, "view.origin[1]");
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        MeshArrays mesh = plane(2);
        FlgMeshView input = mesh.view();
        input.origin[2] = bad;
        desc.mesh = &input;
        FlgSurface surface{};
        expect_failure(flgSurfaceCreate(host.context, &desc, &surface, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                       "desc.mesh.origin[2]");
    }
    FlgManifoldShapeDesc space = flgManifoldShapeDefaults();
    space.origin[0] = 1;
    FlgManifold manifold{};
    expect_failure(flgManifoldCreateShape(host.context, &space, &manifold), FLG_ERROR_INVALID_ARGUMENT, "desc.origin");
}

// A mesh a metre wide, in floats of the world.
MeshArrays wavy(const Place& at, double size = 1, uint32_t cells = 60) {
    return grid(cells, cells, [&](double u, double v) {
        return Point{at[0] + size * u, at[1] + size * v, at[2] + 0.1 * size * std::sin(5 * u) * std::cos(4 * v)};
    });
}

FlgResult result_of(const SurfaceHost& host, MeshArrays mesh, std::string& error) {
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView view = mesh.view();
    desc.mesh = &view;
    FlgSurface surface{};
    FlgJob job{};
    EXPECT_EQ(flgSurfaceCreate(host.context, &desc, &surface, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    error = host.status_of(job).error;
    return host.result_of(job);
}

TEST(Origin, MeshesThatFloatsCannotHoldAreRefused) {
    const SurfaceHost host;
    std::string error;
    EXPECT_EQ(result_of(host, wavy({1e6, 1e6, 1e6}), error), FLG_ERROR_INVALID_ARGUMENT);
    for (const char* words : {"1e+06", "0.0625 m apart", "origin"})
        EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_EQ(result_of(host, wavy({0, 2e5, 0}), error), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(result_of(host, wavy({0, 0, 1e9}), error), FLG_ERROR_INVALID_ARGUMENT);
}

TEST(Origin, SplinesThatFloatsCannotHoldAreNotSampled) {
    const Host host;
    const FlgManifold space = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE);
    for (const bool has_origin : {false, true}) {
        std::vector<double> points = {0, 0, 0, 0.5, 0.25, 0, 1, 0, 0.25};
        for (size_t i = 0; i < points.size(); ++i) points[i] += has_origin ? 0 : far_places[0][i % 3];
        FlgSplineDesc desc = spline_desc(space, points);
        if (has_origin) set_origin(desc.origin, far_places[0]);
        FlgSplineSampleDesc sample = flgSplineSampleDefaults();
        sample.spline = make_spline(host, desc).spline;
        FlgCurveSet set{};
        FlgJob job{};
        ASSERT_EQ(flgSplineSample(host.context, &sample, &set, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), has_origin ? FLG_OK : FLG_ERROR_INVALID_ARGUMENT);
        const bool names_remedy = std::strstr(host.status_of(job).error, "FlgSplineDesc::origin") != nullptr;
        EXPECT_EQ(names_remedy, !has_origin) << host.status_of(job).error;
    }
}

TEST(Origin, MeshesThatFloatsHoldAreTaken) {
    const SurfaceHost host;
    std::string error;
    EXPECT_EQ(result_of(host, wavy({1e4, 1e4, 1e4}), error), FLG_OK) << error;
    EXPECT_EQ(result_of(host, wavy({1e6, 1e6, 1e6}, 1e4), error), FLG_OK) << error;
    // A dense scan of a millimetre, and one of a continent.
    EXPECT_EQ(result_of(host, wavy({0, 0, 0}, 1e-3, 200), error), FLG_OK) << error;
    EXPECT_EQ(result_of(host, wavy({-5e6, 0, 0}, 1e7, 200), error), FLG_OK) << error;
    // Something small near the origin of a large scene, and vertices that are repeated for their attributes.
    MeshArrays scene = wavy({0, 0, 0}, 0.01);
    const MeshArrays ground = wavy({-5e5, -5e5, 0}, 1e6, 4);
    const uint32_t first = scene.vertex_count();
    scene.positions.insert(scene.positions.end(), ground.positions.begin(), ground.positions.end());
    for (const uint32_t v : ground.triangles) scene.triangles.push_back(first + v);
    EXPECT_EQ(result_of(host, scene, error), FLG_OK) << error;
    EXPECT_EQ(result_of(host, cube(20), error), FLG_OK) << error;
}

}  // namespace
}  // namespace flg::test
