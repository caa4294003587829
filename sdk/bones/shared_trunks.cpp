// SPDX-License-Identifier: MIT
#include "bones/shared_trunks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t most_branches = 5;     // at a junction: a palm, a hub of more, is none of a trunk
constexpr double parallel = 0.766;        // cosine of the angle between limbs beyond
constexpr double step_length = 1.0 / 16;  // of the trunk's width at the junction
constexpr int halvings = 40;              // of the last step
constexpr double as_wide = 1.6;           // by the limbs side by side: what else the trunk may be
constexpr double least_trunk = 0.6;       // of what merges junctions
constexpr double least_limb = 0.5;        // what is left of a branch beyond the trunk, of half the trunk's width
constexpr double near_axis = 1e-9;        // of a part's length

// A point of a branch.
struct WayPoint {
    Vec3 at;
    double radius;
    size_t bone;  // of the way's
    double share;
};

// A branch as it leaves a junction: its joints to the next junction or end, and how far along they are.
class Way {
public:
    Way(const BoneGraph& graph, uint32_t junction, uint32_t bone, Memory* memory)
        : graph_(&graph), joints_(memory), along_(memory) {
        add(junction, 0);
        BoneGraph::Walk walk = graph.begin_walk(junction, bone);
        do add(walk.joint, walk.length);
        while (graph.go_on(walk));
    }

    double length() const { return along_.back(); }
    const std::pmr::vector<uint32_t>& joints() const { return joints_; }

    WayPoint at(double along) const {
        size_t bone = 0;
        while (bone + 2 < along_.size() && along_[bone + 1] < along) ++bone;
        const double length = along_[bone + 1] - along_[bone];
        const double share = length > 0 ? std::clamp((along - along_[bone]) / length, 0.0, 1.0) : 0;
        const BoneGraph::Joint &a = graph_->joints()[joints_[bone]], &b = graph_->joints()[joints_[bone + 1]];
        return {a.at + share * (b.at - a.at), std::lerp(a.radius, b.radius, share), bone, share};
    }

private:
    void add(uint32_t joint, double along) {
        joints_.push_back(joint);
        along_.push_back(along);
    }

    const BoneGraph* graph_;
    std::pmr::vector<uint32_t> joints_;
    std::pmr::vector<double> along_;
};

struct Pair {
    const Way *first, *second;

    double most() const { return std::min(first->length(), second->length()); }
    Vec3 middle(double along) const { return (first->at(along).at + second->at(along).at) / 2; }
    double radius(double along) const { return (first->at(along).radius + second->at(along).radius) / 2; }
    // `widening`: of half the width in the drawing, by the radius of a joint.
    bool is_one(double along, double widening) const {
        const WayPoint a = first->at(along), b = second->at(along);
        return (a.at - b.at).norm() <= widening * std::min(a.radius, b.radius);
    }
    // Whether the limbs go the same way beyond, over about their trunk's width.
    bool goes_one_way(double along, double width) const {
        const Vec3 a = first->at(along + width).at - first->at(along).at;
        const Vec3 b = second->at(along + width).at - second->at(along).at;
        return a.dot(b) >= parallel * a.norm() * b.norm();
    }
};

class Sharer {
public:
    Sharer(Pace& pace, const ModelPart& part, double merge, BoneGraph& graph)
        : pace_(pace), part_(part), merge_(merge), widening_(2 / (1 + part.thickness)), graph_(graph) {}

