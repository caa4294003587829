// SPDX-License-Identifier: MIT
#include "curves/framed_sampler.h"

#include <algorithm>

#include "curves/drawn_normal.h"

namespace flg {

FramedSampler::FramedSampler(const SamplingPlan& plan)
    : plan_(plan),
      sampler_(begin()),
      left_(plan.sample_count()),
      special_(plan.steps > 0 && (plan.frame != FLG_FRAME_METHOD_ROTATION_MINIMIZING || plan.curve.closed)) {
    constexpr double min_turn_rad = 1e-6;
    const double step = plan.steps > 0 ? plan.measure.length / plan.steps : 1.0;
    straight_ = std::max(min_turn_rad, plan.measure.resolution() / step);
}

EvenSampler FramedSampler::begin() const {
    if (plan_.exact_step > 0) return {plan_.curve, plan_.exact_step, plan_.step_scales};
    const double length = plan_.step_scales ? plan_.scaled_length : plan_.measure.length;
    return {plan_.curve, length, plan_.steps, plan_.step_scales};
}

void FramedSampler::begin_frame(const CurveSample& first) {
    const Vec3 normal =
        plan_.orientation ? drawn_normal(plan_.orientation, first.tangent) : plan_.measure.initial_normal();
    frame_ = RotationMinimizingFrame(first.position, first.tangent, normal);
}

// All places first, then all frames: so the long latencies of different samples overlap.
uint32_t FramedSampler::next(FramedSample* out, uint32_t capacity, uint32_t& units) {
    capacity = std::min(capacity, left_);
    uint32_t count = 0;
    if (special_) {
        while (count < capacity && next_special(out[count], units)) ++count;
        left_ -= count;
        return count;
    }
    while (count < capacity && sampler_.next(out[count], units)) ++count;
    if (count == 0) return 0;
    uint32_t k = 0;
    if (next_ == 0) {
        begin_frame(out[0]);
        out[k++].normal = frame_.normal();
    }
    RotationMinimizingFrame frame = frame_;
    for (; k < count; ++k) {
        frame.step(out[k].position, out[k].tangent);
        out[k].normal = frame.normal();
    }
    frame_ = frame;
    next_ += count;
    left_ -= count;
    return count;
}

bool FramedSampler::next_special(FramedSample& out, uint32_t& units) {
    if (plan_.curve.closed && !been_around_ && !go_around(units)) return false;
    return next_by_method(out, units);
}

bool FramedSampler::next_by_method(FramedSample& out, uint32_t& units) {
    if (plan_.frame == FLG_FRAME_METHOD_FRENET) return next_frenet(out, units);
    if (plan_.frame == FLG_FRAME_METHOD_SUPPLIED) return next_supplied(out, units);
    return next_twisted(out, units);
}

// So that the first sample continues the last.
bool FramedSampler::go_around(uint32_t& units) {
    while (next_ < plan_.steps) {
        FramedSample sample;
        if (!next_by_method(sample, units)) return false;
        if (next_ == 1) first_ = sample;
    }
    frame_.step(first_.position, first_.tangent);
    if (!has_normal_) {
        plan_.frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
        twist_per_step_ = angle_about(first_.tangent, frame_.normal(), first_.normal) / plan_.steps;
    }
    sampler_ = begin();
    next_ = 0;
    has_ahead_ = false;
    been_around_ = true;
    return true;
}

// The first sample has nothing before it, unless normals are carried around.
void FramedSampler::carry_frame(const CurveSample& to) {
    if (next_ > 0 || has_normal_) {
        frame_.step(to.position, to.tangent);
    } else {
        begin_frame(to);
    }
}

void FramedSampler::take_normal(const Vec3& normal) {
    frame_.set_normal(normal);
    has_normal_ = true;
}

bool FramedSampler::next_twisted(FramedSample& out, uint32_t& units) {
    if (!sampler_.next(out, units)) return false;
    carry_frame(out);
    out.normal = turned_about(out.tangent, frame_.normal(), next_ * twist_per_step_);
    ++next_;
    return true;
}

bool FramedSampler::next_frenet(FramedSample& out, uint32_t& units) {
    if (!has_ahead_) {
        if (!sampler_.next(ahead_, units)) return false;
        if (!been_around_) before_ = ahead_.tangent;
        has_ahead_ = true;
    }
    const CurveSample current = ahead_;
    if (next_ < plan_.steps && !sampler_.next(ahead_, units)) return false;
    static_cast<CurveSample&>(out) = current;
    carry_frame(current);
    const Vec3 turn = ahead_.tangent - before_;
    const Vec3 across = turn - turn.dot(current.tangent) * current.tangent;
    const double size = across.norm();
    if (size > straight_) take_normal(across / size);
    out.normal = frame_.normal();
    before_ = current.tangent;
    ++next_;
    return true;
}

bool FramedSampler::next_supplied(FramedSample& out, uint32_t& units) {
    constexpr double parallel_sine = 1e-4;  // well above what float coordinates make of parallel vectors
    if (!sampler_.next(out, units)) return false;
    carry_frame(out);
    const Vec3 a = load_vec3(plan_.normals + size_t{3} * out.segment);
    const Vec3 b = load_vec3(plan_.normals + size_t{3} * plan_.curve.following(out.segment));
    const Vec3 supplied = (1.0 - out.t) * a + out.t * b;
    const Vec3 across = supplied - supplied.dot(out.tangent) * out.tangent;
    const double size = across.norm();
    if (size > parallel_sine * supplied.norm()) take_normal(across / size);
    out.normal = frame_.normal();
    ++next_;
    return true;
}

}  // namespace flg
