// SPDX-License-Identifier: MIT
// Debug drawing behind the C ABI: lines and points of closed form, counts before they are written, one refusal for each
// argument.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>

#include "api/live_inputs.h"
#include "api/part_inputs.h"
#include "api/spline_inputs.h"
#include "api/style_inputs.h"
#include "filigree/filigree_debug.h"

namespace flg::test {
namespace {

constexpr uint32_t white = 0xffffffff, red = 0xff0000ff, green = 0xff00ff00, blue = 0xffff0000, grey = 0xff808080,
                   yellow = 0xff00ffff;

template <class Handle>
using Entry = FlgResult (*)(FlgContext, Handle, const FlgDebugDrawDesc*, FlgDebugDrawing*);

struct Drawn {
    std::vector<FlgDebugVertex> lines, points;

    uint32_t line_count() const { return static_cast<uint32_t>(lines.size() / 2); }
    uint32_t point_count() const { return static_cast<uint32_t>(points.size()); }
    uint32_t line_count(uint32_t color) const {
        return static_cast<uint32_t>(
                   std::count_if(lines.begin(), lines.end(), [&](auto& v) { return v.color == color; })) /
               2;
    }
    Point end(uint32_t vertex) const {
        const float* p = lines[vertex].position;
        return {p[0], p[1], p[2]};
    }
    double length(uint32_t line) const { return distance(end(2 * line), end(2 * line + 1)); }
    std::string bits() const {
        std::string all(reinterpret_cast<const char*>(lines.data()), lines.size() * sizeof(FlgDebugVertex));
        return all.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(FlgDebugVertex));
    }
};

FlgDebugDrawDesc of_parts(uint32_t parts) {
    FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    desc.parts = parts;
    return desc;
}

// Counts, then writes into arrays that are just large enough; before that into ones that are too small by one.
template <class Handle>
Drawn draw(const Host& host, Entry<Handle> entry, Handle handle, FlgDebugDrawDesc desc = flgDebugDrawDefaults()) {
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    EXPECT_EQ(entry(host.context, handle, &desc, &drawing), FLG_OK) << flgErrorGetMessage();
    const FlgDebugVertex untouched{{7, 7, 7}, 7};
    const uint32_t lines = drawing.line_count, points = drawing.point_count;
    Drawn drawn{std::vector<FlgDebugVertex>(2 * lines + 1, untouched),
                std::vector<FlgDebugVertex>(points + 1, untouched)};
    drawing.lines = drawn.lines.data();
    drawing.points = drawn.points.data();
    const auto is_untouched = [&](const FlgDebugVertex& v) { return std::memcmp(&v, &untouched, sizeof v) == 0; };
    for (const bool of_lines : {true, false}) {
        if ((of_lines ? lines : points) == 0) continue;
        drawing.line_capacity = of_lines ? lines - 1 : lines;
        drawing.point_capacity = of_lines ? points : points - 1;
        expect_failure(entry(host.context, handle, &desc, &drawing), FLG_ERROR_LIMIT,
                       of_lines ? "drawing.line_capacity is" : "drawing.point_capacity is");
        EXPECT_EQ(drawing.line_count, lines);
        EXPECT_EQ(drawing.point_count, points);
        EXPECT_TRUE(std::all_of(drawn.lines.begin(), drawn.lines.end(), is_untouched));
        EXPECT_TRUE(std::all_of(drawn.points.begin(), drawn.points.end(), is_untouched));
    }
    drawing.line_capacity = lines;
    drawing.point_capacity = points;
    EXPECT_EQ(entry(host.context, handle, &desc, &drawing), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(drawing.line_count, lines);
    EXPECT_EQ(drawing.point_count, points);
    EXPECT_TRUE(is_untouched(drawn.lines.back()));
    EXPECT_TRUE(is_untouched(drawn.points.back()));
    drawn.lines.pop_back();
    drawn.points.pop_back();
    EXPECT_TRUE(std::none_of(drawn.lines.begin(), drawn.lines.end(), is_untouched));
    EXPECT_TRUE(std::none_of(drawn.points.begin(), drawn.points.end(), is_untouched));
    return drawn;
}

// Ranges of elements, one behind the other, draw what one call draws.
template <class Handle>
void expect_ranges_add_up(const Host& host, Entry<Handle> entry, Handle handle, FlgDebugDrawDesc desc) {
    const Drawn whole = draw(host, entry, handle, desc);
    Drawn sum;
    for (desc.first = 0, desc.count = 5; desc.first < 10000; desc.first += 5) {
        const Drawn part = draw(host, entry, handle, desc);
        sum.lines.insert(sum.lines.end(), part.lines.begin(), part.lines.end());
        sum.points.insert(sum.points.end(), part.points.begin(), part.points.end());
        if (sum.bits().size() >= whole.bits().size()) break;
    }
    EXPECT_EQ(sum.bits(), whole.bits());
    desc.first = UINT32_MAX;
    EXPECT_EQ(draw(host, entry, handle, desc).bits(), "");
}

FlgObstacle box_of(double x, double y, double z) {
    FlgObstacle box = flgObstacleDefaults();
    box.kind = FLG_OBSTACLE_KIND_BOX;
    box.half[0] = x;
    box.half[1] = y;
    box.half[2] = z;
    return box;
}

TEST(DebugDrawingApi, ABoxHasTwelveEdges) {
    const Host host;
    const FlgObstacles box = make_obstacles(host, {box_of(1, 2, 3)}, 3, 0.5);
    host.finish();
    const Drawn drawn = draw(host, flgDebugDrawObstacles, box);
    ASSERT_EQ(drawn.line_count(), 24u);
    EXPECT_EQ(drawn.line_count(white), 12u);
    EXPECT_EQ(drawn.line_count(grey), 12u);
    for (uint32_t line = 0; line < 24; ++line) {
        const double grown = line < 12 ? 0 : 0.5;
        const Point a = drawn.end(2 * line), b = drawn.end(2 * line + 1);
        uint32_t differing = 0;
        for (uint32_t k = 0; k < 3; ++k) {
            EXPECT_EQ(std::abs(a[k]), k + 1 + grown);
            EXPECT_EQ(std::abs(b[k]), k + 1 + grown);
            differing += a[k] != b[k] ? 1 : 0;
        }
        EXPECT_EQ(differing, 1u);
    }
    std::set<std::pair<Point, Point>> different;
    for (uint32_t line = 0; line < 12; ++line) different.insert({drawn.end(2 * line), drawn.end(2 * line + 1)});
    EXPECT_EQ(different.size(), 12u);
}

TEST(DebugDrawingApi, RoundSolidsAreDrawnOnTheirBoundary) {
    const Host host;
    FlgObstacle ball = flgObstacleDefaults(), capsule = flgObstacleDefaults();
    ball.centre[1] = 5;
    ball.radius = 2;
    capsule.kind = FLG_OBSTACLE_KIND_CAPSULE;
    capsule.to[0] = 3;
    for (const uint32_t dimension : {2u, 3u}) {
        const FlgObstacles solids = make_obstacles(host, {ball, capsule}, dimension, 0.25);
        host.finish();
        const Drawn drawn = draw(host, flgDebugDrawObstacles, solids);
        EXPECT_EQ(drawn.line_count(), dimension == 2 ? 2 * (32u + 34u) : 2 * (96u + 132u));
        for (uint32_t v = 0; v < drawn.lines.size(); ++v) {
            const Point at = drawn.end(v);
            const double grown = drawn.lines[v].color == grey ? 0.25 : 0;
            const double to_ball = distance(at, {0, 5, 0}) - 2;
            const double to_capsule = distance(at, {std::clamp<double>(at[0], 0, 3), 0, 0}) - 1;
            EXPECT_NEAR(std::min(std::abs(to_ball - grown), std::abs(to_capsule - grown)), 0, 1e-6);
            EXPECT_TRUE(dimension == 3 || at[2] == 0);
        }
    }
}

TEST(DebugDrawingApi, PolygonsFunctionsAndMeshesAreDrawn) {
    const Host host;
    const double square[] = {0, 0, 0, 2, 2, 2, 2, 0};  // clockwise
    FlgObstacle polygon = flgObstacleDefaults();
    polygon.kind = FLG_OBSTACLE_KIND_POLYGON;
    polygon.points = square;
    polygon.point_count = 4;
    const FlgObstacles flat = make_obstacles(host, {polygon}, 2, 0.5);
    host.finish();
    const Drawn around = draw(host, flgDebugDrawObstacles, flat, of_parts(FLG_DEBUG_PART_CLEARANCE));
    ASSERT_EQ(around.line_count(), 4u);
    for (uint32_t v = 0; v < 8; ++v) {
        EXPECT_EQ(std::max(std::abs(around.end(v)[0] - 1), std::abs(around.end(v)[1] - 1)), 1.5);
    }

    FlgObstacle function = box_of(3, 4, 5);
    function.kind = FLG_OBSTACLE_KIND_FUNCTION;
    function.value = [](void*, const double* x, double* gradient) {
        const double length = std::hypot(x[0], x[1], x[2]);
        for (int k = 0; k < 3; ++k) gradient[k] = x[k] / length;
        return length - 2;
    };
    const FlgObstacles ball = make_obstacles(host, {function});
    host.finish();
    const Drawn box = draw(host, flgDebugDrawObstacles, ball);
    ASSERT_EQ(box.line_count(), 12u);
    for (uint32_t v = 0; v < 24; ++v) EXPECT_EQ(std::abs(box.end(v)[2]), 5);

    FlgObstacle mesh = flgObstacleDefaults();
    mesh.kind = FLG_OBSTACLE_KIND_MESH;
    mesh.surface = mesh_surface(host, cube(2));
    mesh.cells = 16;
    const FlgObstacles solid = make_obstacles(host, {mesh}, 3, 0.125);
    host.finish();
    const Drawn drawn = draw(host, flgDebugDrawObstacles, solid);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    ASSERT_EQ(flgSurfaceGetView(host.context, mesh.surface, &view), FLG_OK);
    EXPECT_EQ(drawn.line_count(white), view.mesh->triangle_count * 3 / 2);
    EXPECT_EQ(drawn.line_count(grey), 12u);
}

TEST(DebugDrawingApi, CurvesAreLinesAndPoints) {
    const Host host;
    Curves curves;
    for (const auto& p : std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 5, 5}})
        curves.add_point(p[0], p[1], p[2]);
    curves.offsets.push_back(3);
    curves.flags.push_back(FLG_CURVE_CLOSED);
    curves.end_curve();
    const FlgCurveSet set = host.create(curves);
    FlgDebugDrawDesc desc = of_parts(FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS);
    desc.color = 0x12345678;
    const Drawn drawn = draw(host, flgDebugDrawCurveSet, set, desc);
    ASSERT_EQ(drawn.line_count(), 3u);
    EXPECT_EQ(drawn.line_count(0x12345678), 3u);
    EXPECT_EQ(drawn.end(4), (Point{1, 1, 0}));
    EXPECT_EQ(drawn.end(5), (Point{0, 0, 0}));
    ASSERT_EQ(drawn.point_count(), 4u);
    EXPECT_EQ(drawn.points[3].position[2], 5);
    desc.first = 1;
    desc.count = 1;
    EXPECT_EQ(draw(host, flgDebugDrawCurveSet, set, desc).line_count(), 0u);
    EXPECT_EQ(draw(host, flgDebugDrawCurveSet, set, desc).point_count(), 1u);
}

