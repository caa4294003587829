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
    chain_ = FrameChain(plan.exact_step > 0 ? plan.exact_step : step);
}

BlockSampler FramedSampler::begin() const {
    if (!plan_.pieces.empty()) return {plan_.curve, plan_.steps, plan_.step_scales, plan_.pieces};
    if (plan_.exact_step > 0) return {plan_.curve, plan_.exact_step, plan_.step_scales};
    const double length = plan_.step_scales ? plan_.scaled_length : plan_.measure.length;
    return {plan_.curve, length, plan_.steps, plan_.step_scales};
}

Vec3 FramedSampler::first_normal(const Vec3& tangent) const {
    return plan_.orientation ? drawn_normal(plan_.orientation, tangent) : plan_.measure.initial_normal();
}

uint32_t FramedSampler::next(SampleBlock& out, uint32_t& units) {
    if (special_) {
        out.count = 0;
        Sample sample;
        while (out.count < std::min(left_, SampleBlock::capacity) && next_special(sample, units)) {
            const uint32_t k = out.count++;
            for (int c = 0; c < 3; ++c) {
                out.start[c][k + 1] = sample.start[c];
                out.offset[c][k + 1] = sample.offset[c];
                out.tangent[c][k + 1] = static_cast<float>(sample.tangent[c]);
            }
            out.set_normal(k, sample.normal);
            out.segment[k] = sample.segment;
            out.t[k] = sample.t;
        }
    } else {
        if (!sampler_.next(out, units)) return 0;
        out.count = std::min(out.count, left_);
        if (!chain_.begun()) chain_.begin(out, first_normal(out.tangent_of(0)));
        chain_.follow(out);
    }
    left_ -= out.count;
    return out.count;
}

bool FramedSampler::place(Sample& out, uint32_t& units) {
    if (placed_at_ == placed_.count) {
        placed_at_ = 0;
        if (!sampler_.next(placed_, units)) return false;
    }
    const uint32_t k = placed_at_++;
    for (int c = 0; c < 3; ++c) {
        out.start[c] = placed_.start[c][k + 1];
        out.offset[c] = placed_.offset[c][k + 1];
    }
    out.position = placed_.position_of(k);
    out.tangent = placed_.tangent_of(k);
    out.segment = placed_.segment[k];
    out.t = placed_.t[k];
    return true;
}

bool FramedSampler::next_special(Sample& out, uint32_t& units) {
    if (plan_.curve.closed && !been_around_ && !go_around(units)) return false;
    return next_by_method(out, units);
}

bool FramedSampler::next_by_method(Sample& out, uint32_t& units) {
    if (plan_.frame == FLG_FRAME_METHOD_FRENET) return next_frenet(out, units);
    if (plan_.frame == FLG_FRAME_METHOD_SUPPLIED) return next_supplied(out, units);
    return next_twisted(out, units);
}

// So that the first sample continues the last.
bool FramedSampler::go_around(uint32_t& units) {
    while (next_ < plan_.steps) {
        Sample sample;
        if (!next_by_method(sample, units)) return false;
        if (next_ == 1) first_ = sample;
    }
    frame_.step(first_.position, first_.tangent);
    if (!has_normal_) {
        plan_.frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
        twist_per_step_ = angle_about(first_.tangent, frame_.normal(), first_.normal) / plan_.steps;
    }
    sampler_ = begin();
    placed_.count = placed_at_ = 0;
    next_ = 0;
    has_ahead_ = false;
    been_around_ = true;
    return true;
}

// The first sample has nothing before it, unless normals are carried around.
void FramedSampler::carry_frame(const Sample& to) {
    if (next_ > 0 || has_normal_) {
        frame_.step(to.position, to.tangent);
    } else {
        frame_ = RotationMinimizingFrame(to.position, to.tangent, first_normal(to.tangent));
    }
}

void FramedSampler::take_normal(const Vec3& normal) {
    frame_.set_normal(normal);
    has_normal_ = true;
}

bool FramedSampler::next_twisted(Sample& out, uint32_t& units) {
    if (!place(out, units)) return false;
    carry_frame(out);
    out.normal = turned_about(out.tangent, frame_.normal(), next_ * twist_per_step_);
    ++next_;
    return true;
}

bool FramedSampler::next_frenet(Sample& out, uint32_t& units) {
    if (!has_ahead_) {
        if (!place(ahead_, units)) return false;
        if (!been_around_) before_ = ahead_.tangent;
        has_ahead_ = true;
    }
    const Sample current = ahead_;
    if (next_ < plan_.steps && !place(ahead_, units)) return false;
    out = current;
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

bool FramedSampler::next_supplied(Sample& out, uint32_t& units) {
    constexpr double parallel_sine = 1e-4;  // well above what float coordinates make of parallel vectors
    if (!place(out, units)) return false;
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
