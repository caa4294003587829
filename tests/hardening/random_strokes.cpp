// SPDX-License-Identifier: MIT
// Curves, styles, strokes, splines, motions: any time, with anything.
#include "api/live_inputs.h"
#include "hardening/manifold_inputs.h"
#include "hardening/random_host.h"

namespace flg::test {

void RandomHost::make_curves() {
    Curves curves = chance(2) ? coil(40 + draw(60), 3, 2) : arcs(1 + draw(3), 8 + draw(20), 4);
    if (chance(8)) curves.positions[draw(static_cast<uint32_t>(curves.positions.size()))] = number(-1, 1);
    if (chance(8)) curves.flags[0] = FLG_CURVE_CLOSED;
    if (chance(30)) curves.offsets.back() = draw(5);
    FlgCurveSetView view = curves.view();
    odd(view);
    if (chance(30)) view.column_count = draw(view.column_count + 1);
    if (chance(60)) view.curve_offsets = nullptr;
    returned(flgCurveSetCreate(at(), maybe(&view), out<FlgCurveSet>(curve_set)));
}

void RandomHost::resample() {
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = any<FlgCurveSet>(curve_set);
    desc.spacing = number(0.02, 1);
    desc.frame = choice<FlgFrameMethod>(3);
    odd(desc);
    returned(flgCurveSetResample(at(), maybe(&desc), out<FlgCurveSet>(curve_set), job_out()));
}

void RandomHost::simplify() {
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    const float tolerances[] = {number(0, 0.1), number(0, 1), number(-1, 1)};
    desc.curves = any<FlgCurveSet>(curve_set);
    desc.level_count = 1 + draw(chance(8) ? 3 : 2);
    desc.tolerances = maybe(tolerances);
    desc.ribbons = draw(2);
    odd(desc);
    if (desc.level_count > 3) return;  // the array has no more
    returned(flgCurveSetSimplify(at(), maybe(&desc), out<FlgCurveSet>(curve_set), job_out()));
}

void RandomHost::make_style() {
    FlgStyleDesc desc = flgStyleDefaults();
    const FlgStyleAttribute attribute = {choice<FlgAttribute>(14), choice<FlgMetric>(4), number(0, 1), 0};
    desc.style = any<FlgCurveSet>(curve_set);
    if (chance(6)) desc.guide = any<FlgCurveSet>(curve_set);
    desc.point_count = 48 + draw(40);
    desc.patch = chance(20) ? draw(2000) : 2 + draw(6);
    desc.alpha = number(0, 1);
    if (chance(4)) {
        desc.attributes = maybe(&attribute);
        desc.attribute_count = 1;
    }
    if (chance(3)) desc.start_cap = number(-0.2, 1);
    if (chance(3)) desc.end_cap = number(-0.2, 1);
    odd(desc);
    returned(flgStyleCreate(at(), maybe(&desc), out<FlgStyle>(style), job_out()));
    if (chance(2)) returned(flgStyleWarm(at(), any<FlgStyle>(style), number(0, 2), nullptr, job_out()));
}

// Bytes of a style, sound or damaged.
void RandomHost::keep_style() {
    const FlgStyle kept = any<FlgStyle>(style);
    size_t size = 0;
    const FlgResult result = flgStyleGetData(context, kept, nullptr, 0, &size);
    returned(result);
    if (result != FLG_OK) return;
    std::string data(size, '\0');
    returned(flgStyleGetData(context, kept, data.data(), size, &size));
    if (chance(2)) data[draw(static_cast<uint32_t>(size))] ^= static_cast<char>(1 + draw(255));
    if (chance(4)) size = draw(static_cast<uint32_t>(size));
    returned(flgStyleCreateFromData(context, data.data(), size, out<FlgStyle>(style)));
    if (chance(3)) returned(flgStyleGetGuide(context, kept, out<FlgCurveSet>(curve_set)));
}

void RandomHost::stylize() {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = any<FlgStyle>(style);
    desc.target = any<FlgCurveSet>(curve_set);
    desc.magnitude = number(-1, 1);
    desc.temperature = number(0, 3);
    desc.scale = number(0.3, 2);
    if (chance(5)) desc.scale = 0;
    desc.frame = choice<FlgFrameMethod>(3);
    desc.start = choice<FlgStyleStart>(3);
    desc.strokes = chance(10) ? draw(2000) : 1 + draw(2);
    desc.pin_ends = chance(3);
    desc.max_points = 5000;
    if (chance(3)) desc.fit = number(0, 1);
    desc.corners = choice<FlgStyleCorners>(3);
    if (chance(3)) desc.corner_angle = number(0.1f, 3);
    desc.corner_caps = desc.corners == FLG_STYLE_CORNERS_MOTIFS && chance(3);
    desc.smooth_junctions = chance(3);
    const FlgStyleDrive drive = {
        choice<FlgAttribute>(14), choice<FlgStyleDriven>(5), number(-1, 1), number(-1, 1), number(0, 2), number(0, 2)};
    if (chance(3)) {
        desc.drives = maybe(&drive);
        desc.drive_count = 1;
    }
    const auto further = any<FlgStyle>(style);
    if (chance(3)) {
        desc.further_styles = maybe(&further);
        desc.further_style_count = 1;
        desc.style_blend = number(0, 2);
    }
    odd(desc);
    returned(flgCurveSetStylize(at(), maybe(&desc), out<FlgCurveSet>(curve_set), job_out()));
}

void RandomHost::draw_live() {
    if (chance(3)) {
        FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
        desc.style = any<FlgStyle>(style);
        desc.scale = number(0.2, 1);
        desc.max_samples = 8 + draw(60);
        desc.max_points = 64 + draw(400);
        desc.smoothing = chance(4) ? number(0, 0.1) : 0;
        desc.end_cap = chance(3);
        const FlgStyleDrive drive = {
            choice<FlgAttribute>(14), choice<FlgStyleDriven>(5), 0, 1, number(0, 2), number(0, 2)};
        const auto further = any<FlgStyle>(style);
        if (chance(3)) {
            desc.drives = maybe(&drive);
            desc.drive_count = 1;
            desc.further_styles = maybe(&further);
            desc.further_style_count = draw(2);
            desc.style_blend = number(0, 2);
        }
        odd(desc);
        returned(flgLiveStrokeBegin(at(), maybe(&desc), out<FlgLiveStroke>(live_stroke)));
        if (chance(8)) {
            returned(flgLiveStrokeReplay(at(), maybe(&desc), any<FlgCurveSet>(curve_set), nullptr,
                                         out<FlgCurveSet>(curve_set), job_out()));
        }
    }
    const FlgLiveStroke stroke = any<FlgLiveStroke>(live_stroke);
    Samples samples = drawn(2 + draw(8));
    LiveSample& sample = samples[draw(static_cast<uint32_t>(samples.size()))];
    if (chance(10)) sample.position[0] = number(-2, 2);
    if (chance(10)) sample.time = number<double>(0, 2000);
    if (chance(10)) sample.pressure = number(-1, 2);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    odd(view);
    FlgLiveSampleView pushed = view_of(samples.data(), samples.size());
    if (chance(10)) pushed.stride = draw(64);
    if (chance(10)) pushed.times = nullptr;
    odd(pushed);
    // A stride of the host's own that leads out of its arrays is beyond what can be seen.
    if (pushed.stride > sizeof(LiveSample)) pushed.stride = sizeof(LiveSample);
    returned(flgLiveStrokePush(at(), stroke, maybe(&pushed), maybe(&view)));
    FlgLiveStrokeInfo info{};
    info.struct_size = sizeof info;
    returned(flgLiveStrokeGetInfo(at(), stroke, maybe(&info)));
    if (chance(3)) returned(flgLiveStrokeUndo(at(), stroke, draw(6), nullptr));
    if (chance(3)) returned(flgLiveStrokeGetPoints(at(), stroke, maybe(&view)));
    if (chance(3)) returned(flgLiveStrokeGetTip(at(), stroke, maybe(&view)));
}

void RandomHost::end_live() {
    const FlgLiveStroke stroke = any<FlgLiveStroke>(live_stroke);
    switch (draw(3)) {
        case 0:
            returned(flgLiveStrokeEnd(at(), stroke, nullptr, out<FlgCurveSet>(curve_set), out<FlgCurveSet>(curve_set),
                                      job_out()));
            break;
        case 1: returned(flgLiveStrokeResume(at(), stroke)); break;
        default:
            returned(flgLiveStrokeSplit(at(), stroke, draw(60), nullptr, out<FlgCurveSet>(curve_set),
                                        out<FlgCurveSet>(curve_set), job_out()));
    }
}

void RandomHost::make_manifold() {
    switch (draw(5)) {
        case 0: {
            FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
            desc.surface = any<FlgSurface>(surface);
            odd(desc);
            returned(flgManifoldCreateFromSurface(at(), maybe(&desc), out<FlgManifold>(manifold), job_out()));
            break;
        }
        case 1: {
            std::vector<float> points = points_on_sphere(40);
            if (chance(4)) points[draw(120)] = number(-1, 1);
            FlgManifoldFromPointsDesc desc = flgManifoldFromPointsDefaults();
            desc.points = maybe(points.data());
            desc.point_count = chance(8) ? draw(8) : 40;
            desc.neighbours = chance(8) ? draw(50) : 12;
            odd(desc);
            returned(flgManifoldCreateFromPoints(at(), maybe(&desc), out<FlgManifold>(manifold), job_out()));
            break;
        }
        case 2:
            returned(flgManifoldCreateImage(at(), any<FlgManifold>(manifold), number<double>(0.1, 1),
                                            out<FlgManifold>(manifold)));
            break;
        default: {
            FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
            desc.shape = choice<FlgManifoldShape>(5);
            desc.radius = number<double>(0.5, 2);
            desc.name = chance(3) ? "no such formula" : flgFormulaGetName(draw(3));
            odd(desc);
            returned(flgManifoldCreateShape(at(), maybe(&desc), out<FlgManifold>(manifold)));
        }
    }
    double points[6] = {number<double>(-1, 1), 0.2, 0.3, 0.1, number<double>(-1, 1), 0.4};
    returned(flgManifoldProject(at(), any<FlgManifold>(manifold), maybe(points), draw(3), nullptr));
}

void RandomHost::fit_spline() {
    std::vector<double> points;
    const uint32_t count = 1 + draw(6);
    for (uint32_t i = 0; i < 6 * count; ++i) points.push_back(number<double>(-1, 1));
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = any<FlgManifold>(manifold);
    desc.points = maybe(points.data());
    desc.point_count = count;
    desc.closed = chance(3);
    desc.energy = choice<FlgSplineEnergy>(3);
    desc.start = choice<FlgSplineStart>(2);
    desc.node_count = chance(10) ? draw(1000) : 0;
    desc.max_rounds = 1 + draw(8);
    desc.smoothing = chance(4) ? number<double>(0, 1) : 0;
    if (chance(3)) desc.warm_start = any<FlgSpline>(spline);
    if (chance(5)) desc.obstacles = any<FlgObstacles>(obstacles);
    odd(desc);
    returned(flgSplineCreate(at(), maybe(&desc), out<FlgSpline>(spline), job_out()));
    FlgSplineSampleDesc curves = flgSplineSampleDefaults();
    curves.spline = any<FlgSpline>(spline);
    curves.height = number(-1, 1);
    if (chance(3)) returned(flgSplineSample(at(), &curves, out<FlgCurveSet>(curve_set), job_out()));
    FlgSplineOffsetDesc beside = flgSplineOffsetDefaults();
    beside.spline = any<FlgSpline>(spline);
    beside.left = number<double>(-1, 1);
    beside.above = chance(2) ? number<double>(-1, 1) : 0;
    beside.up[2] = chance(2) ? 1 : 0;
    if (chance(3)) returned(flgSplineOffset(at(), &beside, out<FlgCurveSet>(curve_set), job_out()));
}

void RandomHost::make_obstacles() {
    FlgObstacle solids[2] = {flgObstacleDefaults(), flgObstacleDefaults()};
    const double triangle[6] = {0, 0, number<double>(0, 1), 0, 0, number<double>(0, 1)};
    for (FlgObstacle& solid : solids) {
        solid.kind = choice<FlgObstacleKind>(8);
        solid.radius = number<double>(0.05, 0.5);
        solid.centre[0] = number<double>(2, 4);
        solid.cells = 8 + draw(4);
        solid.points = maybe(triangle);
        solid.point_count = 3;
        if (solid.kind >= FLG_OBSTACLE_KIND_MESH) solid.surface = any<FlgSurface>(surface);
    }
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.dimension = 2 + draw(3);
    desc.obstacles = maybe(solids);
    desc.obstacle_count = draw(3);
    desc.clearance = number<double>(0, 0.1);
    odd(desc);
    returned(flgObstaclesCreate(at(), maybe(&desc), out<FlgObstacles>(obstacles), job_out()));
}

void RandomHost::move_body() {
    const double times[] = {0, number<double>(0.5, 1), 2};
    const double poses[] = {1,  0,
                            0,  0,
                            0,  1,
                            0,  0,
                            0,  0,
                            1,  number<double>(-1, 1),  //
                            1,  0,
                            0,  1,
                            0,  0,
                            -1, 0,
                            0,  1,
                            0,  0,  //
                            0,  0,
                            1,  1,
                            1,  0,
                            0,  2,
                            0,  number<double>(1, 1),
                            0,  0};
    FlgMotionDesc desc = flgMotionDefaults();
    desc.key_count = chance(8) ? draw(4) : 3;
    desc.times = maybe(times);
    desc.poses = maybe(poses);
    desc.closed = chance(3);
    desc.position_count = chance(5) ? draw(40) : 20;
    desc.max_rounds = 1 + draw(8);
    desc.smoothing = chance(4) ? number<double>(0, 1) : 0;
    odd(desc);
    returned(flgMotionCreate(at(), maybe(&desc), out<FlgMotion>(motion), job_out()));
}

}  // namespace flg::test
