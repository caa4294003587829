// SPDX-License-Identifier: MIT
#include "bones/mirrored_axis.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"
#include "skeletons/node_clusters.h"

namespace flg {
namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr size_t most_nodes = 512;          // no drawing by hand has more; each is held against each
constexpr double alike = 0.5;               // of how far a node is from the axis: so far its image may be off
constexpr double across[] = {0.5, 0.1, 0};  // of a node's clearance; tried in this order until the halves hang together
constexpr double one_place = 0.1;           // of a node's clearance
constexpr double twigs = 0.25;              // of a node's clearance
constexpr double same_place = 1e-4;         // of a node's clearance: straight skeletons are a little off

enum class Side : uint8_t { left, on, right };

// The left half: nodes to the left, then those on the axis, and what is between them.
struct Half {
    explicit Half(Memory* memory) : graph(memory), is_on(memory) {}
    AxisGraph graph;
    std::pmr::vector<bool> is_on;

    uint32_t add(const AxisNode& node, bool on) {
        graph.nodes.push_back(node);
        is_on.push_back(on);
        return static_cast<uint32_t>(graph.nodes.size()) - 1;
    }
};

bool has_image(const AxisGraph& graph, const MirrorAxis& mirror, uint32_t node) {
    const AxisNode& n = graph.nodes[node];
    const Point2 image = mirror.image(n.at);
    for (uint32_t i = 0; i < graph.nodes.size(); ++i)
        if (i != node && distance(graph.nodes[i].at, image) <= alike * std::abs(mirror.side(n.at))) return true;
    return false;
}

Side side_of(const AxisGraph& graph, const MirrorAxis& mirror, uint32_t node, double reach) {
    const AxisNode& n = graph.nodes[node];
    const double side = mirror.side(n.at);
    if (std::abs(side) <= same_place * n.clearance) return Side::on;
    if (std::abs(side) <= reach * n.clearance) {
        const bool is_pair = has_image(graph, mirror, node);
        if (!is_pair) return Side::on;
        // A twig and its image that are almost one become one.
        if (std::abs(side) <= twigs * n.clearance) return side > 0 ? Side::on : Side::right;
    }
    return side > 0 ? Side::left : Side::right;
}

// Makes one tree that stays one with its image: what lies on the axis hangs together along it, from one end to the
// other, which is inside of the shape all the way, and each piece to the left hangs on that once, where there is most
// room.
bool make_tree(const MirrorAxis& mirror, Half& half, Memory* memory) {
    AxisGraph& graph = half.graph;
    NodeClusters clusters(graph.nodes.size(), memory);
    for (uint32_t i = 0; i < graph.nodes.size(); ++i) clusters.begin(i);
    std::pmr::vector<std::array<uint32_t, 2>> arcs(memory);
    const auto add = [&](uint32_t a, uint32_t b) {
        if (clusters.join(a, b)) arcs.push_back({a, b});
    };
    struct OnAxis {
        double along;
        uint32_t node;
    };
    struct Join {
        double clearance;
        uint32_t a, b;
    };
    std::pmr::vector<OnAxis> nodes(memory);
    for (uint32_t i = 0; i < graph.nodes.size(); ++i) {
        const Point2& at = graph.nodes[i].at;
        if (half.is_on[i])
            nodes.push_back({mirror.along.x * (at.x - mirror.at.x) + mirror.along.y * (at.y - mirror.at.y), i});
    }
    std::sort(nodes.begin(), nodes.end(), [](const OnAxis& a, const OnAxis& b) {
        return a.along != b.along ? a.along < b.along : a.node < b.node;
    });
    for (size_t i = 0; i + 1 < nodes.size(); ++i) add(nodes[i].node, nodes[i + 1].node);
    std::pmr::vector<Join> joins(memory);
    for (const auto& [a, b] : graph.arcs) {
        if (half.is_on[a] && half.is_on[b]) continue;
        if (!half.is_on[a] && !half.is_on[b])
            add(a, b);
        else
            joins.push_back({graph.nodes[half.is_on[a] ? a : b].clearance, a, b});
    }
    std::sort(joins.begin(), joins.end(), [](const Join& a, const Join& b) {
        return a.clearance != b.clearance ? a.clearance > b.clearance : a.a < b.a;
    });
    for (const Join& join : joins) add(join.a, join.b);
    graph.arcs = std::move(arcs);
    return !nodes.empty() && graph.arcs.size() + 1 == graph.nodes.size();
}

Task<Half> left_half(Pace& pace, const AxisGraph& graph, MirrorAxis mirror, double reach) {
    Half half(pace.memory());
    const auto count = static_cast<uint32_t>(graph.nodes.size());
    Buffer<Side> side(count, pace.memory());
    Buffer<uint32_t> number(count, pace.memory());
    co_await each_by_work(pace, count, Cost::some_ns, [&](uint32_t i) {
        side[i] = side_of(graph, mirror, i, reach);
        return count;
    });
    // Nodes that come to the same place on the axis are one: that with the most room.
    Buffer<uint32_t> same(count, pace.memory());
    const auto find = [&](uint32_t i) {
        while (same[i] != i) i = same[i];
        return i;
    };
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { same[i] = i; });
    co_await each(pace, graph.arcs.size(), Cost::tens_of_ns, [&](uint32_t e) {
        const auto [x, y] = graph.arcs[e];
        if (side[x] != Side::on || side[y] != Side::on) return;
        const uint32_t a = find(x), b = find(y);
        const AxisNode &first = graph.nodes[a], &second = graph.nodes[b];
        const double room = std::max(first.clearance, second.clearance);
        if (distance(mirror.on_axis(first.at), mirror.on_axis(second.at)) > one_place * room) return;
        (first.clearance >= second.clearance ? same[b] : same[a]) = first.clearance >= second.clearance ? a : b;
    });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        number[i] = none;
        AxisNode node = graph.nodes[i];
        if (side[i] == Side::on) node.at = mirror.on_axis(node.at);
        if (side[i] != Side::right && same[i] == i) number[i] = half.add(node, side[i] == Side::on);
    });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (same[i] != i) number[i] = number[find(i)];
    });
    co_await each(pace, graph.arcs.size(), Cost::tens_of_ns, [&](uint32_t e) {
        auto [a, b] = graph.arcs[e];
        if (side[b] == Side::left) std::swap(a, b);
        if (side[a] == Side::right || (side[a] == Side::on && side[b] == Side::right)) return;
        if (side[b] != Side::right) {
            if (number[a] != number[b]) half.graph.arcs.push_back({number[a], number[b]});
            return;
        }
        if (side[a] != Side::left) return;
        const AxisNode &from = graph.nodes[a], &to = graph.nodes[b];
        const double share = mirror.side(from.at) / (mirror.side(from.at) - mirror.side(to.at));
        const AxisNode middle{mirror.on_axis(mix(from.at, to.at, share)),
                              std::lerp(from.clearance, to.clearance, share)};
        half.graph.arcs.push_back({number[a], half.add(middle, true)});
    });
    co_return half;
}

