// SPDX-License-Identifier: MIT
#include "bones/shared_trunks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/each.h"
#include "skeletons/point2.h"

namespace flg {
namespace {

constexpr uint32_t most_branches = 8;  // at a node
constexpr double least_length = 0.6;   // of a trunk, by the clearance at its node
constexpr double least_of_many = 1;    // the same where more than one other branch ends: arms of a star are none
constexpr double longest_spur = 2;     // by the same
constexpr double side_by_side = 1;     // share of half the trunk's width: branches nearer to each other are one trunk

// A branch as it leaves a node.
struct Way {
    uint32_t branch;
    std::span<const AxisSample> samples;
    bool is_reversed;

    double step() const { return distance(samples[0].at, samples[1].at); }
    uint32_t last() const { return static_cast<uint32_t>(samples.size()) - 1; }
    uint32_t number(uint32_t steps) const { return is_reversed ? last() - steps : steps; }
    const AxisSample& after(uint32_t steps) const { return samples[number(steps)]; }
};

struct Pair {
    Way ways[2];

    // Steps along the second one for as long a way along the first.
    uint32_t beside(uint32_t steps) const {
        return std::min(static_cast<uint32_t>(std::lround(steps * ways[0].step() / ways[1].step())), ways[1].last());
    }
    SharedTrunk::Joint middle(uint32_t steps) const {
        const AxisSample &a = ways[0].after(steps), &b = ways[1].after(beside(steps));
        return {mix(a.at, b.at, 0.5), 0.25 * (a.left + a.right + b.left + b.right)};
    }
    bool is_one(uint32_t steps) const {
        const AxisSample &a = ways[0].after(steps), &b = ways[1].after(beside(steps));
        return distance(a.at, b.at) <= side_by_side * 0.5 * std::min(a.left + a.right, b.left + b.right);
    }
    // Both branches go on beyond.
    bool goes_on(uint32_t steps) const { return steps + 1 < ways[0].last() && beside(steps) + 1 < ways[1].last(); }
};

class Finder {
public:
    Finder(Pace& pace, const HeldPart& part, double detail)
        : pace_(pace),
          part_(part),
          skeleton_(part.skeleton),
          detail_(detail),
          nodes_(pace.memory()),
          trunks_(pace.memory()) {}

