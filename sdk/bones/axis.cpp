// SPDX-License-Identifier: MIT
#include "bones/axis.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "runtime/each.h"
#include "skeletons/point2.h"

namespace flg {

namespace {

constexpr double sharpness = 2.5, tip_share = 0.75;
constexpr uint32_t no_link = UINT32_MAX;
constexpr uint32_t arc_work = 16;  // of an arc in a queue, by an edge of the contour that an arc is held against

// The arcs as a tree that is contracted.
class AxisTree {
public:
    struct Contraction {
        uint32_t arc, kept, dropped;  // dropped becomes one with kept
    };

    AxisTree(const Contour& contour, const StraightSkeleton& skeleton, Memory* memory)
        : border_(contour.size()),
          skeleton_(skeleton),
          nodes_(memory),
          arcs_(memory),
          links_(memory),
          queue_(std::less<Ranked>(), reserved(2 * skeleton.arcs.size(), memory)) {
        nodes_.reserve(skeleton.nodes.size());
        arcs_.reserve(skeleton.arcs.size());
        links_.reserve(2 * skeleton.arcs.size());
    }

    uint32_t node_count() const { return static_cast<uint32_t>(nodes_.size()); }
    uint32_t arc_count() const { return static_cast<uint32_t>(arcs_.size()); }
    // Those that are there.
    uint32_t alive() const { return alive_; }

    // The skeleton's next node inside.
    void add_node() {
        const SkeletonNode& node = skeleton_.nodes[border_ + nodes_.size()];
        nodes_.push_back({node.at, node.time, node_count(), no_link, no_link, 0});
    }

    void add_arc(const SkeletonArc& arc) {
        if (arc.a < border_ || arc.b < border_) return add_tip(std::min(arc.a, arc.b), std::max(arc.a, arc.b));
        queue_.push({skeleton_.nodes[arc.a].time + skeleton_.nodes[arc.b].time, arc_count()});
        arcs_.push_back({arc.a - border_, arc.b - border_, false});
    }

    // The widest first: what would close a circle is its narrowest arc. Returns whether there was one.
    bool link_widest() {
        if (queue_.empty()) return false;
        const uint32_t number = queue_.top().arc;
        queue_.pop();
        Arc& arc = arcs_[number];
        const uint32_t a = root(arc.a), b = root(arc.b);
        arc.gone = a == b;
        if (arc.gone) return true;
        nodes_[std::max(a, b)].united = std::min(a, b);
        const auto slot = static_cast<uint32_t>(links_.size());
        links_.push_back({number, no_link});
        links_.push_back({number, no_link});
        link(arc.a, slot);
        link(arc.b, slot + 1);
        sum_ += distance(nodes_[arc.a].at, nodes_[arc.b].at);
        ++alive_;
        return true;
    }

    // For unions of another kind: nodes that were contracted to one.
    void part(uint32_t node) { nodes_[node].united = node; }

    void set_threshold(double collapse) { threshold_ = alive_ > 0 ? collapse * sum_ / alive_ : 0; }
    void queue_if_short(uint32_t arc) {
        if (arcs_[arc].gone) return;
        const double arc_length = length(arcs_[arc]);
        if (arc_length < threshold_) queue_.push({-arc_length, arc});
    }
    bool has_short() const { return !queue_.empty(); }

    // Takes the shortest arc, and says whether that still is what it was when it was queued.
    bool take_shortest(Contraction& out) {
        const Ranked top = queue_.top();
        queue_.pop();
        const Arc& arc = arcs_[top.arc];
        if (arc.gone || length(arc) != -top.rank) return false;
        const uint32_t a = root(arc.a), b = root(arc.b);
        const Node &first = nodes_[a], &second = nodes_[b];
        bool keep_first = first.clearance > second.clearance || (first.clearance == second.clearance && a < b);
        const auto rank = [](const Node& node) { return node.degree >= 3 ? 2 : node.degree == 1 ? 1 : 0; };
        if (rank(first) != rank(second)) keep_first = rank(first) > rank(second);
        out = {top.arc, keep_first ? a : b, keep_first ? b : a};
        return true;
    }

    uint32_t first_link(uint32_t node) const { return nodes_[node].first; }
    uint32_t next_link(uint32_t link) const { return links_[link].next; }
    uint32_t arc_of(uint32_t link) const { return links_[link].arc; }
    const Point2& at(uint32_t node) const { return nodes_[node].at; }

