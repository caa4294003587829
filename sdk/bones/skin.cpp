// SPDX-License-Identifier: MIT
#include "bones/skin.h"

#include <deque>

#include "bones/part_body.h"
#include "inflation/four_joints.h"
#include "inflation/mesh_simplification.h"
#include "inflation/part_depths.h"
#include "runtime/each.h"

namespace flg {
namespace {

static_assert(sizeof(std::array<uint16_t, 4>) == 4 * sizeof(uint16_t));
static_assert(sizeof(std::array<float, 4>) == 4 * sizeof(float));

constexpr double held = 1.25;         // of the radii of a limb and of what it hangs on: so far they are one
constexpr double max_surplus = 1.25;  // of vertices: from so many on, thin parts need them
constexpr double gap_cells = 2;       // between parts that pass each other, by the length of edges

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
        Eigen::Matrix<double, 3, 4> placement = part.placement;
        placement.col(3) = part.place(bodies[body].origin);
        placement.leftCols<3>() *= bodies[body].scale;
        for (int i = 0; i < 12; ++i) out.placement[i] = placement(i / 4, i % 4);
        placed.push_back(out);
    }
}

// How parts hang on each other, and which the mirror or the host keeps apart.
struct Hanging {
    explicit Hanging(Memory* memory) : parts(memory), apart(memory) {}

    std::pmr::vector<HungPart> parts;
    std::pmr::vector<std::array<uint32_t, 2>> apart;
};

Task<Hanging> find_hanging(Pace& pace, const HeldModel& model) {
    Hanging out(pace.memory());
    out.parts.reserve(model.parts.size());
    co_await each(pace, model.parts.size(), Cost::tens_of_ns, [&](uint32_t p) {
        const ModelPart& part = model.parts[p];
        HungPart& hung = out.parts.emplace_back();
        hung.twin = part.twin;
        hung.depth = part.depth;
        if (part.twin != no_number)
            hung.is_turned = part.is_mirrored && part.placement.col(2).dot(model.parts[part.twin].placement.col(2)) < 0;
        const BoneJoint& own = model.tree.joints[model.part_joints[p]];
        const BoneJoint& bearing = own.parent != no_joint ? model.tree.joints[own.parent] : own;
        hung.parent = model.links[p].parent;
        hung.joint = own.at;
        hung.bearing = bearing.at;
        hung.hold = held * (bearing.radius + own.radius);
    });
    out.apart.reserve(model.apart.size() + model.parts.size());
    co_await each(pace, model.apart.size(), Cost::some_ns, [&](uint32_t i) { out.apart.push_back(model.apart[i]); });
    for (uint32_t p = 0; p < model.parts.size(); ++p) {
        const uint32_t twin = model.parts[p].twin;
        if (twin != no_number && p < twin && co_await is_beside_mirror(pace, model, model.parts[p]))
            out.apart.push_back({p, twin});
    }
    co_return out;
}

