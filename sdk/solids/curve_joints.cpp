// SPDX-License-Identifier: MIT
#include "solids/curve_joints.h"

#include <algorithm>
#include <cmath>

#include "bones/refinement.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t nothing = UINT32_MAX;
constexpr double leaves_at = 0.85;         // of the radius: how far from where it branches off a limb leaves the trunk
constexpr double is_root = 0.5;            // of the radius there: how near to the root a fork is it
constexpr double is_thinner = 0.85;        // of the radius there: what leaves the trunk, and does not go on with it
constexpr double shape_weight = 0.25;      // of how the radius deviates, against the way (as FlgModelDesc has it)
constexpr double bones_a_doubling = 0.75;  // of a bone's length by its width (as in bones/part_joints.cpp)
constexpr double window = 0.3;             // of a piece: so far a joint may be from the even place
constexpr double evenness = 0.2;           // of the radius: what an elbow is deeper by than the even place
constexpr uint32_t most_pieces = 8;

// From one end or fork of the curves to the next.
using Chain = std::pmr::vector<uint32_t>;

class Chooser {
public:
    Chooser(Pace& pace, const CurveSkeleton& curves, const SolidFrame& frame, FlgBoneThresholds thresholds, double size)
        : pace_(pace),
          nodes_(curves.nodes),
          frame_(frame),
          detail_(static_cast<double>(thresholds.detail)),
          thresholds_(thresholds),
          size_(size),
          joint_of_(nodes_.size(), pace.memory()),
          image_of_(nodes_.size(), pace.memory()),
          graph_(pace.memory()) {}

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

    Task<BoneTree> choose() {
        const auto count = static_cast<uint32_t>(nodes_.size());
        children_ = co_await group_by(pace_, count, count, [&](uint32_t i) {
            return nodes_[i].parent == no_curve_node ? no_key : nodes_[i].parent;
        });
        co_await each(pace_, count, Cost::some_ns, [&](uint32_t i) { joint_of_[i] = image_of_[i] = nothing; });
        add_joint(0);
        graph_.joints()[0].hold = BoneGraph::Hold::pinned;
        Chain chain(pace_.memory());
        // Parents come first, so where a chain begins there is a joint.
        for (uint32_t i = 0; i < count; ++i) {
            if (!is_key(i)) continue;
            for (const uint32_t child : children_.of(i)) {
                chain.assign({i, child});
                while (!is_key(chain.back())) chain.push_back(children_.of(chain.back())[0]);
                co_await add_chain(chain);
            }
        }
        const double share = size_ / (detail_ > 0 ? detail_ : 1);
        const RefinementThresholds lengths{static_cast<double>(thresholds_.merge) * share,
                                           static_cast<double>(thresholds_.prune) * share,
                                           static_cast<double>(thresholds_.collapse) * share};
        const RefinementThresholds both[] = {lengths, lengths};
        co_await refine(pace_, graph_, both);
        const uint32_t roots[] = {0};
        OrderedBones ordered = co_await order_bones(pace_, graph_, roots);
        co_return std::move(ordered.tree);
    }

private:
    const Vec3& at(uint32_t node) const { return nodes_[node].at; }
    double radius(uint32_t node) const { return nodes_[node].radius; }
    bool is_doubled(uint32_t node) const { return frame_.is_mirrored && !nodes_[node].is_middle; }
    // The root, ends, forks, and where a way and its mirror image part.
    bool is_key(uint32_t node) const {
        const auto children = children_.of(node);
        return node == 0 || children.size() != 1 || is_doubled(children[0]) != is_doubled(node);
    }

    void add_joint(uint32_t node) {
        const auto add = [&](const Vec3& place) {
            const uint32_t joint = graph_.add_joint(place, radius(node), 0);
            if (frame_.is_mirrored && nodes_[node].is_middle) graph_.joints()[joint].hold = BoneGraph::Hold::middle;
            return joint;
        };
        joint_of_[node] = image_of_[node] = add(at(node));
        if (!is_doubled(node)) return;
        const Vec3 across = frame_.axes.col(0);
        image_of_[node] = add(at(node) - 2 * across.dot(at(node) - frame_.middle) * across);
    }

    Task<void> add_chain(const Chain& chain) {
        std::pmr::vector<uint32_t> joints(pace_.memory());  // places in the chain
        const auto last = static_cast<uint32_t>(chain.size()) - 1;
        // A fork next to the root is it.
        if (joint_of_[chain[0]] == 0 && children_.of(chain[last]).size() > 0 && !is_doubled(chain[last]) &&
            (at(chain[last]) - at(0)).norm() < is_root * radius(0)) {
            joint_of_[chain[last]] = image_of_[chain[last]] = 0;
            co_return;
        }
        const uint32_t first = detail_ > 0 ? where_it_leaves(chain) : 0;
        joints.push_back(0);
        if (first > 0) joints.push_back(first);
        co_await simplify(chain, first, last, joints);
        if (detail_ > 0) divide_long(chain, joints, first > 0 ? 1 : 0);
        uint32_t before = chain[0];
        for (const uint32_t place : joints) {
            if (place == 0) continue;
            const uint32_t node = chain[place];
            add_joint(node);
            graph_.add_bone(joint_of_[before], joint_of_[node], 0);
            if (is_doubled(node)) graph_.add_bone(image_of_[before], image_of_[node], 0);
            before = node;
        }
    }