    // The other end of an arc that is moved, if two discs do not cover the moved arc; else the dropped node.
    uint32_t uncovered_end(const Contraction& by, uint32_t link) {
        const Arc& arc = arcs_[links_[link].arc];
        if (arc.gone || links_[link].arc == by.arc) return by.dropped;
        const uint32_t a = root(arc.a), end = a == by.dropped ? root(arc.b) : a;
        const Node &other = nodes_[end], &kept = nodes_[by.kept];
        return distance(other.at, kept.at) > other.clearance + kept.clearance ? end : by.dropped;
    }

    void contract(const Contraction& by) {
        Node &kept = nodes_[by.kept], &dropped = nodes_[by.dropped];
        arcs_[by.arc].gone = true;
        --alive_;
        dropped.united = by.kept;
        kept.degree += dropped.degree - 2;
        links_[kept.last].next = dropped.first;
        kept.last = dropped.last;
    }

    void write_node(uint32_t node, Buffer<uint32_t>& number, AxisGraph& out) const {
        if (nodes_[node].united != node) return;
        number[node] = static_cast<uint32_t>(out.nodes.size());
        out.nodes.push_back({nodes_[node].at, nodes_[node].clearance});
    }
    void write_arc(uint32_t arc, const Buffer<uint32_t>& number, AxisGraph& out) {
        if (!arcs_[arc].gone) out.arcs.push_back({number[root(arcs_[arc].a)], number[root(arcs_[arc].b)]});
    }

private:
    struct Link {  // an arc at one of its nodes
        uint32_t arc;
        uint32_t next;  // the node's next link; no_link: none
    };
    struct Node {
        Point2 at;
        double clearance;
        uint32_t united;  // with this node, itself: none
        uint32_t first, last, degree;
    };
    struct Arc {
        uint32_t a, b;
        bool gone;
    };
    struct Ranked {
        double rank;
        uint32_t arc;
        // The largest comes first; then that with the lowest number.
        bool operator<(const Ranked& other) const { return rank != other.rank ? rank < other.rank : arc > other.arc; }
    };

    static std::pmr::vector<Ranked> reserved(size_t size, Memory* memory) {
        std::pmr::vector<Ranked> ranked(memory);
        ranked.reserve(size);
        return ranked;
    }

    uint32_t root(uint32_t node) {
        while (nodes_[node].united != node) node = nodes_[node].united = nodes_[nodes_[node].united].united;
        return node;
    }

    double length(const Arc& arc) { return distance(nodes_[root(arc.a)].at, nodes_[root(arc.b)].at); }

    void link(uint32_t node, uint32_t slot) {
        Node& n = nodes_[node];
        (n.first == no_link ? n.first : links_[n.last].next) = slot;
        n.last = slot;
        ++n.degree;
    }

    // Keeps the arc from a node to a point of the contour if that is the end of a sharp tip, without the very end.
    void add_tip(uint32_t tip, uint32_t inner) {
        if (inner < border_) return;
        const SkeletonNode& node = skeleton_.nodes[inner];
        const Point2& end = skeleton_.nodes[tip].at;
        if (distance(node.at, end) <= sharpness * node.time) return;
        const double clearance = (1 - tip_share) * node.time;
        queue_.push({node.time + clearance, arc_count()});
        arcs_.push_back({inner - border_, node_count(), false});
        nodes_.push_back({mix(node.at, end, tip_share), clearance, node_count(), no_link, no_link, 0});
    }

