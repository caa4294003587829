// SPDX-License-Identifier: MIT
#include "stylization/live_stroke.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "core/failure.h"
#include "core/number_text.h"
#include "stylization/automatic_scale.h"
#include "stylization/style_mix.h"

namespace flg {

namespace {

constexpr float max_coordinate = 1e30f;  // as curve sets have it
// A tip's: a unit makes a point at most, and the last final point is in front of them.
constexpr uint32_t tip_rows = LiveStroke::tip_units + 1;

// The numbers of a sample in a column, `size` bytes each where it is packed.
template <class T>
const T* row(const T* column, const FlgLiveSampleView& samples, uint32_t index, size_t size) {
    const size_t stride = samples.stride > 0 ? samples.stride : size;
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(column) + index * stride);
}

LiveSample sample_at(const FlgLiveSampleView& samples, uint32_t index) {
    LiveSample sample;
    std::copy_n(row(samples.positions, samples, index, sizeof sample.position), 3, sample.position);
    if (samples.orientations) {
        std::copy_n(row(samples.orientations, samples, index, sizeof sample.orientation), 4, sample.orientation);
    }
    if (samples.pressures) sample.pressure = *row(samples.pressures, samples, index, sizeof sample.pressure);
    if (samples.times) sample.time = *row(samples.times, samples, index, sizeof sample.time);
    return sample;
}

}  // namespace

void check_sample(const LiveSample& sample, uint32_t index) {
    for (float v : sample.position) {
        if (!(std::abs(v) <= max_coordinate)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.positions[%u] holds %s, must be at most 1e30 in size",
                          index, NumberText(v).c_str());
        }
    }
    for (float v : sample.orientation) {
        if (!std::isfinite(v)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.orientations[%u] holds %s, must be finite", index,
                          NumberText(v).c_str());
        }
    }
    if (!(sample.pressure >= 0 && sample.pressure <= 1)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.pressures[%u] is %s, must be 0 to 1", index,
                      NumberText(sample.pressure).c_str());
    }
    if (!std::isfinite(sample.time)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.times[%u] is %s, must be finite", index,
                      NumberText(sample.time).c_str());
    }
}

void check_next_sample(const float* position_before, double time_before, const LiveSample& sample, double max_jump,
                       uint32_t index) {
    if (sample.time < time_before) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.times[%u] is %s, before that of the sample before it, %s",
                      index, NumberText(sample.time).c_str(), NumberText(time_before).c_str());
    }
    const double jump = (load_vec3(sample.position) - load_vec3(position_before)).norm();
    if (jump > max_jump) {
        throw Failure(FLG_ERROR_LIMIT, "samples.positions[%u] is %g m from the sample before it, max_jump is %s m",
                      index, jump, NumberText(max_jump).c_str());
    }
}

const FlgCurveSetView& OneCurveView::show(const LiveColumns& from, uint32_t first, uint32_t count) {
    for (uint32_t k = 0; k < from.count; ++k) {
        const CurveSet::ColumnLayout& layout = from.layout[k];
        columns[k] = {layout.attribute, layout.components, from.data[k] + size_t{first} * layout.components, 0, 0};
    }
    offsets = {0, count};
    view = {.struct_size = sizeof view,
            .curve_count = count > 0 ? 1u : 0u,
            .curve_offsets = offsets.data(),
            .curve_flags = &flags,
            .columns = columns.data(),
            .column_count = from.count,
            .reserved = 0,
            .origin = {}};
    write_origin(origin, view.origin);
    return view;
}

