// SPDX-License-Identifier: MIT
// filigree.hpp in C++17, against the shared library, with exceptions.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "filigree/filigree.hpp"

namespace {

// A square of two triangles, measured from a corner and cut in the middle.
bool surfaces_work(filigree::Context& context) {
    const float corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const uint32_t source = 0;
    const filigree::Surface surface = context.surface_from_triangles(corners, {0, 1, 2, 0, 2, 3});
    filigree::FieldGeodesicDesc geodesic(surface);
    geodesic.set_vertices({&source, 1});
    const filigree::Field field = context.field_geodesic(geodesic);
    const std::vector<filigree::SurfacePoint> ends = {{0, 0.25f, 0.25f}, {1, 0.25f, 0.5f}};
    const uint32_t offsets[] = {0, 2};
    filigree::FieldTracePathsDesc across(surface);
    across.points = ends.data();
    across.set_path_offsets(offsets);
    const filigree::SurfaceCurves lines = context.trace_paths(across);
    const filigree::CurveSet lifted = lines.lift();
    const filigree::Job cut = context.cut_curves({lines});
    if (surface.ready() || field.ready() || !field.view().values.empty()) return false;
    context.run();
    const filigree::SurfaceView view = surface.view();
    return view.revision == 1 && !surface.changes(0).empty() && surface.report().border_count == 1 &&
           field.view().values.size() == 4 && field.view().values[1] == 1 && lines.view().points.size() >= 2 &&
           lifted.ready() && cut.finished() && view.neighbours.size() == 3 * view.mesh.triangle_count &&
           view.mesh.column(FLG_ATTRIBUTE_POSITION)->components == 3;
}

bool straight_skeletons_work(filigree::Context& context) {
    const double corners[] = {0, 0, 5, 0, 5, 2, 0, 2};
    filigree::StraightSkeletonDesc desc;
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = corners;
    drawn.point_count = 4;
    desc.contour = &drawn;
    filigree::Job job;
    const filigree::StraightSkeleton skeleton = context.straight_skeleton(desc, &job);
    if (skeleton.ready() || !skeleton.offset(0.5).offsets.empty()) return false;
    context.run({job});
    const filigree::StraightSkeleton::Rings rings = skeleton.offset(0.5);
    const filigree::StraightSkeletonView view = skeleton.view();
    filigree::DebugDrawing drawing;
    if (!context.debug_draw_straight_skeleton(skeleton.get(), {}, drawing) || drawing.line_count != 9) return false;
    return job.finished() && view.node_count == 6 && view.nodes.size() == 18 && view.face_nodes.size() == 14 &&
           rings.points.size() == 8 && rings.edges.size() == 4 && rings.offsets.size() == 2 && rings.offsets[1] == 4 &&
           skeleton.offset(2).points.empty();
}

// A bar, as a part, its body, its bones and its skin, which bends.
bool models_work(filigree::Context& context) {
    const double corners[] = {0, 0, 5, 0, 5, 1, 0, 1};
    filigree::PartDesc part_desc;
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = corners;
    drawn.point_count = 4;
    part_desc.contour = &drawn;
    const filigree::Part part = context.part(part_desc);
    const filigree::PartMesh body = context.part_mesh({part});
    const std::vector<FlgModelPart> parts = {filigree::ModelPart(part)};
    filigree::ModelDesc model_desc;
    model_desc.set_parts(parts);
    const filigree::Model model = context.model(model_desc);
    filigree::SkinDesc skin_desc(model);
    skin_desc.vertex_count = 500;
    const filigree::Skin skin = context.skin(skin_desc);
    if (part.ready() || skin.ready() || !skin.view().positions.empty()) return false;
    context.run();
    const filigree::SkinView view = skin.view();
    std::vector<float> rotations(4 * std::size_t{view.joint_count}), matrices(12 * std::size_t{view.joint_count});
    for (uint32_t joint = 0; joint < view.joint_count; ++joint) rotations[4 * joint + 3] = 1;
    if (!view.pose(rotations.data(), nullptr, matrices.data(), nullptr) || matrices[0] != 1) return false;
    return body.ready() && part.view().nodes.size() >= 6 && view.joint_count == model.view().joint_names.size() &&
           view.joint_count >= 2 && view.vertex_weights.size() == 4 * view.vertex_count && view.vertex_count > 300;
}

// The count behind an animation is that of the joints.
bool animations_are_sampled() {
    const float times[] = {0, 1}, rotations[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0};
    filigree::SkinAnimation animation;
    animation.key_count = 2;
    animation.times = times;
    animation.rotations = rotations;
    float sampled[] = {9, 9, 9, 9, 9, 9, 9, 9};
    return filigree::skin_animation_sample(animation, 2, 1.0f, sampled, nullptr) && sampled[3] == 1 && sampled[6] == 1;
}

// A list that ends within a point is refused whole.
bool halves_of_points_are_refused(filigree::Context& context) {
    int refused = 0;
    try {
        context.curve_set_from_points({0, 0, 0, 1, 1});
    } catch (const filigree::Error& error) {
        refused += error.result() == FLG_ERROR_LIMIT;
    }
    try {
        context.surface_from_triangles({0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2});
    } catch (const filigree::Error& error) {
        refused += error.result() == FLG_ERROR_LIMIT;
    }
    return refused == 2;
}

// Assigning lets go of what was held, and a context can be destroyed before its end.
bool owners_let_go(filigree::Context& context) {
    filigree::CurveSet held = context.curve_set_from_points({0, 0, 0, 1, 1, 1});
    const FlgCurveSet before = held.get();
    filigree::CurveSet other = context.curve_set_from_points({0, 0, 0, 2, 1, 1});
    held = std::move(other);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    if (other || flgCurveSetGetView(context.get(), before, &view) != FLG_ERROR_INVALID_HANDLE) return false;
    filigree::Context second = filigree::Context::create();
    return second.destroy() && !second;
}

bool live_strokes_work(filigree::Context& context, const filigree::Style& style) {
    filigree::LiveStrokeDesc live(style);
    if (context.begin(live)) return false;  // not warm
    const filigree::Job warming = style.warm();
    context.run();
    filigree::LiveStroke stroke = context.begin(live);
    std::vector<float> places;
    for (int i = 0; i < 100; ++i) places.insert(places.end(), {0.01f * static_cast<float>(i), 0, 0});
    filigree::LiveSampleView samples;
    samples.sample_count = 100;
    samples.positions = places.data();
    if (stroke.push(samples).curve_count != 1 || stroke.undo(50) == 0) return false;
    const filigree::LiveStroke::EndResults ended = stroke.end();
    context.run();
    return warming.finished() && ended.stylized.ready() && ended.samples.view().curve_offsets[1] == 50 &&
           stroke.resume();
}

}  // namespace

