// SPDX-License-Identifier: MIT
#include "bones/connection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr double at_an_end = 1e-9;      // of a bone's length
constexpr double nearness = 1.1;        // of two balls' radii: balls are smaller than what they are in
constexpr double little_nearer = 1.25;  // how much farther a limb's upper end may be and still count
constexpr double across_gap = 1.4;      // likewise: what was meant to meet
constexpr double meets_image = 2;       // of a ball's radius, from the mirror: tips reach beyond their balls
constexpr double off_image = 1.5;       // likewise, of the end of an arm whose hand meets its image
constexpr double alike = 0.1;           // of the radius: how far from each other's mirror images joints may be
constexpr double thicker = 1.25;  // an arm that lies over the chest hangs by its shoulder: the end that is so thick

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

// A box around a part, as far as its joints reach.
struct Reach {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;

    void widen(const Vec3& at, double radius) {
        low = low.cwiseMin(at - Vec3::Constant(nearness * radius));
        high = high.cwiseMax(at + Vec3::Constant(nearness * radius));
    }
    bool meets(const BoneGraph::Joint& a, const BoneGraph::Joint& b) const {
        const double radius = nearness * std::max(a.radius, b.radius);
        return ((a.at.cwiseMin(b.at) - high).array() <= radius).all() &&
               ((low - a.at.cwiseMax(b.at)).array() <= radius).all();
    }
};

Nearby near_bone(const BoneGraph& graph, uint32_t number, const Vec3& point, uint32_t child) {
    const BoneGraph::Bone& bone = graph.bones()[number];
    const BoneGraph::Joint &a = graph.joints()[bone.joints[0]], &b = graph.joints()[bone.joints[1]];
    const Vec3 along = b.at - a.at;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((point - a.at).dot(along) / length2, 0.0, 1.0) : 0;
    const double distance = (point - a.at - share * along).norm();
    return {{distance, child, number, no_number, share}, std::lerp(a.radius, b.radius, share), bone.part};
}

// Bones, and joints that have none, of the parts that count.
class Candidates {
public:
    Candidates(const BoneGraph& graph, const Reach* reach, Memory* memory)
        : graph_(graph), reach_(reach), near_(memory) {}

    // Lists a bone, or a joint after all bones. Returns what that cost.
    template <class Counts>
    uint32_t list(uint32_t number, Counts counts) {
        const auto& joints = graph_.joints();
        const auto bones = static_cast<uint32_t>(graph_.bones().size());
        if (number < bones) {
            const BoneGraph::Bone& bone = graph_.bones()[number];
            if (bone.gone || bone.part == no_number || !counts(bone.part)) return 1;
            if (is_near(joints[bone.joints[0]], joints[bone.joints[1]])) near_.push_back(number);
            return 1;
        }
        const uint32_t joint = number - bones;
        uint32_t work = 1;
        if (!graph_.is_there(joint) || !counts(joints[joint].part) || !is_near(joints[joint], joints[joint]))
            return work;
        for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end), ++work)
            if (graph_.bones()[BoneGraph::bone_of(end)].part != no_number) return work;
        near_.push_back(number);
        return work;
    }

    uint32_t count() const { return static_cast<uint32_t>(near_.size()); }

    Nearby from(const Vec3& point, uint32_t child, uint32_t i) const {
        const uint32_t number = near_[i];
        const auto bones = static_cast<uint32_t>(graph_.bones().size());
        if (number < bones) return near_bone(graph_, number, point, child);
        const BoneGraph::Joint& j = graph_.joints()[number - bones];
        return {{(point - j.at).norm(), child, no_number, number - bones, 0}, j.radius, j.part};
    }

private:
    bool is_near(const BoneGraph::Joint& a, const BoneGraph::Joint& b) const { return !reach_ || reach_->meets(a, b); }

    const BoneGraph& graph_;
    const Reach* reach_;
    std::pmr::vector<uint32_t> near_;  // bones, then joints
};

// Ends and junctions of a part.
Task<std::pmr::vector<uint32_t>> list_ends(Pace& pace, const BoneGraph& graph, const NewPart& part) {
    std::pmr::vector<uint32_t> ends(pace.memory());
    co_await each(pace, part.first_joint, part.end_joint, Cost::some_ns, [&](uint32_t j) {
        if (graph.is_there(j) && graph.is_end(j)) ends.push_back(j);
    });
    co_return ends;
}

