// SPDX-License-Identifier: MIT
#include "bones/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr double at_an_end = 1e-9;  // of a bone's length
constexpr double nearness = 1.1;    // of two balls' radii: balls are smaller than what they are in

// Where a joint could be connected.
struct Place {
    double distance = std::numeric_limits<double>::infinity();
    uint32_t child = no_number;
    uint32_t bone = no_number, joint = no_number;  // nearest to a bone, or to a joint that has none
    double share = 0;                              // along the bone, in [0, 1]
};

// What is near a point: how, of which part, and the radius there.
struct Nearby {
    Place place;
    double radius;
    uint32_t part;
};

// What the new part is connected with: bones, and joints that have none.
class EarlierParts {
public:
    EarlierParts(const BoneGraph& graph, const NewPart& part, Memory* memory)
        : graph_(graph),
          part_(part),
          low_(Vec3::Constant(std::numeric_limits<double>::infinity())),
          high_(-low_),
          near_(memory) {}

    // The box that they have to reach.
    void widen(const Vec3& at, double radius) {
        low_ = low_.cwiseMin(at - Vec3::Constant(nearness * radius));
        high_ = high_.cwiseMax(at + Vec3::Constant(nearness * radius));
    }

    // Lists a bone, or a joint after all bones. Returns what that cost.
    uint32_t list(uint32_t number) {
        const auto& joints = graph_.joints();
        if (number < part_.first_bone) {
            const BoneGraph::Bone& bone = graph_.bones()[number];
            if (bone.gone || bone.part == no_number || bone.part == part_.twin) return 1;
            if (reaches(joints[bone.joints[0]], joints[bone.joints[1]])) near_.push_back(number);
            return 1;
        }
        const uint32_t joint = number - part_.first_bone;
        uint32_t work = 1;
        if (!graph_.is_there(joint) || joints[joint].part == part_.twin || !reaches(joints[joint], joints[joint]))
            return work;
        for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end), ++work)
            if (graph_.bones()[BoneGraph::bone_of(end)].part != no_number) return work;
        near_.push_back(number);
        return work;
    }

    uint32_t count() const { return static_cast<uint32_t>(near_.size()); }

    Nearby from(const Vec3& point, uint32_t child, uint32_t i) const {
        const uint32_t number = near_[i];
        if (number >= part_.first_bone) {
            const uint32_t joint = number - part_.first_bone;
            const BoneGraph::Joint& j = graph_.joints()[joint];
            return {{(point - j.at).norm(), child, no_number, joint, 0}, j.radius, j.part};
        }
        const BoneGraph::Bone& bone = graph_.bones()[number];
        const BoneGraph::Joint &a = graph_.joints()[bone.joints[0]], &b = graph_.joints()[bone.joints[1]];
        const Vec3 along = b.at - a.at;
        const double length2 = along.squaredNorm();
        const double share = length2 > 0 ? std::clamp((point - a.at).dot(along) / length2, 0.0, 1.0) : 0;
        const double distance = (point - a.at - share * along).norm();
        return {{distance, child, number, no_number, share}, std::lerp(a.radius, b.radius, share), bone.part};
    }

private:
    bool reaches(const BoneGraph::Joint& a, const BoneGraph::Joint& b) const {
        const double radius = nearness * std::max(a.radius, b.radius);
        return ((a.at.cwiseMin(b.at) - high_).array() <= radius).all() &&
               ((low_ - a.at.cwiseMax(b.at)).array() <= radius).all();
    }

    const BoneGraph& graph_;
    const NewPart& part_;
    Vec3 low_, high_;
    std::pmr::vector<uint32_t> near_;  // bones, then joints
};

// From ends and junctions of the new part to all that is near.
Task<Place> nearest_of_joints(Pace& pace, const BoneGraph& graph, const NewPart& part, const EarlierParts& earlier) {
    Place inside, touching;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t j = part.first_joint; j < graph.joints().size(); ++j) {
        const BoneGraph::Joint& joint = graph.joints()[j];
        for (uint32_t i = 0; joint.degree != 2 && i < earlier.count(); ++i) {
            const Nearby near = earlier.from(joint.at, j, i);
            const double distance = near.place.distance;
            if (distance <= near.radius && distance < inside.distance) inside = near.place;
            if (distance <= nearness * (near.radius + joint.radius) && distance < touching.distance)
                touching = near.place;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    co_return inside.child != no_number ? inside : touching;
}

// The same with those parts only that a point of the outline is in, however far.
Task<Place> nearest_by_outline(Pace& pace, const BoneGraph& graph, const NewPart& part, const EarlierParts& earlier) {
    std::pmr::vector<bool> meets(part.number, false, pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (const Vec3& point : part.outline) {
        for (uint32_t i = 0; i < earlier.count(); ++i) {
            const Nearby near = earlier.from(point, no_number, i);
            if (near.place.distance <= near.radius) meets[near.part] = true;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    Place nearest;
    for (uint32_t j = part.first_joint; j < graph.joints().size(); ++j) {
        const BoneGraph::Joint& joint = graph.joints()[j];
        for (uint32_t i = 0; joint.degree != 2 && i < earlier.count(); ++i) {
            const Nearby near = earlier.from(joint.at, j, i);
            if (meets[near.part] && near.place.distance < nearest.distance) nearest = near.place;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    co_return nearest;
}

PartLink connect(BoneGraph& graph, const Place& place) {
    PartLink link;
    if (place.child == no_number) return link;
    link.joint = place.child;
    link.event = PartLink::Event::joint_connect;
    link.parent_joint = place.joint;
    if (place.bone != no_number) {
        const BoneGraph::Bone bone = graph.bones()[place.bone];
        const BoneGraph::Joint &from = graph.joints()[bone.joints[0]], &to = graph.joints()[bone.joints[1]];
        if (place.share <= at_an_end) {
            link.parent_joint = bone.joints[0];
        } else if (place.share >= 1 - at_an_end) {
            link.parent_joint = bone.joints[1];
        } else {
            const Vec3 at = from.at + place.share * (to.at - from.at);
            link.event = PartLink::Event::bone_split;
            link.parent_joint = graph.split(place.bone, at, std::lerp(from.radius, to.radius, place.share));
        }
    }
    link.parent = graph.joints()[link.parent_joint].part;
    graph.add_bone(link.parent_joint, place.child, no_number);
    return link;
}

}  // namespace

Task<PartLink> connect_part(Pace& pace, BoneGraph& graph, NewPart part) {
    EarlierParts earlier(graph, part, pace.memory());
    const auto joints = static_cast<uint32_t>(graph.joints().size()) - part.first_joint;
    co_await each(pace, joints + part.outline.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (i >= joints) return earlier.widen(part.outline[i - joints], 0);
        const BoneGraph::Joint& joint = graph.joints()[part.first_joint + i];
        earlier.widen(joint.at, joint.radius);
    });
    co_await each_by_work(pace, part.first_bone + part.first_joint, Cost::tens_of_ns,
                          [&](uint32_t number) { return earlier.list(number); });
    Place place;
    if (earlier.count() > 0) place = co_await nearest_of_joints(pace, graph, part, earlier);
    if (earlier.count() > 0 && place.child == no_number)
        place = co_await nearest_by_outline(pace, graph, part, earlier);
    co_return connect(graph, place);
}

}  // namespace flg
