// SPDX-License-Identifier: MIT
// Surfaces, tangles, models: any time, with anything.
#include "hardening/random_host.h"

namespace flg::test {

void RandomHost::make_surface() {
    MeshArrays mesh = chance(2) ? plane(2 + draw(5)) : sphere(1 + draw(3));
    if (chance(6)) mesh.positions[draw(static_cast<uint32_t>(mesh.positions.size()))] = number(-1, 1);
    if (chance(6)) mesh.triangles[draw(static_cast<uint32_t>(mesh.triangles.size()))] = draw(30);
    if (chance(60)) mesh.triangles[0] = UINT32_MAX;
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgMeshView input = mesh.view();
    desc.mesh = maybe(&input);
    desc.weld_distance = chance(10) ? number(0, 0.1) : 0;
    desc.provenance = draw(2);
    odd(input);
    odd(desc);
    returned(flgSurfaceCreate(at(), maybe(&desc), out<FlgSurface>(surface), job_out()));
}

// Into a finer one, if it is small.
void RandomHost::change_surface() {
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = any<FlgSurface>(surface);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    const FlgResult shown = flgSurfaceGetView(context, desc.surface, &view);
    returned(shown);
    if (shown == FLG_OK && view.mesh->triangle_count > 300) return;
    desc.scheme = choice<FlgSubdivision>(2);
    desc.levels = chance(20) ? 9 + draw(9) : 1;
    odd(desc);
    if (shown == FLG_OK) returned(flgSurfaceRefine(at(), maybe(&desc), out<FlgSurface>(surface), job_out()));
    FlgSurfaceProvenanceView lies = flgSurfaceProvenanceViewDefaults();
    returned(flgSurfaceGetProvenance(at(), desc.surface, maybe(&lies)));
    FlgSurfacePoint point{};
    returned(flgSurfaceProvenanceViewGetPoint(&lies, draw(40), draw(40), maybe(&point)));
    uint32_t count = 0, few[4];
    returned(flgSurfaceGetChanges(at(), desc.surface, draw(4), maybe(few), draw(5), maybe(&count)));
}

void RandomHost::measure() {
    const uint32_t vertices[] = {draw(60), draw(40)}, regions[] = {draw(4), draw(100)};
    const FlgSurfacePoint point = {draw(60), number(0, 0.5), number(0, 0.5)};
    switch (draw(6)) {
        case 0: {
            FlgFieldBlendDesc desc = flgFieldBlendDefaults();
            desc.from = any<FlgField>(field);
            desc.to = any<FlgField>(field);
            odd(desc);
            return returned(flgFieldBlend(at(), maybe(&desc), out<FlgField>(field), job_out()));
        }
        case 1: {
            FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
            desc.surface = any<FlgSurface>(surface);
            desc.radius = number(0.1, 1);
            desc.max_count = draw(20);
            odd(desc);
            return returned(flgSurfaceSample(at(), maybe(&desc), out<FlgField>(field), job_out()));
        }
        case 2: {
            const std::vector<float> values(49, number(0, 1));
            return returned(flgFieldCreate(at(), any<FlgSurface>(surface), maybe(values.data()), 25 + 24 * draw(2),
                                           out<FlgField>(field)));
        }
        default: {
            FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
            desc.surface = any<FlgSurface>(surface);
            desc.vertices = maybe(vertices);
            desc.vertex_count = draw(3);
            desc.points = maybe(&point);
            desc.point_count = chance(3);
            if (chance(4)) desc.curves = any<FlgSurfaceCurves>(surface_curves);
            desc.regions = desc.border_regions = maybe(regions);
            desc.region_count = chance(4) ? 2 : 0;
            desc.border_region_count = chance(4);
            desc.max_distance = chance(4) ? number(0.1, 1) : HUGE_VALF;
            desc.perturbation = chance(6) ? number(0, 0.1) : 0;
            desc.labels = chance(3);
            odd(desc);
            returned(flgFieldCreateGeodesic(at(), maybe(&desc), out<FlgField>(field), job_out()));
        }
    }
}

void RandomHost::trace() {
    const FlgSurfacePoint points[] = {{draw(60), number(0, 0.4), number(0, 0.4)}, {draw(60), 0.2f, 0.2f}};
    const uint32_t offsets[] = {0, 2};
    switch (draw(6)) {
        case 0: {
            FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
            desc.field = any<FlgField>(field);
            desc.level_every = number(0.05, 0.5);
            desc.level_count = draw(4);
            odd(desc);
            return returned(
                flgFieldTraceIsolines(at(), maybe(&desc), out<FlgSurfaceCurves>(surface_curves), job_out()));
        }
        case 1: {
            FlgFieldTraceStreamsDesc desc = flgFieldTraceStreamsDefaults();
            desc.field = any<FlgField>(field);
            desc.starts = maybe(points);
            desc.start_count = draw(3);
            desc.downhill = chance(2);
            if (chance(3)) desc.border_samples = any<FlgSurfaceCurves>(surface_curves);
            odd(desc);
            return returned(flgFieldTraceStreams(at(), maybe(&desc), out<FlgSurfaceCurves>(surface_curves), job_out()));
        }
        case 2: {
            FlgFieldTracePathsDesc desc = flgFieldTracePathsDefaults();
            desc.surface = any<FlgSurface>(surface);
            desc.points = maybe(points);
            desc.path_offsets = maybe(offsets);
            desc.path_count = chance(10) ? 0 : 1;
            desc.closed = chance(3);
            odd(desc);
            return returned(flgFieldTracePaths(at(), maybe(&desc), out<FlgSurfaceCurves>(surface_curves), job_out()));
        }
        case 3: {
            FlgSurfaceSampleBordersDesc desc = flgSurfaceSampleBordersDefaults();
            desc.surface = any<FlgSurface>(surface);
            desc.spacing = number(0.1, 1);
            desc.region = draw(4);
            odd(desc);
            return returned(
                flgSurfaceSampleBorders(at(), maybe(&desc), out<FlgSurfaceCurves>(surface_curves), job_out()));
        }
        case 4: {
            FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
            desc.surface = any<FlgSurface>(surface);
            desc.curves = any<FlgCurveSet>(curve_set);
            odd(desc);
            return returned(flgCurveSetProject(at(), maybe(&desc), out<FlgSurfaceCurves>(surface_curves), job_out()));
        }
        default: {
            FlgSurfaceCurvesLiftDesc desc = flgSurfaceCurvesLiftDefaults();
            desc.curves = any<FlgSurfaceCurves>(surface_curves);
            desc.height = number(-1, 1);
            odd(desc);
            returned(flgSurfaceCurvesLift(at(), maybe(&desc), out<FlgCurveSet>(curve_set), job_out()));
        }
    }
}

void RandomHost::cut() {
    if (chance(2)) {
        FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
        desc.field = any<FlgField>(field);
        desc.level_first = number(0, 0.5);
        desc.level_every = number(0.2, 0.6);
        desc.level_count = draw(4);
        desc.first_label = chance(2) ? draw(100) : FLG_NO_INDEX;
        odd(desc);
        returned(flgSurfaceCutIsolines(at(), maybe(&desc), out<FlgField>(field), job_out()));
    } else {
        FlgSurfaceCutCurvesDesc desc = flgSurfaceCutCurvesDefaults();
        desc.curves = any<FlgSurfaceCurves>(surface_curves);
        desc.first_label = chance(2) ? draw(100) : FLG_NO_INDEX;
        odd(desc);
        returned(flgSurfaceCutCurves(at(), maybe(&desc), job_out()));
    }
}

void RandomHost::divide_tangle() {
    if (chance(3))
        returned(flgTangleCreate(at(), any<FlgSurface>(surface), nullptr, out<FlgTangle>(tangle), job_out()));
    const uint32_t regions[] = {draw(4), draw(8)};
    const FlgSurfacePoint points[] = {{draw(60), number(0, 0.4), 0.3f}, {draw(60), 0.2f, 0.2f}};
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.tangle = any<FlgTangle>(tangle);
    desc.kind = choice<FlgTangleOperator>(4);
    desc.regions = maybe(regions);
    desc.region_count = draw(3);
    FlgTangleSeeds a = flgTangleSeedsDefaults(), b = flgTangleSeedsDefaults();
    a.borders = chance(2) ? FLG_TANGLE_BORDERS_OUTER : FLG_TANGLE_BORDERS_NONE;
    a.sample_radius = chance(2) ? number(0.2, 0.6) : 0;
    a.points = maybe(points);
    a.point_count = draw(3);
    b.sample_radius = chance(4) ? number(0.3, 0.6) : 0;
    odd(a);
    desc.a = maybe(&a);
    desc.b = chance(2) ? &b : nullptr;
    desc.delta = number(0.05, 0.4);
    desc.count = draw(3);
    desc.grouping = choice<FlgTangleGrouping>(4);
    desc.scaffold = chance(5);
    odd(desc);
    returned(flgTangleDivide(at(), maybe(&desc), job_out()));
}

void RandomHost::edit_tangle() {
    const uint32_t regions[] = {draw(6), draw(6)};
    const FlgTangle edited = any<FlgTangle>(tangle);
    switch (draw(8)) {
        case 0: return returned(flgTangleUndo(at(), edited, nullptr, job_out()));
        case 1: return returned(flgTangleRedo(at(), edited, nullptr, job_out()));
        case 2: return returned(flgTangleGroup(at(), edited, maybe(regions), draw(3), nullptr, job_out()));
        case 3: return returned(flgTangleUngroup(at(), edited, draw(5), nullptr, job_out()));
        case 4: return returned(flgTangleJoin(at(), edited, maybe(regions), draw(3), nullptr, job_out()));
        case 5:
            return returned(
                flgTangleTraceBorders(at(), edited, nullptr, out<FlgSurfaceCurves>(surface_curves), job_out()));
        case 6: {
            FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
            desc.tangle = edited;
            desc.regions = maybe(regions);
            desc.region_count = draw(3);
            desc.amount = number(-0.05, 0.05);
            desc.bias = number(0.2, 0.8);
            odd(desc);
            return returned(flgTangleDisplace(at(), maybe(&desc), job_out()));
        }
        default: {
            FlgTangleApplyMacroDesc desc = flgTangleApplyMacroDefaults();
            desc.tangle = edited;
            desc.kind = choice<FlgTangleMacro>(8);
            desc.regions = maybe(regions);
            desc.region_count = 1;
            desc.count = draw(3);
            desc.size = number(0.05, 0.2);
            desc.spacing = number(0.2, 0.5);
            odd(desc);
            returned(flgTangleApplyMacro(at(), maybe(&desc), job_out()));
        }
    }
}

void RandomHost::replay_tangle() {
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    const FlgResult result = flgTangleGetHistory(context, any<FlgTangle>(tangle), &history);
    returned(result);
    if (result != FLG_OK || history.step_count > 6) return;
    if (chance(4)) history.made_count = draw(4);
    if (chance(20)) history.steps = nullptr;
    returned(flgTangleReplay(at(), any<FlgTangle>(tangle), maybe(&history), nullptr, job_out()));
}

void RandomHost::sketch() {
    std::vector<double> points;
    const uint32_t count = chance(10) ? draw(4) : 8 + draw(20);
    for (uint32_t i = 0; i < count; ++i) {
        const double radius = chance(4) ? number<double>(0.2, 2) : 1;
        points.push_back(radius * std::cos(2 * M_PI * i / count));
        points.push_back(0.6 * radius * std::sin(2 * M_PI * i / count));
    }
    FlgContourView contour = flgContourViewDefaults();
    contour.points = maybe(points.data());
    contour.point_count = count;
    odd(contour);
    if (chance(2)) {
        FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
        desc.contour = maybe(&contour);
        desc.repair = chance(2);
        odd(desc);
        returned(flgStraightSkeletonCreate(at(), maybe(&desc), out<FlgStraightSkeleton>(skeleton), job_out()));
        FlgOffsetPolygons polygons = flgOffsetPolygonsDefaults();
        returned(flgStraightSkeletonOffset(at(), any<FlgStraightSkeleton>(skeleton), number<double>(0, 0.5),
                                           maybe(&polygons)));
    } else {
        FlgPartDesc desc = flgPartDefaults();
        desc.contour = maybe(&contour);
        desc.spacing = chance(8) ? number<double>(0, 0.1) : 0.03;
        desc.repair = chance(2);
        odd(desc);
        returned(flgPartCreate(at(), maybe(&desc), out<FlgPart>(part), job_out()));
    }
}

void RandomHost::make_model() {
    FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
    for (FlgModelPart& used : parts) {
        used.part = any<FlgPart>(part);
        used.placement[3] = number<double>(-1, 1);
        used.mirrored = chance(4);
        used.thickness = chance(8) ? number(0, 2) : 1;
    }
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = maybe(parts);
    desc.part_count = draw(3);
    odd(desc);
    returned(flgModelCreate(at(), maybe(&desc), out<FlgModel>(model), job_out()));
    FlgPartMeshDesc body = flgPartMeshDefaults();
    body.part = any<FlgPart>(part);
    body.spacing = chance(8) ? number<double>(0.3, 2) : 0.4;
    if (chance(3)) returned(flgPartMeshCreate(at(), &body, out<FlgPartMesh>(part_mesh), job_out()));
    FlgSkinDesc bound = flgSkinDefaults();
    bound.model = any<FlgModel>(model);
    bound.vertex_count = 100;
    bound.max_vertices = 2000;
    if (chance(6)) returned(flgSkinCreate(at(), &bound, out<FlgSkin>(skin), job_out()));
    FlgOutlineDesc seen = flgOutlineDefaults();
    seen.surface = any<FlgSurface>(surface);
    seen.direction[2] = number(0, 1);
    if (chance(3)) returned(flgOutlineCreate(at(), &seen, out<FlgOutline>(outline), job_out()));
}

// Views of whatever there is; all that they show can be read.
void RandomHost::look() {
    FlgCurveSetView curves = flgCurveSetViewDefaults();
    FlgResult result = flgCurveSetGetView(at(), any<FlgCurveSet>(curve_set), maybe(&curves));
    returned(result);
    EXPECT_TRUE(result != FLG_OK || curves.curve_count == 0 || !bits(curves).empty());
    FlgSurfaceView shape = flgSurfaceViewDefaults();
    result = flgSurfaceGetView(context, any<FlgSurface>(surface), &shape);
    returned(result);
    if (result == FLG_OK) expect_valid(shape);
    FlgFieldView values = flgFieldViewDefaults();
    returned(flgFieldGetView(at(), any<FlgField>(field), maybe(&values)));
    FlgSurfaceCurvesView lines = flgSurfaceCurvesViewDefaults();
    returned(flgSurfaceCurvesGetView(at(), any<FlgSurfaceCurves>(surface_curves), maybe(&lines)));
    FlgSplineView bent = flgSplineViewDefaults();
    returned(flgSplineGetView(at(), any<FlgSpline>(spline), maybe(&bent)));
    FlgMotionView moved = flgMotionViewDefaults();
    returned(flgMotionGetView(at(), any<FlgMotion>(motion), maybe(&moved)));
    FlgModelView bones = flgModelViewDefaults();
    returned(flgModelGetView(at(), any<FlgModel>(model), maybe(&bones)));
    FlgSkinView bound = flgSkinViewDefaults();
    returned(flgSkinGetView(at(), any<FlgSkin>(skin), maybe(&bound)));
    FlgTangleInfo info{};
    info.struct_size = sizeof info;
    returned(flgTangleGetInfo(at(), any<FlgTangle>(tangle), maybe(&info)));
    FlgTangleRegion region{};
    region.struct_size = sizeof region;
    returned(flgTangleGetRegion(at(), any<FlgTangle>(tangle), draw(20), maybe(&region)));
}

}  // namespace flg::test
