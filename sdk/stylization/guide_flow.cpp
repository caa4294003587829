// SPDX-License-Identifier: MIT
#include "stylization/guide_flow.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// The flow looks for its end up to t = this times the squared length of the curve at t. The overall bend of a curve,
// a half wave of its own length, decays as exp(-pi^2 (1 - alpha) t / length^2): with alpha = 1/2 by a fifth at the limit.
constexpr double longest_time = 0.04;
// t * mean(kappa^2) must change by this factor for a rise or a fall to count; below it is the noise of the sampling.
constexpr double significant_change = 1.05;
// Detail that only ends with the search: the length falls below this part of what it was in the last valley.
constexpr double drastic_shrinking = 0.5;
// Agreement asked of the diffusivity at the critical curvature; it is a margin, not a result.
constexpr double limit_tolerance = 0.01;
constexpr uint32_t max_limit_passes = 8;
constexpr double min_elasticity = 0.1;
// |t_i - t_(i-1)|, the Steiner curvature of a corner expanded by a line segment times the spacing, is at most this.
constexpr double max_bend = 2.0;

}  // namespace

GuideFlow::GuideFlow(const Vec3* style, uint32_t count, const Params& params, Memory* memory)
    : style_(style),
      count_(count),
      params_(params),
      points_(count, memory),
      other_(count, memory),
      saved_(count, memory),
      bend_(count, memory),
      factor_(count, memory),
      end_time_(params.time),
      critical_bend_(max_bend),
      rising_(true) {}

bool GuideFlow::run(uint32_t n) {
    // A pass that ends early in the budget leaves the rest to the next call: results don't depend on n, and passes are
    // long next to what a call costs.
    const uint32_t end = n < count_ - index_ ? index_ + n : count_;
    switch (phase_) {
        case Phase::load: load(end); break;
        case Phase::measure: measure(end); break;
        case Phase::limit: limit(end); break;
        case Phase::forward: forward(end); break;
        case Phase::backward: backward(end); break;
        case Phase::respace: respace(n); break;
        case Phase::save: save(end); break;
        case Phase::done: break;
    }
    return phase_ == Phase::done;
}

void GuideFlow::enter(Phase phase) {
    phase_ = phase;
    index_ = 0;
}

void GuideFlow::load(uint32_t end) {
    for (; index_ < end; ++index_) {
        points_[index_] = style_[index_];
        if (end_time_ == 0.0) saved_[index_] = style_[index_];
    }
    if (index_ == count_) enter(Phase::measure);
}

// Lengths and curvatures of the evenly spaced curve. index_ runs over the segments, its own bend is at its start.
void GuideFlow::measure(uint32_t end) {
    if (index_ == 0) {
        length_ = 0.0;
        sum_bend_sq_ = 0.0;
    }
    const uint32_t last = std::min(end, count_ - 1);
    const auto unit = [](const Vec3& v, double norm) -> Vec3 { return norm > 0.0 ? Vec3(v / norm) : Vec3::Zero(); };
    Vec3 before = Vec3::Zero();
    if (index_ > 0 && index_ < last) {
        before = points_[index_] - points_[index_ - 1];
        before = unit(before, before.norm());
    }
    for (; index_ < last; ++index_) {
        const Vec3 step = points_[index_ + 1] - points_[index_];
        const double step_length = step.norm();
        const Vec3 tangent = unit(step, step_length);
        const double bend_sq = index_ > 0 ? (tangent - before).squaredNorm() : 0.0;
        bend_[index_] = std::sqrt(bend_sq);
        sum_bend_sq_ += bend_sq;
        length_ += step_length;
        before = tangent;
    }
    if (index_ == count_ - 1) measured();
}

// Chooses what comes next: the end, a copy of the valley, or a step.
void GuideFlow::measured() {
    if (end_time_ > 0.0) {
        if (time_ >= end_time_) return finish(points_, time_, length_);
        return begin_step();
    }
    if (steps_ == 0) saved_length_ = length_;
    const bool over = length_ == 0.0 || params_.alpha >= 1.0 || time_ >= longest_time * length_ * length_;
    // t * mean(kappa^2), with kappa = bend / spacing, spacing = length / (count - 1).
    const double loss = over ? 0.0 : time_ * sum_bend_sq_ * (count_ - 1) / (length_ * length_);
    if (over) {
        // Still losing length at the limit, and most of it already: all of that was detail.
        if (rising_ && length_ < drastic_shrinking * saved_length_) {
            saved_.swap(points_);
            saved_time_ = time_;
            saved_length_ = length_;
        }
        if (params_.smoothing == 1.0 || saved_time_ == 0.0) return finish(saved_, saved_time_, saved_length_);
        return restart(params_.smoothing * saved_time_);
    }
    if (rising_) {
        peak_ = std::max(peak_, loss);
        if (loss * significant_change < peak_) {
            rising_ = false;
            low_ = peak_;
        }
    }
    if (!rising_) {
        if (loss < low_) {
            low_ = loss;
            saved_time_ = time_;
            saved_length_ = length_;
            return enter(Phase::save);
        }
        if (loss > low_ * significant_change) {
            rising_ = true;
            peak_ = loss;
        }
    }
    begin_step();
}

void GuideFlow::save(uint32_t end) {
    for (; index_ < end; ++index_) saved_[index_] = points_[index_];
    if (index_ == count_) begin_step();
}