TEST(DebugDrawingApi, FramesAreOrthonormalAndSeamsAreJumps) {
    const Host host;
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(coil());
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = prepare(host, style);
    desc.target = host.create(arcs(2));
    desc.temperature = 1;
    const FlgCurveSet set = stylize(host, desc);
    const FlgCurveSetView view = host.view_of(set);
    const float* indices = find_column(view, FLG_ATTRIBUTE_STYLE_INDEX)->data;

    FlgDebugDrawDesc how = of_parts(FLG_DEBUG_PART_FRAMES);
    how.every = 7;
    how.size = 0.25f;
    const Drawn axes = draw(host, flgDebugDrawCurveSet, set, how);
    uint32_t expected = 0, jumps = 0;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const uint32_t begin = view.curve_offsets[c], end = view.curve_offsets[c + 1];
        expected += (end - begin + 6) / 7;
        for (uint32_t i = begin + 1; i < end; ++i) jumps += indices[i] != indices[i - 1] + 1 ? 1 : 0;
    }
    ASSERT_EQ(axes.line_count(), 3 * expected);
    for (uint32_t line = 0; line < axes.line_count(); line += 3) {
        double dots[3]{};
        for (uint32_t k = 0; k < 3; ++k) {
            EXPECT_EQ(axes.end(2 * (line + k)), axes.end(2 * line));
            EXPECT_EQ(axes.lines[2 * (line + k)].color, (std::array{red, green, blue})[k]);
            EXPECT_NEAR(axes.length(line + k), 0.25, 1e-5);
            for (uint32_t c = 0; c < 3; ++c) {
                const uint32_t other = line + (k + 1) % 3;
                dots[k] += (axes.end(2 * (line + k) + 1)[c] - axes.end(2 * line)[c]) *
                           (axes.end(2 * other + 1)[c] - axes.end(2 * line)[c]);
            }
            EXPECT_NEAR(dots[k], 0, 1e-5);
        }
    }
    ASSERT_GT(jumps, 0u);
    EXPECT_EQ(draw(host, flgDebugDrawCurveSet, set, of_parts(FLG_DEBUG_PART_SEAMS)).point_count(), jumps);
}