LiveSettings live_settings(const FlgLiveStrokeDesc& desc, std::span<const LiveStyleRequest> styles,
                           const StyleDrives& drives) {
    LiveSettings settings;
    settings.style_count = static_cast<uint32_t>(styles.size());
    const double pen_radius = 0.5 * (double{desc.min_radius} + desc.max_radius);
    double blend = 0;
    for (uint32_t i = 0; i < styles.size(); ++i) {
        const PreparedStyle& style = styles[i].style->prepared;
        if (i > 0) check_same_attributes(styles[0].style->prepared, style, i - 1);
        const double scale = desc.scale > 0 ? desc.scale : live_scale(style, pen_radius);
        settings.styles[i] = {&style, styles[i].trees.get(), styles[i].hot_trees.get(), scale};
        blend = std::max(blend, default_blend(style, settings.styles[i].spacing()));
    }
    settings.style_blend = desc.style_blend > 0 ? desc.style_blend : blend;
    settings.drives = drives;
    settings.magnitude = desc.magnitude;
    settings.min_radius = desc.min_radius;
    settings.max_radius = desc.max_radius;
    settings.smoothing = desc.smoothing;
    settings.frame = desc.frame;
    std::copy(std::begin(desc.basis), std::end(desc.basis), settings.basis.begin());
    settings.from_start = desc.start != FLG_STYLE_START_RANDOM;
    settings.seed = desc.seed;
    settings.max_points = desc.max_points;
    settings.end_cap = desc.end_cap != 0;
    return settings;
}

LiveStroke::LiveStroke(const LiveStrokeRequest& request, Memory* memory)
    : origin(request.origin),
      styles_(request.styles),
      settings_(live_settings(request.desc, {styles_.data(), request.style_count}, request.drives)),
      max_jump_(request.desc.max_jump),
      max_samples_(request.desc.max_samples),
      positions_(size_t{3} * request.desc.max_samples, memory),
      orientations_(size_t{4} * request.desc.max_samples, memory),
      pressures_(request.desc.max_samples, memory),
      times_(request.desc.max_samples, memory),
      host_times_(request.desc.max_samples, memory),
      checkpoints_(request.desc.max_samples / checkpoint_interval + 1, memory),
      mix_states_(request.style_count, mix_of_checkpoints + checkpoints_.size(), memory),
      samples_{positions_.data(), orientations_.data(), pressures_.data(), times_.data()},
      columns_(live_columns(*settings_.styles[0].style)) {
    size_t components = 0;
    for (uint32_t k = 0; k < columns_.count; ++k) {
        const CurveSet::ColumnLayout& layout = columns_.layout[k];
        values_[k] = Buffer<float>(size_t{settings_.max_points} * layout.components, memory);
        columns_.data[k] = values_[k].data();
        components += layout.components;
    }
    kernel_ = LiveKernel(settings_, samples_, columns_, mix_states_[mix_of_kernel]);
    keep_checkpoint(0);

    tip_values_ = Buffer<float>(size_t{tip_rows} * components, memory);
    tip_columns_ = columns_;
    float* place = tip_values_.data();
    for (uint32_t k = 0; k < columns_.count; ++k) {
        tip_columns_.data[k] = place;
        place += size_t{tip_rows} * columns_.layout[k].components;
    }
    tip_kernel_ = LiveKernel(settings_, samples_, tip_columns_, mix_states_[mix_of_tip]);
    view_.origin = tip_view_.origin = origin;
}

void LiveStroke::check_all(const FlgLiveSampleView& samples) const {
    if (phase() != Phase::drawing) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has ended; resume it first");
    const uint32_t count = samples.sample_count;
    if (count > max_samples_ - sample_count_) {
        throw Failure(FLG_ERROR_LIMIT, "stroke holds %u samples, %u more would pass max_samples, %u", sample_count_,
                      count, max_samples_);
    }
    if (count > 0 && kernel_.state().cut) {
        throw Failure(FLG_ERROR_LIMIT, "stroke has come to max_points, %u", settings_.max_points);
    }
    if (count > 0 && !samples.times && (settings_.smoothing > 0 || settings_.drives.drive_by(FLG_ATTRIBUTE_SPEED))) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "samples.times is null, but the stroke's %s needs times",
                      settings_.smoothing > 0 ? "smoothing" : "drive by SPEED");
    }
    std::array<float, 3> position;
    double time = 0;
    if (sample_count_ > 0) {
        std::copy_n(positions_.data() + 3 * size_t{sample_count_ - 1}, 3, position.data());
        time = host_times_[sample_count_ - 1];
    }
    for (uint32_t i = 0; i < count; ++i) {
        const LiveSample sample = sample_at(samples, i);
        check_sample(sample, i);
        if (sample_count_ + i > 0) check_next_sample(position.data(), time, sample, max_jump_, i);
        std::copy_n(sample.position, 3, position.data());
        time = sample.time;
    }
}