int main() {
    try {
        filigree::Context context = filigree::Context::create();
        std::vector<float> wave;
        for (int i = 0; i < 300; ++i) {
            const float u = 0.01f * static_cast<float>(i);
            wave.insert(wave.end(), {u, 0.2f * std::cos(20 * u), 0.2f * std::sin(20 * u)});
        }
        const filigree::CurveSet example = context.curve_set_from_points(wave);
        const filigree::Style style = context.style({example});
        filigree::CurveSetStylizeDesc desc(style, example);
        filigree::Job job;
        const filigree::CurveSet result = context.stylize(desc, &job);
        if (result.ready() || style.ready() || !style.data().empty()) return 1;
        context.run();
        if (!job.finished() || job.stages().size() != 2 || !style.guide().ready()) return 1;
        const filigree::CurveSetView view = result.view();
        std::printf("%u points\n", view.curve_offsets[1]);
        if (view.curve_offsets.size() != 2 || view.columns.size() != view.column_count) return 1;
        if (context.curve_set(view).view().column(FLG_ATTRIBUTE_POSITION)->components != 3) return 1;
        const filigree::Style copy = context.style_from_data(style.data());
        if (copy.info().matching.size() != style.info().point_count || copy.data() != style.data()) return 1;
        if (!surfaces_work(context) || !straight_skeletons_work(context) || !models_work(context)) return 1;
        if (!live_strokes_work(context, style) || !animations_are_sampled()) return 1;
        if (!halves_of_points_are_refused(context) || !owners_let_go(context)) return 1;
        desc.scale = -1;
        try {
            const filigree::CurveSet refused = context.stylize(desc);
            return 1;
        } catch (const filigree::Error& error) {
            std::printf("%s: %s\n", filigree::result_name(error.result()), error.what());
            return std::strstr(error.what(), "scale") ? 0 : 1;
        }
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
