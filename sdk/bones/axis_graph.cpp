// SPDX-License-Identifier: MIT
#include "bones/axis_graph.h"

#include <algorithm>
#include <cmath>

#include "skeletons/plane.h"

namespace flg {
namespace {

constexpr uint32_t batch = 64;
constexpr double sharpness = 2.5, tip_share = 0.75;

}  // namespace

AxisGraphKernel::AxisGraphKernel(const Contour& contour, const StraightSkeleton& skeleton, double collapse,
                                 AxisGraph& out, Memory* memory)
    : contour_(contour),
      skeleton_(skeleton),
      collapse_(collapse),
      out_(out),
      nodes_(memory),
      arcs_(memory),
      links_(memory),
      number_(memory),
      queue_(std::less<Ranked>(), std::pmr::vector<Ranked>(memory)) {
    const uint32_t first = contour.size(), count = static_cast<uint32_t>(skeleton.nodes.size()) - first;
    nodes_.reserve(count);
    arcs_.reserve(skeleton.arcs.size());
    links_.reserve(2 * skeleton.arcs.size());
}

bool AxisGraphKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

uint32_t AxisGraphKernel::root(uint32_t node) {
    while (nodes_[node].united != node) node = nodes_[node].united = nodes_[nodes_[node].united].united;
    return node;
}

double AxisGraphKernel::length(const Arc& arc) {
    return distance(nodes_[root(arc.a)].at, nodes_[root(arc.b)].at);
}

void AxisGraphKernel::link(uint32_t node, uint32_t slot) {
    Node& n = nodes_[node];
    (n.first == no_link ? n.first : links_[n.last].next) = slot;
    n.last = slot;
    ++n.degree;
}

// An arc whose ends are not linked yet becomes one of the tree.
void AxisGraphKernel::add_arc(uint32_t arc) {
    const auto slot = static_cast<uint32_t>(links_.size());
    links_.push_back({arc, no_link});
    links_.push_back({arc, no_link});
    link(arcs_[arc].a, slot);
    link(arcs_[arc].b, slot + 1);
    sum_ += distance(nodes_[arcs_[arc].a].at, nodes_[arcs_[arc].b].at);
}

// Keeps the arc from a node to a point of the contour if that is the end of a sharp tip, without the very end.
void AxisGraphKernel::add_tip(uint32_t tip, uint32_t inner) {
    const uint32_t border = contour_.size();
    if (inner < border) return;
    const SkeletonNode& node = skeleton_.nodes[inner];
    const Point2& end = skeleton_.nodes[tip].at;
    if (distance(node.at, end) <= sharpness * node.time) return;
    const auto self = static_cast<uint32_t>(nodes_.size()), arc = static_cast<uint32_t>(arcs_.size());
    const double clearance = (1 - tip_share) * node.time;
    nodes_.push_back({mix(node.at, end, tip_share), clearance, self, no_link, no_link, 0});
    arcs_.push_back({inner - border, self, false});
    queue_.push({node.time + clearance, arc});
}

void AxisGraphKernel::step() {
    const uint32_t border = contour_.size();
    switch (pass_) {
        case Pass::nodes: {
            if (nodes_.size() + border == skeleton_.nodes.size()) return enter(Pass::arcs);
            const SkeletonNode& node = skeleton_.nodes[border + nodes_.size()];
            const auto self = static_cast<uint32_t>(nodes_.size());
            nodes_.push_back({node.at, node.time, self, no_link, no_link, 0});
            return;
        }
        case Pass::arcs: {
            if (at_ == skeleton_.arcs.size()) return enter(Pass::tree);
            const SkeletonArc& arc = skeleton_.arcs[at_++];
            if (arc.a < border || arc.b < border) return add_tip(std::min(arc.a, arc.b), std::max(arc.a, arc.b));
            const auto self = static_cast<uint32_t>(arcs_.size());
            arcs_.push_back({arc.a - border, arc.b - border, false});
            queue_.push({skeleton_.nodes[arc.a].time + skeleton_.nodes[arc.b].time, self});
            return;
        }
        case Pass::tree: {  // the widest first: what would close a circle is its narrowest arc
            if (queue_.empty()) {
                return enter(Pass::lengths);
            }
            const uint32_t arc = queue_.top().arc;
            queue_.pop();
            const uint32_t a = root(arcs_[arc].a), b = root(arcs_[arc].b);
            if (a == b) {
                arcs_[arc].gone = true;
                return;
            }
            nodes_[std::max(a, b)].united = std::min(a, b);
            add_arc(arc);
            ++alive_;
            return;
        }
        case Pass::lengths:
            if (at_ < nodes_.size()) {
                nodes_[at_].united = at_;
                ++at_;
                return;
            }
            {
                const uint32_t arc = at_ - static_cast<uint32_t>(nodes_.size());
                if (arc == 0) threshold_ = alive_ > 0 ? collapse_ * sum_ / alive_ : 0;
                if (arc == arcs_.size()) return enter(Pass::contract);
                ++at_;
                if (arcs_[arc].gone) return;
                const double arc_length = distance(nodes_[arcs_[arc].a].at, nodes_[arcs_[arc].b].at);
                if (arc_length < threshold_) queue_.push({-arc_length, arc});
            }
            return;
        case Pass::contract: return choose();
        case Pass::check: return check();
        case Pass::apply: return apply();
        case Pass::number:
            if (at_ == 0) number_.resize(nodes_.size());
            if (nodes_[at_].united == at_) {
                number_[at_] = static_cast<uint32_t>(out_.nodes.size());
                out_.nodes.push_back({nodes_[at_].at, nodes_[at_].clearance});
            }
            if (++at_ == nodes_.size()) enter(Pass::write);
            return;
        case Pass::write: {
            if (at_ == arcs_.size()) return enter(Pass::done);
            const Arc& arc = arcs_[at_++];
            if (!arc.gone) out_.arcs.push_back({number_[root(arc.a)], number_[root(arc.b)]});
            return;
        }
        case Pass::done: return;
    }
}

// The shortest arc, unless what is in the queue is out of date.
void AxisGraphKernel::choose() {
    if (queue_.empty()) return enter(Pass::number);
    const Ranked top = queue_.top();
    queue_.pop();
    const Arc& arc = arcs_[top.arc];
    if (arc.gone || length(arc) != -top.rank) return;
    const uint32_t a = root(arc.a), b = root(arc.b);
    const Node &first = nodes_[a], &second = nodes_[b];
    bool keep_first = first.clearance > second.clearance || (first.clearance == second.clearance && a < b);
    const auto rank = [](const Node& node) { return node.degree >= 3 ? 2 : node.degree == 1 ? 1 : 0; };
    if (rank(first) != rank(second)) keep_first = rank(first) > rank(second);
    arc_ = top.arc;
    kept_ = keep_first ? a : b;
    dropped_ = keep_first ? b : a;
    moved_ = nodes_[dropped_].first;
    enter(next_moved() ? Pass::check : Pass::apply);
}

// Goes on to an arc of the dropped end that is moved and that two discs do not cover.
bool AxisGraphKernel::next_moved() {
    for (; moved_ != no_link; moved_ = links_[moved_].next) {
        const Arc& arc = arcs_[links_[moved_].arc];
        if (arc.gone || links_[moved_].arc == arc_) continue;
        const uint32_t a = root(arc.a);
        const Node& other = nodes_[a == dropped_ ? root(arc.b) : a];
        const Node& kept = nodes_[kept_];
        if (distance(other.at, kept.at) > other.clearance + kept.clearance) return true;
    }
    return false;
}

void AxisGraphKernel::check() {
    const Arc& arc = arcs_[links_[moved_].arc];
    const uint32_t a = root(arc.a);
    const Point2 &p = nodes_[kept_].at, &q = nodes_[a == dropped_ ? root(arc.b) : a].at;
    for (uint32_t k = 0; k < batch; ++k) {
        if (at_ == contour_.size()) {
            moved_ = links_[moved_].next;
            return enter(next_moved() ? Pass::check : Pass::apply);
        }
        const Point2 &c = contour_.points[at_], &d = contour_.points[contour_.next(at_)];
        ++at_;
        if (stretches_meet(p, q, c, d))
            return enter(Pass::contract);  // it would leave the shape: the arc stays as it is
    }
}

void AxisGraphKernel::apply() {
    Node &kept = nodes_[kept_], &dropped = nodes_[dropped_];
    if (at_ == 0) {
        arcs_[arc_].gone = true;
        dropped.united = kept_;
        kept.degree += dropped.degree - 2;
        moved_ = dropped.first;
        at_ = 1;
    }
    for (uint32_t k = 0; k < 4; ++k, moved_ = links_[moved_].next) {
        if (moved_ == no_link) {
            links_[kept.last].next = dropped.first;
            kept.last = dropped.last;
            return enter(Pass::contract);
        }
        const uint32_t number = links_[moved_].arc;
        if (arcs_[number].gone) continue;
        const double arc_length = length(arcs_[number]);
        if (arc_length < threshold_) queue_.push({-arc_length, number});
    }
}

}  // namespace flg