// The drawing's joints where the lifted parts are.
Task<void> lift_joints(Pace& pace, std::span<const PlacedPart> placed, const BoneTree& drawn, BoneTree& out) {
    std::pmr::vector<ImplicitPart> shapes(pace.memory());
    shapes.reserve(placed.size());
    co_await each(pace, placed.size(), Cost::hundreds_of_ns, [&](uint32_t p) { shapes.emplace_back(placed[p], p); });
    out.joints.reserve(drawn.joints.size());
    co_await each(pace, drawn.joints.size(), Cost::hundreds_of_ns, [&](uint32_t j) {
        BoneJoint& joint = out.joints.emplace_back(drawn.joints[j]);
        const ImplicitPart& shape = shapes[joint.part];
        const Vec3 at = shape.local(joint.at);
        joint.at += shape.scale() * shape.lift(at.x(), at.y()) * shape.normal();
    });
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

bool has_pictures(const HeldModel& model) {
    return std::any_of(model.parts.begin(), model.parts.end(),
                       [](const ModelPart& part) { return part.picture != std::array<double, 4>{}; });
}

Task<void> show_all(Pace& pace, HeldSkin& skin) {
    co_await each(pace, skin.mesh.positions.size(), Cost::tens_of_ns, [&](uint32_t v) { skin.show_vertex(v); });
    if (skin.model && has_pictures(*skin.model))
        co_await each(pace, 3 * skin.mesh.triangles.size(), Cost::tens_of_ns,
                      [&](uint32_t corner) { skin.show_corner(corner); });
    co_await each(pace, skin.tree.joints.size(), Cost::some_ns, [&](uint32_t j) { skin.show_joint(j); });
}

template <class T>
Task<void> copy_buffer(Pace& pace, const Buffer<T>& from, Buffer<T>& to) {
    to = Buffer<T>(from.size(), pace.memory());
    co_await each(pace, from.size(), Cost::some_ns, [&](uint32_t i) { to[i] = from[i]; });
}

// All of a skin that its vertices have no part in.
Task<void> copy_joints(Pace& pace, const HeldSkin& from, HeldSkin& to) {
    to.origin = from.origin;
    to.mirror_normal = from.mirror_normal;
    to.mirror_offset = from.mirror_offset;
    to.tree.joints.reserve(from.tree.joints.size());
    co_await each(pace, from.tree.joints.size(), Cost::tens_of_ns, [&](uint32_t j) {
        to.tree.joints.push_back(from.tree.joints[j]);
        to.names.emplace_back(from.names[j]);
    });
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

// Where it is in the picture of the triangle's part, along the plane's normal.
void HeldSkin::show_corner(size_t corner) {
    if (columns_.corner_uvs.empty()) columns_.corner_uvs.reserve(6 * mesh.triangles.size());
    const ModelPart& part = model->parts[mesh.triangle_parts[corner / 3]];
    const auto& [left, bottom, right, top] = part.picture;
    const Point2 at = part.drawn(mesh.positions[mesh.triangles[corner / 3][corner % 3]]);
    const bool has_picture = right > left;
    columns_.corner_uvs.push_back(has_picture ? static_cast<float>((at.x - left) / (right - left)) : 0);
    columns_.corner_uvs.push_back(has_picture ? static_cast<float>((top - at.y) / (top - bottom)) : 0);
}

void HeldSkin::show_joint(size_t joint) {
    const BoneJoint& shown = tree.joints[joint];
    for (int i = 0; i < 3; ++i) columns_.joint_positions.push_back(static_cast<float>(shown.at[i]));
    columns_.joint_radii.push_back(static_cast<float>(shown.radius));
    columns_.joint_parents.push_back(shown.parent == no_joint ? FLG_NO_INDEX : shown.parent);
    columns_.joint_names.push_back(names[joint].c_str());
}

void HeldSkin::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .vertex_count = static_cast<uint32_t>(mesh.positions.size()),
             .triangle_count = static_cast<uint32_t>(mesh.triangles.size()),
             .joint_count = static_cast<uint32_t>(tree.joints.size()),
             .positions = columns_.positions.data(),
             .normals = columns_.normals.data(),
             .triangles = mesh.triangles.data()->data(),
             .vertex_joints = weights.joints.data()->data(),
             .vertex_weights = weights.weights.data()->data(),
             .vertex_parts = mesh.parts.data(),
             .joint_positions = columns_.joint_positions.data(),
             .joint_parents = columns_.joint_parents.data(),
             .joint_names = columns_.joint_names.data(),
             .origin = {},
             .joint_radii = columns_.joint_radii.data(),
             .mirror = {},
             .triangle_parts = mesh.triangle_parts.data(),
             .corner_uvs = columns_.corner_uvs.empty() ? nullptr : columns_.corner_uvs.data()};
    write_origin(origin, view_.origin);
    store_vec3(mirror_normal, view_.mirror);
    view_.mirror[3] = static_cast<float>(mirror_offset);
}

