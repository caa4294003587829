// SPDX-License-Identifier: MIT
#include "bones/model.h"

#include <algorithm>
#include <cstdio>

#include "bones/bone_graph.h"
#include "bones/bounded_dp.h"
#include "bones/refinement.h"
#include "runtime/each.h"
#include "skeletons/point2.h"

namespace flg {
namespace {

constexpr size_t max_joints = 65535;

// The joints of a part: of the ends of its branches, and where BoundedDP bends them.
Task<void> add_part(Pace& pace, const HeldModel& model, uint32_t number, BoneGraph& graph) {
    const ModelPart& placed = model.parts[number];
    const PartSkeleton& skeleton = placed.part->skeleton;
    // What is measured across the axis in the plane, and through the part at right angles to it, on the average.
    const double radius_scale = placed.scale * 0.5 * (1 + placed.thickness);
    Buffer<uint32_t> joint_of(skeleton.graph.nodes.size(), pace.memory());
    co_await each(pace, joint_of.size(), Cost::some_ns, [&](uint32_t node) { joint_of[node] = no_number; });
    const auto end_joint = [&](uint32_t node) {
        const AxisNode& n = skeleton.graph.nodes[node];
        if (joint_of[node] == no_number)
            joint_of[node] = graph.add_joint(placed.place(n.at), n.clearance * radius_scale, number);
        return joint_of[node];
    };
    if (skeleton.branches.empty()) end_joint(0);
    if (!placed.branch_simplify.empty() && placed.branch_simplify.size() != skeleton.branches.size())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.parts[%u].branch_count is %zu; the part has %zu branches",
                      placed.source, placed.branch_simplify.size(), skeleton.branches.size());
    Slice slice(Cost::tens_of_ns);
    for (size_t b = 0; b < skeleton.branches.size(); ++b) {
        const AxisBranch& branch = skeleton.branches[b];
        const std::span<const AxisSample> samples(skeleton.samples.data() + branch.begin, branch.end - branch.begin);
        double share = placed.thresholds.simplify;
        if (!placed.branch_simplify.empty() && placed.branch_simplify[b] >= 0) share = placed.branch_simplify[b];
        const auto kept = co_await bounded_dp(pace, placed.part->outline, samples, share * model.size / placed.scale,
                                              model.shape_weight);
        uint32_t before = end_joint(branch.from);
        for (size_t i = 1; i < kept.size(); ++i) {
            const AxisSample& sample = samples[kept[i]];
            const uint32_t joint = i + 1 == kept.size()
                                       ? end_joint(branch.to)
                                       : graph.add_joint(placed.place(sample.at),
                                                         0.5 * (sample.left + sample.right) * radius_scale, number);
            graph.add_bone(before, joint, number);
            before = joint;
            if (slice.is_over()) co_await pace;
        }
        if (graph.joints().size() > max_joints)
            throw Failure(FLG_ERROR_LIMIT, "desc.parts have more than %zu joints; larger thresholds make fewer",
                          max_joints);
    }
}

// Its points, and those half-way between them.
Task<void> place_outline(Pace& pace, const ModelPart& part, std::pmr::vector<Vec3>& out) {
    const Contour& contour = part.part->outline;
    out.clear();
    out.reserve(2 * contour.size());
    co_await each(pace, contour.size(), Cost::tens_of_ns, [&](uint32_t i) {
        out.push_back(part.place(contour.points[i]));
        out.push_back(part.place(mix(contour.points[i], contour.points[contour.next(i)], 0.5)));
    });
}

// Which of two twins is the left one: on the side of the mirror's normal, by the middle of its axis.
Task<void> name_twins(Pace& pace, HeldModel& model) {
    for (ModelPart& part : model.parts) {
        if (part.twin == no_number) continue;
        const auto& nodes = part.part->skeleton.graph.nodes;
        double sum = 0;
        co_await each(pace, nodes.size(), Cost::tens_of_ns, [&](uint32_t i) {
            sum += part.place(nodes[i].at).dot(model.mirror_normal) - model.mirror_offset;
        });
        part.suffix = sum > 0 || (sum == 0 && !part.is_mirrored) ? ".L" : ".R";
    }
}

// By part that hangs on none, its widest joint.
Task<std::pmr::vector<uint32_t>> find_roots(Pace& pace, const HeldModel& model, const BoneGraph& graph,
                                            std::span<const uint32_t> first_joints) {
    std::pmr::vector<uint32_t> roots(pace.memory());
    const auto& joints = graph.joints();
    uint32_t next_part = 0;
    bool is_root = false;
    co_await each(pace, joints.size(), Cost::tens_of_ns, [&](uint32_t j) {
        if (next_part < first_joints.size() && j == first_joints[next_part]) {
            is_root = model.links[next_part++].event == PartLink::Event::root;
            if (is_root) roots.push_back(graph.heir(j));
        }
        const uint32_t part = next_part - 1;
        if (!is_root || !graph.is_there(j) || joints[j].part != part) return;
        uint32_t& root = roots.back();
        if (joints[root].part != part || joints[j].radius > joints[root].radius) root = j;
    });
    co_return roots;
}

}  // namespace

