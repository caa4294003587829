// SPDX-License-Identifier: MIT
// What a stylized curve needs once its last point is known: its ends where they belong (Minarcik, Fiser, Sykora, sec.
// 4.5.1 and 4.5.2), and the times of a motion along it.
//
// The paper's correction of a result that is pinned is linear in arc length. Here it is linear in the arc length of the
// target and taken off the displacement, so that it grows with the magnitude: a result is pinned at every magnitude.
// With u from 0 to 1 along the target and D the displacement:
//   D(u) - (1 - u) D(0) - u D(1)
// A closed curve has come back to the style's point that it began with. What is left of the blend of its last seam
// goes on over its first samples, in displacement and attributes, so that ribbons and sizes go on there as they do
// elsewhere.
// Times: the distance of two points takes as long as the mean of their speeds says.
#pragma once

#include <span>

#include "curves/resample.h"
#include "stylization/applied_style.h"
#include "stylization/seam_blend.h"
#include "stylization/steering.h"

namespace flg {

// Where the result of one curve goes. The columns begin at the curve's first sample.
struct StylizedColumns {
    FrameColumns frames;            // positions are the result's; tangents are the target's, normals too but for ANGLE
    float* style_index = nullptr;   // 1 a sample
    float* displacement = nullptr;  // 3 a sample; null: not wanted
    float* time = nullptr;          // 1 a sample; null exactly if the style doesn't transfer SPEED
    std::span<float* const> attributes;  // in the order of the style's
    float* carried_radius = nullptr;     // 1 a sample: the target's RADIUS; null: it has none, or the style has
};

struct FinishingInput {
    StylizedColumns out;
    const AppliedStyle* style = nullptr;
    double scale = 1;  // of the style
    CurveView target;
    uint32_t count = 0;  // samples
    uint32_t steps = 0;
    double magnitude = 1;
    bool pinned = false;
    bool closed = false;
    // Of pinned curves: what is taken off the displacement at u = 0, and at u = 1.
    Vec3 start_excess = Vec3::Zero();
    Vec3 end_excess = Vec3::Zero();
    SeamBlend around;                        // of closed curves: at the first sample, where the curve has come around
    std::span<const Steered> first_steered;  // their first samples', as many as `around` has points; empty: not steered
    double start_time = 0;                   // seconds
};

// Throws what the host is told of a position that curve sets can't hold.
void check_position(const Vec3& position, double magnitude);

// When a motion gets to the points of a curve: point after point, from where it is at `seconds`.
struct MotionTime {
    const float* positions = nullptr;  // 3 a point
    const float* speeds = nullptr;     // metres a second
    float* times = nullptr;
    double seconds = 0;

    MotionTime(const float* at, const float* how_fast, float* when) : positions(at), speeds(how_fast), times(when) {}
    // Throws what the host is told of times that curve sets can't hold.
    void add(uint32_t point);
};

// Makes the TIME of a stylized curve from its SPEED, which the style has; it starts when curve `curve` of the target
// does.
Task<void> time_motion(Pace& pace, const CurveSet& target, uint32_t curve, CurveSet& out, uint32_t out_curve);

// Stays a kernel: synthesis and live strokes go on with it, which allocate nothing. A unit is about 50 ns of it.
class Finishing {
public:
    explicit Finishing(const FinishingInput& input);
    // Spends units; true when all is done.
    bool run(uint32_t& units);

private:
    void move_ends(uint32_t first, uint32_t last);
    void blend_over_start(uint32_t sample);
    void add_times(uint32_t first, uint32_t last);
    void pin(uint32_t sample, uint32_t target_point);

    FinishingInput input_;
    size_t angle_;  // where among the attributes ANGLE is
    uint32_t units_per_block_;
    uint32_t done_ = 0;
    double time_;
};

}  // namespace flg
