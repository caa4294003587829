// SPDX-License-Identifier: MIT
#include "stylization/live_kernel.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "curves/drawn_normal.h"
#include "curves/segment_stream.h"
#include "curves/step_scale.h"

namespace flg {

namespace {

Vec3 mirrored(const Vec3& tangent, const Vec3& direction) {
    return (2.0 * tangent.dot(direction)) * direction - tangent;
}

}  // namespace

void LiveSegment::load(SegmentBlock& block) const {
    block.points.set(0, start);
    block.points.set(1, end);
    block.directions.set(0, direction);
    block.chords[0] = chord;
    block.tangents_start.set(0, tangent_start);
    block.tangents_end.set(0, tangent_end);
    block.measure(1);
}

LiveCurve::Reading LiveCurve::reading_of(const LiveSamples& samples, uint32_t sample) {
    Reading reading;
    reading.head<3>() = load_vec3(samples.positions + 3 * size_t{sample});
    reading[3] = samples.pressures ? samples.pressures[sample] : 1.0;
    const bool has_up = samples.orientations != nullptr;
    reading.tail<3>() = has_up ? turned_by(samples.orientations + 4 * size_t{sample}, Vec3::UnitY()) : Vec3::Zero();
    return reading;
}

LiveCurve::Reading LiveCurve::filtered(const Reading& value, double time) {
    if (samples_ == 0 || smoothing_ == 0) {
        smoothed_ = value;
    } else if (time > time_) {
        const double elapsed = time - time_;
        // The state runs behind the input by this when it has settled.
        const Reading lag = (smoothing_ / elapsed) * (value - raw_);
        const double kept = std::exp(-elapsed / smoothing_);
        smoothed_ = value - lag + kept * (smoothed_ - raw_ + lag);
    }
    raw_ = value;
    time_ = time;
    ++samples_;
    return smoothed_;
}

LiveSegment LiveCurve::segment_to(bool smooth_end, const Vec3& tangent_end) const {
    const Vec3& u = direction_;
    LiveSegment segment{start_, end_, u, chord_, u, u, hand_start_, hand_end_, left_start_, came_to_end_};
    if (smooth_start_) {
        segment.tangent_start = tangent_start_;
        segment.tangent_end = mirrored(tangent_start_, u);
    }
    if (smooth_end) {
        segment.tangent_end = tangent_end;
        if (!smooth_start_) segment.tangent_start = mirrored(tangent_end, u);
    }
    return segment;
}

bool LiveCurve::read(const LiveSamples& samples, uint32_t sample, LiveSegment& segment) {
    // Counted from the first sample in float, as the host gets the samples back.
    const double time =
        samples.times ? static_cast<float>(double{samples.times[sample]} - double{samples.times[0]}) : 0.0;
    const Reading value = filtered(reading_of(samples, sample), time);
    const Vec3 place = value.head<3>();
    const LiveHand hand{value[3], time, value.tail<3>()};
    HandReading reading{static_cast<float>(hand.pressure), left_end_.speed};
    if (places_ == 0) {
        end_ = place;
        hand_end_ = hand;
        left_end_ = reading;
        places_ = 1;
        return false;
    }
    // As SegmentStream has it, to the bit.
    const Vec3 way = place - end_;
    const double chord = std::sqrt(way.x() * way.x() + way.y() * way.y() + way.z() * way.z());
    if (!(chord > resolution_)) {
        hand_end_ = hand;
        left_end_ = reading;
        return false;
    }
    const Vec3 direction = (1.0 / chord) * way;
    const bool has_segment = places_ == 2;
    bool smooth = false;
    Vec3 tangent = direction;
    if (has_segment) {
        const Vec3 &u = direction_, &v = direction;
        smooth = u.x() * v.x() + u.y() * v.y() + u.z() * v.z() >= corner_cosine;
        const Vec3 sum = chord * u + chord_ * v;
        tangent = (1.0 / std::sqrt(sum.x() * sum.x() + sum.y() * sum.y() + sum.z() * sum.z())) * sum;
        segment = segment_to(smooth, tangent);
    }
    reading.speed = speed_between(end_, place, time - hand_end_.time);
    left_start_ = left_end_;
    if (!moves_) left_start_.speed = reading.speed;
    moves_ = true;
    came_to_end_ = left_end_ = reading;
    start_ = end_;
    end_ = place;
    direction_ = direction;
    chord_ = chord;
    hand_start_ = hand_end_;
    hand_end_ = hand;
    tangent_start_ = tangent;
    smooth_start_ = smooth;
    places_ = 2;
    return has_segment;
}

bool LiveCurve::finish(LiveSegment& segment) {
    if (places_ < 2) return false;
    segment = segment_to(false, direction_);
    places_ = 1;
    return true;
}

namespace {

constexpr double place_share = 1e-3;    // of a step: places nearer than this are one
constexpr double parallel_sine = 1e-4;  // as FramedSampler has it

}  // namespace

bool all_trees_made(const PathTrees& trees) {
    for (uint32_t k = 0; k < trees.destination_count(); ++k) {
        if (trees.find(k) == nullptr) return false;
    }
    return true;
}

LiveColumns live_columns(const PreparedStyle& style) {
    LiveColumns columns;
    const auto add = [&](FlgAttribute attribute, uint32_t components) {
        columns.layout[columns.count++] = {attribute, components};
    };
    add(FLG_ATTRIBUTE_POSITION, 3);
    add(FLG_ATTRIBUTE_TANGENT, 3);
    add(FLG_ATTRIBUTE_NORMAL, 3);
    add(FLG_ATTRIBUTE_RADIUS, 1);
    add(FLG_ATTRIBUTE_STYLE_INDEX, 1);
    add(FLG_ATTRIBUTE_TIME, 1);
    for (const StyleAttribute& attribute : style.attributes) {
        if (attribute.attribute != FLG_ATTRIBUTE_RADIUS) add(attribute.attribute, attribute.components);
    }
    return columns;
}

LiveKernel::LiveKernel(const LiveSettings& settings, const LiveSamples& samples, const LiveColumns& out,
                       const LiveMixState& mix)
    : settings_(settings),
      samples_(samples),
      out_(out),
      follower_(settings, settings.styles[0]),
      mix_(settings, mix),
      step_(settings.spacing()) {
    for (const StyleAttribute& attribute : follower_.style().attributes) {
        if (attribute.attribute == FLG_ATTRIBUTE_ANGLE) turns_ = true;
    }
    for (uint32_t k = live_own_columns; k < out.count; ++k) {
        if (out.layout[k].attribute == FLG_ATTRIBUTE_SPEED) speeds_ = out.data[k];
    }
    state_.curve = LiveCurve(settings.smoothing, place_share * step_);
    state_.chain = FrameChain(step_);
    displaced_.set_magnitude(settings.magnitude);
}

void LiveKernel::restore(const LiveState& state, const LiveMixState& mix) {
    state_ = state;
    mix_.state().copy(mix);
    if (state_.in_segment) take_segment();
}

bool LiveKernel::run(uint32_t sample_count, uint32_t& units) {
    while (!state_.cut) {
        if (state_.in_segment) {
            if (!follow_segment(units)) return state_.cut;
        } else if (state_.samples < sample_count) {
            if (units < sample_units) {
                units = 0;
                return false;
            }
            units -= sample_units;
            if (state_.curve.read(samples_, state_.samples++, state_.segment)) begin_segment();
        } else if (!state_.closing) {
            return true;
        } else if (state_.curve.finish(state_.segment)) {
            begin_segment();
        } else {
            if (state_.points == 0 && state_.curve.has_place()) make_lone_point();
            return true;
        }
    }
    return true;
}

void LiveKernel::begin_segment() {
    take_segment();
    if (!only_counts()) choose(state_.segment.reading_start, state_.segment.reading_end, block_.lengths[0]);
}

void LiveKernel::choose(const HandReading& start, const HandReading& end, double length) {
    if (mix_.empty()) return;
    const auto style = [&](const HandReading& reading) {
        return settings_.drives.style([&](uint32_t k) { return reading.of(settings_.drives.list()[k].attribute); });
    };
    mix_.read(style(start), style(end), length);
}

void LiveKernel::take_segment() {
    state_.segment.load(block_);
    make_rows(block_, 0, 1, rows_);
    state_.in_segment = true;
    steered_start_ = steered_by(settings_.drives, state_.segment.reading_start);
    steered_end_ = steered_by(settings_.drives, state_.segment.reading_end);
}

Steered steered_by(const StyleDrives& drives, const HandReading& reading) {
    return drives.steer([&](uint32_t k) { return reading.of(drives.list()[k].attribute); });
}

// False if it wasn't followed to its end.
bool LiveKernel::follow_segment(uint32_t& units) {
    const double length = block_.lengths[0];
    const StepScale scale{steered_start_.scale, steered_end_.scale};
    const bool scaled = settings_.drives.drive(FLG_STYLE_DRIVEN_SCALE);
    const double end = state_.start + (scaled ? scale.steps(length) : length);
    // A point at a segment's end is the next one's, unless there is none.
    const bool last = state_.closing && !state_.curve.has_segment();
    const auto reached = [&](double s) { return last ? s <= end : s < end; };
    while (reached(state_.points * step_)) {
        const uint32_t room = settings_.max_points - state_.points;
        state_.cut = room == 0;
        const uint32_t capacity = std::min({units, room, SampleBlock::capacity});
        if (capacity == 0) return false;
        uint32_t count = 0;
        while (count < capacity && reached((state_.points + count) * step_)) samples_made_.row[count++] = 0;
        units -= count;
        state_.segment_points += count;
        if (only_counts()) {
            state_.points += count;
        } else {
            samples_made_.count = count;
            find_places(&state_.start, state_.points, step_, samples_made_);
            for (uint32_t k = 0; scaled && k < count; ++k) {
                samples_made_.along[k] = scale.place(length, samples_made_.along[k]);
            }
            make_points();
        }
    }
    if (state_.segment_points > dense_points) ++state_.dense_segments;
    state_.segment_points = 0;
    state_.start = end;
    state_.in_segment = false;
    return true;
}

// As FramedSampler has it.
void LiveKernel::take_supplied_normal(const Vec3& up) {
    const Vec3& tangent = state_.frame.tangent();
    const Vec3 normal = up - up.dot(tangent) * tangent;
    const double size = normal.norm();
    if (size > parallel_sine * up.norm()) state_.frame.set_normal(normal / size);
}

void LiveKernel::make_points() {
    place_samples(rows_, samples_made_);
    make_frames();
    const bool driven = !settings_.drives.empty();
    for (uint32_t k = 0; k < samples_made_.count; ++k) {
        const float t = samples_made_.t[k];
        const Steered steered = driven ? steered_start_.between(steered_end_, t) : Steered{};
        make_point(k, t, state_.segment.hand_start.between(state_.segment.hand_end, t), steered);
    }
    write();
}

void LiveKernel::make_frames() {
    SampleBlock& samples = samples_made_;
    const auto first_normal = [&] { return drawn_normal(samples_.orientations, samples.tangent_of(0)); };
    if (settings_.frame != FLG_FRAME_METHOD_SUPPLIED) {
        if (state_.points == 0) state_.chain.begin(samples, first_normal());
        state_.chain.follow(samples);
        return;
    }
    for (uint32_t k = 0; k < samples.count; ++k) {
        if (state_.points + k == 0) {
            state_.frame = RotationMinimizingFrame(samples.position_of(0), samples.tangent_of(0), first_normal());
        } else {
            state_.frame.step(samples.position_of(k), samples.tangent_of(k));
        }
        const double t = samples.t[k];
        take_supplied_normal(state_.segment.hand_start.up +
                             t * (state_.segment.hand_end.up - state_.segment.hand_start.up));
        samples.set_normal(k, state_.frame.normal());
    }
}

// Of a stroke without length. It has no frame to be displaced in.
void LiveKernel::make_lone_point() {
    if (only_counts()) {
        ++state_.points;
        return;
    }
    const Vec3 place = state_.curve.last_place(), tangent = Vec3::UnitX();
    float position[3];
    store_vec3(place, position);
    samples_made_.count = 1;
    samples_made_.set_place(0, position, tangent);
    samples_made_.set_normal(0, drawn_normal(samples_.orientations, tangent));
    const HandReading reading = state_.curve.last_reading();
    const Steered steered = steered_by(settings_.drives, reading);
    choose(reading, reading, 0);
    make_point(0, 0, state_.curve.last_hand(), steered);
    displaced_.set_along(0, Vec3::Zero());
    write();
}

// Point k of those that are made, at t of the segment: goes on along the style, and copies it. Attributes are as
// flgCurveSetStylize gives them, sizes times scale. The style's radius makes the hand's.
void LiveKernel::make_point(uint32_t k, float t, const LiveHand& hand, const Steered& steered) {
    const size_t at = row() + k;
    double radius = settings_.min_radius + (settings_.max_radius - settings_.min_radius) * hand.pressure;
    radius *= steered.radius;
    radius *= mix_.empty() ? copy_style(k, steered) : copy_mix(k, t, steered);
    if (!settings_.drives.empty()) displaced_.scale_at(k, static_cast<float>(steered.weight()));
    out_.data[3][at] = static_cast<float>(radius);
    out_.data[5][at] = static_cast<float>(hand.time);
}

// Returns what the style makes of the radius.
double LiveKernel::copy_style(uint32_t k, const Steered& steered) {
    FollowedStyle& style = state_.style;
    if (state_.points + k == 0) {
        style = follower_.begin();
    } else {
        follower_.advance(style, state_.points + k, steered);
    }
    const uint32_t node = style.walk.node();
    const size_t at = row() + k;
    displaced_.set_along(k, follower_.displacement(style));
    out_.data[4][at] = static_cast<float>(node);
    double radius = 1;
    uint32_t column = live_own_columns;
    const auto& attributes = follower_.style().attributes;
    for (size_t a = 0; a < attributes.size(); ++a) {
        const StyleAttribute& attribute = attributes[a];
        if (attribute.attribute == FLG_ATTRIBUTE_RADIUS) {
            radius = style.blend.value(a, 0, node) / follower_.radius_unit();
            continue;
        }
        style.blend.write(a, node, follower_.scale() * steered.scale, out_.data[column++] + at * attribute.components);
        if (attribute.attribute == FLG_ATTRIBUTE_ANGLE) displaced_.turn_rad[k] = style.blend.value(a, 0, node);
    }
    return radius;
}

// The same of several styles.
double LiveKernel::copy_mix(uint32_t k, float t, const Steered& steered) {
    if (state_.points + k == 0) mix_.begin();
    mix_.go_to(state_.points + k, t, steered);
    const size_t at = row() + k;
    displaced_.set_along(k, mix_.displacement());
    out_.data[4][at] = static_cast<float>(mix_.node());
    double radius = 1;
    uint32_t column = live_own_columns;
    const auto& attributes = follower_.style().attributes;
    for (size_t a = 0; a < attributes.size(); ++a) {
        const StyleAttribute& attribute = attributes[a];
        const double* values = mix_.values(a);
        if (attribute.attribute == FLG_ATTRIBUTE_RADIUS) {
            radius = values[0];
            continue;
        }
        std::copy_n(values, attribute.components, out_.data[column++] + at * attribute.components);
        if (attribute.attribute == FLG_ATTRIBUTE_ANGLE) displaced_.turn_rad[k] = values[0];
    }
    return radius;
}

// Points that know what they copy. An angle of the style turns the normal.
void LiveKernel::write() {
    const uint32_t count = samples_made_.count;
    const size_t at = row();
    displace_samples(samples_made_, displaced_);
    if (turns_) turn_normals(displaced_, samples_made_);
    pack(displaced_.position, count, out_.data[0] + 3 * at);
    pack(samples_made_.tangent, count, out_.data[1] + 3 * at);
    pack(samples_made_.normal, count, out_.data[2] + 3 * at);
    for (uint32_t k = 0; speeds_ && k < count; ++k, ++state_.points) {
        out_.data[5][row()] = static_cast<float>(motion_time());
    }
    if (!speeds_) state_.points += count;
}

// Of the point whose position and speed have been written.
double LiveKernel::motion_time() {
    if (state_.points == 0) return 0;
    const size_t at = row();
    const float* position = out_.data[0] + 3 * at;
    const double distance = (load_vec3(position) - load_vec3(position - 3)).norm();
    state_.motion_s += distance / (0.5 * (double{speeds_[at - 1]} + double{speeds_[at]}));
    return state_.motion_s;
}

}  // namespace flg
