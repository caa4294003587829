// SPDX-License-Identifier: MIT
// One step of the refined solver: what a vertex whose distance is known tells its neighbours. Eight triangles at a time.
//
// Unfolding. Let v be the vertex, V its distance, and n, t two neighbours that span a triangle with it. Where the distance
// D of n is known, the source can be unfolded into the triangle's plane: it lies on the other side of the edge v-n, V from v
// and D from n, and is seen from v at an angle phi from n (law of cosines). With the triangle's angle theta at v, t is
//   f = sqrt(V^2 + |vt|^2 - 2 V |vt| cos(phi + theta))
// from it, if the straight way crosses the edge; else the way to t goes along the edge, V + |vt|.
//
// Curvature. The waves of a curved surface are not circles about one point: distances along the edge differ from those in
// the plane. Of the true distance we know more than its values at both ends: its gradients there, since every vertex keeps
// the direction in which the wave came to it. The cubic that has the same values as the plane's distances and the slopes of
// the gradients differs from them, at x of the edge's length L from v, by
//   x (1 - x/L) (a (1 - x/L) - b x/L)
// where a and b are the slopes by the gradients less those in the plane, at v and n. They are clamped to +-1/2.
//
// The same bits on every machine: only correctly rounded operations, in the order written, no fused ones.
#pragma once

#include <cstdint>

#include "surfaces/geodesic_blocks.h"

namespace flg {

// The wave at a vertex.
struct alignas(16) WaveState {
    float distance;  // metres, from the source; infinite where no wave has come yet
    float x, y, z;   // where it goes: a unit vector, or 0
};

// Changes of a distance below this part of it are not worth to go on with.
constexpr float least_improvement = 1e-5f;

struct WaveStep {
    WaveState states[lane_count];  // for each lane the least distance on the ways through the vertex
    uint32_t improved;             // a bit for each lane that is improved by it
};

// `lanes` is a block of the vertex `rank`, its top bit cleared; states of rank 0 are -infinity.
using WaveStepFunction = void (*)(const uint32_t* lanes, const RankedPosition* positions, const WaveState* states,
                                  uint32_t rank, WaveStep& step);

void wave_step_portable(const uint32_t* lanes, const RankedPosition* positions, const WaveState* states, uint32_t rank,
                        WaveStep& step);
void wave_step_avx2(const uint32_t* lanes, const RankedPosition* positions, const WaveState* states, uint32_t rank,
                    WaveStep& step);

// The fastest for this machine.
WaveStepFunction choose_wave_step();

}  // namespace flg