TEST(DebugDrawingApi, AStyleIsItsExampleItsGuideAndWhatIsBetween) {
    const Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil(400, 12, 6, 0.25));
    const FlgStyle style = prepare(host, desc);
    const uint32_t count = style_info(host, style).point_count;
    const Drawn drawn = draw(host, flgDebugDrawStyle, style);
    EXPECT_EQ(drawn.line_count(white), count - 1);
    EXPECT_EQ(drawn.line_count(green), count - 1);
    ASSERT_EQ(drawn.line_count(grey), count);
    double square = 0;
    for (uint32_t line = 0; line < drawn.line_count(); ++line) {
        if (drawn.lines[2 * line].color == grey) square += drawn.length(line) * drawn.length(line);
    }
    const double rms = style_info(host, style).displacement_rms;
    EXPECT_NEAR(std::sqrt(square / count), rms, 1e-4 * rms);
}

TEST(DebugDrawingApi, SurfacesFieldsAndTheirCurves) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(4));
    const FlgSurfaceReport report = host.report(surface);
    const Drawn border = draw(host, flgDebugDrawSurface, surface);
    EXPECT_EQ(border.line_count(red), report.border_edges);
    EXPECT_EQ(border.line_count(), report.border_edges);
    const Drawn edges = draw(host, flgDebugDrawSurface, surface, of_parts(FLG_DEBUG_PART_EDGES));
    EXPECT_EQ(int64_t{edges.line_count()}, report.vertex_count + report.triangle_count - report.euler_number);
    expect_ranges_add_up(host, flgDebugDrawSurface, surface, of_parts(FLG_DEBUG_PART_EDGES));
    expect_ranges_add_up(host, flgDebugDrawSurface, surface, of_parts(FLG_DEBUG_PART_POINTS));

    const FlgField field = host.field(surface, [](const Point& p) { return p[0]; });
    const Drawn values = draw(host, flgDebugDrawField, field);
    ASSERT_EQ(values.point_count(), report.vertex_count);
    for (const FlgDebugVertex& v : values.points) {
        EXPECT_EQ(v.position[0] == report.box_min[0], v.color == blue);
        EXPECT_EQ(v.position[0] == report.box_max[0], v.color == red);
    }
    const float level = 0.3f * report.box_max[0] + 0.7f * report.box_min[0];
    const FlgSurfaceCurves curves = host.isolines(field, {level});
    const Drawn isoline = draw(host, flgDebugDrawSurfaceCurves, curves);
    ASSERT_GT(isoline.line_count(), 3u);
    for (uint32_t v = 0; v < isoline.lines.size(); ++v) EXPECT_NEAR(isoline.end(v)[0], level, 1e-6);

    FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
    cut.field = field;
    cut.levels = &level;
    cut.level_count = 1;
    cut.first_label = 1;
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    EXPECT_EQ(flgDebugDrawSurface(host.context, surface, &desc, &drawing), FLG_NOT_READY);
    host.finish();
    EXPECT_GT(draw(host, flgDebugDrawSurface, surface).line_count(), host.report(surface).border_edges);
    expect_failure(flgDebugDrawField(host.context, field, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT,
                   "field belongs to revision 0");
    expect_failure(flgDebugDrawSurfaceCurves(host.context, curves, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT,
                   "curves belongs to revision 0");
}

TEST(DebugDrawingApi, ATangleShowsBordersAndSeeds) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(plane(8));
    FlgTangle tangle{};
    ASSERT_EQ(flgTangleCreate(host.context, surface, nullptr, &tangle, nullptr), FLG_OK);
    const FlgSurfacePoint point{0, 0.25f, 0.25f};
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.points = &point;
    seeds.point_count = 1;
    const uint32_t root = 0;
    FlgTangleDivideDesc divide = flgTangleDivideDefaults();
    divide.tangle = tangle;
    divide.regions = &root;
    divide.region_count = 1;
    divide.a = &seeds;
    divide.delta = 0.4f;
    ASSERT_EQ(flgTangleDivide(host.context, &divide, nullptr), FLG_OK) << flgErrorGetMessage();
    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    EXPECT_EQ(flgDebugDrawTangle(host.context, tangle, &desc, &drawing), FLG_NOT_READY);
    host.finish();
    const Drawn drawn = draw(host, flgDebugDrawTangle, tangle);
    ASSERT_EQ(drawn.point_count(), 1u);
    const Point seed = point_at(host.view(surface), {0, 0.25f, 0.25f});
    double inner = 0;
    for (uint32_t line = 0; line < drawn.line_count(); ++line) {
        if (drawn.lines[2 * line].color != red) inner += drawn.length(line);
    }
    EXPECT_GT(inner, 0.4);  // an arc about the seed
    EXPECT_LT(inner, 2 * M_PI * 0.4);
    EXPECT_GT(drawn.line_count(red), 32u);
    const float* at = drawn.points[0].position;
    EXPECT_LT(distance(seed, {at[0], at[1], at[2]}), 0.5);
    ASSERT_EQ(flgTangleUndo(host.context, tangle, nullptr, nullptr), FLG_OK);
    host.finish();
    EXPECT_EQ(draw(host, flgDebugDrawTangle, tangle).point_count(), 0u);
}

