// SPDX-License-Identifier: MIT
// Branches are short, and many: so the loops here share one frame and one slice, where each() would take a frame each.
#include "bones/bounded_dp.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr double falls_by = 0.8;     // the paper's factor
constexpr uint32_t max_rounds = 64;  // the threshold is down by six orders of magnitude then

double distance_to_line(const Point2& p, const Point2& a, const Point2& b) {
    const double length = distance(a, b);
    if (length == 0) return distance(p, a);
    return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

struct Range {
    uint32_t begin, end;
    uint32_t size() const { return end - begin; }
};

// The sample of the largest error in a range.
struct Worst {
    double error = 0;
    uint32_t at = 0;
};

// Whether a bone crosses the slices from `begin` to `end`.
bool crosses_slices(std::span<const AxisSample> samples, const Range& bone, uint32_t begin, uint32_t end) {
    const Point2 &a = samples[bone.begin].at, &b = samples[bone.end].at;
    for (uint32_t i = begin; i < end; ++i) {
        const AxisSample& s = samples[i];
        const Point2& n = s.left_of;
        const double front_a = (a.x - s.at.x) * n.y - (a.y - s.at.y) * n.x;
        const double front_b = (b.x - s.at.x) * n.y - (b.y - s.at.y) * n.x;
        if (front_a > 0 || front_b < 0 || front_a == front_b) return false;
        const double left_a = (a.x - s.at.x) * n.x + (a.y - s.at.y) * n.y;
        const double left_b = (b.x - s.at.x) * n.x + (b.y - s.at.y) * n.y;
        const double left = left_a + front_a / (front_a - front_b) * (left_b - left_a);
        if (left > s.left || left < -s.right) return false;
    }
    return true;
}

class Branch {
public:
    Branch(std::span<const AxisSample> samples, double shape_weight, Memory* memory)
        : samples_(samples),
          shape_weight_(shape_weight),
          along_(samples.size(), memory),
          is_kept_(samples.size(), memory) {}

    uint32_t size() const { return static_cast<uint32_t>(samples_.size()); }
    const Point2& at(uint32_t i) const { return samples_[i].at; }
    size_t kept_count() const { return kept_count_; }
    void keep(uint32_t i) {
        is_kept_[i] = 1;
        ++kept_count_;
    }
    void collect(uint32_t begin, uint32_t end, std::pmr::vector<uint32_t>& joints) const {
        for (uint32_t i = begin; i < end; ++i)
            if (is_kept_[i] != 0) joints.push_back(i);
    }

    void measure(uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            along_[i] = i == 0 ? 0 : along_[i - 1] + distance(samples_[i - 1].at, samples_[i].at);
            is_kept_[i] = i == 0 || i + 1 == size();
        }
    }

    // Of the range's samples from `begin` to `end`, and what was found before.
    Worst worst_in(const Range& range, uint32_t begin, uint32_t end, Worst worst) const {
        const AxisSample &s = samples_[range.begin], &e = samples_[range.end];
        const Point2 upper_s{along_[range.begin], s.left}, upper_e{along_[range.end], e.left};
        const Point2 lower_s{along_[range.begin], -s.right}, lower_e{along_[range.end], -e.right};
        for (uint32_t i = begin; i < end; ++i) {
            const AxisSample& sample = samples_[i];
            const double axis = distance_to_line(sample.at, s.at, e.at);
            const double shape = distance_to_line({along_[i], sample.left}, upper_s, upper_e) +
                                 distance_to_line({along_[i], -sample.right}, lower_s, lower_e);
            const double error = axis + shape_weight_ * shape;
            if (error > worst.error) worst = {error, i};
        }
        return worst;
    }

private:
    std::span<const AxisSample> samples_;
    double shape_weight_;
    Buffer<double> along_;
    Buffer<uint8_t> is_kept_;
    size_t kept_count_ = 2;  // the first and the last are to begin with
};

}  // namespace

Task<std::pmr::vector<uint32_t>> bounded_dp(Pace& pace, const Contour& contour, std::span<const AxisSample> samples,
                                            double threshold, double shape_weight) {
    Branch branch(samples, shape_weight, pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (Portion part(slice, 0, branch.size()); part.next();) {
        branch.measure(part.begin, part.end);
        if (part.is_over()) co_await pace;
    }
    std::pmr::vector<uint32_t> joints(pace.memory());
    std::pmr::vector<Range> ranges(pace.memory());
    joints.push_back(0);
    joints.push_back(branch.size() - 1);
    for (uint32_t round = 1;; ++round) {
        // What a larger threshold keeps a smaller one keeps too, so each round goes on where the last one ended.
        for (size_t bone = 0; bone + 1 < joints.size(); ++bone) {
            ranges.push_back({joints[bone], joints[bone + 1]});
            while (!ranges.empty()) {
                const Range range = ranges.back();
                ranges.pop_back();
                Worst worst{0, range.begin + 1};
                for (Portion part(slice, range.begin + 1, range.end); part.next();) {
                    worst = branch.worst_in(range, part.begin, part.end, worst);
                    if (part.is_over()) co_await pace;
                }
                if (slice.is_over()) co_await pace;
                if (range.size() == 1 || !(worst.error > threshold)) continue;
                branch.keep(worst.at);
                // The shorter one first: so there are never many.
                const Range before{range.begin, worst.at}, after{worst.at, range.end};
                const bool before_is_longer = before.size() > after.size();
                ranges.push_back(before_is_longer ? before : after);
                ranges.push_back(before_is_longer ? after : before);
            }
        }
        joints.clear();
        joints.reserve(branch.kept_count());
        for (Portion part(slice, 0, branch.size()); part.next();) {
            branch.collect(part.begin, part.end, joints);
            if (part.is_over()) co_await pace;
        }
        bool is_inside = true;
        for (size_t number = 0; number + 1 < joints.size() && is_inside; ++number) {
            const Range bone{joints[number], joints[number + 1]};
            for (Portion part(slice, bone.begin + 1, bone.end); is_inside && part.next();) {
                is_inside = crosses_slices(samples, bone, part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
            // Neighbours on an axis that is inside of the shape need no look at the contour.
            const uint32_t edges = bone.size() == 1 ? 0 : contour.size();
            for (Portion part(slice, 0, edges); is_inside && part.next();) {
                is_inside = !meets_edges(contour, branch.at(bone.begin), branch.at(bone.end), part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
            if (slice.is_over()) co_await pace;
        }
        if (is_inside) break;
        threshold = round < max_rounds ? threshold * falls_by : -1;
    }
    co_await pace;
    co_return joints;
}

Task<bool> bone_is_inside(Pace& pace, const Contour& contour, std::span<const AxisSample> samples, uint32_t from,
                          uint32_t to) {
    const Range bone{from, to};
    bool is_inside = true;
    Slice slice(Cost::tens_of_ns);
    for (Portion part(slice, from + 1, to); is_inside && part.next();) {
        is_inside = crosses_slices(samples, bone, part.begin, part.end);
        if (part.is_over()) co_await pace;
    }
    const uint32_t edges = bone.size() == 1 ? 0 : contour.size();
    for (Portion part(slice, 0, edges); is_inside && part.next();) {
        is_inside = !meets_edges(contour, samples[from].at, samples[to].at, part.begin, part.end);
        if (part.is_over()) co_await pace;
    }
    co_return is_inside;
}

}  // namespace flg
