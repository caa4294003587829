// SPDX-License-Identifier: MIT
#include "bones/axis_branches.h"

#include <algorithm>
#include <cmath>

#include "skeletons/plane.h"

namespace flg {
namespace {

constexpr uint32_t batch = 64;
constexpr uint32_t steps_per_piece = 8;
constexpr double slice_limit = 2;  // times the clearance

}  // namespace

AxisBranchesKernel::AxisBranchesKernel(const Contour& contour, double spacing, PartSkeleton& part, Memory* memory)
    : contour_(contour),
      spacing_(spacing),
      part_(part),
      first_link_(part.graph.nodes.size() + 2, 0, memory),
      links_(2 * part.graph.arcs.size(), 0, memory),
      path_(memory),
      curve_(memory) {}

bool AxisBranchesKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void AxisBranchesKernel::step() {
    const auto& arcs = part_.graph.arcs;
    switch (pass_) {
        case Pass::count:
            if (at_ == arcs.size()) return enter(Pass::sum);
            for (const uint32_t node : arcs[at_]) ++first_link_[node + 2];
            ++at_;
            return;
        case Pass::sum:
            if (at_ == part_.graph.nodes.size()) return enter(Pass::links);
            first_link_[at_ + 2] += first_link_[at_ + 1];
            ++at_;
            return;
        case Pass::links:  // what is one place too far becomes right as the places are taken
            if (at_ == arcs.size()) return enter(Pass::begin);
            links_[first_link_[arcs[at_][0] + 1]++] = arcs[at_][1];
            links_[first_link_[arcs[at_][1] + 1]++] = arcs[at_][0];
            ++at_;
            return;
        case Pass::begin: return begin_branch();
        case Pass::walk: return walk();
        case Pass::curve: return add_curve_point();
        case Pass::samples: return add_sample();
        case Pass::slices: return slice();
        case Pass::done: return;
    }
}

// The next way out of a junction or an end that has not been gone yet.
void AxisBranchesKernel::begin_branch() {
    if (node_ == part_.graph.nodes.size()) return enter(Pass::done);
    if (degree(node_) == 2 || side_ == degree(node_)) {
        ++node_;
        side_ = 0;
        return;
    }
    path_.assign({node_, links_[first_link_[node_] + side_]});
    ++side_;
    enter(Pass::walk);
}

void AxisBranchesKernel::walk() {
    const uint32_t here = path_.back(), before = path_[path_.size() - 2];
    if (degree(here) == 2) {
        const uint32_t first = links_[first_link_[here]];
        path_.push_back(first == before ? links_[first_link_[here] + 1] : first);
        return;
    }
    // Each branch is found from both of its ends; it is taken from the one with the lower number.
    if (here < path_.front()) return enter(Pass::begin);
    is_smooth_ = path_.size() > 2;
    part_.branches.push_back({path_.front(), here, static_cast<uint32_t>(part_.samples.size()), 0});
    begin_curve();
}

void AxisBranchesKernel::begin_curve() {
    curve_.clear();
    piece_ = 0;
    enter(Pass::curve);
}

// A point between two of the path's nodes, on the centripetal Catmull-Rom spline (Barry, Goldman 1988).
Point2 AxisBranchesKernel::spline(uint32_t piece, double share) const {
    const auto node = [&](size_t i) { return part_.graph.nodes[path_[i]].at; };
    const Point2 b = node(piece), c = node(piece + 1);
    const Point2 a = piece > 0 ? node(piece - 1) : mix(b, c, -1);
    const Point2 d = piece + 2 < path_.size() ? node(piece + 2) : mix(c, b, -1);
    const double t1 = std::sqrt(distance(a, b)), t2 = t1 + std::sqrt(distance(b, c)),
                 t3 = t2 + std::sqrt(distance(c, d));
    const double t = t1 + share * (t2 - t1);
    const Point2 ab = mix(a, b, t / t1), bc = mix(b, c, share), cd = mix(c, d, (t - t2) / (t3 - t2));
    return mix(mix(ab, bc, t / t2), mix(bc, cd, (t - t1) / (t3 - t1)), share);
}

// Of a smooth branch some points for each piece, to measure it by; of another those that become its samples, so that
// its nodes are among them.
void AxisBranchesKernel::add_curve_point() {
    const bool is_last = piece_ + 1 == path_.size();
    const AxisNode& from = part_.graph.nodes[path_[piece_]];
    CurvePoint point{from.at, 0, from.clearance};
    if (at_ > 0) {
        const AxisNode& to = part_.graph.nodes[path_[piece_ + 1]];
        const double share = static_cast<double>(at_) / steps_;
        point = {is_smooth_ ? spline(piece_, share) : mix(from.at, to.at, share), 0,
                 std::lerp(from.clearance, to.clearance, share)};
    } else if (!is_last) {
        const double length = distance(from.at, part_.graph.nodes[path_[piece_ + 1]].at);
        steps_ = is_smooth_ ? steps_per_piece : static_cast<uint32_t>(std::max(1.0, std::ceil(length / spacing_)));
    }
    if (!curve_.empty()) point.along = curve_.back().along + distance(curve_.back().at, point.at);
    curve_.push_back(point);
    if (is_last) {
        wanted_ = is_smooth_ ? static_cast<uint32_t>(std::max(1.0, std::ceil(point.along / spacing_)))
                             : static_cast<uint32_t>(curve_.size()) - 1;
        piece_ = 0;
        return enter(Pass::samples);
    }
    if (++at_ == steps_) {
        ++piece_;
        at_ = 0;
    }
}

void AxisBranchesKernel::add_sample() {
    const double along = curve_.back().along * at_ / wanted_;
    if (is_smooth_ && piece_ + 2 < curve_.size() && curve_[piece_ + 1].along < along) {
        ++piece_;
        return;
    }
    CurvePoint point = at_ == wanted_ ? curve_.back() : curve_[is_smooth_ ? piece_ : at_];
    if (is_smooth_ && at_ < wanted_) {
        const CurvePoint& to = curve_[piece_ + 1];
        const double share = std::clamp((along - point.along) / (to.along - point.along), 0.0, 1.0);
        point = {mix(point.at, to.at, share), along, std::lerp(point.clearance, to.clearance, share)};
    }
    const double reach = slice_limit * point.clearance;
    part_.samples.push_back({point.at, {}, reach, reach});
    if (at_++ < wanted_) return;
    AxisBranch& branch = part_.branches.back();
    branch.end = static_cast<uint32_t>(part_.samples.size());
    sample_ = branch.begin;
    is_outside_ = false;
    enter(Pass::slices);
}

void AxisBranchesKernel::begin_slice() {
    const AxisBranch& branch = part_.branches.back();
    AxisSample& sample = part_.samples[sample_];
    const Point2& from = part_.samples[std::max(sample_, branch.begin + 1) - 1].at;
    const Point2& to = part_.samples[std::min(sample_ + 1, branch.end - 1)].at;
    const double length = distance(from, to);
    // A curve that turns back on itself at once has no direction there: any will do.
    sample.left_of = length > 0 ? Point2{(from.y - to.y) / length, (to.x - from.x) / length} : Point2{0, 1};
    before_ = from;
    reach_ = distance(from, sample.at) * (1 + 1e-9);
    crossings_ = 0;
    ring_ = 0;
}

void AxisBranchesKernel::slice() {
    if (at_ == 0) begin_slice();
    AxisSample& sample = part_.samples[sample_];
    const Point2& n = sample.left_of;
    // In front of the slice's line, and to the left.
    const auto seen = [&](const Point2& p) {
        const double x = p.x - sample.at.x, y = p.y - sample.at.y;
        return Point2{x * n.y - y * n.x, x * n.x + y * n.y};
    };
    for (uint32_t k = 0; k < batch && at_ < contour_.size(); ++k) {
        const Point2 &a = contour_.points[at_], &b = contour_.points[next_point()];
        const Point2 from = seen(a), to = seen(b);
        const bool is_far = std::min(from.x, to.x) > reach_ || std::max(from.x, to.x) < -reach_ ||
                            std::min(from.y, to.y) > reach_ || std::max(from.y, to.y) < -reach_;
        is_outside_ = is_outside_ || (!is_far && stretches_meet(before_, sample.at, a, b));
        // Half-open, so that a line through a point counts once.
        if ((from.x < 0) == (to.x < 0)) continue;
        const double left = from.y + from.x / (from.x - to.x) * (to.y - from.y);
        if (left > 0) {
            sample.left = std::min(sample.left, left);
            ++crossings_;
        } else {
            sample.right = std::min(sample.right, -left);
        }
    }
    if (at_ == contour_.size()) end_sample();
}

// The point after number at_ on its ring; at_ goes on.
uint32_t AxisBranchesKernel::next_point() {
    if (++at_ < contour_.offsets[ring_ + 1]) return at_;
    return contour_.offsets[ring_++];
}

void AxisBranchesKernel::end_sample() {
    is_outside_ = is_outside_ || crossings_ % 2 == 0;
    ++sample_;
    AxisBranch& branch = part_.branches.back();
    if (sample_ < branch.end) return enter(Pass::slices);
    if (is_outside_ && is_smooth_) {  // again, along the polyline
        is_smooth_ = false;
        part_.samples.resize(branch.begin);
        return begin_curve();
    }
    enter(Pass::begin);
}

}  // namespace flg