using Ends = std::span<const uint32_t>;

// Of a limb's two ends the one that is much thicker.
bool is_thick_end(const BoneGraph& graph, Ends ends, uint32_t end) {
    if (ends.size() != 2) return false;
    const uint32_t other = ends[0] == end ? ends[1] : ends[0];
    return graph.joints()[end].radius > thicker * graph.joints()[other].radius;
}

// Of a limb's two ends the upper one, where neither is much thicker.
uint32_t upper_end(const BoneGraph& graph, Ends ends) {
    if (ends.size() != 2 || is_thick_end(graph, ends, ends[0]) || is_thick_end(graph, ends, ends[1])) return no_number;
    const BoneGraph::Joint &a = graph.joints()[ends[0]], &b = graph.joints()[ends[1]];
    const double rise = a.at.y() - b.at.y();
    if (std::abs(rise) <= a.radius + b.radius) return no_number;
    return ends[rise > 0 ? 0 : 1];
}

// From ends and junctions to what counts.
struct Nearest {
    Place inside, touching;
};

Task<Nearest> nearest_of(Pace& pace, const BoneGraph& graph, Ends ends, const Candidates& candidates) {
    Nearest nearest;
    Place thick;
    Slice slice(Cost::tens_of_ns);
    for (const uint32_t j : ends) {
        const BoneGraph::Joint& joint = graph.joints()[j];
        Nearest own;
        for (uint32_t i = 0; i < candidates.count(); ++i) {
            const Nearby near = candidates.from(joint.at, j, i);
            const double distance = near.place.distance;
            if (distance <= near.radius && distance < own.inside.distance) own.inside = near.place;
            if (distance <= nearness * (near.radius + joint.radius) && distance < own.touching.distance)
                own.touching = near.place;
            if (slice.is_over()) co_await pace;
        }
        if (is_thick_end(graph, ends, j)) thick = own.inside.child != no_number ? own.inside : own.touching;
        if (own.inside.distance < nearest.inside.distance) nearest.inside = own.inside;
        if (own.touching.distance < nearest.touching.distance) nearest.touching = own.touching;
        if (slice.is_over()) co_await pace;
    }
    if (nearest.inside.child != no_number && thick.child != no_number) nearest.inside = thick;
    co_return nearest;
}