    Task<std::pmr::vector<SharedTrunk>> find() {
        co_await list_ways();
        for (uint32_t n = 0; n < skeleton_.graph.nodes.size(); ++n) {
            if (nodes_[n].count < 3 || nodes_[n].count > most_branches) continue;
            const uint32_t image = image_of(n);
            if (image < n) {
                co_await repeat_of(image, n);
            } else {
                co_await look_at(n, image == n && !skeleton_.twins.empty());
            }
        }
        co_return std::move(trunks_);
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    struct Node {
        uint32_t count = 0;
        std::array<uint32_t, most_branches> ends{};  // twice the branch, one more where it ends here
    };

    Task<void> list_ways() {
        nodes_.resize(skeleton_.graph.nodes.size());
        co_await each(pace_, skeleton_.branches.size(), Cost::some_ns, [&](uint32_t b) {
            const AxisBranch& branch = skeleton_.branches[b];
            add(branch.from, 2 * b);
            add(branch.to, 2 * b + 1);
        });
    }

    void add(uint32_t node, uint32_t end) {
        Node& n = nodes_[node];
        if (n.count < n.ends.size()) n.ends[n.count] = end;
        ++n.count;
    }

    Way way(uint32_t end) const {
        const AxisBranch& branch = skeleton_.branches[end / 2];
        return {end / 2, std::span(skeleton_.samples).subspan(branch.begin, branch.end - branch.begin), end % 2 == 1};
    }

    uint32_t twin(uint32_t branch) const { return skeleton_.twins[branch]; }

    uint32_t image_of(uint32_t node) const {
        const uint32_t end = nodes_[node].ends[0];
        if (skeleton_.twins.empty() || twin(end / 2) == end / 2) return node;
        const AxisBranch& image = skeleton_.branches[twin(end / 2)];
        return end % 2 == 1 ? image.to : image.from;
    }

    // On the mirror axis two branches are one trunk only if they are images of each other.
    Task<void> look_at(uint32_t node, bool is_on_axis) {
        const std::span<const uint32_t> ends(nodes_[node].ends.data(), nodes_[node].count);
        std::optional<Pair> best;
        uint32_t best_steps = 0;
        double farthest =
            (ends.size() - spurs(node) > 3 ? least_of_many : least_length) * skeleton_.graph.nodes[node].clearance;
        for (uint32_t b = 1; b < ends.size(); ++b) {
            for (uint32_t a = 0; a < b; ++a) {
                if (is_on_axis && twin(ends[a] / 2) != ends[b] / 2) continue;
                const Pair pair{{way(ends[a]), way(ends[b])}};
                const uint32_t steps = co_await steps_together(pair);
                if (!pair.goes_on(steps)) continue;
                const double reach = distance(skeleton_.graph.nodes[node].at, pair.middle(steps).at);
                if (reach > farthest) best = pair, best_steps = steps, farthest = reach;
            }
        }
        if (best) co_await add_trunk(node, *best, best_steps);
    }

    // Branches that end freely about as far away as the node is from the outline: such as one into a crotch.
    uint32_t spurs(uint32_t node) const {
        uint32_t count = 0;
        for (const uint32_t end : std::span(nodes_[node].ends.data(), nodes_[node].count)) {
            const AxisBranch& branch = skeleton_.branches[end / 2];
            const uint32_t tip = end % 2 == 1 ? branch.from : branch.to;
            const double length = distance(skeleton_.graph.nodes[node].at, skeleton_.graph.nodes[tip].at);
            count += nodes_[tip].count == 1 && length <= longest_spur * skeleton_.graph.nodes[node].clearance;
        }
        return count;
    }

    // What was found at the mirror image of a node.
    Task<void> repeat_of(uint32_t image, uint32_t node) {
        const auto same = [image](const SharedTrunk& shared) { return shared.node == image; };
        const auto found = std::find_if(trunks_.begin(), trunks_.end(), same);
        if (found == trunks_.end()) co_return;
        Pair pair{};
        for (uint32_t i = 0; i < 2; ++i) {
            const uint32_t branch = twin(found->branches[i]);
            pair.ways[i] = way(2 * branch + (skeleton_.branches[branch].from == node ? 0 : 1));
        }
        const uint32_t sample = found->samples[0];
        co_await add_trunk(node, pair, pair.ways[0].is_reversed ? pair.ways[0].last() - sample : sample);
    }

    Task<void> add_trunk(uint32_t node, Pair pair, uint32_t steps) {
        SharedTrunk shared{node, {}, {}, std::pmr::vector<SharedTrunk::Joint>(pace_.memory())};
        shared.branches = {pair.ways[0].branch, pair.ways[1].branch};
        shared.samples = {pair.ways[0].number(steps), pair.ways[1].number(pair.beside(steps))};
        const double length = distance(skeleton_.graph.nodes[node].at, pair.middle(steps).at);
        const uint32_t pieces = pieces_of(length, 2 * pair.middle(steps / 2).radius, detail_);
        for (uint32_t k = 1; k <= pieces; ++k) shared.joints.push_back(pair.middle(steps * k / pieces));
        const bool is_inside = co_await stays_inside(shared, pair, steps);
        if (is_inside) trunks_.push_back(std::move(shared));
    }

    Task<uint32_t> steps_together(Pair pair) const {
        uint32_t steps = 0;
        Slice slice(Cost::tens_of_ns);
        while (pair.goes_on(steps) && pair.is_one(steps + 1)) {
            ++steps;
            if (slice.is_over()) co_await pace_;
        }
        co_return steps;
    }

    Task<bool> stays_inside(const SharedTrunk& shared, Pair pair, uint32_t steps) const {
        Point2 at = skeleton_.graph.nodes[shared.node].at;
        for (const SharedTrunk::Joint& joint : shared.joints) {
            const bool is_inside = co_await lies_inside(at, joint.at);
            if (!is_inside) co_return false;
            at = joint.at;
        }
        const bool first = co_await lies_inside(at, pair.ways[0].after(steps).at);
        const bool second = co_await lies_inside(at, pair.ways[1].after(pair.beside(steps)).at);
        co_return first&& second;
    }

    Task<bool> lies_inside(Point2 a, Point2 b) const {
        bool meets = false;
        Slice slice(Cost::tens_of_ns);
        for (Portion edges(slice, 0, part_.outline.size()); !meets && edges.next();) {
            meets = meets_edges(part_.outline, a, b, edges.begin, edges.end);
            if (edges.is_over()) co_await pace_;
        }
        co_return !meets;
    }

    Pace& pace_;
    const HeldPart& part_;
    const PartSkeleton& skeleton_;
    const double detail_;
    std::pmr::vector<Node> nodes_;  // by node
    std::pmr::vector<SharedTrunk> trunks_;
};

}  // namespace

uint32_t pieces_of(double length, double width, double detail) {
    constexpr double bones_a_doubling = 0.75;  // of a bone's length by its width
    constexpr double most = 8;
    const double aspect = width > 0 ? length / width : 0;
    return static_cast<uint32_t>(std::clamp(std::round(bones_a_doubling * std::log2(1 + aspect * detail)), 1.0, most));
}

Task<std::pmr::vector<SharedTrunk>> find_shared_trunks(Pace& pace, const HeldPart& part, double detail) {
    Finder finder(pace, part, detail);
    co_return co_await finder.find();
}

}  // namespace flg
