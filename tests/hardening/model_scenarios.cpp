// SPDX-License-Identifier: MIT
// Straight skeletons, models of parts with their skins, outlines, poses.
#include "filigree/filigree_model.h"
#include "filigree/filigree_pull.h"
#include "filigree/filigree_rig.h"
#include "hardening/host_buffers.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

std::vector<double> ellipse(double x, double y, double rx, double ry, uint32_t count = 24) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        points.push_back(x + rx * std::cos(2 * M_PI * i / count));
        points.push_back(y + ry * std::sin(2 * M_PI * i / count));
    }
    return points;
}

FlgContourView contour(Calls& calls, const std::vector<double>& points) {
    FlgContourView view = FLG_INIT(calls, flgContourViewInit);
    view.points = points.data();
    view.point_count = static_cast<uint32_t>(points.size() / 2);
    return view;
}

FlgPart make_part(Calls& calls, const std::vector<double>& points) {
    FlgPartDesc desc = FLG_INIT(calls, flgPartDescInit);
    const FlgContourView drawn = contour(calls, points);
    desc.contour = &drawn;
    desc.spacing = 0.03;
    FlgPart part{};
    FLG_CALL(calls, flgPartCreate, calls.context, &desc, calls.out(part), calls.job());
    return part;
}

// A body and an arm that is there twice.
FlgModel make_model(Calls& calls) {
    FlgModelPart parts[2];
    for (FlgModelPart& part : parts) part = FLG_INIT(calls, flgModelPartInit);
    parts[0].part = make_part(calls, ellipse(0, 0, 1, 2));
    parts[0].name = "body";
    parts[1].part = make_part(calls, ellipse(1.6, 0.8, 1.2, 0.35));
    parts[1].mirrored = 1;
    FlgModelDesc desc = FLG_INIT(calls, flgModelDescInit);
    desc.parts = parts;
    desc.part_count = 2;
    desc.root = 0;
    FlgModel model{};
    FLG_CALL(calls, flgModelCreate, calls.context, &desc, calls.out(model), calls.job());
    // Again, with what was set about joints.
    FlgJointEdit edits[2];
    for (FlgJointEdit& edit : edits) edit = FLG_INIT(calls, flgJointEditInit);
    edits[0].joint = "body_0";
    edits[1].joint = "part1_0";
    edits[1].kind = FLG_JOINT_EDIT_KIND_RENAME;
    edits[1].name = "shoulder";
    parts[1].parent = 0;
    desc.joint_edits = edits;
    desc.joint_edit_count = 2;
    desc.previous = model;
    const uint32_t apart[] = {1, 1};
    parts[1].depth = 1;
    desc.apart_pairs = apart;
    desc.apart_pair_count = 1;
    FLG_CALL(calls, flgModelCreate, calls.context, &desc, calls.out(model), calls.job());
    FLG_CALL(calls, flgModelRelease, calls.context, desc.previous);
    // Once more, with what a file kept.
    const char* const keys[] = {"body_0", "part1_0.L", "body_at_part1"};
    const double places[] = {0, 0, 0, 1.6, 0.8, 0, 0, 1, 0};
    const uint32_t parents[] = {FLG_NO_INDEX, 0, 1};
    FlgModelView kept = FLG_INIT(calls, flgModelViewInit);
    kept.joint_count = 3;
    kept.joint_keys = keys;
    kept.joint_places = places;
    kept.joint_parents = parents;
    desc.previous = {};
    desc.previous_view = &kept;
    const FlgModel before = model;
    FLG_CALL(calls, flgModelCreate, calls.context, &desc, calls.out(model), calls.job());
    FLG_CALL(calls, flgModelRelease, calls.context, before);
    FLG_CALL(calls, flgPartRelease, calls.context, parts[0].part);
    return model;
}

}  // namespace

