// SPDX-License-Identifier: MIT
#include "stylization/finishing.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "core/moving_frame.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double coordinate_max = 1e30;  // as curve sets have it
constexpr double time_max_s = 1e30;

constexpr uint32_t block = 16;  // samples
// What one costs, in units.
constexpr uint32_t units_to_move = 3;
constexpr uint32_t units_per_component = 2;
constexpr uint32_t units_to_turn = 16;  // the ribbon's normals

}  // namespace

void check_position(const Vec3& position, double magnitude) {
    const double largest = position.cwiseAbs().maxCoeff();
    if (largest <= coordinate_max) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "desc.magnitude is %g: the result would have a coordinate of %g m, above 1e30", magnitude, largest);
}

Finishing::Finishing(const FinishingInput& input)
    : input_(input),
      angle_(input.style->find(FLG_ATTRIBUTE_ANGLE)),
      units_per_block_(units_to_move),
      time_(input.start_time) {
    if (!input.closed) return;
    for (const StyleAttribute& attribute : input.style->attributes) {
        units_per_block_ += units_per_component * attribute.components;
        if (attribute.attribute == FLG_ATTRIBUTE_ANGLE) units_per_block_ += units_to_turn;
    }
}

bool Finishing::run(uint32_t& units) {
    while (done_ < input_.count) {
        if (units == 0) return false;
        units -= std::min(units, units_per_block_);
        const uint32_t last = std::min(input_.count, done_ + block);
        for (uint32_t i = done_; i < last && input_.closed && input_.around.points_left() > 0; ++i) {
            blend_over_start(i);
            input_.around.go_on();
        }
        if (input_.pinned) move_ends(done_, last);
        if (input_.out.time) add_times(done_, last);
        done_ = last;
    }
    return true;
}

void Finishing::move_ends(uint32_t first, uint32_t last) {
    const StylizedColumns& out = input_.out;
    for (uint32_t i = first; i < last; ++i) {
        const double u = static_cast<double>(i) / input_.steps;
        const Vec3 excess = (1.0 - u) * input_.start_excess + u * input_.end_excess;
        const size_t at = 3 * static_cast<size_t>(i);
        const Vec3 position = load_vec3(out.frames.positions + at) - input_.magnitude * excess;
        check_position(position, input_.magnitude);
        store_vec3(position, out.frames.positions + at);
        if (out.displacement) store_vec3(load_vec3(out.displacement + at) - excess, out.displacement + at);
    }
    if (first == 0) pin(0, 0);
    if (last == input_.count && !input_.closed) pin(input_.count - 1, input_.target.count - 1);
}

// To the bit.
void Finishing::pin(uint32_t sample, uint32_t target_point) {
    const size_t at = 3 * static_cast<size_t>(sample);
    std::copy_n(input_.target.raw(target_point), 3, input_.out.frames.positions + at);
    if (input_.out.displacement) std::fill_n(input_.out.displacement + at, 3, 0.0f);
}

void Finishing::blend_over_start(uint32_t sample) {
    const StylizedColumns& out = input_.out;
    const AppliedStyle& style = *input_.style;
    const bool has_angle = angle_ < style.attributes.size();
    const size_t at = 3 * static_cast<size_t>(sample);
    const Vec3 tangent = load_vec3(out.frames.tangents + at);
    Vec3 normal = load_vec3(out.frames.normals + at);
    if (has_angle) normal = turned_about(tangent, normal, -double{out.attributes[angle_][sample]});
    const Steered steered = input_.first_steered.empty() ? Steered{} : input_.first_steered[sample];
    const Vec3 d = input_.scale * steered.weight() * input_.around.offset();
    const Vec3 offset = in_frame(d, tangent, normal);
    const Vec3 position = load_vec3(out.frames.positions + at) + input_.magnitude * offset;
    check_position(position, input_.magnitude);
    store_vec3(position, out.frames.positions + at);
    if (out.displacement) store_vec3(load_vec3(out.displacement + at) + offset, out.displacement + at);
    for (size_t a = 0; a < style.attributes.size(); ++a) {
        const StyleAttribute& attribute = style.attributes[a];
        float* values = out.attributes[a] + size_t{sample} * attribute.components;
        for (uint32_t k = 0; k < attribute.components; ++k) {
            const bool is_length = k < attribute.length_count();
            const double scale = is_length ? input_.scale * style.scale * steered.size(attribute.attribute) : 1.0;
            const double value = values[k] + scale * input_.around.offset(a, k);
            const ValueRange range = attribute.ranges[k];
            const bool angle = attribute.period(k) > 0;
            values[k] = static_cast<float>(angle ? value : std::clamp(value, scale * range.low, scale * range.high));
        }
    }
    if (has_angle) {
        store_vec3(turned_about(tangent, normal, out.attributes[angle_][sample]), out.frames.normals + at);
    }
}

void Finishing::add_times(uint32_t first, uint32_t last) {
    const float* speeds = input_.out.attributes[input_.style->find(FLG_ATTRIBUTE_SPEED)];
    MotionTime time(input_.out.frames.positions, speeds, input_.out.time);
    time.seconds = time_;
    for (uint32_t i = first; i < last; ++i) time.add(i);
    time_ = time.seconds;
}

Task<void> time_motion(Pace& pace, const CurveSet& target, uint32_t curve, CurveSet& out, uint32_t out_curve) {
    const uint32_t first = out.offsets()[out_curve];
    MotionTime time(out.positions() + size_t{3} * first, out.find(FLG_ATTRIBUTE_SPEED)->values.data() + first,
                    out.find(FLG_ATTRIBUTE_TIME)->values.data() + first);
    const Column* start = target.find(FLG_ATTRIBUTE_TIME);
    time.seconds = start ? double{start->values[target.offsets()[curve]]} : 0.0;
    co_await each(pace, out.offsets()[out_curve + 1] - first, Cost::tens_of_ns, [&](uint32_t i) { time.add(i); });
}

void MotionTime::add(uint32_t point) {
    if (point > 0) {
        const float* position = positions + 3 * static_cast<size_t>(point);
        const double distance = (load_vec3(position) - load_vec3(position - 3)).norm();
        seconds += distance / (0.5 * (static_cast<double>(speeds[point - 1]) + speeds[point]));
    }
    if (!(seconds <= time_max_s)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the style's SPEED is as low as %g m/s: the result would have a TIME of %g s, above 1e30",
                      static_cast<double>(speeds[point]), seconds);
    }
    times[point] = static_cast<float>(seconds);
}

}  // namespace flg