    Task<void> share() {
        const auto count = static_cast<uint32_t>(graph_.joints().size());
        for (uint32_t j = 0; j < count; ++j) {
            const uint32_t degree = graph_.is_there(j) ? graph_.joints()[j].degree : 0;
            if (degree >= 3 && degree <= most_branches) co_await look_at(j);
            co_await pace_;
        }
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    Task<void> look_at(uint32_t junction) {
        std::pmr::vector<Way> ways(pace_.memory());
        for (uint32_t end = graph_.first_end(junction); end != no_number; end = graph_.next_end(end)) {
            ways.emplace_back(graph_, junction, BoneGraph::bone_of(end), pace_.memory());
            co_await pace_;
        }
        std::optional<Pair> best;
        double best_along = 0, farthest = least_trunk * merge_;
        for (size_t b = 1; b < ways.size(); ++b)
            for (size_t a = 0; a < b; ++a) {
                const Pair pair{&ways[a], &ways[b]};
                const double along = co_await together(pair, graph_.joints()[junction].radius);
                if (!is_trunk(junction, pair, along)) continue;
                const double reach = (pair.middle(along) - graph_.joints()[junction].at).norm();
                if (reach > farthest) best = pair, best_along = along, farthest = reach;
            }
        if (!best) co_return;
        const bool is_inside = co_await stays_inside(junction, *best, best_along);
        const bool is_all = co_await becomes_both(*best, best_along);
        if (is_inside && is_all) make_trunk(junction, *best, best_along);
    }

    // How far along both.
    Task<double> together(Pair pair, double radius) const {
        const double step = 2 * step_length * widening_ * radius;
        if (!(step > 0)) co_return 0;
        double along = 0;
        Slice slice(Cost::tens_of_ns);
        while (along + step < pair.most() && pair.is_one(along + step, widening_)) {
            along += step;
            if (slice.is_over()) co_await pace_;
        }
        double beyond = std::min(along + step, pair.most());
        for (int i = 0; i < halvings; ++i) {
            const double middle = (along + beyond) / 2;
            (pair.is_one(middle, widening_) ? along : beyond) = middle;
        }
        co_return along;
    }

    bool is_trunk(uint32_t junction, const Pair& pair, double along) const {
        const double half_width = widening_ * pair.radius(along);
        if (pair.most() - along < least_limb * half_width || !pair.goes_one_way(along, 2 * half_width)) return false;
        return graph_.joints()[junction].hold != BoneGraph::Hold::middle || is_on_axis(pair.middle(along));
    }
    bool is_on_axis(const Vec3& at) const {
        const HeldPart& part = *part_.part;
        return part.mirror && std::abs(part.mirror->side(part_.drawn(at))) <= near_axis * part.length;
    }

    uint32_t pieces(uint32_t junction, const Pair& pair, double along) const {
        const double length = (pair.middle(along) - graph_.joints()[junction].at).norm();
        return pieces_of(length, 2 * widening_ * pair.radius(along / 2), part_.thresholds.detail);
    }

    Task<bool> stays_inside(uint32_t junction, Pair pair, double along) const {
        const uint32_t count = pieces(junction, pair, along);
        Vec3 from = graph_.joints()[junction].at;
        for (uint32_t k = 1; k <= count; ++k) {
            const Vec3 to = pair.middle(along * k / count);
            const bool is_inside = co_await lies_inside(from, to);
            if (!is_inside) co_return false;
            from = to;
        }
        const bool first = co_await lies_inside(from, pair.first->at(along).at);
        const bool second = co_await lies_inside(from, pair.second->at(along).at);
        co_return first&& second;
    }

    // Whether the trunk is as wide where it ends as both limbs are: a palm is wider than two of its fingers.
    Task<bool> becomes_both(Pair pair, double along) const {
        const double beyond = along + widening_ * pair.radius(along);
        const double apart = (pair.first->at(along).at - pair.second->at(along).at).norm();
        const double wide = as_wide * (apart / 2 + widening_ * pair.radius(beyond));
        const Vec3 middle = pair.middle(along),
                   across = middle + wide * (pair.first->at(along).at - middle).normalized();
        const bool first = co_await lies_inside(middle, across);
        const bool second = co_await lies_inside(middle, 2 * middle - across);
        co_return !first && !second;
    }

    Task<bool> lies_inside(Vec3 from, Vec3 to) const {
        const Contour& outline = part_.part->outline;
        const Point2 a = part_.drawn(from), b = part_.drawn(to);
        bool meets = false;
        Slice slice(Cost::tens_of_ns);
        for (Portion edges(slice, 0, outline.size()); !meets && edges.next();) {
            meets = meets_edges(outline, a, b, edges.begin, edges.end);
            if (edges.is_over()) co_await pace_;
        }
        co_return !meets;
    }

    void make_trunk(uint32_t junction, const Pair& pair, double along) {
        const uint32_t count = pieces(junction, pair, along);
        struct Made {
            Vec3 at;
            double radius;
        };
        std::pmr::vector<Made> trunk(pace_.memory());
        for (uint32_t k = 1; k <= count; ++k)
            trunk.push_back({pair.middle(along * k / count), pair.radius(along * k / count)});
        const uint32_t limbs[2] = {cut_out(junction, *pair.first, along), cut_out(junction, *pair.second, along)};
        uint32_t end = junction;
        for (const Made& made : trunk) {
            const uint32_t next = graph_.add_joint(made.at, made.radius, graph_.joints()[junction].part);
            graph_.joints()[next].hold = graph_.joints()[junction].hold;
            graph_.add_bone(end, next, graph_.joints()[junction].part);
            end = next;
        }
        // Not to be merged with the junction again.
        graph_.joints()[end].hold = BoneGraph::Hold::pinned;
        for (const uint32_t limb : limbs) graph_.hang_on(graph_.bone_between(junction, limb), junction, end);
    }

    // The branch begins at a new joint there; what was between becomes the junction.
    uint32_t cut_out(uint32_t junction, const Way& way, double along) {
        const WayPoint place = way.at(along);
        const auto& joints = way.joints();
        const uint32_t bone = graph_.bone_between(joints[place.bone], joints[place.bone + 1]);
        const uint32_t limb = graph_.split(bone, place.at, place.radius);
        graph_.joints()[limb].own_degree = no_number;
        for (size_t i = 1; i <= place.bone; ++i) graph_.contract(graph_.bone_between(junction, joints[i]), junction);
        return limb;
    }

    Pace& pace_;
    const ModelPart& part_;
    const double merge_, widening_;
    BoneGraph& graph_;
};

}  // namespace

uint32_t pieces_of(double length, double width, double detail) {
    constexpr double bones_a_doubling = 0.75;  // of a bone's length by its width
    constexpr double most = 8;
    const double aspect = width > 0 ? length / width : 0;
    return static_cast<uint32_t>(std::clamp(std::round(bones_a_doubling * std::log2(1 + aspect * detail)), 1.0, most));
}

Task<void> share_trunks(Pace& pace, const ModelPart& part, double merge, BoneGraph& graph) {
    Sharer sharer(pace, part, merge, graph);
    co_await sharer.share();
}

}  // namespace flg