Task<void> make_skin(Pace& pace, std::shared_ptr<HeldSkin> skin) {
    const HeldModel& model = *skin->model;
    skin->origin = model.origin;
    const bool is_mirrored =
        std::any_of(model.parts.begin(), model.parts.end(), [](const ModelPart& p) { return p.twin != no_number; });
    if (is_mirrored) {
        skin->mirror_normal = model.mirror_normal;
        skin->mirror_offset = model.mirror_offset;
    }
    std::pmr::deque<PartBody> bodies(pace.memory());
    std::pmr::vector<PlacedPart> placed(pace.memory());
    co_await inflate_parts(pace, model, bodies, placed);
    const Hanging hanging = co_await find_hanging(pace, model);
    const std::pmr::vector<BoneSegment> drawn = co_await bone_segments(pace, model.tree, model.part_joints);
    const double gap = gap_cells * expected_spacing(placed, skin->options.vertices);
    PartDepths depths = co_await find_depths(pace, {placed, hanging.parts, drawn, hanging.apart, gap});
    co_await each(pace, placed.size(), Cost::some_ns, [&](uint32_t p) {
        placed[p].apart_from = depths.apart_from(p);
        placed[p].lift = depths.lift(p);
    });
    co_await lift_joints(pace, placed, model.tree, skin->tree);
    EvenMesh even = co_await merge_evenly(pace, placed, skin->options);
    const std::pmr::vector<BoneSegment> bones = co_await bone_segments(pace, skin->tree, model.part_joints);
    Buffer<uint32_t> parents(model.tree.joints.size(), pace.memory());
    co_await each(pace, parents.size(), Cost::some_ns, [&](uint32_t j) { parents[j] = model.tree.joints[j].parent; });
    const BoneRig rig{bones, {parents.data(), parents.size()}};
    ManyWeights weights = co_await many_weights(pace, even.mesh, placed, rig, BoneWeightOptions());
    skin->mesh = co_await cut_merged(pace, even, &weights);
    pace.stage("weights");
    skin->weights = co_await keep_four_joints(pace, skin->mesh, weights, rig);
    weights = {};
    co_await pace;
    // Borders take more vertices than were asked for. Where thin parts do, they stay: with larger triangles, limbs that
    // pass close by each other would cut through each other.
    const bool is_even = skin->mesh.even_vertices <= max_surplus * skin->options.vertices;
    if (is_even && skin->mesh.positions.size() > skin->options.vertices) {
        SimplifiedMesh simpler = co_await simplify_mesh(pace, skin->mesh, skin->weights, skin->options.vertices);
        skin->mesh = std::move(simpler.mesh);
        skin->weights = std::move(simpler.weights);
    }
    // One by one: all at once they would take longer to be given back than a slice may.
    for (; !bodies.empty(); bodies.pop_back()) co_await pace;
    for (; !depths.lifts.empty(); depths.lifts.pop_back()) co_await pace;
    co_await each(pace, skin->tree.joints.size(), Cost::tens_of_ns,
                  [&](uint32_t j) { skin->names.emplace_back(model.joint_name(j)); });
    co_await show_all(pace, *skin);
}

Task<void> make_simpler_skin(Pace& pace, std::shared_ptr<const HeldSkin> source, std::shared_ptr<HeldSkin> skin) {
    SimplifiedMesh simpler = co_await simplify_mesh(pace, source->mesh, source->weights, skin->options.vertices);
    skin->mesh = std::move(simpler.mesh);
    skin->weights = std::move(simpler.weights);
    co_await copy_joints(pace, *source, *skin);
    co_await show_all(pace, *skin);
}

Task<void> make_bound_skin(Pace& pace, std::shared_ptr<const HeldSkin> source, std::shared_ptr<HeldSkin> skin) {
    const size_t vertices = source->mesh.positions.size(), joints = source->tree.joints.size();
    if (skin->weights.joints.size() != vertices)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.vertex_count is %zu, but the skin has %zu vertices",
                      skin->weights.joints.size(), vertices);
    co_await each(pace, 4 * vertices, Cost::some_ns, [&](uint32_t i) {
        const uint16_t joint = skin->weights.joints[i / 4][i % 4];
        if (joint >= joints)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.vertex_joints: vertex %u has joint %u, but there are %zu",
                          i / 4, joint, joints);
    });
    const MergedMesh& mesh = source->mesh;
    skin->mesh.spacing = mesh.spacing;
    skin->mesh.even_vertices = mesh.even_vertices;
    co_await copy_buffer(pace, mesh.positions, skin->mesh.positions);
    co_await copy_buffer(pace, mesh.normals, skin->mesh.normals);
    co_await copy_buffer(pace, mesh.triangles, skin->mesh.triangles);
    co_await copy_buffer(pace, mesh.parts, skin->mesh.parts);
    co_await copy_buffer(pace, mesh.triangle_parts, skin->mesh.triangle_parts);
    co_await copy_buffer(pace, mesh.is_fixed, skin->mesh.is_fixed);
    co_await copy_joints(pace, *source, *skin);
    co_await show_all(pace, *skin);
}

}  // namespace flg