AxisSample image_of(const AxisSample& sample, const MirrorAxis& mirror) {
    const Point2 tip{sample.at.x + sample.left_of.x, sample.at.y + sample.left_of.y};
    const Point2 at = mirror.image(sample.at), end = mirror.image(tip);
    return {at, {at.x - end.x, at.y - end.y}, sample.right, sample.left};
}

}  // namespace

Task<std::optional<PartSkeleton>> mirrored_branches(Pace& pace, const Contour& outline, const AxisGraph& graph,
                                                    MirrorAxis mirror, double spacing) {
    if (graph.nodes.size() > most_nodes) co_return std::nullopt;
    Half half(pace.memory());
    bool hangs_together = false;
    for (const double reach : across) {
        if (hangs_together) break;
        half = co_await left_half(pace, graph, mirror, reach);
        hangs_together = make_tree(mirror, half, pace.memory());
        co_await pace;
    }
    if (!hangs_together) co_return std::nullopt;
    const auto count = static_cast<uint32_t>(half.graph.nodes.size());
    std::pmr::vector<uint8_t> stops(count, 0, pace.memory());
    co_await each(pace, half.graph.arcs.size(), Cost::some_ns, [&](uint32_t e) {
        const auto [a, b] = half.graph.arcs[e];
        if (half.is_on[a] && !half.is_on[b]) stops[a] = 1;
        if (half.is_on[b] && !half.is_on[a]) stops[b] = 1;
    });
    const std::pmr::vector<bool> is_on = std::move(half.is_on);
    PartSkeleton part = co_await axis_branches(pace, outline, std::move(half.graph), spacing, stops);
    Buffer<uint32_t> image(count, pace.memory());
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        image[i] = i;
        if (is_on[i]) return;
        image[i] = static_cast<uint32_t>(part.graph.nodes.size());
        const AxisNode node = part.graph.nodes[i];
        part.graph.nodes.push_back({mirror.image(node.at), node.clearance});
    });
    co_await each(pace, part.graph.arcs.size(), Cost::tens_of_ns, [&](uint32_t e) {
        const auto [a, b] = part.graph.arcs[e];
        if (!is_on[a] || !is_on[b]) part.graph.arcs.push_back({image[a], image[b]});
    });
    const auto branches = static_cast<uint32_t>(part.branches.size());
    for (uint32_t b = 0; b < branches; ++b) part.twins.push_back(b);
    for (uint32_t b = 0; b < branches; ++b) {
        const AxisBranch branch = part.branches[b];
        const AxisSample& inner = part.samples[branch.begin + (branch.end - branch.begin) / 2];
        const bool lies_on = is_on[branch.from] && is_on[branch.to] &&
                             std::abs(mirror.side(inner.at)) <= same_place * (inner.left + inner.right);
        if (lies_on) continue;
        const auto begin = static_cast<uint32_t>(part.samples.size());
        co_await each(pace, branch.end - branch.begin, Cost::tens_of_ns, [&](uint32_t i) {
            const AxisSample sample = part.samples[branch.begin + i];
            part.samples.push_back(image_of(sample, mirror));
        });
        const auto twin = static_cast<uint32_t>(part.branches.size());
        part.branches.push_back(
            {image[branch.from], image[branch.to], begin, static_cast<uint32_t>(part.samples.size())});
        part.twins[b] = twin;
        part.twins.push_back(b);
    }
    co_return part;
}

}  // namespace flg
