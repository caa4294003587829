// SPDX-License-Identifier: MIT
#include "bones/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {
namespace {

constexpr uint32_t batch = 16;
constexpr double no_length = 1e-9;  // of a bone's length

}  // namespace

ConnectionKernel::ConnectionKernel(BoneGraph& graph, uint32_t part, uint32_t twin, uint32_t first_joint,
                                   uint32_t first_bone, PartLink& out)
    : graph_(graph),
      part_(part),
      twin_(twin),
      first_joint_(first_joint),
      first_bone_(first_bone),
      last_joint_(static_cast<uint32_t>(graph.joints().size())),
      out_(out),
      inside_{std::numeric_limits<double>::infinity(), no_number, no_number, no_number, 0},
      touching_(inside_),
      child_(first_joint) {}

bool ConnectionKernel::run(uint32_t count) {
    for (; count > 0; --count) {
        if (child_ == last_joint_) {
            connect();
            return true;
        }
        const uint32_t end = std::min(at_ + batch, first_bone_ + first_joint_);
        if (holds(child_)) {
            for (; at_ < end; ++at_)
                at_ < first_bone_ ? look_at_bone(child_, at_) : look_at_joint(child_, at_ - first_bone_);
        }
        if (end == first_bone_ + first_joint_ || !holds(child_)) {
            ++child_;
            at_ = 0;
        }
    }
    return false;
}

void ConnectionKernel::look_at_bone(uint32_t child, uint32_t bone) {
    const BoneGraph::Bone& b = graph_.bones()[bone];
    if (b.gone || b.part == no_number || b.part == twin_) return;
    const BoneGraph::Joint &from = graph_.joints()[b.joints[0]], &to = graph_.joints()[b.joints[1]];
    const Vec3& at = graph_.joints()[child].at;
    const Vec3 along = to.at - from.at;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((at - from.at).dot(along) / length2, 0.0, 1.0) : 0;
    const double distance = (at - from.at - share * along).norm();
    look({distance, child, bone, no_number, share}, std::lerp(from.radius, to.radius, share));
}

void ConnectionKernel::look_at_joint(uint32_t child, uint32_t joint) {
    const BoneGraph::Joint& j = graph_.joints()[joint];
    if (!graph_.is_there(joint) || j.part == twin_) return;
    for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end))
        if (graph_.bones()[BoneGraph::bone_of(end)].part != no_number) return;
    look({(graph_.joints()[child].at - j.at).norm(), child, no_number, joint, 0}, j.radius);
}

void ConnectionKernel::look(const Place& place, double parent_radius) {
    const double radius = graph_.joints()[place.child].radius;
    if (place.distance <= parent_radius && place.distance < inside_.distance) inside_ = place;
    if (place.distance <= parent_radius + radius && place.distance < touching_.distance) touching_ = place;
}

void ConnectionKernel::connect() {
    const Place& place = inside_.child != no_number ? inside_ : touching_;
    if (place.child == no_number) return;
    out_.joint = place.child;
    out_.event = PartLink::Event::joint_connect;
    out_.parent_joint = place.joint;
    if (place.bone != no_number) {
        const BoneGraph::Bone bone = graph_.bones()[place.bone];
        const BoneGraph::Joint &from = graph_.joints()[bone.joints[0]], &to = graph_.joints()[bone.joints[1]];
        if (place.share <= no_length) {
            out_.parent_joint = bone.joints[0];
        } else if (place.share >= 1 - no_length) {
            out_.parent_joint = bone.joints[1];
        } else {
            const Vec3 at = from.at + place.share * (to.at - from.at);
            out_.event = PartLink::Event::bone_split;
            out_.parent_joint = graph_.split(place.bone, at, std::lerp(from.radius, to.radius, place.share));
        }
    }
    out_.parent = graph_.joints()[out_.parent_joint].part;
    graph_.add_bone(out_.parent_joint, place.child, no_number);
}

}  // namespace flg