TEST(DebugDrawingApi, DrawingsAndModels) {
    const PartHost host;
    const std::vector<double> bar{0, 0, 4, 0, 4, 1, 0, 1};
    FlgContourView contour = flgContourViewDefaults();
    contour.points = bar.data();
    contour.point_count = 4;
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = &contour;
    FlgStraightSkeleton skeleton{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const Drawn roof = draw(host, flgDebugDrawStraightSkeleton, skeleton);
    EXPECT_EQ(roof.line_count(), 4u + 5u);
    EXPECT_EQ(roof.line_count(red), 5u);  // all arcs end at the latest time
    ASSERT_EQ(roof.point_count(), 2u);
    for (const FlgDebugVertex& v : roof.points) EXPECT_NEAR(v.position[1], 0.5, 1e-6);

    FlgModelPart parts = flgModelPartDefaults();
    parts.part = host.part(bar);
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = &parts;
    model_desc.part_count = 1;
    FlgModel model{};
    ASSERT_EQ(flgModelCreate(host.context, &model_desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgSkinDesc skin_desc = flgSkinDefaults();
    skin_desc.model = model;
    skin_desc.vertex_count = 300;
    FlgSkin skin{};
    ASSERT_EQ(flgSkinCreate(host.context, &skin_desc, &skin, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgPartMeshDesc mesh_desc = flgPartMeshDefaults();
    mesh_desc.part = parts.part;
    FlgPartMesh mesh{};
    ASSERT_EQ(flgPartMeshCreate(host.context, &mesh_desc, &mesh, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgPartView part = flgPartViewDefaults();
    ASSERT_EQ(flgPartGetView(host.context, parts.part, &part), FLG_OK);
    const Drawn drawn = draw(host, flgDebugDrawPart, parts.part);
    EXPECT_EQ(drawn.line_count(white), part.outline_count);
    EXPECT_EQ(drawn.line_count(green), part.node_count - 1);
    EXPECT_EQ(draw(host, flgDebugDrawPart, parts.part, of_parts(FLG_DEBUG_PART_FRAMES)).line_count(grey),
              part.sample_count);

    FlgModelView view = flgModelViewDefaults();
    ASSERT_EQ(flgModelGetView(host.context, model, &view), FLG_OK);
    uint32_t bones = 0;
    for (uint32_t j = 0; j < view.joint_count; ++j) bones += view.joint_parents[j] != FLG_NO_INDEX ? 1 : 0;
    ASSERT_GT(bones, 0u);
    EXPECT_EQ(draw(host, flgDebugDrawModel, model).line_count(), 12 * bones);
    EXPECT_EQ(draw(host, flgDebugDrawModel, model).point_count(), view.joint_count);
    EXPECT_EQ(draw(host, flgDebugDrawSkin, skin).line_count(), 12 * bones);

    FlgSkinView skin_view = flgSkinViewDefaults();
    ASSERT_EQ(flgSkinGetView(host.context, skin, &skin_view), FLG_OK);
    const FlgDebugDrawDesc edges = of_parts(FLG_DEBUG_PART_EDGES);
    EXPECT_EQ(draw(host, flgDebugDrawSkin, skin, edges).line_count(), skin_view.triangle_count * 3 / 2);
    FlgPartMeshView mesh_view = flgPartMeshViewDefaults();
    ASSERT_EQ(flgPartMeshGetView(host.context, mesh, &mesh_view), FLG_OK);
    EXPECT_EQ(draw(host, flgDebugDrawPartMesh, mesh).line_count(), mesh_view.triangle_count * 3 / 2);
}

TEST(DebugDrawingApi, AnOutlineIsDrawnInItsPlace) {
    const SurfaceHost host;
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(plane(4));
    FlgOutline outline{};
    ASSERT_EQ(flgOutlineCreate(host.context, &desc, &outline, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const Drawn drawn = draw(host, flgDebugDrawOutline, outline);
    const FlgSurfaceReport report = host.report(desc.surface);
    ASSERT_GE(drawn.line_count(), 4u);
    for (uint32_t v = 0; v < drawn.lines.size(); ++v) {
        double off_border = HUGE_VAL;
        for (uint32_t k = 0; k < 2; ++k) {
            const double at = drawn.end(v)[k];
            off_border = std::min({off_border, std::abs(at - report.box_min[k]), std::abs(at - report.box_max[k])});
        }
        EXPECT_NEAR(off_border, 0, 1e-5);
    }
}

TEST(DebugDrawingApi, SplinesAndMotions) {
    const Host host;
    const std::vector<double> points{1, 0, 0, 0, 1, 0, -1, 0, 0};
    FlgSplineDesc desc = spline_desc(shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE), points);
    desc.closed = 1;
    const MadeSpline made = make_spline(host, desc);
    ASSERT_EQ(made.result, FLG_OK) << made.error;
    const Drawn drawn = draw(host, flgDebugDrawSpline, made.spline,
                             of_parts(FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS | FLG_DEBUG_PART_FRAMES));
    EXPECT_EQ(drawn.line_count(white), made.view.node_count);
    EXPECT_EQ(drawn.line_count(red), made.view.node_count);
    for (uint32_t line = 0; line < drawn.line_count(); ++line) {
        if (drawn.lines[2 * line].color == green) {
            EXPECT_NEAR(distance(drawn.end(2 * line + 1), {}), 1.05, 1e-5);
        }
    }
    ASSERT_EQ(drawn.point_count(), 3u);
    EXPECT_EQ(drawn.points[1].color, yellow);
    EXPECT_NEAR(drawn.points[1].position[1], 1, 1e-6);

    const double times[] = {0, 1};
    const double poses[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 3, 1, 0, 0, 0, 0, 0, 1, 0};
    FlgMotionDesc motion_desc = flgMotionDefaults();
    motion_desc.key_count = 2;
    motion_desc.times = times;
    motion_desc.poses = poses;
    FlgMotion motion{};
    ASSERT_EQ(flgMotionCreate(host.context, &motion_desc, &motion, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const Drawn moved = draw(host, flgDebugDrawMotion, motion);
    EXPECT_EQ(moved.line_count(), 32u + 3 * 33u);
    double length = 0;
    for (uint32_t line = 0; line < 32; ++line) length += moved.length(line);
    EXPECT_NEAR(length, 3, 1e-5);
    EXPECT_EQ(moved.point_count(), 2u);
}

// Of a unit sphere around `middle`: points on it, each with its normal.
void expect_sphere(const Drawn& drawn, const Point& middle, uint32_t least, double tolerance) {
    EXPECT_GE(drawn.point_count(), least);
    ASSERT_EQ(drawn.line_count(green), drawn.point_count());
    ASSERT_EQ(drawn.line_count(), drawn.point_count());
    std::set<Point> different;
    for (uint32_t i = 0; i < drawn.point_count(); ++i) {
        const float* p = drawn.points[i].position;
        EXPECT_EQ(drawn.points[i].color, white);
        EXPECT_EQ(distance(drawn.end(2 * i), {p[0], p[1], p[2]}), 0);
        EXPECT_NEAR(distance(drawn.end(2 * i), middle), 1, tolerance);
        EXPECT_NEAR(drawn.length(i), 0.05, 1e-5);
        EXPECT_NEAR(distance(drawn.end(2 * i + 1), middle), 1.05, tolerance);
        different.insert(drawn.end(2 * i));
    }
    EXPECT_EQ(different.size(), drawn.point_count());
}

TEST(DebugDrawingApi, ManifoldsShowPointsWithTheirNormals) {
    const Host host;
    const FlgManifold ball = shape_manifold(host, FLG_MANIFOLD_SHAPE_SPHERE);
    expect_sphere(draw(host, flgDebugDrawManifold, ball), {}, 300, 1e-6);
    expect_ranges_add_up(host, flgDebugDrawManifold, ball, of_parts(FLG_DEBUG_PART_POINTS));

    FlgManifold image{};
    ASSERT_EQ(flgManifoldCreateImage(host.context, ball, 0.5, &image), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(draw(host, flgDebugDrawManifold, image).bits(), draw(host, flgDebugDrawManifold, ball).bits());

    const Drawn plane = draw(host, flgDebugDrawManifold, shape_manifold(host, FLG_MANIFOLD_SHAPE_PLANE));
    EXPECT_EQ(plane.point_count(), 256u);
    for (const FlgDebugVertex& v : plane.points) EXPECT_EQ(v.position[2], 0);

    std::vector<float> values;
    FlgManifoldFromGridDesc grid = flgManifoldFromGridDefaults();
    std::fill_n(grid.counts, 3, 25u);
    std::fill_n(grid.corner, 3, 3.5);
    grid.spacing = 0.125;
    for (int i = 0; i < 25 * 25 * 25; ++i) {
        const Point at{i % 25 - 12.0, i / 25 % 25 - 12.0, i / 625 - 12.0};
        values.push_back(static_cast<float>(0.125 * distance(at, {}) - 1));
    }
    grid.values = values.data();
    FlgManifold level{}, scan{};
    ASSERT_EQ(flgManifoldCreateFromGrid(host.context, &grid, &level, nullptr), FLG_OK) << flgErrorGetMessage();

    FlgManifoldFromPointsDesc cloud = flgManifoldFromPointsDefaults();
    std::vector<float> places;
    for (int i = 0; i < 2000; ++i) {
        const double z = (i + 0.5) / 1000 - 1, turn = 2.4 * i, across = std::sqrt(1 - z * z);
        for (const double p : {across * std::cos(turn), across * std::sin(turn), z})
            places.push_back(static_cast<float>(p));
    }
    cloud.points = places.data();
    cloud.point_count = 2000;
    ASSERT_EQ(flgManifoldCreateFromPoints(host.context, &cloud, &scan, nullptr), FLG_OK) << flgErrorGetMessage();
    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    EXPECT_EQ(flgDebugDrawManifold(host.context, scan, &desc, &drawing), FLG_NOT_READY);
    host.finish();
    expect_sphere(draw(host, flgDebugDrawManifold, level), {5, 5, 5}, 100, 2e-3);
    expect_sphere(draw(host, flgDebugDrawManifold, scan), {}, 1800, 2e-3);

    FlgDebugDrawDesc some = of_parts(FLG_DEBUG_PART_LINES);
    some.every = 10;
    EXPECT_NEAR(draw(host, flgDebugDrawManifold, scan, some).line_count(), 200, 20);
    const int64_t calls = host.allocator.calls;
    draw(host, flgDebugDrawManifold, ball);
    draw(host, flgDebugDrawManifold, scan);
    EXPECT_EQ(host.allocator.calls, calls);
}

TEST(DebugDrawingApi, OfSpaceAndTheHostsFunctionsThereIsNothingToDraw) {
    const Host host;
    EXPECT_EQ(draw(host, flgDebugDrawManifold, shape_manifold(host, FLG_MANIFOLD_SHAPE_SPACE)).bits(), "");
    FlgManifoldFunctions functions = flgManifoldFunctionsDefaults();
    functions.project = [](void*, double* point, double*) {
        point[2] = 0;
        return int32_t{1};
    };
    functions.tangent_basis = [](void*, const double*, double*, double* basis) {
        std::fill_n(basis, 6, 0.0);
        basis[0] = basis[4] = 1;
    };
    const double near[] = {0, 0, 0};
    FlgManifold flat{};
    ASSERT_EQ(flgManifoldCreateHost(host.context, &functions, near, &flat), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(draw(host, flgDebugDrawManifold, flat).bits(), "");
}

TEST(DebugDrawingApi, ALiveStrokeIsDrawnAsItsPoints) {
    LiveHost host;
    const FlgLiveStroke stroke = host.begin();
    EXPECT_EQ(draw(host, flgDebugDrawLiveStroke, stroke).bits(), "");
    const Samples samples = drawn(200);
    host.push(stroke, samples.data(), samples.size());
    const uint32_t all = FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS | FLG_DEBUG_PART_FRAMES | FLG_DEBUG_PART_SEAMS;
    for (const uint32_t parts : {0u, all}) {
        const FlgCurveSetView view = host.points(stroke);
        FlgCurveSet same{};
        ASSERT_EQ(flgCurveSetCreate(host.context, &view, &same), FLG_OK) << flgErrorGetMessage();
        const int64_t calls = host.allocator.calls;
        const Drawn live = draw(host, flgDebugDrawLiveStroke, stroke, of_parts(parts));
        EXPECT_EQ(host.allocator.calls, calls);
        EXPECT_EQ(live.line_count(white), host.info(stroke).point_count - 1);
        EXPECT_EQ(live.bits(), draw(host, flgDebugDrawCurveSet, same, of_parts(parts)).bits());
    }
    host.end(stroke);
    EXPECT_EQ(draw(host, flgDebugDrawLiveStroke, stroke).line_count(white), host.info(stroke).point_count - 1);
    host.finish();
    EXPECT_EQ(draw(host, flgDebugDrawLiveStroke, stroke).line_count(white), host.info(stroke).point_count - 1);
    ASSERT_EQ(flgLiveStrokeRelease(host.context, stroke), FLG_OK);
    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    expect_failure(flgDebugDrawLiveStroke(host.context, stroke, &desc, &drawing), FLG_ERROR_INVALID_HANDLE, "stroke");
}

TEST(DebugDrawingApi, AnOriginShiftsNoBit) {
    const Host host;
    Curves curves = arcs(2);
    FlgCurveSetView view = curves.view();
    FlgCurveSet here{}, far{};
    ASSERT_EQ(flgCurveSetCreate(host.context, &view, &here), FLG_OK);
    const double origin[3] = {1e7, -3e8, 1e9};
    FlgDebugDrawDesc desc = of_parts(FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS);
    const std::string bits = draw(host, flgDebugDrawCurveSet, here, desc).bits();
    std::copy_n(origin, 3, view.origin);
    std::copy_n(origin, 3, desc.origin);
    ASSERT_EQ(flgCurveSetCreate(host.context, &view, &far), FLG_OK);
    EXPECT_EQ(draw(host, flgDebugDrawCurveSet, far, desc).bits(), bits);
    const Drawn from_far = draw(host, flgDebugDrawCurveSet, here, desc);
    EXPECT_EQ(from_far.points[0].position[0], -1e7f);
}

TEST(DebugDrawingApi, NothingIsAllocated) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(sphere(8));
    const int64_t calls = host.allocator.calls;
    draw(host, flgDebugDrawSurface, surface, of_parts(FLG_DEBUG_PART_EDGES));
    EXPECT_EQ(host.allocator.calls, calls);
}

TEST(DebugDrawingApi, RefusesWhatIsWrong) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(1));
    const auto refuse = [&](const std::function<void(FlgDebugDrawDesc&)>& change, const char* words) {
        FlgDebugDrawDesc desc = flgDebugDrawDefaults();
        change(desc);
        FlgDebugDrawing drawing = flgDebugDrawingDefaults();
        drawing.line_count = drawing.point_count = 7;
        expect_failure(flgDebugDrawCurveSet(host.context, set, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(drawing.line_count, 0u) << words;
        EXPECT_EQ(drawing.point_count, 0u) << words;
    };
    refuse([](auto& d) { d.struct_size = 3; }, "desc: struct_size is 3");
    refuse([](auto& d) { d.reserved = 1; }, "desc.reserved is 1");
    refuse([](auto& d) { d.parts = 1024; }, "desc.parts is 1024");
    refuse([](auto& d) { d.every = 0; }, "desc.every is 0");
    refuse([](auto& d) { d.size = 0; }, "desc.size is 0");
    refuse([](auto& d) { d.size = HUGE_VALF; }, "desc.size is inf");
    refuse([](auto& d) { d.origin[1] = HUGE_VAL; }, "desc.origin[1] is inf");

    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    expect_failure(flgDebugDrawCurveSet(host.context, set, nullptr, &drawing), FLG_ERROR_INVALID_ARGUMENT,
                   "desc is null");
    expect_failure(flgDebugDrawCurveSet(host.context, set, &desc, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "drawing is null");
    expect_failure(flgDebugDrawCurveSet({}, set, &desc, &drawing), FLG_ERROR_INVALID_HANDLE, "context is null");
    expect_failure(flgDebugDrawCurveSet(host.context, {12345}, &desc, &drawing), FLG_ERROR_INVALID_HANDLE,
                   "set (0x3039)");
    drawing.reserved = 1;
    expect_failure(flgDebugDrawCurveSet(host.context, set, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT,
                   "drawing.reserved is 1");
}

TEST(DebugDrawingApi, WhatIsNotThereIsNotDrawn) {
    const Host host;
    Curves point;
    point.add_point(0, 0, 0);
    point.end_curve();
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = host.create(point);
    FlgStyle style{};
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.curves = host.create(arcs(1));
    resample.spacing = 1;
    FlgCurveSet set{};
    FlgJob job{}, failing{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, &failing), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgCurveSetResample(host.context, &resample, &set, &job), FLG_OK) << flgErrorGetMessage();
    const FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    FlgDebugDrawing drawing = flgDebugDrawingDefaults();
    drawing.line_count = 7;
    EXPECT_EQ(flgDebugDrawCurveSet(host.context, set, &desc, &drawing), FLG_NOT_READY);
    EXPECT_EQ(drawing.line_count, 0u);
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    EXPECT_EQ(flgDebugDrawCurveSet(host.context, set, &desc, &drawing), FLG_ERROR_CANCELLED);
    EXPECT_EQ(drawing.line_count, 0u);
    expect_failure(flgDebugDrawStyle(host.context, style, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT,
                   host.status_of(failing).error);
}

TEST(DebugDrawing, ArraysAreApartAndAligned) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(1, 4));
    FlgDebugDrawDesc desc = flgDebugDrawDefaults();
    desc.parts = FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS;
    std::vector<FlgDebugVertex> memory(32);
    std::memset(static_cast<void*>(memory.data()), 0xcd, memory.size() * sizeof(FlgDebugVertex));
    const std::vector<FlgDebugVertex> before = memory;
    const auto refused = [&](FlgDebugVertex* lines, FlgDebugVertex* points, const char* words) {
        FlgDebugDrawing drawing = flgDebugDrawingDefaults();
        drawing.lines = lines;
        drawing.points = points;
        drawing.line_capacity = drawing.point_capacity = 8;
        expect_failure(flgDebugDrawCurveSet(host.context, set, &desc, &drawing), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(std::memcmp(memory.data(), before.data(), memory.size() * sizeof(FlgDebugVertex)), 0);
    };
    refused(memory.data(), memory.data(), "drawing.points overlaps drawing.lines");
    refused(memory.data() + 1, memory.data(), "overlap");
    const auto aside = [&](size_t bytes) {
        return reinterpret_cast<FlgDebugVertex*>(reinterpret_cast<char*>(memory.data()) + bytes);
    };
    refused(aside(1), nullptr, "drawing.lines is ");
    refused(memory.data(), aside(20 * sizeof(FlgDebugVertex) + 2), "drawing.points is ");
}

}  // namespace
}  // namespace flg::test
