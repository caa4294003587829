// SPDX-License-Identifier: MIT
// A stroke that is stylized while it is drawn: its samples, its points, and the way back.
//
// All memory is taken when it is made. Every checkpoint_interval samples the state is kept; undo goes back to the last
// one before and draws the samples behind it again, which gives the same bits. So that it does, each sample brings the
// same number of units of work to spend, and none are carried over.
//
// Threads. push(), undo(), view(), tip() and what they read belong to whoever draws, on any thread but one at a time,
// and wait for nobody. Meanwhile, elsewhere:
// - A job that ends the stroke owns kernel_ from begin_end() to settle(), which runs inside the host's tick. phase_ is
//   all that settle() and who draws share: settle() stores it with release behind all the job and itself wrote, and who
//   draws loads it with acquire first. Either it still reads `ending`, and then touches only before_end_, samples and
//   the tip, which nobody writes meanwhile; or it finds the kernel as it was left.
// - Jobs that split it only read, and the phase stays `ended` while there are any (readers is the host's thread's).
// - What is shared with other strokes and jobs doesn't change: the style is published, and all path trees are made.
// begin_end(), resume() and the release are calls for the stroke like those of who draws: they don't overlap with them.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <span>

#include "core/origin.h"
#include "filigree/filigree_live.h"
#include "stylization/live_kernel.h"

namespace flg {

struct LiveStyleRequest {
    std::shared_ptr<Style> style;
    std::shared_ptr<PathTrees> trees, hot_trees;  // of the drives' temperatures, or twice the same
};
using LiveStyleRequests = std::array<LiveStyleRequest, styles_max>;

struct LiveStrokeRequest {
    LiveStyleRequests styles{};
    uint32_t style_count = 1;
    Origin origin{};
    FlgLiveStrokeDesc desc;  // checked; its styles are resolved above, its drives copied below
    StyleDrives drives{};
};

// Throws FLG_ERROR_INVALID_ARGUMENT if styles transfer other attributes than the first one.
LiveSettings live_settings(const FlgLiveStrokeDesc& desc, std::span<const LiveStyleRequest> styles,
                           const StyleDrives& drives);

// One sample of the controller; see FlgLiveSampleView.
struct LiveSample {
    float position[3] = {};
    float orientation[4] = {};
    float pressure = 1;
    double time = 0;
};

// Throws what the host is told of values that can't be taken: numbers first, then the sample's place after the one
// before it.
void check_sample(const LiveSample& sample, uint32_t index);
void check_next_sample(const float* position_before, double time_before, const LiveSample& sample, double max_jump,
                       uint32_t index);

// Rows of columns, as a set of at most one curve.
struct OneCurveView {
    const FlgCurveSetView& show(const LiveColumns& columns, uint32_t first, uint32_t count);

    Origin origin{};
    std::array<FlgColumn, live_columns_max> columns{};
    std::array<uint32_t, 2> offsets{};
    uint8_t flags = 0;
    FlgCurveSetView view{};
};

class LiveStroke {
public:
    static constexpr uint32_t checkpoint_interval = 6;
    // What keeps a push, and undoing with its checkpoint_interval - 1 samples, below what a frame can spare: a point is
    // about 30 ns. Styles share them.
    static constexpr uint32_t units_per_sample = 1024;
    // The same for a tip: further than this it doesn't look ahead. More than two samples make.
    static constexpr uint32_t tip_units = 256;

    LiveStroke(const LiveStrokeRequest& request, Memory* memory);
    const Origin origin;
    LiveStroke(const LiveStroke&) = delete;
    LiveStroke& operator=(const LiveStroke&) = delete;

    // All of them or, if it throws, none.
    void push(const FlgLiveSampleView& samples);
    void undo(uint32_t count);

    // Points from `first` on; valid until the next call.
    const FlgCurveSetView& view_from(uint32_t first);
    // The last point, if there is one, and those behind it if the stroke ended now; no curve if there are none. Changes
    // nothing else; valid until the next call of push(), undo() or this.
    const FlgCurveSetView& tip();

    uint32_t sample_count() const { return sample_count_; }
    uint32_t waiting_samples() const { return sample_count_ - seen().samples; }
    uint32_t point_count() const { return seen().points; }
    // Due, but not made yet: about as many.
    uint32_t waiting_points() const;
    uint32_t dense_samples() const { return seen().dense_segments; }
    // The next point has found no room.
    bool cut() const { return seen().cut; }
    double spacing() const { return settings_.spacing(); }
    double scale() const { return settings_.styles[0].scale; }
    const LiveSettings& settings() const { return settings_; }
    const LiveColumns& columns() const { return columns_; }
    const LiveSamples& samples() const { return samples_; }

    // ---- ending: between begin_end() and settle(), the kernel belongs to a job ----

    enum class Phase : uint8_t { drawing, ending, ended };
    Phase phase() const { return phase_.load(std::memory_order_acquire); }
    void begin_end();
    LiveKernel& kernel() { return kernel_; }
    // After the job: the whole stroke, or as before begin_end().
    void settle(bool succeeded);
    void resume();
    uint32_t readers = 0;  // jobs that copy from it, the one that ends it included

private:
    void check_all(const FlgLiveSampleView& samples) const;
    void store(const LiveSample& sample);
    void keep_checkpoint(uint32_t checkpoint);
    void draw_to(uint32_t sample_count);
    // What the host sees: while a job ends the stroke, as before.
    const LiveState& seen() const { return phase() == Phase::ending ? before_end_ : kernel_.state(); }
    // Where several styles stand: for the kernel, before its end, for the tip, and at checkpoints.
    static constexpr size_t mix_of_kernel = 0, mix_before_end = 1, mix_of_tip = 2, mix_of_checkpoints = 3;
    LiveMixState mix_before() { return mix_states_[mix_before_end]; }
    LiveMixState mix_at(uint32_t checkpoint) { return mix_states_[mix_of_checkpoints + checkpoint]; }

    LiveStyleRequests styles_;
    LiveSettings settings_;
    double max_jump_;
    uint32_t max_samples_;

    Buffer<float> positions_, orientations_, pressures_, times_;
    Buffer<double> host_times_;  // as the host counts
    std::array<Buffer<float>, live_columns_max> values_;
    Buffer<LiveState> checkpoints_;
    LiveMixStates mix_states_;
    LiveSamples samples_;
    LiveColumns columns_;
    LiveKernel kernel_;

    uint32_t sample_count_ = 0;
    std::atomic<Phase> phase_{Phase::drawing};
    LiveState before_end_;

    Buffer<float> tip_values_;
    LiveColumns tip_columns_;
    LiveKernel tip_kernel_;

    OneCurveView view_, tip_view_;
};

}  // namespace flg