    uint32_t border_;
    const StraightSkeleton& skeleton_;
    std::pmr::vector<Node> nodes_;
    std::pmr::vector<Arc> arcs_;
    std::pmr::vector<Link> links_;  // two an arc
    std::priority_queue<Ranked, std::pmr::vector<Ranked>> queue_;
    double threshold_ = 0, sum_ = 0;
    uint32_t alive_ = 0;
};

// The shortest first. An arc stays if without it another one would leave the shape.
Task<void> contract_short_arcs(Pace& pace, const Contour& contour, AxisTree& tree) {
    Slice slice(Cost::tens_of_ns);
    while (tree.has_short()) {
        if (slice.is_over(arc_work)) co_await pace;
        AxisTree::Contraction next;
        if (!tree.take_shortest(next)) continue;
        bool leaves_shape = false;
        for (uint32_t link = tree.first_link(next.dropped); link != no_link; link = tree.next_link(link)) {
            if (slice.is_over()) co_await pace;
            const uint32_t end = tree.uncovered_end(next, link);
            if (end == next.dropped) continue;
            for (Portion part(slice, 0, contour.size()); !leaves_shape && part.next();) {
                leaves_shape = meets_edges(contour, tree.at(next.kept), tree.at(end), part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
            if (leaves_shape) break;
        }
        if (leaves_shape) continue;
        const uint32_t moved = tree.first_link(next.dropped);
        tree.contract(next);
        for (uint32_t link = moved; link != no_link; link = tree.next_link(link)) {
            tree.queue_if_short(tree.arc_of(link));
            if (slice.is_over(arc_work)) co_await pace;
        }
    }
}

}  // namespace

Task<AxisGraph> axis_graph(Pace& pace, const Contour& contour, const StraightSkeleton& skeleton, double collapse) {
    AxisTree tree(contour, skeleton, pace.memory());
    co_await each(pace, contour.size(), static_cast<uint32_t>(skeleton.nodes.size()), Cost::some_ns,
                  [&](uint32_t) { tree.add_node(); });
    co_await each(pace, skeleton.arcs.size(), Cost::hundreds_of_ns,
                  [&](uint32_t arc) { tree.add_arc(skeleton.arcs[arc]); });
    co_await repeat(pace, Cost::hundreds_of_ns, [&] { return tree.link_widest(); });
    co_await each(pace, tree.node_count(), Cost::some_ns, [&](uint32_t node) { tree.part(node); });
    tree.set_threshold(collapse);
    co_await each(pace, tree.arc_count(), Cost::hundreds_of_ns, [&](uint32_t arc) { tree.queue_if_short(arc); });
    co_await contract_short_arcs(pace, contour, tree);

    AxisGraph graph(pace.memory());
    graph.nodes.reserve(tree.alive() + 1);
    graph.arcs.reserve(tree.alive());
    Buffer<uint32_t> number(tree.node_count(), pace.memory());
    co_await each(pace, tree.node_count(), Cost::some_ns, [&](uint32_t node) { tree.write_node(node, number, graph); });
    co_await each(pace, tree.arc_count(), Cost::tens_of_ns, [&](uint32_t arc) { tree.write_arc(arc, number, graph); });
    co_return graph;
}

namespace {

constexpr uint32_t steps_per_piece = 8;
constexpr double slice_limit = 2;  // times the clearance
constexpr uint32_t edges_a_step = 256, near_edge_work = 16;

struct CurvePoint {
    Point2 at;
    double along, clearance;
};

using Samples = std::pmr::vector<AxisSample>;

AxisSample new_sample(const Point2& at, double clearance) {
    return {at, {}, slice_limit * clearance, slice_limit * clearance};
}

// A branch by its nodes.
struct Path {
    size_t pieces() const { return nodes.size() - 1; }
    const AxisNode& node(size_t i) const { return graph.nodes[nodes[i]]; }

    // A point between two of the nodes, on the centripetal Catmull-Rom spline (Barry, Goldman 1988).
    Point2 spline(size_t piece, double share) const {
        const Point2 b = node(piece).at, c = node(piece + 1).at;
        const Point2 a = piece > 0 ? node(piece - 1).at : mix(b, c, -1);
        const Point2 d = piece + 1 < pieces() ? node(piece + 2).at : mix(c, b, -1);
        const double t1 = std::sqrt(distance(a, b)), t2 = t1 + std::sqrt(distance(b, c)),
                     t3 = t2 + std::sqrt(distance(c, d));
        const double t = t1 + share * (t2 - t1);
        const Point2 ab = mix(a, b, t / t1), bc = mix(b, c, share), cd = mix(c, d, (t - t2) / (t3 - t2));
        return mix(mix(ab, bc, t / t2), mix(bc, cd, (t - t1) / (t3 - t1)), share);
    }
    // Some points for each piece, to measure the curve by.
    CurvePoint curve_point(uint32_t number) const {
        const uint32_t piece = number / steps_per_piece, step = number % steps_per_piece;
        const AxisNode& from = node(piece);
        if (step == 0) return {from.at, 0, from.clearance};
        const double share = static_cast<double>(step) / steps_per_piece;
        return {spline(piece, share), 0, std::lerp(from.clearance, node(piece + 1).clearance, share)};
    }

    const AxisGraph& graph;
    std::pmr::vector<uint32_t> nodes;
};

// Room for more samples, without moving many in one go.
Task<void> make_room(Pace& pace, size_t more, Samples& samples) {
    Samples larger(pace.memory());
    larger.reserve(std::max(samples.size() + more, 2 * samples.size()));
    co_await each(pace, samples.size(), Cost::some_ns, [&](uint32_t i) { larger.push_back(samples[i]); });
    samples.swap(larger);
}

bool has_room(size_t more, const Samples& samples) {
    return samples.capacity() - samples.size() >= more;
}

Task<void> sample_spline(Pace& pace, const Path& path, double spacing, Samples& samples) {
    std::pmr::vector<CurvePoint> curve(pace.memory());
    const size_t points = steps_per_piece * path.pieces() + 1;
    curve.reserve(points);
    co_await each(pace, points, Cost::tens_of_ns, [&](uint32_t i) {
        CurvePoint point = path.curve_point(i);
        if (i > 0) point.along = curve[i - 1].along + distance(curve[i - 1].at, point.at);
        curve.push_back(point);
    });
    const double length = curve.back().along;
    const auto wanted = static_cast<uint32_t>(std::max(1.0, std::ceil(length / spacing)));
    if (!has_room(wanted + size_t{1}, samples)) co_await make_room(pace, wanted + size_t{1}, samples);
    uint32_t made = 0;
    size_t piece = 0;  // of the curve
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        const double along = length * made / wanted;
        if (piece + 2 < points && curve[piece + 1].along < along) {
            ++piece;
            return true;
        }
        if (made == wanted) {
            samples.push_back(new_sample(curve.back().at, curve.back().clearance));
            return false;
        }
        const CurvePoint &from = curve[piece], &to = curve[piece + 1];
        const double share = std::clamp((along - from.along) / (to.along - from.along), 0.0, 1.0);
        samples.push_back(new_sample(mix(from.at, to.at, share), std::lerp(from.clearance, to.clearance, share)));
        ++made;
        return true;
    });
}

// The nodes are among the samples.
Task<void> sample_polyline(Pace& pace, const Path& path, double spacing, Samples& samples) {
    Slice slice(Cost::tens_of_ns);
    for (size_t piece = 0; piece < path.pieces(); ++piece) {
        const AxisNode &from = path.node(piece), &to = path.node(piece + 1);
        const auto steps = static_cast<uint32_t>(std::max(1.0, std::ceil(distance(from.at, to.at) / spacing)));
        if (!has_room(steps + size_t{1}, samples)) co_await make_room(pace, steps + size_t{1}, samples);
        samples.push_back(new_sample(from.at, from.clearance));
        for (uint32_t step = 1; step < steps; ++step) {
            const double share = static_cast<double>(step) / steps;
            samples.push_back(new_sample(mix(from.at, to.at, share), std::lerp(from.clearance, to.clearance, share)));
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    const AxisNode& last = path.node(path.pieces());
    samples.push_back(new_sample(last.at, last.clearance));
}

// The slice at a sample while it is held against the contour's edges.
struct Cut {
    Cut(std::span<AxisSample> samples, size_t number) : sample(samples[number]) {
        const Point2& from = samples[std::max<size_t>(number, 1) - 1].at;
        const Point2& to = samples[std::min(number + 1, samples.size() - 1)].at;
        const double length = distance(from, to);
        // A curve that turns back on itself at once has no direction there: any will do.
        sample.left_of = length > 0 ? Point2{(from.y - to.y) / length, (to.x - from.x) / length} : Point2{0, 1};
        before = from;
        reach = distance(from, sample.at) * (1 + 1e-9);
    }

    // Takes the edges [begin, end) into account. Returns what that cost.
    uint32_t hold_against(const Contour& contour, uint32_t begin, uint32_t end) {
        const Point2 at = sample.at, n = sample.left_of;
        const double near = reach;
        double left = sample.left, right = sample.right;
        uint32_t work = end - begin, to_the_left = 0;
        // In front of the slice's line, and to the left.
        const auto seen = [&](const Point2& p) {
            const double x = p.x - at.x, y = p.y - at.y;
            return Point2{x * n.y - y * n.x, x * n.x + y * n.y};
        };
        for (; begin < end; ++begin) {
            const bool ends_ring = begin + 1 == contour.offsets[ring + 1];
            const uint32_t next = ends_ring ? contour.offsets[ring] : begin + 1;
            ring += ends_ring;
            const Point2 &a = contour.points[begin], &b = contour.points[next];
            const Point2 from = seen(a), to = seen(b);
            const bool is_far = std::min(from.x, to.x) > near || std::max(from.x, to.x) < -near ||
                                std::min(from.y, to.y) > near || std::max(from.y, to.y) < -near;
            if (!is_far) {
                work += near_edge_work;
                is_outside = is_outside || stretches_meet(before, at, a, b);
            }
            // Half-open, so that a line through a point counts once.
            if ((from.x < 0) == (to.x < 0)) continue;
            const double crossing = from.y + from.x / (from.x - to.x) * (to.y - from.y);
            if (crossing > 0) {
                left = std::min(left, crossing);
                ++to_the_left;
            } else {
                right = std::min(right, -crossing);
            }
        }
        sample.left = left;
        sample.right = right;
        crossings += to_the_left;
        return work;
    }
    // Whether the sample and the way to it from the one before are in the shape.
    bool is_inside() const { return !is_outside && crossings % 2 == 1; }

    AxisSample& sample;
    Point2 before{};
    double reach = 0;  // the distance to that
    uint32_t ring = 0;
    uint32_t crossings = 0;  // of the slice's line to the left of the sample
    bool is_outside = false;
};

// Returns whether the branch stays in the shape.
Task<bool> cut_slices(Pace& pace, const Contour& contour, std::span<AxisSample> samples) {
    Slice slice(Cost::some_ns);
    bool is_inside = true;
    for (size_t i = 0; i < samples.size(); ++i) {
        Cut cut(samples, i);
        for (uint32_t edge = 0; edge < contour.size();) {
            const uint32_t begin = edge;
            edge += std::min(contour.size() - begin, edges_a_step);
            if (slice.is_over(cut.hold_against(contour, begin, edge))) co_await pace;
        }
        is_inside = is_inside && cut.is_inside();
    }
    co_await pace;
    co_return is_inside;
}

}  // namespace

Task<PartSkeleton> axis_branches(Pace& pace, const Contour& contour, AxisGraph graph, double spacing,
                                 std::span<const uint8_t> stops) {
    PartSkeleton part(pace.memory());
    part.graph = std::move(graph);
    const auto& arcs = part.graph.arcs;
    // An arc's ends, each two, by node.
    const Groups ends = co_await group_by(pace, 2 * arcs.size(), part.graph.nodes.size(),
                                          [&](uint32_t end) { return arcs[end / 2][end % 2]; });
    const auto goes_on = [&](uint32_t node) {
        return ends.of(node).size() == 2 && (stops.empty() || stops[node] == 0);
    };
    const auto neighbour = [&](uint32_t end) { return arcs[end / 2][1 - end % 2]; };
    Path path{part.graph, std::pmr::vector<uint32_t>(pace.memory())};
    path.nodes.reserve(part.graph.nodes.size());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t node = 0; node < part.graph.nodes.size(); ++node) {
        if (slice.is_over()) co_await pace;
        if (goes_on(node)) continue;
        for (const uint32_t begin : ends.of(node)) {
            path.nodes.clear();
            path.nodes.push_back(node);
            path.nodes.push_back(neighbour(begin));
            while (goes_on(path.nodes.back())) {
                const auto here = ends.of(path.nodes.back());
                const uint32_t before = path.nodes[path.nodes.size() - 2], first = neighbour(here[0]);
                path.nodes.push_back(first == before ? neighbour(here[1]) : first);
                if (slice.is_over()) co_await pace;
            }
            // Each branch is found from both of its ends; it is taken from the one with the lower number.
            if (path.nodes.back() < node) continue;
            const auto first = static_cast<uint32_t>(part.samples.size());
            bool is_inside = false;
            if (path.pieces() > 1) {
                co_await sample_spline(pace, path, spacing, part.samples);
                const auto samples = std::span(part.samples).subspan(first);
                is_inside = co_await cut_slices(pace, contour, samples);
                if (!is_inside) part.samples.resize(first);
            }
            if (!is_inside) {
                co_await sample_polyline(pace, path, spacing, part.samples);
                const auto samples = std::span(part.samples).subspan(first);
                co_await cut_slices(pace, contour, samples);
            }
            part.branches.push_back({node, path.nodes.back(), first, static_cast<uint32_t>(part.samples.size())});
        }
    }
    co_return part;
}

}  // namespace flg
