// SPDX-License-Identifier: MIT
// filigree.hpp in C++17, against the shared library.
#include <cmath>
#include <cstdio>
#include <vector>

#include "filigree/filigree.hpp"

namespace {

// A square of two triangles, measured from a corner and cut in the middle.
bool surfaces_work(filigree::Context& context) {
    const float corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const uint32_t triangles[] = {0, 1, 2, 0, 2, 3}, source = 0;
    const FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, corners, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh.vertex_count = 4;
    desc.mesh.columns = &column;
    desc.mesh.column_count = 1;
    desc.mesh.triangles = triangles;
    desc.mesh.triangle_count = 2;
    const filigree::Surface surface = context.surface(desc);
    FlgGeodesicDesc geodesic = flgGeodesicDefaults();
    geodesic.surface = surface.get();
    geodesic.vertices = &source;
    geodesic.vertex_count = 1;
    const filigree::Field field = context.geodesic(geodesic);
    FlgIsolinesDesc isolines = flgIsolinesDefaults();
    isolines.field = field.get();
    isolines.levels = {nullptr, 1, 0.5f, 1};
    const filigree::SurfaceCurves lines = context.isolines(isolines);
    FlgLiftDesc lift = flgLiftDefaults();
    lift.curves = lines.get();
    const filigree::CurveSet lifted = context.lift(lift);
    FlgCutIsolinesDesc cut = flgCutIsolinesDefaults();
    cut.field = field.get();
    cut.levels = isolines.levels;
    const filigree::Field after = context.cut(cut);
    if (surface.ready() || field.ready()) return false;
    context.finish();
    return surface.view().revision == 1 && !surface.changes(0).empty() && surface.report().border_count == 1 &&
           field.view().values[1] == 1 && lines.view().curve_count == 1 && lifted.ready() &&
           after.view().vertex_count > 4;
}

bool straight_skeletons_work(filigree::Context& context) {
    const double corners[] = {0, 0, 5, 0, 5, 2, 0, 2};
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour.points = corners;
    desc.contour.point_count = 4;
    filigree::Job job;
    const filigree::StraightSkeleton skeleton = context.straight_skeleton(desc, &job);
    if (skeleton.ready() || !skeleton.offset(0.5).offsets.empty()) return false;
    context.finish();
    const filigree::StraightSkeleton::Rings rings = skeleton.offset(0.5);
    return job.finished() && skeleton.view().node_count == 6 && rings.points.size() == 8 && rings.edges.size() == 4 &&
           rings.offsets.size() == 2 && rings.offsets[1] == 4 && skeleton.offset(2).points.empty();
}

// A bar, as a part, its body, its bones and its skin.
bool models_work(filigree::Context& context) {
    const double corners[] = {0, 0, 5, 0, 5, 1, 0, 1};
    FlgPartDesc part_desc = flgPartDefaults();
    part_desc.contour.points = corners;
    part_desc.contour.point_count = 4;
    const filigree::Part part = context.part(part_desc);
    FlgPartMeshDesc body_desc = flgPartMeshDefaults();
    body_desc.part = part.get();
    const filigree::PartMesh body = context.part_mesh(body_desc);
    FlgModelPart model_part = flgModelPartDefaults();
    model_part.part = part.get();
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = &model_part;
    model_desc.part_count = 1;
    const filigree::Model model = context.model(model_desc);
    FlgSkinDesc skin_desc = flgSkinDefaults();
    skin_desc.model = model.get();
    skin_desc.vertex_count = 500;
    const filigree::Skin skin = context.skin(skin_desc);
    if (part.ready() || skin.ready() || skin.view().vertex_count != 0) return false;
    context.finish();
    const FlgSkinView view = skin.view();
    return body.ready() && part.view().node_count >= 2 && view.joint_count == model.view().joint_count &&
           view.joint_count >= 2 && view.vertex_count > 300;
}

}  // namespace

int main() {
    try {
        filigree::Context context;
        std::vector<float> positions;
        for (int i = 0; i < 300; ++i) {
            const float u = 0.01f * static_cast<float>(i);
            for (float v : {u, 0.2f * std::cos(20 * u), 0.2f * std::sin(20 * u)}) positions.push_back(v);
        }
        const uint32_t offsets[] = {0, 300};
        const FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        FlgCurveSetView view = flgCurveSetViewDefaults();
        view.curve_count = 1;
        view.curve_offsets = offsets;
        view.columns = &column;
        view.column_count = 1;
        const filigree::CurveSet example = context.curves(view);
        const filigree::Style style = context.style(example);
        FlgStylizeDesc desc = flgStylizeDefaults();
        desc.style = style.get();
        desc.target = example.get();
        filigree::Job job;
        const filigree::CurveSet result = context.stylize(desc, &job);
        if (result.ready() || style.ready()) return 1;
        context.finish();
        if (!job.finished() || job.stages().size() != 2 || !style.guide().ready()) return 1;
        std::printf("%u points\n", result.view().curve_offsets[1]);
        if (!surfaces_work(context) || !straight_skeletons_work(context) || !models_work(context)) return 1;
        FlgLiveStrokeDesc live = flgLiveStrokeDefaults();
        live.style = style.get();
        if (context.begin(live)) return 1;  // not warm
        const filigree::Job warming = context.warm(style);
        context.finish();
        filigree::LiveStroke stroke = context.begin(live);
        std::vector<FlgLiveSample> samples;
        for (int i = 0; i < 100; ++i)
            samples.push_back({{0.01f * static_cast<float>(i), 0, 0}, {0, 0, 0, 1}, 0.5f, i / 90.0});
        if (stroke.push(samples.data(), 100).curve_count != 1 || stroke.undo(50) == 0) return 1;
        const filigree::LiveStroke::Ended ended = stroke.end();
        context.finish();
        if (!ended.stylized.ready() || ended.samples.view().curve_offsets[1] != 50 || !stroke.resume()) return 1;
        desc.scale = -1;
        try {
            context.stylize(desc);
            return 1;
        } catch (const filigree::Error& error) {
            std::printf("%s: %s\n", flgResultName(error.result()), error.what());
        }
        return 0;
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
