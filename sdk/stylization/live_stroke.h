// SPDX-License-Identifier: MIT
// A stroke that is stylized while it is drawn: its samples, its points, and the way back.
//
// All memory is taken when it is made. Every checkpoint_interval samples the state is kept; undo goes back to the last
// one before and draws the samples behind it again, which gives the same bits. So that it does, each sample brings the
// same number of units of work to spend, and none are carried over. Host's thread only, but for what the jobs in
// live_jobs do while it is ended.
#pragma once

#include <memory>

#include "filigree/filigree_live.h"
#include "stylization/live_kernel.h"

namespace flg {

struct LiveStrokeRequest {
    std::shared_ptr<Style> style;
    std::shared_ptr<PathTrees> trees;
    LiveSettings settings;  // without style and trees
    double max_jump = 1;    // metres
    uint32_t max_samples = 16'384;
};

// Throws what the host is told of values that can't be taken: numbers first, then the sample's place after the one
// before it.
void check_sample(const FlgLiveSample& sample, uint32_t index);
void check_next_sample(const float* position_before, double time_before, const FlgLiveSample& sample, double max_jump,
                       uint32_t index);

class LiveStroke {
public:
    static constexpr uint32_t checkpoint_interval = 6;
    // What keeps a push, and undoing with its checkpoint_interval - 1 samples, below what a frame can spare: a point is
    // about 0.1 us.
    static constexpr uint32_t units_per_sample = 64;

    LiveStroke(const LiveStrokeRequest& request, Memory* memory);
    LiveStroke(const LiveStroke&) = delete;
    LiveStroke& operator=(const LiveStroke&) = delete;

    // All of them or, if it throws, none.
    void push(const FlgLiveSample* samples, uint32_t count);
    void undo(uint32_t count);

    // Points from `first` on; valid until the next call.
    const FlgCurveSetView& view_from(uint32_t first);

    uint32_t sample_count() const { return sample_count_; }
    uint32_t waiting_samples() const { return sample_count_ - visible_samples_; }
    uint32_t point_count() const { return visible_points_; }
    // The next point has found no room.
    bool cut() const { return visible_cut_; }
    double spacing() const { return settings_.spacing(); }
    const LiveColumns& columns() const { return columns_; }
    const LiveSamples& samples() const { return samples_; }

    // ---- ending: between begin_end() and settle(), the kernel belongs to a job ----

    enum class Phase : uint8_t { drawing, ending, ended };
    Phase phase() const { return phase_; }
    void begin_end();
    LiveKernel& kernel() { return kernel_; }
    // After the job: the whole stroke, or as before begin_end().
    void settle(bool succeeded);
    void resume();
    uint32_t readers = 0;  // jobs that copy from it, the one that ends it included

private:
    void check_all(const FlgLiveSample* samples, uint32_t count) const;
    void store(const FlgLiveSample& sample);
    void draw_to(uint32_t sample_count);
    void show();

    std::shared_ptr<Style> style_;
    std::shared_ptr<PathTrees> trees_;
    LiveSettings settings_;
    double max_jump_;
    uint32_t max_samples_;

    Buffer<float> positions_, orientations_, pressures_, times_;
    Buffer<double> host_times_;  // as the host counts
    std::array<Buffer<float>, live_columns_max> values_;
    Buffer<LiveState> checkpoints_;
    LiveSamples samples_;
    LiveColumns columns_;
    LiveKernel kernel_;

    uint32_t sample_count_ = 0;
    Phase phase_ = Phase::drawing;
    LiveState before_end_;
    // What the host sees.
    uint32_t visible_points_ = 0, visible_samples_ = 0;
    bool visible_cut_ = false;
    std::array<FlgColumn, live_columns_max> view_columns_{};
    std::array<uint32_t, 2> view_offsets_{};
    uint8_t view_flags_ = 0;
    FlgCurveSetView view_{};
};

}  // namespace flg
