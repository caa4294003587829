// SPDX-License-Identifier: MIT
#include "bones/joint_edits.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr const char* sides[] = {"", ".L", ".R"};
constexpr double border = 1e-6;  // of a part's length: pins so far outside count as on the outline

class Editor {
public:
    Editor(Pace& pace, const HeldModel& model, BoneGraph& graph, Hierarchy& hierarchy)
        : pace_(pace),
          model_(model),
          graph_(graph),
          hierarchy_(hierarchy),
          joints_(pace.memory()),
          names_(pace.memory()),
          towards_(pace.memory()) {}

    Task<void> apply() {
        co_await list_joints();
        co_await find_directions();
        for (uint32_t e = 0; e < model_.edits.size(); ++e) {
            const JointEdit& edit = model_.edits[e];
            bool is_there = false;
            // One joint, or both of two mirror images.
            for (const char* side : sides) {
                std::pmr::string key(edit.joint, pace_.memory());
                const auto found = joints_.find(key.append(side));
                if (found == joints_.end()) continue;
                is_there = true;
                co_await apply(edit, e, graph_.heir(found->second), side);
                if (*side == 0) break;
            }
            if (!is_there && edit.kind == FLG_JOINT_EDIT_KIND_PIN) co_await make_pinned(edit, e);
        }
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    Task<void> list_joints() {
        joints_.reserve(graph_.joints().size());
        co_await each(pace_, graph_.joints().size(), Cost::hundreds_of_ns, [&](uint32_t j) {
            const BoneGraph::Joint& joint = graph_.joints()[j];
            if (graph_.is_there(j) && joint.label != no_number) joints_.emplace(hierarchy_.labels[joint.label].key, j);
        });
    }

    Task<void> find_directions() {
        towards_.resize(graph_.joints().size(), no_number);
        std::pmr::vector<uint32_t> way(pace_.memory());
        for (const uint32_t root : hierarchy_.roots) {
            towards_[root] = root;
            way.push_back(root);
        }
        Slice slice(Cost::tens_of_ns);
        while (!way.empty()) {
            const uint32_t joint = way.back();
            way.pop_back();
            for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end)) {
                const uint32_t next = graph_.other(BoneGraph::bone_of(end), joint);
                if (towards_[next] == no_number) towards_[next] = joint, way.push_back(next);
                if (slice.is_over()) co_await pace_;
            }
        }
    }

    Task<void> apply(const JointEdit& edit, uint32_t number, uint32_t joint, const char* side) {
        switch (edit.kind) {
            case FLG_JOINT_EDIT_KIND_PIN:
                co_await check_inside(edit, number, model_.parts[graph_.joints()[joint].part]);
                pin(edit, joint);
                break;
            case FLG_JOINT_EDIT_KIND_SPLIT: split(edit, number, joint, side); break;
            case FLG_JOINT_EDIT_KIND_MERGE: co_await merge(edit, number, joint); break;
            default: rename(edit, number, joint, side);
        }
    }

    Task<void> check_inside(const JointEdit& edit, uint32_t number, const ModelPart& part) {
        const HeldPart& drawn = *part.part;
        const double depth = co_await depth_in(pace_, drawn.outline, {edit.at[0], edit.at[1]});
        const double margin = border * drawn.length;
        if (depth < -margin || std::abs(edit.at[2]) > height_over(depth, drawn.widest, part.thickness) + margin)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.joint_edits[%u] pins %s at (%g, %g, %g), which is outside of its part %s", number,
                          edit.joint.c_str(), edit.at[0], edit.at[1], edit.at[2], part.name.c_str());
    }

    void pin(const JointEdit& edit, uint32_t joint) {
        BoneGraph::Joint& j = graph_.joints()[joint];
        j.at = model_.parts[j.part].placement * edit.at.homogeneous();
        j.hold = BoneGraph::Hold::pinned;
        hierarchy_.labels[j.label].is_pinned = true;
    }

    // The joint is not there: one is made on the nearest bone of its part, which the key begins with.
    Task<void> make_pinned(const JointEdit& edit, uint32_t number) {
        for (uint32_t p = 0; p < model_.parts.size(); ++p) {
            const ModelPart& part = model_.parts[p];
            std::string_view key = edit.joint;
            if (!key.starts_with(part.name)) continue;
            key.remove_prefix(part.name.size());
            if (!key.starts_with('_')) continue;
            const bool says_side = key.ends_with(".L") || key.ends_with(".R");
            if (says_side && !key.ends_with(part.suffix)) continue;
            co_await check_inside(edit, number, part);
            const uint32_t joint = co_await split_nearest(p, part.placement * edit.at.homogeneous());
            if (joint == no_number) continue;
            uint32_t& label = graph_.joints()[joint].label;
            if (label == no_number) label = add_label(edit.joint, says_side ? "" : part.suffix.c_str());
            pin(edit, joint);
        }
    }

    Task<uint32_t> split_nearest(uint32_t part, Vec3 at) {
        uint32_t bone = no_number;
        double least = 0, share = 0;
        co_await each(pace_, graph_.bones().size(), Cost::tens_of_ns, [&](uint32_t b) {
            if (graph_.bones()[b].gone || graph_.bones()[b].part != part) return;
            const auto& ends = graph_.bones()[b].joints;
            const Vec3 from = graph_.joints()[ends[0]].at, along = graph_.joints()[ends[1]].at - from;
            const double length2 = along.squaredNorm();
            const double s = length2 > 0 ? std::clamp((at - from).dot(along) / length2, 0.01, 0.99) : 0.5;
            const double distance = (from + s * along - at).norm();
            if (bone == no_number || distance < least) bone = b, least = distance, share = s;
        });
        if (bone == no_number) co_return no_number;
        const auto ends = graph_.bones()[bone].joints;
        const bool is_down = towards_[ends[1]] == ends[0];
        co_return split_bone(is_down ? ends[0] : ends[1], is_down ? ends[1] : ends[0], is_down ? share : 1 - share);
    }

    uint32_t split_bone(uint32_t parent, uint32_t child, double share) {
        const BoneGraph::Joint &from = graph_.joints()[parent], &to = graph_.joints()[child];
        const Vec3 at = from.at + share * (to.at - from.at);
        const double radius = std::lerp(from.radius, to.radius, share);
        const uint32_t part = to.part;
        const uint32_t joint = graph_.split(graph_.bone_between(parent, child), at, radius);
        graph_.joints()[joint].part = part;
        graph_.joints()[joint].hold = BoneGraph::Hold::pinned;
        towards_.push_back(parent);
        towards_[child] = joint;
        return joint;
    }

    uint32_t add_label(const std::pmr::string& key, const char* side) {
        const auto number = static_cast<uint32_t>(hierarchy_.labels.size());
        hierarchy_.labels.emplace_back(pace_.memory());
        hierarchy_.labels.back().key.append(key).append(side);
        return number;
    }

    void split(const JointEdit& edit, uint32_t number, uint32_t joint, const char* side) {
        if (towards_[joint] == joint)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.joint_edits[%u] splits the bone to %s, which is a root: no bone leads to it", number,
                          edit.joint.c_str());
        const uint32_t made = split_bone(towards_[joint], joint, edit.share);
        const uint32_t label = add_label(edit.name, side);
        graph_.joints()[made].label = label;
        const std::pmr::string& key = hierarchy_.labels[label].key;
        if (!joints_.emplace(key, made).second) refuse_name(number, key);
    }

    Task<void> merge(const JointEdit& edit, uint32_t number, uint32_t joint) {
        const uint32_t parent = towards_[joint];
        if (parent == joint)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.joint_edits[%u] merges %s, which is a root and has no parent", number,
                          edit.joint.c_str());
        Slice slice(Cost::some_ns);
        for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end)) {
            const uint32_t next = graph_.other(BoneGraph::bone_of(end), joint);
            if (next != parent) towards_[next] = parent;
            if (slice.is_over()) co_await pace_;
        }
        joints_.erase(hierarchy_.labels[graph_.joints()[joint].label].key);
        graph_.contract(graph_.bone_between(parent, joint), parent);
    }

    void rename(const JointEdit& edit, uint32_t number, uint32_t joint, const char* side) {
        JointLabel& label = hierarchy_.labels[graph_.joints()[joint].label];
        label.name = edit.name;
        label.name.append(side);
        const auto other = joints_.find(label.name);
        if (other != joints_.end() && other->second != joint) refuse_name(number, label.name);
        const auto [taken, is_new] = names_.emplace(label.name, joint);
        if (!is_new && taken->second != joint) refuse_name(number, label.name);
    }

    [[noreturn]] static void refuse_name(uint32_t number, const std::pmr::string& name) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.joint_edits[%u].name is \"%s\", as that of another joint",
                      number, name.c_str());
    }

    Pace& pace_;
    const HeldModel& model_;
    BoneGraph& graph_;
    Hierarchy& hierarchy_;
    std::pmr::unordered_map<std::pmr::string, uint32_t> joints_;  // by key
    std::pmr::unordered_map<std::pmr::string, uint32_t> names_;   // the same by name that the host gave
    std::pmr::vector<uint32_t> towards_;                          // by joint the one nearer to the root, a root: itself
};

}  // namespace

Task<void> edit_joints(Pace& pace, const HeldModel& model, BoneGraph& graph, Hierarchy& hierarchy) {
    if (model.edits.empty()) co_return;
    Editor editor(pace, model, graph, hierarchy);
    co_await editor.apply();
}

}  // namespace flg