void make_straight_skeletons(Calls& calls) {
    const std::vector<double> hourglass = {0, 0, 3, 2, 3, 0, 0, 2};
    for (const std::vector<double>& points : {ellipse(0, 0, 2, 1), hourglass}) {
        FlgStraightSkeletonDesc desc = FLG_INIT(calls, flgStraightSkeletonDescInit);
        const FlgContourView drawn = contour(calls, points);
        desc.contour = &drawn;
        desc.repair = points == hourglass;
        FlgStraightSkeleton skeleton{};
        FLG_CALL(calls, flgStraightSkeletonCreate, calls.context, &desc, calls.out(skeleton), calls.job());
        calls.finish();
        FlgStraightSkeletonView view = FLG_INIT(calls, flgStraightSkeletonViewInit);
        FLG_CALL(calls, flgStraightSkeletonGetView, calls.context, skeleton, &view);
        calls.note(view.nodes, size_t{3} * view.node_count * sizeof(double));
        calls.note(view.arcs, size_t{4} * view.arc_count * sizeof(uint32_t));
        FLG_DRAW(calls, flgDebugDrawStraightSkeleton, skeleton);
        FlgOffsetPolygons polygons = FLG_INIT(calls, flgOffsetPolygonsInit);
        FLG_CALL(calls, flgStraightSkeletonOffset, calls.context, skeleton, 0.2, &polygons);
        std::vector<double> front(2 * size_t{polygons.point_count});
        std::vector<uint32_t> offsets(polygons.ring_count + 1);
        polygons.points = front.data();
        polygons.ring_offsets = offsets.data();
        polygons.point_capacity = polygons.point_count;
        polygons.ring_capacity = polygons.ring_count;
        FLG_CALL(calls, flgStraightSkeletonOffset, calls.context, skeleton, 0.2, &polygons);
        calls.note(front.data(), front.size() * sizeof(double));
        FLG_CALL(calls, flgStraightSkeletonRelease, calls.context, skeleton);
    }
}

void make_models(Calls& calls) {
    FlgPartMeshDesc body = FLG_INIT(calls, flgPartMeshDescInit);
    body.part = make_part(calls, ellipse(0, 0, 1.5, 0.5));
    body.spacing = 0.4;
    FlgPartMesh mesh{};
    FLG_CALL(calls, flgPartMeshCreate, calls.context, &body, calls.out(mesh), calls.job());
    FlgSkinDesc desc = FLG_INIT(calls, flgSkinDescInit);
    desc.model = make_model(calls);
    desc.vertex_count = 100;
    FlgSkin skin{};
    FLG_CALL(calls, flgSkinCreate, calls.context, &desc, calls.out(skin), calls.job());
    FlgSkinSimplifyDesc simpler = FLG_INIT(calls, flgSkinSimplifyDescInit);
    simpler.skin = skin;
    simpler.vertex_count = 50;
    FlgSkin level{};
    FLG_CALL(calls, flgSkinSimplify, calls.context, &simpler, calls.out(level), calls.job());
    FlgBufferOutput output = output_to_buffers(calls, {{FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32},
                                                       {FLG_ATTRIBUTE_JOINTS, FLG_NUMBER_FORMAT_UINT8},
                                                       {FLG_ATTRIBUTE_WEIGHTS, FLG_NUMBER_FORMAT_UNORM8}});
    add_triangles(output);
    FLG_CALL(calls, flgSkinWrite, calls.context, skin, &output, nullptr, calls.job());
    calls.finish();
    note_buffers(calls, output);
    output.column_count = 1;
    FLG_CALL(calls, flgPartMeshWrite, calls.context, mesh, &output, nullptr, calls.job());
    calls.finish();
    note_buffers(calls, output);

    FlgPartView part = FLG_INIT(calls, flgPartViewInit);
    FLG_CALL(calls, flgPartGetView, calls.context, body.part, &part);
    calls.note(part.nodes, size_t{3} * part.node_count * sizeof(double));
    FlgPartMeshView shape = FLG_INIT(calls, flgPartMeshViewInit);
    FLG_CALL(calls, flgPartMeshGetView, calls.context, mesh, &shape);
    calls.note(shape.positions, size_t{3} * shape.vertex_count * sizeof(float));
    FlgModelView model = FLG_INIT(calls, flgModelViewInit);
    FLG_CALL(calls, flgModelGetView, calls.context, desc.model, &model);
    calls.note(model.joint_positions, size_t{3} * model.joint_count * sizeof(float));
    FlgSkinView view = FLG_INIT(calls, flgSkinViewInit);
    FLG_CALL(calls, flgSkinGetView, calls.context, skin, &view);
    calls.note(view.positions, size_t{3} * view.vertex_count * sizeof(float));
    calls.note(view.vertex_weights, size_t{4} * view.vertex_count * sizeof(float));
    FlgSkinSetWeightsDesc weights = FLG_INIT(calls, flgSkinSetWeightsDescInit);
    weights.skin = skin;
    weights.vertex_count = view.vertex_count;
    weights.vertex_joints = view.vertex_joints;
    weights.vertex_weights = view.vertex_weights;
    FlgSkin bound{};
    FLG_CALL(calls, flgSkinSetWeights, calls.context, &weights, calls.out(bound), calls.job());
    calls.finish();
    FLG_CALL(calls, flgSkinGetView, calls.context, bound, &view);
    calls.note(view.vertex_weights, size_t{4} * view.vertex_count * sizeof(float));
    FLG_CALL(calls, flgSkinRelease, calls.context, bound);
    FLG_CALL(calls, flgSkinGetView, calls.context, level, &view);
    calls.note(view.positions, size_t{3} * view.vertex_count * sizeof(float));
    FLG_CALL(calls, flgSkinRelease, calls.context, level);
    FLG_DRAW(calls, flgDebugDrawPart, body.part);
    FLG_DRAW(calls, flgDebugDrawPartMesh, mesh);
    FLG_DRAW(calls, flgDebugDrawModel, desc.model);
    FLG_DRAW(calls, flgDebugDrawSkin, skin);
    FLG_CALL(calls, flgSkinRelease, calls.context, skin);
    FLG_CALL(calls, flgModelRelease, calls.context, desc.model);
    FLG_CALL(calls, flgPartMeshRelease, calls.context, mesh);
}

