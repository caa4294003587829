// SPDX-License-Identifier: MIT
#include "bones/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {
namespace {

constexpr uint32_t batch = 16;
constexpr double at_an_end = 1e-9;  // of a bone's length
constexpr double nearness = 1.1;    // of two balls' radii: balls are smaller than what they are in

}  // namespace

ConnectionKernel::ConnectionKernel(BoneGraph& graph, uint32_t part, uint32_t twin, uint32_t first_joint,
                                   uint32_t first_bone, std::span<const Vec3> outline, PartLink& out, Memory* memory)
    : graph_(graph),
      twin_(twin),
      first_joint_(first_joint),
      first_bone_(first_bone),
      last_joint_(static_cast<uint32_t>(graph.joints().size())),
      outline_(outline),
      out_(out),
      inside_{std::numeric_limits<double>::infinity(), no_number, no_number, no_number, 0},
      near_(inside_),
      nearest_(inside_),
      meets_(part, false, memory),
      low_(Vec3::Constant(std::numeric_limits<double>::infinity())),
      high_(-low_),
      near_numbers_(memory) {}

void ConnectionKernel::enter(Pass pass) {
    pass_ = pass;
    point_ = pass == Pass::outline ? 0 : first_joint_;
    at_ = 0;
}

bool ConnectionKernel::run(uint32_t count) {
    for (; count > 0; --count)
        if (step()) return true;
    return false;
}

void ConnectionKernel::widen(const Vec3& at, double radius) {
    low_ = low_.cwiseMin(at - Vec3::Constant(nearness * radius));
    high_ = high_.cwiseMax(at + Vec3::Constant(nearness * radius));
}

// A bone or joint without one whose ball or cone reaches the new part's box.
void ConnectionKernel::list(uint32_t number) {
    const auto reaches = [&](const BoneGraph::Joint& a, const BoneGraph::Joint& b) {
        const double radius = nearness * std::max(a.radius, b.radius);
        return ((a.at.cwiseMin(b.at) - high_).array() <= radius).all() &&
               ((low_ - a.at.cwiseMax(b.at)).array() <= radius).all();
    };
    const auto& joints = graph_.joints();
    const BoneGraph::Joint *a, *b;
    if (number < first_bone_) {
        const BoneGraph::Bone& bone = graph_.bones()[number];
        if (bone.gone || bone.part == no_number || bone.part == twin_) return;
        a = &joints[bone.joints[0]], b = &joints[bone.joints[1]];
    } else {
        a = b = &joints[number - first_bone_];
        if (!graph_.is_there(number - first_bone_) || a->part == twin_) return;
    }
    if (reaches(*a, *b)) near_numbers_.push_back(number);
}

bool ConnectionKernel::step() {
    const uint32_t all = first_bone_ + first_joint_;
    switch (pass_) {
        case Pass::box:
            if (at_ < last_joint_ - first_joint_) {
                const BoneGraph::Joint& joint = graph_.joints()[first_joint_ + at_++];
                widen(joint.at, joint.radius);
            } else if (at_ - (last_joint_ - first_joint_) < outline_.size()) {
                widen(outline_[at_++ - (last_joint_ - first_joint_)], 0);
            } else {
                enter(Pass::list);
            }
            return false;
        case Pass::list:
            for (uint32_t k = 0; k < batch && at_ < all; ++k) list(at_++);
            if (at_ == all) enter(Pass::joints);
            return false;
        default: return compare();
    }
}

bool ConnectionKernel::compare() {
    const bool is_outline = pass_ == Pass::outline;
    if (point_ == (is_outline ? outline_.size() : last_joint_)) {
        if (pass_ == Pass::joints && inside_.child == no_number && near_.child == no_number) {
            enter(Pass::outline);
        } else if (is_outline) {
            enter(Pass::nearest);
        } else {
            connect(inside_.child != no_number ? inside_ : near_.child != no_number ? near_ : nearest_);
            return true;
        }
        return false;
    }
    const auto all = static_cast<uint32_t>(near_numbers_.size()), end = std::min(at_ + batch, all);
    // Ends and junctions of the new part; those of two bones are none.
    const bool counts = is_outline || graph_.joints()[point_].degree != 2;
    for (; counts && at_ < end; ++at_)
        look(is_outline ? outline_[point_] : graph_.joints()[point_].at, is_outline ? no_number : point_,
             near_numbers_[at_]);
    if (end == all || !counts) {
        ++point_;
        at_ = 0;
    }
    return false;
}

ConnectionKernel::Place ConnectionKernel::from(const Vec3& point, uint32_t child, uint32_t number, double& radius,
                                               uint32_t& part) const {
    Place place{std::numeric_limits<double>::infinity(), child, no_number, no_number, 0};
    if (number < first_bone_) {
        const BoneGraph::Bone& bone = graph_.bones()[number];
        part = bone.part;
        const BoneGraph::Joint &a = graph_.joints()[bone.joints[0]], &b = graph_.joints()[bone.joints[1]];
        const Vec3 along = b.at - a.at;
        const double length2 = along.squaredNorm();
        place.bone = number;
        place.share = length2 > 0 ? std::clamp((point - a.at).dot(along) / length2, 0.0, 1.0) : 0;
        place.distance = (point - a.at - place.share * along).norm();
        radius = std::lerp(a.radius, b.radius, place.share);
        return place;
    }
    const uint32_t joint = number - first_bone_;
    const BoneGraph::Joint& j = graph_.joints()[joint];
    part = j.part;
    for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end))
        if (graph_.bones()[BoneGraph::bone_of(end)].part != no_number) return place;
    place.joint = joint;
    place.distance = (point - j.at).norm();
    radius = j.radius;
    return place;
}

void ConnectionKernel::look(const Vec3& point, uint32_t child, uint32_t number) {
    double radius = 0;
    uint32_t part = no_number;
    const Place place = from(point, child, number, radius, part);
    if (!std::isfinite(place.distance)) return;
    switch (pass_) {
        case Pass::joints:
            if (place.distance <= radius && place.distance < inside_.distance) inside_ = place;
            radius = nearness * (radius + graph_.joints()[child].radius);
            if (place.distance <= radius && place.distance < near_.distance) near_ = place;
            return;
        case Pass::outline: meets_[part] = meets_[part] || place.distance <= radius; return;
        default:
            if (meets_[part] && place.distance < nearest_.distance) nearest_ = place;
            return;
    }
}

void ConnectionKernel::connect(const Place& place) {
    if (place.child == no_number) return;
    out_.joint = place.child;
    out_.event = PartLink::Event::joint_connect;
    out_.parent_joint = place.joint;
    if (place.bone != no_number) {
        const BoneGraph::Bone bone = graph_.bones()[place.bone];
        const BoneGraph::Joint &from = graph_.joints()[bone.joints[0]], &to = graph_.joints()[bone.joints[1]];
        if (place.share <= at_an_end) {
            out_.parent_joint = bone.joints[0];
        } else if (place.share >= 1 - at_an_end) {
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
