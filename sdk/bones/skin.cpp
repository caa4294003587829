// SPDX-License-Identifier: MIT
#include "bones/skin.h"

#include <deque>

#include "bones/part_body.h"
#include "runtime/each.h"

namespace flg {
namespace {

static_assert(sizeof(std::array<uint16_t, 4>) == 4 * sizeof(uint16_t));
static_assert(sizeof(std::array<float, 4>) == 4 * sizeof(float));

// Whether a part's axis is on one side of the mirror: then it and its image are two things, however near they are.
Task<bool> is_beside_mirror(Pace& pace, const HeldModel& model, const ModelPart& part) {
    const auto& nodes = part.part->skeleton.graph.nodes;
    double low = HUGE_VAL, high = -HUGE_VAL;
    co_await each(pace, nodes.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const double side = part.place(nodes[i].at).dot(model.mirror_normal) - model.mirror_offset;
        low = std::min(low, side);
        high = std::max(high, side);
    });
    co_return low > 0 || high < 0;
}

// Bodies of all parts, those that are there more than once only once.
Task<void> inflate_parts(Pace& pace, const HeldModel& model, std::pmr::deque<PartBody>& bodies,
                         std::pmr::vector<PlacedPart>& placed) {
    std::pmr::vector<const HeldPart*> done(pace.memory());
    for (const ModelPart& part : model.parts) {
        size_t body = std::find(done.begin(), done.end(), part.part.get()) - done.begin();
        if (body == done.size()) {
            done.push_back(part.part.get());
            bodies.emplace_back(pace.memory());
            co_await inflate(pace, *part.part, InflationOptions(), bodies.back());
        }
        PlacedPart out;
        out.part = &bodies[body].inflated;
        out.thickness = part.thickness;
        if (part.twin != no_number && co_await is_beside_mirror(pace, model, part)) out.apart_from = part.twin;
        Eigen::Matrix<double, 3, 4> placement = part.placement;
        placement.col(3) = part.place(bodies[body].origin);
        placement.leftCols<3>() *= bodies[body].scale;
        for (int i = 0; i < 12; ++i) out.placement[i] = placement(i / 4, i % 4);
        placed.push_back(out);
    }
}

// A bone from each joint's parent to it, with the joint it turns with. A part that no bone begins in (its joints are
// ends, or became those of other parts) gets one that is a point: that of its joint in `part_joints`.
Task<std::pmr::vector<BoneSegment>> bone_segments(Pace& pace, const BoneTree& tree,
                                                  std::span<const uint32_t> part_joints) {
    std::pmr::vector<BoneSegment> segments(pace.memory());
    segments.reserve(tree.joints.size() + part_joints.size());
    std::pmr::vector<bool> has_bone(part_joints.size(), false, pace.memory());
    co_await each(pace, tree.joints.size(), Cost::tens_of_ns, [&](uint32_t j) {
        const BoneJoint& joint = tree.joints[j];
        if (joint.parent == no_joint) return;
        const BoneJoint& parent = tree.joints[joint.parent];
        // A bone into another part lies in this one, however thin the other is.
        const double radius = joint.part == parent.part ? joint.radius : parent.radius;
        segments.push_back({parent.at, joint.at, parent.radius, radius, joint.parent, parent.part});
        has_bone[parent.part] = true;
    });
    co_await each(pace, part_joints.size(), Cost::tens_of_ns, [&](uint32_t p) {
        if (has_bone[p]) return;
        const BoneJoint& joint = tree.joints[part_joints[p]];
        segments.push_back({joint.at, joint.at, joint.radius, joint.radius, part_joints[p], p});
    });
    co_return segments;
}

}  // namespace

void HeldSkin::show_vertex(size_t vertex) {
    if (columns_.positions.empty()) {
        columns_.positions.reserve(3 * mesh.positions.size());
        columns_.normals.reserve(3 * mesh.positions.size());
    }
    for (int i = 0; i < 3; ++i) {
        columns_.positions.push_back(static_cast<float>(mesh.positions[vertex][i]));
        columns_.normals.push_back(static_cast<float>(mesh.normals[vertex][i]));
    }
}

void HeldSkin::show() noexcept {
    const FlgModelView& bones = model->view();
    view_ = {.struct_size = sizeof view_,
             .vertex_count = static_cast<uint32_t>(mesh.positions.size()),
             .triangle_count = static_cast<uint32_t>(mesh.triangles.size()),
             .joint_count = bones.joint_count,
             .positions = columns_.positions.data(),
             .normals = columns_.normals.data(),
             .triangles = mesh.triangles.data()->data(),
             .vertex_joints = weights.joints.data()->data(),
             .vertex_weights = weights.weights.data()->data(),
             .vertex_parts = mesh.parts.data(),
             .joint_positions = bones.joint_positions,
             .joint_parents = bones.joint_parents,
             .joint_names = bones.joint_names,
             .origin = {}};
    write_origin(model->origin, view_.origin);
}

Task<void> make_skin(Pace& pace, std::shared_ptr<HeldSkin> skin) {
    const HeldModel& model = *skin->model;
    std::pmr::deque<PartBody> bodies(pace.memory());
    std::pmr::vector<PlacedPart> placed(pace.memory());
    co_await inflate_parts(pace, model, bodies, placed);
    skin->mesh = co_await merge_parts(pace, placed, skin->options);
    const std::pmr::vector<BoneSegment> bones = co_await bone_segments(pace, model.tree, model.part_joints);
    Buffer<uint32_t> parents(model.tree.joints.size(), pace.memory());
    co_await each(pace, parents.size(), Cost::some_ns, [&](uint32_t j) { parents[j] = model.tree.joints[j].parent; });
    const BoneRig rig{bones, {parents.data(), parents.size()}};
    skin->weights = co_await bone_weights(pace, skin->mesh, placed, rig, BoneWeightOptions());
    // One by one: all at once they would take longer to be given back than a slice may.
    for (; !bodies.empty(); bodies.pop_back()) co_await pace;
    co_await each(pace, skin->mesh.positions.size(), Cost::tens_of_ns, [&](uint32_t v) { skin->show_vertex(v); });
}

}  // namespace flg