void LiveStroke::store(const LiveSample& sample) {
    const size_t at = sample_count_;
    std::copy_n(sample.position, 3, &positions_[3 * at]);
    std::copy_n(sample.orientation, 4, &orientations_[4 * at]);
    pressures_[at] = sample.pressure;
    host_times_[at] = sample.time;
    times_[at] = static_cast<float>(sample.time - host_times_[0]);
}

void LiveStroke::keep_checkpoint(uint32_t checkpoint) {
    std::construct_at(&checkpoints_[checkpoint], kernel_.state());
    mix_at(checkpoint).copy(kernel_.mix_state());
}

// One sample more, which is stored already.
void LiveStroke::draw_to(uint32_t sample_count) {
    sample_count_ = sample_count;
    uint32_t units = units_per_sample / settings_.style_count;
    kernel_.run(sample_count_, units);
    if (sample_count_ % checkpoint_interval == 0) keep_checkpoint(sample_count_ / checkpoint_interval);
}

void LiveStroke::push(const FlgLiveSampleView& samples) {
    check_all(samples);
    for (uint32_t i = 0; i < samples.sample_count; ++i) {
        store(sample_at(samples, i));
        draw_to(sample_count_ + 1);
    }
}

void LiveStroke::undo(uint32_t count) {
    if (phase() != Phase::drawing) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has ended; resume it first");
    if (count > sample_count_) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "count is %u, stroke has %u samples", count, sample_count_);
    }
    const uint32_t left = sample_count_ - count;
    const uint32_t checkpoint = left / checkpoint_interval;
    kernel_.restore(checkpoints_[checkpoint], mix_at(checkpoint));
    sample_count_ = checkpoint * checkpoint_interval;
    while (sample_count_ < left) draw_to(sample_count_ + 1);
}

const FlgCurveSetView& LiveStroke::view_from(uint32_t first) {
    return view_.show(columns_, first, seen().points - first);
}

const FlgCurveSetView& LiveStroke::tip() {
    // The phase may change meanwhile: it is asked once.
    const bool ending = phase() == Phase::ending;
    const LiveState& from = ending ? before_end_ : kernel_.state();
    const uint32_t first = from.points > 0 ? from.points - 1 : 0;
    for (uint32_t k = 0; from.points > 0 && k < columns_.count; ++k) {
        const size_t components = columns_.layout[k].components;
        std::copy_n(columns_.data[k] + first * components, components, tip_columns_.data[k]);
    }
    tip_kernel_.restore(from, ending ? mix_before() : kernel_.mix_state());
    tip_kernel_.write_from(first);
    tip_kernel_.close();
    uint32_t units = tip_units;
    tip_kernel_.run(sample_count_, units);
    const uint32_t points = tip_kernel_.state().points;
    return tip_view_.show(tip_columns_, 0, points > from.points ? points - first : 0);
}

uint32_t LiveStroke::waiting_points() const {
    const LiveState& state = seen();
    if (!state.in_segment || state.cut) return 0;
    // To the end of the segment, and from there from sample to sample, as if the hand then steered no further.
    const double scale = steered_by(settings_.drives, state.segment.reading_end).scale;
    double length = (state.start + state.segment.chord / scale) - state.points * spacing();
    for (uint32_t i = state.samples; i < sample_count_; ++i) {
        const float* position = positions_.data() + 3 * size_t{i};
        length += (load_vec3(position) - load_vec3(position - 3)).norm() / scale;
    }
    const double points = std::ceil(length / spacing());
    const double room = settings_.max_points - state.points;
    return static_cast<uint32_t>(std::clamp(points, 0.0, room));
}

void LiveStroke::begin_end() {
    before_end_ = kernel_.state();
    mix_before().copy(kernel_.mix_state());
    kernel_.close();
    phase_.store(Phase::ending, std::memory_order_release);
    ++readers;
}

void LiveStroke::settle(bool succeeded) {
    --readers;
    if (!succeeded) kernel_.restore(before_end_, mix_before());
    phase_.store(succeeded ? Phase::ended : Phase::drawing, std::memory_order_release);
}

void LiveStroke::resume() {
    kernel_.restore(before_end_, mix_before());
    phase_.store(Phase::drawing, std::memory_order_release);
}

}  // namespace flg