    // 0 if it goes on with what it branches off.
    uint32_t where_it_leaves(const Chain& chain) const {
        const double wide = radius(chain[0]);
        for (uint32_t i = 1; i + 1 < chain.size(); ++i) {
            if ((at(chain[i]) - at(chain[0])).norm() < leaves_at * wide) continue;
            if (radius(chain[i]) > is_thinner * wide) {
                if ((at(chain[i]) - at(chain[0])).norm() > 2 * wide) return 0;
                continue;
            }
            const double left = length(chain, i, static_cast<uint32_t>(chain.size()) - 1);
            return left > radius(chain[i]) ? i : 0;
        }
        return 0;
    }
    double length(const Chain& chain, uint32_t from, uint32_t to) const {
        double sum = 0;
        for (uint32_t i = from; i < to; ++i) sum += (at(chain[i + 1]) - at(chain[i])).norm();
        return sum;
    }

    // How far a node is from a bone, and how much its radius is not between those of the bone's ends.
    double deviation(const Chain& chain, uint32_t from, uint32_t to, uint32_t i) const {
        const Vec3 way = at(chain[to]) - at(chain[from]), own = at(chain[i]) - at(chain[from]);
        const double squared = way.squaredNorm();
        const double share = squared > 0 ? std::clamp(own.dot(way) / squared, 0.0, 1.0) : 0;
        const double even = std::lerp(radius(chain[from]), radius(chain[to]), share);
        return (own - share * way).norm() + shape_weight * std::max(0.0, even - radius(chain[i]));
    }

    // Adds what a way deviates most at, as long as that is too much, and its end (Douglas and Peucker).
    Task<void> simplify(const Chain& chain, uint32_t first, uint32_t last, std::pmr::vector<uint32_t>& joints) {
        const double most = static_cast<double>(thresholds_.simplify) * size_ / (detail_ > 0 ? detail_ : 1);
        std::pmr::vector<uint32_t> ends(pace_.memory());
        ends.push_back(last);
        uint32_t from = first;
        Slice slice(Cost::tens_of_ns);
        while (!ends.empty()) {
            const uint32_t to = ends.back();
            uint32_t worst = from;
            double deviates = most;
            for (uint32_t i = from + 1; i < to; ++i) {
                const double own = deviation(chain, from, to, i);
                if (own > deviates) deviates = own, worst = i;
            }
            if (slice.is_over(to - from)) co_await pace_;
            if (worst > from) {
                ends.push_back(worst);
                continue;
            }
            joints.push_back(to);
            from = to;
            ends.pop_back();
        }
    }

    double mean_radius(const Chain& chain, uint32_t from, uint32_t to) const {
        double sum = 0;
        for (uint32_t i = from; i <= to; ++i) sum += radius(chain[i]);
        return sum / (to + 1 - from);
    }
    // How many bones suit what is so long for its width.
    double pieces_of(const Chain& chain, uint32_t from, uint32_t to, double long_by) const {
        const double wide = 2 * mean_radius(chain, from, to);
        return wide > 0 ? std::max(1.0, std::round(bones_a_doubling * std::log2(1 + long_by / wide * detail_))) : 1;
    }

    // Joints within bones that are long for their width: where the limb narrows and bends, near the even places.
    void divide_long(const Chain& chain, std::pmr::vector<uint32_t>& joints, size_t first) const {
        const double limb = length(chain, joints[first], joints.back());
        const double wanted = pieces_of(chain, joints[first], joints.back(), limb);
        std::pmr::vector<uint32_t> all(joints.begin(), joints.begin() + static_cast<ptrdiff_t>(first) + 1,
                                       joints.get_allocator());
        for (size_t k = first; k + 1 < joints.size(); ++k) {
            const uint32_t from = joints[k], to = joints[k + 1];
            const double share = limb > 0 ? length(chain, from, to) / limb : 1, mean = mean_radius(chain, from, to);
            const auto pieces = static_cast<uint32_t>(std::clamp(std::round(wanted * share), 1.0, double{most_pieces}));
            const double size = static_cast<double>(to - from) / pieces, reach = std::max(1.0, window * size);
            for (uint32_t p = 1; p < pieces; ++p) {
                const double even = from + p * size;
                double best_rank = -HUGE_VAL;
                uint32_t best = nothing;
                const auto begin = std::max({from + 1, all.back() + 1, static_cast<uint32_t>(std::ceil(even - reach))});
                for (uint32_t i = begin; i < to && i <= even + reach; ++i) {
                    const double rank = deviation(chain, from, to, i) - evenness * mean * std::abs(i - even) / reach;
                    if (rank > best_rank) best_rank = rank, best = i;
                }
                if (best != nothing) all.push_back(best);
            }
            all.push_back(to);
        }
        joints = std::move(all);
    }

    Pace& pace_;
    const std::pmr::vector<CurveNode>& nodes_;
    const SolidFrame& frame_;
    double detail_;
    FlgBoneThresholds thresholds_;
    double size_;
    Groups children_;
    Buffer<uint32_t> joint_of_, image_of_;  // of the graph, by node
    BoneGraph graph_;
};

}  // namespace

Task<BoneTree> curve_joints(Pace& pace, const CurveSkeleton& curves, const SolidFrame& frame,
                            FlgBoneThresholds thresholds, double size) {
    Chooser chooser(pace, curves, frame, thresholds, size);
    co_return co_await chooser.choose();
}

}  // namespace flg
