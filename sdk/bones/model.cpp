// SPDX-License-Identifier: MIT
#include "bones/model.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "bones/bone_graph.h"
#include "bones/hierarchy.h"
#include "bones/joint_edits.h"
#include "bones/part_joints.h"
#include "bones/refinement.h"
#include "bones/shared_trunks.h"
#include "runtime/each.h"
#include "skeletons/point2.h"

namespace flg {
namespace {

constexpr size_t max_joints = 65535;
constexpr double bulge = 0.25;    // of a junction's radius: branches of a part alone that reach less beyond are none
constexpr double on_axis = 1e-9;  // of a part's length: joints on its mirror axis are that near

// The ball of a part where it is widest; where it is its own mirror image, on the axis.
Task<void> find_widest(Pace& pace, const ModelPart& part, RefinementThresholds& out) {
    const HeldPart& drawn = *part.part;
    const auto& nodes = drawn.skeleton.graph.nodes;
    uint32_t widest = no_number;
    co_await each(pace, nodes.size(), Cost::tens_of_ns, [&](uint32_t n) {
        if (drawn.mirror && std::abs(drawn.mirror->side(nodes[n].at)) > on_axis * drawn.length) return;
        if (widest == no_number || nodes[n].clearance > nodes[widest].clearance) widest = n;
    });
    if (widest == no_number) co_return;
    out.widest_at = part.place(nodes[widest].at);
    out.widest = nodes[widest].clearance * part.radius_scale();
}

// The joints of a part: of the ends of its branches, and those chosen along them.
Task<void> add_part(Pace& pace, const HeldModel& model, uint32_t number, const PartJoints& chosen, BoneGraph& graph) {
    const ModelPart& placed = model.parts[number];
    const PartSkeleton& skeleton = placed.part->skeleton;
    const double radius_scale = placed.radius_scale();
    Buffer<uint32_t> joint_of(skeleton.graph.nodes.size(), pace.memory());
    co_await each(pace, joint_of.size(), Cost::some_ns, [&](uint32_t node) { joint_of[node] = no_number; });
    const auto end_joint = [&](uint32_t node) {
        const AxisNode& n = skeleton.graph.nodes[node];
        if (joint_of[node] == no_number)
            joint_of[node] = graph.add_joint(placed.place(n.at), n.clearance * radius_scale, number);
        return joint_of[node];
    };
    const uint32_t first = static_cast<uint32_t>(graph.joints().size());
    if (skeleton.branches.empty()) end_joint(0);
    Slice slice(Cost::tens_of_ns);
    for (size_t b = 0; b < skeleton.branches.size(); ++b) {
        const AxisBranch& branch = skeleton.branches[b];
        const std::span<const AxisSample> samples(skeleton.samples.data() + branch.begin, branch.end - branch.begin);
        const std::span<const uint32_t> kept = chosen.of(number, b);
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
    if (!placed.part->mirror) co_return;
    const MirrorAxis& mirror = *placed.part->mirror;
    co_await each(pace, first, static_cast<uint32_t>(graph.joints().size()), Cost::some_ns, [&](uint32_t j) {
        BoneGraph::Joint& joint = graph.joints()[j];
        if (std::abs(mirror.side(placed.drawn(joint.at))) <= on_axis * placed.part->length)
            joint.hold = BoneGraph::Hold::middle;
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

// Names for hosts to tell joints by; parts' names may make two the same.
Task<void> make_keys_unique(Pace& pace, Hierarchy& hierarchy, const BoneGraph& graph) {
    std::pmr::unordered_set<std::pmr::string> keys(pace.memory());
    keys.reserve(graph.joints().size());
    co_await each(pace, graph.joints().size(), Cost::hundreds_of_ns, [&](uint32_t j) {
        if (!graph.is_there(j)) return;
        std::pmr::string& key = hierarchy.labels[graph.joints()[j].label].key;
        while (!keys.insert(key).second) key.append("_");
    });
}

}  // namespace

void HeldModel::show_joint(const BoneJoint& joint, std::string_view key, std::string_view name, bool is_pinned) {
    for (int i = 0; i < 3; ++i) columns_.positions.push_back(static_cast<float>(joint.at[i]));
    columns_.radii.push_back(static_cast<float>(joint.radius));
    columns_.parents.push_back(joint.parent);
    columns_.parts.push_back(joint.part);
    columns_.keys.emplace_back(key);
    columns_.key_pointers.push_back(columns_.keys.back().c_str());
    columns_.names.emplace_back(name.empty() ? key : name);
    columns_.name_pointers.push_back(columns_.names.back().c_str());
    const ModelPart& part = parts[joint.part];
    const Vec3 offset = (joint.at - part.placement.col(3)) / (part.scale * part.scale);
    for (int i = 0; i < 3; ++i) columns_.places.push_back(offset.dot(part.placement.col(i)));
    columns_.pinned.push_back(is_pinned);
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
             .origin = {},
             .joint_keys = columns_.key_pointers.data(),
             .joint_places = columns_.places.data(),
             .joint_pinned = columns_.pinned.data()};
    write_origin(origin, view_.origin);
}

Task<void> make_model(Pace& pace, std::shared_ptr<HeldModel> model) {
    HeldModel& m = *model;
    Memory* memory = pace.memory();
    // Models do not keep those before them.
    const std::shared_ptr<const HeldModel> previous = m.previous;
    for (const ModelPart& part : m.parts) m.size = std::max(m.size, part.part->length * part.scale);
    co_await name_twins(pace, m);
    m.own_begins.assign(m.parts.size(), 0);
    m.own_counts.assign(m.parts.size(), 0);
    pace.stage("joints");
    BoneGraph graph(memory);
    std::pmr::vector<uint32_t> first_joints(memory);
    std::pmr::vector<RefinementThresholds> thresholds(memory);
    const auto in_space = [&](const FlgBoneThresholds& shares) {
        const double unit = shares.detail > 0 ? m.size / shares.detail : m.size;
        return RefinementThresholds{shares.merge * unit, shares.prune * unit, shares.collapse * unit,
                                    shares.prune > 0 ? bulge : 0};
    };
    {
        const PartJoints chosen = co_await choose_joints(pace, m);
        for (const ModelPart& part : m.parts) {
            thresholds.push_back(in_space(part.thresholds));
            if (part.thresholds.detail > 0) thresholds.back().hub = part.scale / part.radius_scale();
            co_await find_widest(pace, part, thresholds.back());
        }
        thresholds.push_back(in_space(m.thresholds));
        // First each part alone: so its joints are the same wherever it is.
        for (uint32_t p = 0; p < m.parts.size(); ++p) {
            BoneGraph own(memory);
            co_await add_part(pace, m, p, chosen, own);
            co_await refine(pace, own, thresholds);
            if (m.parts[p].thresholds.detail > 0) co_await share_trunks(pace, m.parts[p], thresholds[p].merge, own);
            first_joints.push_back(static_cast<uint32_t>(graph.joints().size()));
            co_await BoneGraph::append(pace, graph, own);
            if (graph.joints().size() > max_joints)
                throw Failure(FLG_ERROR_LIMIT, "desc.parts have more than %zu joints; larger thresholds make fewer",
                              max_joints);
        }
    }
    first_joints.push_back(static_cast<uint32_t>(graph.joints().size()));
    // What hangs on a part may lie in it, like an eye in a head.
    for (RefinementThresholds& own : thresholds) own.bulge = own.hub = 0;
    pace.stage("connect");
    Hierarchy hierarchy = co_await connect_parts(pace, m, graph, first_joints, thresholds.back().collapse);
    m.previous.reset();
    m.kept_joints = std::pmr::vector<KeptJoint>(m.kept_joints.get_allocator());
    co_await edit_joints(pace, m, graph, hierarchy);
    pace.stage("refine");
    co_await refine(pace, graph, thresholds);
    co_await make_keys_unique(pace, hierarchy, graph);
    co_await each(pace, hierarchy.roots.size(), Cost::some_ns,
                  [&](uint32_t r) { hierarchy.roots[r] = graph.heir(hierarchy.roots[r]); });
    OrderedBones ordered = co_await order_bones(pace, graph, hierarchy.roots);
    m.tree = std::move(ordered.tree);
    m.links = std::move(hierarchy.links);
    m.part_joints.assign(m.parts.size(), no_number);
    Buffer<uint32_t> graph_joint(m.tree.joints.size(), memory);
    co_await each(pace, graph.joints().size(), Cost::some_ns, [&](uint32_t j) {
        if (ordered.number[j] != no_joint) graph_joint[ordered.number[j]] = j;
    });
    co_await each(pace, m.tree.joints.size(), Cost::hundreds_of_ns, [&](uint32_t j) {
        uint32_t& topmost = m.part_joints[m.tree.joints[j].part];
        topmost = std::min(topmost, j);
        const JointLabel& label = hierarchy.labels[graph.joints()[graph_joint[j]].label];
        m.show_joint(m.tree.joints[j], label.key, label.name, label.is_pinned);
    });
    co_await each(pace, m.parts.size(), Cost::tens_of_ns, [&](uint32_t p) {
        // Where a part's joints all became others', the one that its first became.
        if (m.part_joints[p] == no_number) m.part_joints[p] = ordered.number[graph.heir(first_joints[p])];
        m.show_part(p);
    });
}

}  // namespace flg