// The nearest place of the parts that count, however far.
template <class Counts>
Task<Place> nearest_in(Pace& pace, const BoneGraph& graph, Ends ends, const Candidates& candidates, Counts counts) {
    Place nearest;
    Slice slice(Cost::tens_of_ns);
    for (const uint32_t j : ends) {
        for (uint32_t i = 0; i < candidates.count(); ++i) {
            const Nearby near = candidates.from(graph.joints()[j].at, j, i);
            if (counts(near.part) && near.place.distance < nearest.distance) nearest = near.place;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    co_return nearest;
}

// The same with those parts only that a point of the outline is in.
Task<Place> nearest_by_outline(Pace& pace, const BoneGraph& graph, Ends ends, const NewPart& part,
                               const Candidates& candidates, size_t parts) {
    std::pmr::vector<bool> meets(parts, false, pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (const Vec3& point : part.outline) {
        for (uint32_t i = 0; i < candidates.count(); ++i) {
            const Nearby near = candidates.from(point, no_number, i);
            if (near.place.distance <= near.radius) meets[near.part] = true;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    co_return co_await nearest_in(pace, graph, ends, candidates, [&](uint32_t p) { return meets[p]; });
}

// The place across the least gap, as between the blocks of a figure; no farther than so many times both radii.
Task<Place> nearest_across_gap(Pace& pace, const BoneGraph& graph, Ends ends, const Candidates& candidates,
                               double reach) {
    Place nearest;
    double least = 0;
    Slice slice(Cost::tens_of_ns);
    for (const uint32_t j : ends) {
        const BoneGraph::Joint& joint = graph.joints()[j];
        for (uint32_t i = 0; i < candidates.count(); ++i) {
            const Nearby near = candidates.from(joint.at, j, i);
            const double radii = near.radius + joint.radius, gap = near.place.distance - radii;
            const bool is_near = near.place.distance <= reach * radii;
            if (is_near && (nearest.child == no_number || gap < least)) nearest = near.place, least = gap;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    co_return nearest;
}

template <class Counts>
Task<void> list_all(Pace& pace, const BoneGraph& graph, Candidates& candidates, Counts counts) {
    co_await each_by_work(pace, graph.bones().size() + graph.joints().size(), Cost::tens_of_ns,
                          [&](uint32_t number) { return candidates.list(number, counts); });
}

// The nearest place of one part to one joint, however far.
Task<Place> nearest_of_part(Pace& pace, const BoneGraph& graph, uint32_t end, uint32_t part) {
    const auto counts = [part](uint32_t p) { return p == part; };
    Candidates candidates(graph, nullptr, pace.memory());
    co_await list_all(pace, graph, candidates, counts);
    const uint32_t ends[] = {end};
    co_return co_await nearest_in(pace, graph, ends, candidates, counts);
}

// The nearest place of a wide part that an end is in.
Task<Place> nearest_in_wide(Pace& pace, const BoneGraph& graph, Ends ends, const OtherParts& others) {
    Place nearest;
    for (uint32_t p = 0; p < others.shapes.size(); ++p) {
        if (!others.shapes[p].outline || !others.may_meet[p]) continue;
        for (const uint32_t end : ends) {
            const BoneGraph::Joint& joint = graph.joints()[end];
            const bool meets = co_await meets_ball(pace, others.shapes[p], joint.at, joint.radius);
            if (!meets) continue;
            const Place place = co_await nearest_of_part(pace, graph, end, p);
            if (place.distance < nearest.distance) nearest = place;
        }
    }
    co_return nearest;
}

uint32_t part_at(const BoneGraph& graph, const Place& place) {
    return place.bone != no_number ? graph.bones()[place.bone].part : graph.joints()[place.joint].part;
}

Vec3 point_at(const BoneGraph& graph, const Place& place) {
    if (place.bone == no_number) return graph.joints()[place.joint].at;
    const auto& ends = graph.bones()[place.bone].joints;
    const Vec3 &from = graph.joints()[ends[0]].at, &to = graph.joints()[ends[1]].at;
    return from + place.share * (to - from);
}

// From the root end of a limb to what the limb hangs on, if the joint is inside of that too.
Task<Place> towards_trunk(Pace& pace, const BoneGraph& graph, Place place, const OtherParts& others) {
    const BoneGraph::Joint& joint = graph.joints()[place.child];
    while (!others.links.empty()) {
        const PartLink& link = others.links[part_at(graph, place)];
        if (link.event == PartLink::Event::root || !others.may_meet[link.parent]) break;
        const BoneGraph::Joint& root_end = graph.joints()[graph.heir(link.joint)];
        if ((point_at(graph, place) - root_end.at).norm() > nearness * (root_end.radius + joint.radius)) break;
        const Place next = co_await nearest_of_part(pace, graph, place.child, link.parent);
        if (next.child == no_number) break;
        const double radius = next.bone == no_number ? graph.joints()[next.joint].radius
                                                     : near_bone(graph, next.bone, joint.at, next.child).radius;
        bool is_inside = next.distance <= radius;
        if (!is_inside && !others.shapes.empty() && others.shapes[link.parent].outline)
            is_inside = co_await meets_ball(pace, others.shapes[link.parent], joint.at, joint.radius);
        if (!is_inside) break;
        place = next;
    }
    co_return place;
}

// Whether a part has another end where a plane reflects one.
bool has_mirror_image(const BoneGraph& graph, Ends ends, uint32_t end, const MirrorPlane& plane) {
    const BoneGraph::Joint& joint = graph.joints()[end];
    const double near = alike * joint.radius, side = plane.side(joint.at);
    if (std::abs(side) <= near) return false;
    const Vec3 image = joint.at - 2 * side * plane.normal;
    return std::any_of(ends.begin(), ends.end(), [&](uint32_t other) {
        const BoneGraph::Joint& there = graph.joints()[other];
        return (there.at - image).norm() <= near && std::abs(there.radius - joint.radius) <= near;
    });
}

// The joint of a part that is nearest to a place of those on a plane, or a new one where a bone crosses it.
uint32_t joint_on_plane(BoneGraph& graph, const NewPart& part, const MirrorPlane& plane, const Vec3& place) {
    uint32_t joint = no_number, bone = no_number;
    double least = std::numeric_limits<double>::infinity(), share = 0;
    const auto side_of = [&](uint32_t j) { return plane.side(graph.joints()[j].at); };
    for (uint32_t j = part.first_joint; j < part.end_joint; ++j) {
        if (!graph.is_there(j) || std::abs(side_of(j)) > alike * graph.joints()[j].radius) continue;
        const double distance = (graph.joints()[j].at - place).norm();
        if (distance < least) joint = j, least = distance;
    }
    if (joint != no_number) return joint;
    const auto point_on = [&](uint32_t b, double along) { return point_at(graph, Place{.bone = b, .share = along}); };
    for (uint32_t b = 0; b < graph.bones().size(); ++b) {
        const auto& ends = graph.bones()[b].joints;
        if (graph.bones()[b].gone || graph.bones()[b].part != part.number) continue;
        const double from = side_of(ends[0]), to = side_of(ends[1]);
        if (from * to >= 0) continue;
        const double distance = (point_on(b, from / (from - to)) - place).norm();
        if (distance < least) bone = b, least = distance, share = from / (from - to);
    }
    if (bone == no_number) return no_number;
    const auto& ends = graph.bones()[bone].joints;
    return graph.split(bone, point_on(bone, share),
                       std::lerp(graph.joints()[ends[0]].radius, graph.joints()[ends[1]].radius, share));
}

// Of a part that lies across the mirror plane of what it hangs on, alike to both sides: by its middle.
Task<Place> by_middle(Pace& pace, BoneGraph& graph, Place place, Ends ends, NewPart part, OtherParts others) {
    if (others.mirrors.empty()) co_return place;
    const uint32_t on = part_at(graph, place);
    const MirrorPlane& plane = others.mirrors[on];
    if (!has_mirror_image(graph, ends, place.child, plane)) co_return place;
    const uint32_t middle = joint_on_plane(graph, part, plane, point_at(graph, place));
    if (middle == no_number) co_return place;
    co_return co_await nearest_of_part(pace, graph, middle, on);
}

// Of a part whose end meets that of its image, the end that is farthest from there.
uint32_t end_off_image(const BoneGraph& graph, Ends ends, uint32_t end, const MirrorPlane& twin) {
    if (twin.normal.isZero()) return no_number;
    const auto away = [&](uint32_t j) {
        return std::abs(twin.side(graph.joints()[j].at)) - meets_image * graph.joints()[j].radius;
    };
    if (away(end) >= 0) return no_number;
    const uint32_t farthest =
        *std::max_element(ends.begin(), ends.end(), [&](uint32_t a, uint32_t b) { return away(a) < away(b); });
    return away(farthest) > 0 ? farthest : no_number;
}

// Where that end is nearest, if that is near.
Task<Place> by_end_off_image(Pace& pace, const BoneGraph& graph, Place place, Ends ends, const NewPart& part,
                             const Candidates& candidates) {
    const uint32_t end = end_off_image(graph, ends, place.child, part.twin);
    if (end == no_number) co_return place;
    const uint32_t only[] = {end};
    const Place nearest = co_await nearest_across_gap(pace, graph, only, candidates, off_image);
    co_return nearest.child == no_number ? place : nearest;
}

PartLink connect(BoneGraph& graph, const Place& place) {
    PartLink link;
    if (place.child == no_number) return link;
    link.joint = place.child;
    link.child = graph.joints()[place.child].part;
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

Task<Reach> reach_of(Pace& pace, const BoneGraph& graph, const NewPart& part) {
    Reach reach;
    const uint32_t joints = part.end_joint - part.first_joint;
    co_await each(pace, joints + part.outline.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (i >= joints) return reach.widen(part.outline[i - joints], 0);
        const BoneGraph::Joint& joint = graph.joints()[part.first_joint + i];
        reach.widen(joint.at, joint.radius);
    });
    co_return reach;
}

}  // namespace

Task<PartLink> connect_part(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others) {
    const auto counts = [&](uint32_t p) {
        return others.may_meet.empty() ? p != part.number : others.may_meet[p] != 0;
    };
    const Reach reach = co_await reach_of(pace, graph, part);
    Candidates candidates(graph, &reach, pace.memory());
    co_await list_all(pace, graph, candidates, counts);
    const auto ends = co_await list_ends(pace, graph, part);
    const Nearest nearest = co_await nearest_of(pace, graph, ends, candidates);
    Place place = nearest.inside;
    if (place.child == no_number) place = co_await nearest_in_wide(pace, graph, ends, others);
    const uint32_t upper = upper_end(graph, ends), only[] = {upper};
    if (place.child != no_number && upper != no_number && place.child != upper) {
        const Nearest above = co_await nearest_of(pace, graph, only, candidates);
        Place higher = above.inside;
        if (higher.child == no_number) higher = co_await nearest_in_wide(pace, graph, only, others);
        if (higher.child != no_number) place = higher;
    }
    if (place.child == no_number) place = nearest.touching;
    if (place.child == no_number && candidates.count() > 0) {
        const size_t parts = std::max<size_t>(others.may_meet.size(), part.number);
        place = co_await nearest_by_outline(pace, graph, ends, part, candidates, parts);
    }
    if (place.child != no_number) place = co_await by_end_off_image(pace, graph, place, ends, part, candidates);
    if (place.child != no_number) place = co_await by_middle(pace, graph, place, ends, part, others);
    if (place.child != no_number) place = co_await towards_trunk(pace, graph, place, others);
    co_return connect(graph, place);
}

Task<PartLink> connect_to_part(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others) {
    const Reach reach = co_await reach_of(pace, graph, part);
    std::pmr::vector<uint32_t> ends(pace.memory());
    co_await each(pace, graph.joints().size(), Cost::tens_of_ns, [&](uint32_t j) {
        const BoneGraph::Joint& joint = graph.joints()[j];
        if (!others.may_meet[joint.part] || !graph.is_there(j) || !graph.is_end(j)) return;
        if (reach.meets(joint, joint)) ends.push_back(j);
    });
    if (ends.empty()) co_return PartLink{};
    Candidates candidates(graph, nullptr, pace.memory());
    co_await list_all(pace, graph, candidates, [&](uint32_t p) { return p == part.number; });
    const Nearest nearest = co_await nearest_of(pace, graph, ends, candidates);
    Place place = nearest.inside;
    if (place.child == no_number && !others.shapes.empty() && others.shapes[part.number].outline) {
        for (const uint32_t end : ends) {
            const BoneGraph::Joint& joint = graph.joints()[end];
            const bool meets = co_await meets_ball(pace, others.shapes[part.number], joint.at, joint.radius);
            if (!meets) continue;
            const Place next = co_await nearest_of_part(pace, graph, end, part.number);
            if (next.distance < place.distance) place = next;
        }
    }
    co_return connect(graph, place);
}

Task<PartLink> connect_across_gap(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others) {
    Candidates candidates(graph, nullptr, pace.memory());
    co_await list_all(pace, graph, candidates, [&](uint32_t p) { return others.may_meet[p] != 0; });
    const auto ends = co_await list_ends(pace, graph, part);
    Place place = co_await nearest_across_gap(pace, graph, ends, candidates, across_gap);
    const uint32_t upper = upper_end(graph, ends), only[] = {upper};
    // An arm beside the body hangs by its shoulder, even if its hand is a little nearer.
    Place higher;
    if (upper != no_number) higher = co_await nearest_across_gap(pace, graph, only, candidates, across_gap);
    if (higher.child != no_number && higher.distance <= little_nearer * place.distance) place = higher;
    co_return connect(graph, place);
}

Task<PartLink> connect_anyway(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others) {
    Candidates candidates(graph, nullptr, pace.memory());
    co_await list_all(pace, graph, candidates, [&](uint32_t p) { return others.may_meet[p] != 0; });
    const auto ends = co_await list_ends(pace, graph, part);
    co_return connect(graph, co_await nearest_in(pace, graph, ends, candidates, [](uint32_t) { return true; }));
}

}  // namespace flg
