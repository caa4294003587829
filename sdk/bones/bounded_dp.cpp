// SPDX-License-Identifier: MIT
#include "bones/bounded_dp.h"

#include <algorithm>
#include <cmath>

#include "skeletons/plane.h"

namespace flg {
namespace {

constexpr uint32_t batch = 16;
constexpr uint32_t edge_batch = 64;
constexpr double falls_by = 0.8;      // the paper's factor
constexpr uint32_t most_rounds = 64;  // the threshold is down by six orders of magnitude then

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
    const double length = distance(a, b);
    if (length == 0) return distance(p, a);
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

}  // namespace

BoundedDpKernel::BoundedDpKernel(const Contour& contour, std::span<const AxisSample> samples, double threshold,
                                 double shape_weight, std::pmr::vector<uint32_t>& joints, Memory* memory)
    : contour_(contour),
      samples_(samples),
      threshold_(threshold),
      shape_weight_(shape_weight),
      joints_(joints),
      along_(memory),
      kept_(samples.size(), false, memory),
      ranges_(memory) {
    along_.reserve(samples.size());
    kept_.front() = kept_.back() = true;
}

bool BoundedDpKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void BoundedDpKernel::step() {
    switch (pass_) {
        case Pass::along:
            for (uint32_t k = 0; k < batch && at_ < samples_.size(); ++k, ++at_)
                along_.push_back(at_ == 0 ? 0 : along_.back() + distance(samples_[at_ - 1].at, samples_[at_].at));
            if (at_ == samples_.size()) begin_round();
            return;
        case Pass::scan: return scan();
        case Pass::collect:
            for (uint32_t k = 0; k < batch && at_ < samples_.size(); ++k, ++at_)
                if (kept_[at_]) joints_.push_back(at_);
            if (at_ < samples_.size()) return;
            bone_ = 0;
            enter(Pass::slices);
            at_ = joints_[0] + 1;
            return;
        case Pass::slices: return hold_against_slices();
        case Pass::contour: return hold_against_contour();
        case Pass::done: return;
    }
}

// What a larger threshold keeps a smaller one keeps too, so each round goes on where the last one ended.
void BoundedDpKernel::begin_round() {
    ranges_.clear();
    joints_.clear();
    uint32_t begin = 0;
    for (uint32_t i = 1; i < samples_.size(); ++i) {
        if (!kept_[i]) continue;
        if (i > begin + 1) ranges_.push_back({begin, i});
        begin = i;
    }
    begin_range();
}

void BoundedDpKernel::begin_range() {
    if (ranges_.empty()) return enter(Pass::collect);
    most_ = 0;
    enter(Pass::scan);
    at_ = ranges_.back().begin + 1;
}

void BoundedDpKernel::scan() {
    const Range range = ranges_.back();
    const AxisSample &s = samples_[range.begin], &e = samples_[range.end];
    const Point2 upper_s{along_[range.begin], s.left}, upper_e{along_[range.end], e.left};
    const Point2 lower_s{along_[range.begin], -s.right}, lower_e{along_[range.end], -e.right};
    for (uint32_t k = 0; k < batch && at_ < range.end; ++k, ++at_) {
        const AxisSample& sample = samples_[at_];
        const double axis = distance_to_line(sample.at, s.at, e.at);
        const double shape = distance_to_line({along_[at_], sample.left}, upper_s, upper_e) +
                             distance_to_line({along_[at_], -sample.right}, lower_s, lower_e);
        const double error = axis + shape_weight_ * shape;
        if (error > most_) most_ = error, farthest_ = at_;
    }
    if (at_ < range.end) return;
    ranges_.pop_back();
    if (most_ > threshold_) {
        kept_[farthest_] = true;
        if (farthest_ > range.begin + 1) ranges_.push_back({range.begin, farthest_});
        if (range.end > farthest_ + 1) ranges_.push_back({farthest_, range.end});
    }
    begin_range();
}

void BoundedDpKernel::hold_against_slices() {
    const uint32_t end = joints_[bone_ + 1];
    const Point2 &a = samples_[joints_[bone_]].at, &b = samples_[end].at;
    for (uint32_t k = 0; k < batch && at_ < end; ++k, ++at_) {
        const AxisSample& s = samples_[at_];
        const Point2& n = s.left_of;
        const double front_a = (a.x - s.at.x) * n.y - (a.y - s.at.y) * n.x;
        const double front_b = (b.x - s.at.x) * n.y - (b.y - s.at.y) * n.x;
        if (front_a > 0 || front_b < 0 || front_a == front_b) return leaves_shape();
        const double left_a = (a.x - s.at.x) * n.x + (a.y - s.at.y) * n.y;
        const double left_b = (b.x - s.at.x) * n.x + (b.y - s.at.y) * n.y;
        const double left = left_a + front_a / (front_a - front_b) * (left_b - left_a);
        if (left > s.left || left < -s.right) return leaves_shape();
    }
    // Neighbours on an axis that is inside of the shape need no look at the contour.
    if (at_ == end) {
        if (end == joints_[bone_] + 1) return next_bone();
        enter(Pass::contour);
    }
}

void BoundedDpKernel::hold_against_contour() {
    const Point2 &a = samples_[joints_[bone_]].at, &b = samples_[joints_[bone_ + 1]].at;
    for (uint32_t k = 0; k < edge_batch; ++k, ++at_) {
        if (at_ == contour_.size()) return next_bone();
        const Point2 &c = contour_.points[at_], &d = contour_.points[contour_.next(at_)];
        if (stretches_meet(a, b, c, d)) return leaves_shape();
    }
}

void BoundedDpKernel::next_bone() {
    if (++bone_ + 1 == joints_.size()) return enter(Pass::done);
    enter(Pass::slices);
    at_ = joints_[bone_] + 1;
}

void BoundedDpKernel::leaves_shape() {
    threshold_ = ++round_ < most_rounds ? threshold_ * falls_by : -1;
    begin_round();
}

}  // namespace flg