void GuideFlow::restart(double time) {
    end_time_ = time;
    time_ = 0.0;
    critical_bend_ = max_bend;
    enter(Phase::load);
}

void GuideFlow::finish(const std::pmr::vector<Vec3>& points, double time, double length) {
    result_ = points.data();
    result_time_ = time;
    result_length_ = length;
    enter(Phase::done);
}

void GuideFlow::begin_step() {
    const double spacing = length_ / (count_ - 1);
    step_time_ = params_.growth * std::max(time_, spacing * spacing);
    if (end_time_ > 0.0) step_time_ = std::min(step_time_, end_time_ - time_);
    limit_passes_ = 0;
    force_ = 0.0;
    enter(params_.alpha > 0.0 && sum_bend_sq_ > 0.0 ? Phase::limit : Phase::forward);
}

// Finds the critical curvature kappa_c with 2 alpha F kappa_c = (1 + alpha) / 2, by Newton's method on the logarithms;
// F belongs to the kappa_c it was summed with, so the length law holds whether or not that has converged.
void GuideFlow::limit(uint32_t end) {
    if (index_ == 0) {
        sum_force_ = 0.0;
        force_ = 0.0;  // the sum of d(kappa psi)/d(kappa_c) while summing
    }
    const uint32_t last = std::min(end, count_ - 1);
    for (; index_ < last; ++index_) {
        const double bend = bend_[index_];
        const double capped = std::min(bend, critical_bend_);
        sum_force_ += bend * capped * (2.0 * bend - capped);  // kappa psi
        force_ += 2.0 * bend * (bend - capped);
    }
    if (index_ == count_ - 1) limited();
}

void GuideFlow::limited() {
    const double elasticity = std::max(1.0 - critical_bend_ * force_ / sum_force_, min_elasticity);
    force_ = sum_bend_sq_ / sum_force_;
    const double wanted = 0.5 * (1.0 + params_.alpha);
    const double ratio = wanted / (2.0 * params_.alpha * force_ * critical_bend_);
    const bool met = ratio > 1.0 - limit_tolerance && (ratio < 1.0 + limit_tolerance || critical_bend_ == max_bend);
    if (met || ++limit_passes_ == max_limit_passes) return enter(Phase::forward);
    critical_bend_ = std::min(critical_bend_ * std::pow(ratio, 1.0 / elasticity), max_bend);
    enter(Phase::limit);
}

// Elimination of (I - step (1 - w) d_ss) x' = x from the first point, which stays, on.
void GuideFlow::forward(uint32_t end) {
    if (index_ == 0) {
        other_[0] = points_[0];
        factor_[0] = 0.0;
        ++index_;
    }
    const double spacing = length_ / (count_ - 1);
    const double ratio = step_time_ / (spacing * spacing);
    const double force = params_.alpha * force_;
    const uint32_t last = std::min(end, count_ - 1);
    for (; index_ < last; ++index_) {
        const double bend = bend_[index_];
        const double capped = std::min(bend, critical_bend_);
        const double held = capped < bend ? force * capped * (2.0 - capped / bend) : force * bend;  // w
        const double weight = ratio * std::max(1.0 - held, 0.0);
        const double scale = 1.0 / (1.0 + weight * (2.0 - factor_[index_ - 1]));
        factor_[index_] = weight * scale;
        other_[index_] = (points_[index_] + weight * other_[index_ - 1]) * scale;
    }
    if (index_ == count_ - 1) enter(Phase::backward);
}

// Substitution back from the last point, which stays. index_ counts from the end; factor_ becomes the arc length from
// a point to the end.
void GuideFlow::backward(uint32_t end) {
    if (index_ == 0) {
        factor_[count_ - 1] = 0.0;
        ++index_;
    }
    for (; index_ < end; ++index_) {
        const uint32_t i = count_ - 1 - index_;
        if (i > 0) points_[i] = other_[i] + factor_[i] * points_[i + 1];
        factor_[i] = factor_[i + 1] + (points_[i + 1] - points_[i]).norm();
    }
    if (index_ == count_) {
        enter(Phase::respace);
        segment_ = 0;
    }
}

// Even spacing along the polygon. A unit is a new point or a step along the old ones.
void GuideFlow::respace(uint32_t n) {
    const double total = factor_[0];
    const double spacing = total / (count_ - 1);
    if (index_ == 0) {
        other_[0] = points_[0];
        ++index_;
    }
    for (; n > 0 && index_ < count_ - 1; --n) {
        const double rest = spacing * (count_ - 1 - index_);
        if (segment_ + 2 < count_ && factor_[segment_ + 1] > rest) {
            ++segment_;
            continue;
        }
        const double segment_length = factor_[segment_] - factor_[segment_ + 1];
        const double t = segment_length > 0.0 ? std::clamp((factor_[segment_] - rest) / segment_length, 0.0, 1.0) : 0.0;
        other_[index_] = points_[segment_] + t * (points_[segment_ + 1] - points_[segment_]);
        ++index_;
    }
    if (index_ < count_ - 1) return;
    other_[count_ - 1] = points_[count_ - 1];
    std::swap(points_, other_);
    time_ = step_time_ == end_time_ - time_ ? end_time_ : time_ + step_time_;  // arrives there exactly
    ++steps_;
    enter(Phase::measure);
}

}  // namespace flg
