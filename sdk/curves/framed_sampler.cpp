// SPDX-License-Identifier: MIT
#include "curves/framed_sampler.h"

#include <algorithm>

namespace flg {

FramedSampler::FramedSampler(const SamplingPlan& plan)
    : plan_(plan),
      sampler_(plan.curve, plan.measure.length, plan.steps),
      left_(plan.sample_count()),
      special_(plan.steps > 0 && (plan.frame != FLG_FRAME_ROTATION_MINIMIZING || plan.curve.closed)) {
    constexpr double least_turn_rad = 1e-6;
    const double step = plan.steps > 0 ? plan.measure.length / plan.steps : 1.0;
    straight_ = std::max(least_turn_rad, plan.measure.resolution() / step);
}

void FramedSampler::begin_frame(const CurveSample& first) {
    frame_ = RotationMinimizingFrame(first.position, first.tangent, plan_.measure.initial_normal());
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
    if (plan_.frame == FLG_FRAME_FRENET) return next_frenet(out, units);
    if (plan_.frame == FLG_FRAME_SUPPLIED) return next_supplied(out, units);
    if (!twist_known_ && !measure_twist(units)) return false;
    return next_twisted(out, units);
}

// Carries the frame once around.
bool FramedSampler::measure_twist(uint32_t& units) {
    CurveSample sample;
    while (next_ <= plan_.steps) {
        if (!sampler_.next(sample, units)) return false;
        if (next_++ == 0) {
            begin_frame(sample);
            first_tangent_ = sample.tangent;
            first_normal_ = frame_.normal();
        } else {
            frame_.step(sample.position, sample.tangent);
        }
    }
    // The two tangents of the first point differ if it is a corner.
    frame_.step(sample.position, first_tangent_);
    twist_per_step_ = angle_about(first_tangent_, frame_.normal(), first_normal_) / plan_.steps;
    twist_known_ = true;
    sampler_ = EvenSampler(plan_.curve, plan_.measure.length, plan_.steps);
    next_ = 0;
    return true;
}

bool FramedSampler::next_twisted(FramedSample& out, uint32_t& units) {
    if (!sampler_.next(out, units)) return false;
    if (next_ == 0) {
        begin_frame(out);
    } else {
        frame_.step(out.position, out.tangent);
    }
    out.normal = turned_about(out.tangent, frame_.normal(), next_ * twist_per_step_);
    ++next_;
    return true;
}

bool FramedSampler::next_frenet(FramedSample& out, uint32_t& units) {
    if (!has_ahead_) {
        if (!sampler_.next(ahead_, units)) return false;
        begin_frame(ahead_);
        before_ = ahead_.tangent;
        has_ahead_ = true;
    }
    const CurveSample current = ahead_;
    if (next_ < plan_.steps && !sampler_.next(ahead_, units)) return false;
    static_cast<CurveSample&>(out) = current;
    if (next_ > 0) frame_.step(current.position, current.tangent);
    const Vec3 turn = ahead_.tangent - before_;
    const Vec3 across = turn - turn.dot(current.tangent) * current.tangent;
    const double size = across.norm();
    if (size > straight_) frame_.set_normal(across / size);
    out.normal = frame_.normal();
    before_ = current.tangent;
    ++next_;
    return true;
}

bool FramedSampler::next_supplied(FramedSample& out, uint32_t& units) {
    constexpr double parallel_sine = 1e-4;  // well above what float coordinates make of parallel vectors
    if (!sampler_.next(out, units)) return false;
    if (next_ == 0) {
        begin_frame(out);
    } else {
        frame_.step(out.position, out.tangent);
    }
    const Vec3 a = load_vec3(plan_.normals + size_t{3} * out.segment);
    const Vec3 b = load_vec3(plan_.normals + size_t{3} * plan_.curve.following(out.segment));
    const Vec3 supplied = (1.0 - out.t) * a + out.t * b;
    const Vec3 across = supplied - supplied.dot(out.tangent) * out.tangent;
    const double size = across.norm();
    if (size > parallel_sine * supplied.norm()) frame_.set_normal(across / size);
    out.normal = frame_.normal();
    ++next_;
    return true;
}

}  // namespace flg