void make_outlines(Calls& calls) {
    MeshArrays mesh = sphere(4);
    FlgSurfaceDesc surface = FLG_INIT(calls, flgSurfaceDescInit);
    const FlgMeshView input = mesh.view();
    surface.mesh = &input;
    FlgOutlineDesc desc = FLG_INIT(calls, flgOutlineDescInit);
    FLG_CALL(calls, flgSurfaceCreate, calls.context, &surface, calls.out(desc.surface), calls.job());
    desc.direction[2] = 1;
    FlgOutline outline{};
    FLG_CALL(calls, flgOutlineCreate, calls.context, &desc, calls.out(outline), calls.job());
    calls.finish();
    FlgOutlineView view = FLG_INIT(calls, flgOutlineViewInit);
    FLG_CALL(calls, flgOutlineGetView, calls.context, outline, &view);
    calls.note(view.contour->points, size_t{2} * view.contour->point_count * sizeof(double));
    FLG_DRAW(calls, flgDebugDrawOutline, outline);
    FLG_CALL(calls, flgOutlineRelease, calls.context, outline);
}

void make_mesh_skins(Calls& calls) {
    MeshArrays mesh = sphere(4);
    const FlgMeshView input = mesh.view();
    FlgSkinFromMeshDesc desc = FLG_INIT(calls, flgSkinFromMeshDescInit);
    desc.mesh = &input;
    desc.cell_count = 1000;
    FlgSkin skin{};
    FLG_CALL(calls, flgSkinCreateFromMesh, calls.context, &desc, calls.out(skin), calls.job());
    calls.finish();
    FlgSkinView view = FLG_INIT(calls, flgSkinViewInit);
    FLG_CALL(calls, flgSkinGetView, calls.context, skin, &view);
    calls.note(view.joint_positions, size_t{3} * view.joint_count * sizeof(float));
    calls.note(view.vertex_weights, size_t{4} * view.vertex_count * sizeof(float));
    FLG_CALL(calls, flgSkinRelease, calls.context, skin);
}

void pull_meshes(Calls& calls) {
    MeshArrays mesh = sphere(4);
    const FlgMeshView input = mesh.view();
    FlgPullDesc desc = FLG_INIT(calls, flgPullDescInit);
    desc.mesh = &input;
    FlgPull pull{};
    FLG_CALL(calls, flgPullCreate, calls.context, &desc, calls.out(pull), calls.job());
    FlgPullHandle handles[2];
    for (uint32_t h = 0; h < 2; ++h) {
        handles[h] = FLG_INIT(calls, flgPullHandleInit);
        handles[h].vertices[0] = handles[h].vertices[1] = handles[h].vertices[2] = 5 * h;
        handles[h].position[2] = static_cast<float>(h);
    }
    FlgPulledDesc frame = FLG_INIT(calls, flgPulledDescInit);
    frame.pull = pull;
    frame.handles = handles;
    frame.handle_count = 2;
    for (int i = 0; i < 2; ++i) {
        FlgPulled pulled{};
        FLG_CALL(calls, flgPulledCreate, calls.context, &frame, calls.out(pulled), calls.job());
        if (i > 0) FLG_CALL(calls, flgPulledRelease, calls.context, frame.previous);
        frame.previous = pulled;
        handles[1].position[0] += 0.5f;
    }
    calls.finish();
    FlgPulledView view = FLG_INIT(calls, flgPulledViewInit);
    FLG_CALL(calls, flgPulledGetView, calls.context, frame.previous, &view);
    calls.note(view.positions, size_t{3} * view.vertex_count * sizeof(float));
    FLG_CALL(calls, flgPulledRelease, calls.context, frame.previous);
    FLG_CALL(calls, flgPullRelease, calls.context, pull);

    const uint32_t offsets[] = {0, 3, 4};
    const double times[] = {0, 1, 3, 0};
    const float places[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1};
    FlgPullKeys keys = FLG_INIT(calls, flgPullKeysInit);
    keys.handle_count = 2;
    keys.offsets = offsets;
    keys.times = times;
    keys.positions = places;
    float at[6];
    FLG_CALL(calls, flgPullKeysSample, &keys, 1.5, at);
    calls.note(at, sizeof at);
}

