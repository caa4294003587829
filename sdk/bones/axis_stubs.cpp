// SPDX-License-Identifier: MIT
#include "bones/axis_stubs.h"

#include "bones/wide_part.h"
#include "runtime/each.h"

namespace flg {
namespace {

constexpr double wedge_length = 2.5;      // times what the clearance falls by on the way
constexpr double pointed = 0.3;           // of the clearance where it begins: a corner's end
constexpr double shortest_limb = 1.5;     // of the clearance where it begins: a limb beside a corner
constexpr double valley = 1.5;            // times the clearance that the contour is away
constexpr int looks = 8, first_look = 2;  // pieces of a branch between which its width is looked at

// A branch from its end to where it begins.
struct Stub {
    explicit Stub(Memory* memory) : nodes(memory) {}

    double length = 0;
    bool is_corner = false, is_valley = false;
    std::pmr::vector<uint32_t> nodes;

    uint32_t junction() const { return nodes.back(); }
    Point2 at(const AxisGraph& graph, double along) const {
        size_t i = 0;
        double piece = 0;
        for (; i + 1 < nodes.size(); ++i, along -= piece) {
            piece = distance(graph.nodes[nodes[i]].at, graph.nodes[nodes[i + 1]].at);
            if (along <= piece && piece > 0)
                return mix(graph.nodes[nodes[i]].at, graph.nodes[nodes[i + 1]].at, along / piece);
        }
        return graph.nodes[nodes.back()].at;
    }
};

bool is_in_wedge(double length, double clearance, const AxisNode& end) {
    return length <= wedge_length * (clearance - end.clearance) + end.clearance;
}

Task<bool> is_corner(Pace& pace, const Contour& contour, const AxisGraph& graph, const Stub& stub) {
    const AxisNode &end = graph.nodes[stub.nodes.front()], &begin = graph.nodes[stub.junction()];
    if (end.clearance > pointed * begin.clearance || !is_in_wedge(stub.length, begin.clearance, end)) co_return false;
    // Arcs that were contracted do not say how wide the shape is beside them. The very end may be a spike.
    for (int i = first_look; i < looks; ++i) {
        const double along = stub.length * i / looks;
        const double depth = co_await depth_in(pace, contour, stub.at(graph, along));
        if (!is_in_wedge(along, depth, end)) co_return false;
    }
    co_return true;
}

Task<bool> ends_in_valley(Pace& pace, const Contour& contour, AxisNode end) {
    const double depth = co_await depth_in(pace, contour, end.at);
    co_return depth > valley* end.clearance;
}

}  // namespace

Task<AxisGraph> without_stubs(Pace& pace, const Contour& contour, AxisGraph graph) {
    const auto count = static_cast<uint32_t>(graph.nodes.size());
    const Groups ends = co_await group_by(pace, 2 * graph.arcs.size(), count,
                                          [&](uint32_t end) { return graph.arcs[end / 2][end % 2]; });
    const auto neighbour = [&](uint32_t end) { return graph.arcs[end / 2][1 - end % 2]; };
    const auto next_on_way = [&](uint32_t node, uint32_t before) {
        const auto here = ends.of(node);
        const uint32_t first = neighbour(here[0]);
        return here.size() == 2 && first == before ? neighbour(here[1]) : first;
    };
    std::pmr::vector<Stub> stubs(pace.memory());
    // By node: branches that are no limbs, the longest limb.
    Buffer<uint32_t> stubs_at(count, pace.memory());
    Buffer<double> limb_at(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t node) { stubs_at[node] = 0, limb_at[node] = 0; });
    Slice slice(Cost::tens_of_ns);
    for (uint32_t end = 0; end < count; ++end) {
        if (slice.is_over()) co_await pace;
        if (ends.of(end).size() != 1) continue;
        Stub stub(pace.memory());
        stub.nodes.push_back(end);
        uint32_t before = end;
        for (uint32_t node = next_on_way(end, end);; node = next_on_way(node, before)) {
            stub.length += distance(graph.nodes[stub.nodes.back()].at, graph.nodes[node].at);
            before = stub.nodes.back();
            stub.nodes.push_back(node);
            if (ends.of(node).size() != 2) break;
            if (slice.is_over()) co_await pace;
        }
        if (ends.of(stub.junction()).size() == 1) co_return graph;
        stub.is_corner = co_await is_corner(pace, contour, graph, stub);
        stub.is_valley = co_await ends_in_valley(pace, contour, graph.nodes[end]);
        double& limb = limb_at[stub.junction()];
        if (!stub.is_corner && !stub.is_valley && stub.length >= shortest_limb * graph.nodes[stub.junction()].clearance)
            limb = std::max(limb, stub.length);
        if (stub.is_corner || stub.is_valley) stubs.push_back(std::move(stub));
    }
    const auto is_cut = [&](const Stub& stub) { return stub.is_valley || stub.length < limb_at[stub.junction()]; };
    for (const Stub& stub : stubs) stubs_at[stub.junction()] += is_cut(stub);
    Buffer<uint8_t> stays(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t node) { stays[node] = 1; });
    for (const Stub& stub : stubs) {
        if (!is_cut(stub) || stubs_at[stub.junction()] == ends.of(stub.junction()).size()) continue;
        for (size_t i = 0; i + 1 < stub.nodes.size(); ++i) {
            stays[stub.nodes[i]] = 0;
            if (slice.is_over()) co_await pace;
        }
    }
    Buffer<uint32_t> number(count, pace.memory());
    AxisGraph rest(pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t node) {
        number[node] = static_cast<uint32_t>(rest.nodes.size());
        if (stays[node] != 0) rest.nodes.push_back(graph.nodes[node]);
    });
    co_await each(pace, graph.arcs.size(), Cost::some_ns, [&](uint32_t arc) {
        const auto [a, b] = graph.arcs[arc];
        if (stays[a] != 0 && stays[b] != 0) rest.arcs.push_back({number[a], number[b]});
    });
    co_return rest;
}

}  // namespace flg