void HeldModel::show_joint(const BoneJoint& joint) {
    columns_.joint_counts.resize(parts.size());
    for (int i = 0; i < 3; ++i) columns_.positions.push_back(static_cast<float>(joint.at[i]));
    columns_.radii.push_back(static_cast<float>(joint.radius));
    columns_.parents.push_back(joint.parent);
    columns_.parts.push_back(joint.part);
    char number[16];
    std::snprintf(number, sizeof number, "_%u", columns_.joint_counts[joint.part]++);
    columns_.names.emplace_back(parts[joint.part].name).append(number).append(parts[joint.part].suffix);
    columns_.name_pointers.push_back(columns_.names.back().c_str());
}

void HeldModel::show_part(uint32_t part) {
    columns_.part_events.push_back(static_cast<FlgPartEvent>(links[part].event));
    columns_.part_parents.push_back(links[part].parent);
    columns_.part_sources.push_back(parts[part].source);
    columns_.part_twins.push_back(parts[part].twin);
    columns_.part_mirrored.push_back(parts[part].is_mirrored);
}

void HeldModel::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .joint_count = static_cast<uint32_t>(tree.joints.size()),
             .joint_positions = columns_.positions.data(),
             .joint_radii = columns_.radii.data(),
             .joint_parents = columns_.parents.data(),
             .joint_parts = columns_.parts.data(),
             .joint_names = columns_.name_pointers.data(),
             .part_count = static_cast<uint32_t>(parts.size()),
             .size = static_cast<float>(size),
             .part_events = columns_.part_events.data(),
             .part_parents = columns_.part_parents.data(),
             .part_joints = part_joints.data(),
             .part_sources = columns_.part_sources.data(),
             .part_twins = columns_.part_twins.data(),
             .part_mirrored = columns_.part_mirrored.data(),
             .origin = {}};
    write_origin(origin, view_.origin);
}

Task<void> make_model(Pace& pace, std::shared_ptr<HeldModel> model) {
    HeldModel& m = *model;
    Memory* memory = pace.memory();
    for (const ModelPart& part : m.parts) m.size = std::max(m.size, part.part->length * part.scale);
    co_await name_twins(pace, m);
    pace.stage("connect");
    BoneGraph graph(memory);
    std::pmr::vector<uint32_t> first_joints(memory);  // by part, before what others put on its bones
    std::pmr::vector<RefinementThresholds> thresholds(memory);
    std::pmr::vector<Vec3> outline(memory);
    const auto in_space = [&](const FlgBoneThresholds& shares) {
        return RefinementThresholds{shares.merge * m.size, shares.prune * m.size, shares.collapse * m.size};
    };
    for (uint32_t p = 0; p < m.parts.size(); ++p) {
        const auto first_joint = static_cast<uint32_t>(graph.joints().size());
        const auto first_bone = static_cast<uint32_t>(graph.bones().size());
        first_joints.push_back(first_joint);
        co_await add_part(pace, m, p, graph);
        co_await place_outline(pace, m.parts[p], outline);
        const NewPart part{p, m.parts[p].twin, first_joint, first_bone, outline};
        const PartLink link = co_await connect_part(pace, graph, part);
        m.links.push_back(link);
        thresholds.push_back(in_space(m.parts[p].thresholds));
    }
    thresholds.push_back(in_space(m.thresholds));
    pace.stage("refine");
    co_await refine(pace, graph, thresholds);
    const std::pmr::vector<uint32_t> roots = co_await find_roots(pace, m, graph, first_joints);
    OrderedBones ordered = co_await order_bones(pace, graph, roots);
    m.tree = std::move(ordered.tree);
    m.part_joints.assign(m.parts.size(), no_number);
    co_await each(pace, m.tree.joints.size(), Cost::hundreds_of_ns, [&](uint32_t j) {
        uint32_t& topmost = m.part_joints[m.tree.joints[j].part];
        topmost = std::min(topmost, j);
        m.show_joint(m.tree.joints[j]);
    });
    co_await each(pace, m.parts.size(), Cost::tens_of_ns, [&](uint32_t p) {
        // Where a part's joints all became others', the one that its first became.
        if (m.part_joints[p] == no_number) m.part_joints[p] = ordered.number[graph.heir(first_joints[p])];
        m.show_part(p);
    });
}

}  // namespace flg