namespace {

// A person of sticks: limbs, names, a T-pose, motions.
void find_rigs(Calls& calls) {
    const float positions[] = {0,    1,    0, 0,     1.4f, 0, 0,     1.7f, 0, 0.2f,  1.3f, 0, 0.5f,  1.2f, 0,
                               0.7f, 1,    0, -0.2f, 1.3f, 0, -0.5f, 1.2f, 0, -0.7f, 1,    0, 0.1f,  0.9f, 0,
                               0.1f, 0.5f, 0, 0.1f,  0,    0, -0.1f, 0.9f, 0, -0.1f, 0.5f, 0, -0.1f, 0,    0};
    const uint32_t parents[] = {FLG_NO_INDEX, 0, 1, 1, 3, 4, 1, 6, 7, 0, 9, 10, 0, 12, 13};
    constexpr uint32_t count = 15;
    const std::vector<float> radii(count, 0.05f);
    FlgRigFindDesc desc = FLG_INIT(calls, flgRigFindDescInit);
    desc.joint_count = count;
    desc.joint_positions = positions;
    desc.joint_radii = radii.data();
    desc.joint_parents = parents;
    FlgRigJoint joints[count];
    FlgRig rig = FLG_INIT(calls, flgRigInit);
    FLG_CALL(calls, flgRigFind, &desc, joints, &rig);
    calls.note(joints, sizeof joints);
    const char* names[count];
    FLG_CALL(calls, flgRigGetNames, &rig, FLG_RIG_STANDARD_VRM, names);
    EXPECT_STREQ(names[0], "hips");
    float rotations[4 * count], translation[3], travel[3];
    FLG_CALL(calls, flgRigGetTPose, &rig, rotations);
    calls.note(rotations, sizeof rotations);
    for (const FlgRigMotion motion : {FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_IDLE, FLG_RIG_MOTION_WAVE}) {
        FLG_CALL(calls, flgRigMotionSample, &rig, motion, 0.25f, rotations, translation, travel);
        calls.note(rotations, sizeof rotations);
    }
}

}  // namespace

void pose_skins(Calls& calls) {
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const uint32_t triangle[] = {0, 1, 2}, parts[] = {0, 0, 0};
    const uint16_t joints[12] = {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    const float weights[12] = {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0};
    // More joints than fit on the stack.
    constexpr uint32_t joint_count = 300;
    std::vector<float> places(3 * joint_count), rotations;
    std::vector<uint32_t> parents;
    const std::vector<const char*> names(joint_count, "joint");
    for (uint32_t j = 0; j < joint_count; ++j) {
        places[3 * j] = static_cast<float>(j);
        parents.push_back(j == 0 ? FLG_NO_INDEX : j - 1);
        rotations.insert(rotations.end(), {0, 0, 0.6f, 0.8f});
    }
    FlgSkinView view = FLG_INIT(calls, flgSkinViewInit);
    view.vertex_count = 3;
    view.triangle_count = 1;
    view.joint_count = joint_count;
    view.positions = positions;
    view.normals = normals;
    view.triangles = triangle;
    view.vertex_joints = joints;
    view.vertex_weights = weights;
    view.vertex_parts = parts;
    view.joint_positions = places.data();
    view.joint_parents = parents.data();
    view.joint_names = names.data();
    const float time = 0;
    FlgSkinAnimation animation = FLG_INIT(calls, flgSkinAnimationInit);
    animation.key_count = 1;
    animation.name = "turn";
    animation.times = &time;
    animation.rotations = rotations.data();
    std::vector<float> sampled(4 * joint_count), matrices(12 * joint_count);
    FLG_CALL(calls, flgSkinAnimationSample, &animation, joint_count, 0.5f, sampled.data(), nullptr);
    FLG_CALL(calls, flgSkinPose, &view, sampled.data(), nullptr, matrices.data(), nullptr);
    float moved[9];
    FLG_CALL(calls, flgSkinDeform, &view, FLG_SKINNING_LINEAR, matrices.data(), moved, nullptr);
    calls.note(moved, sizeof moved);
    find_rigs(calls);
}

}  // namespace flg::test
