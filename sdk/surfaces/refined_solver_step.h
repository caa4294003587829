// SPDX-License-Identifier: MIT
// One step of the refined solver: what a vertex whose distance is known tells its neighbours. Eight triangles at a time.
//
// Unfolding. Let v be the vertex, V its distance, and n, t two neighbours that span a triangle with it. Where the distance
// D of n is known, the source can be unfolded into the triangle's plane: it lies on the other side of the edge v-n, V from v
// and D from n, and is seen from v at an angle phi from n (law of cosines). With the triangle's angle theta at v, t is
//   f = sqrt(V^2 + |vt|^2 - 2 V |vt| cos(phi + theta))
// from it, if the straight way crosses the edge; else the way to t goes along the edge, V + |vt|. Of a triangle's two
// corners the nearer one is n.
//
// Curvature. On a curved surface a wave is not the circle about one point that unfolding takes it for. Let 1/d + delta be the
// curvature of its front at the distance d; delta, its `bend`, is 0 in the plane. Then
// - along the edge, between its ends, the distance differs from the plane's by a parabola:
//     -1/2 delta sin^2(phi) x (L - x)      at x of the edge's length L;
// - on the way on, by the Riccati equation of geodesic deviation, (1/d + delta)' = -(1/d + delta)^2 - K, where K is the
//   Gaussian curvature, constant in a triangle: from d to e = d / q, h = e - d further on,
//     delta_e = q^2 delta / (1 + delta h q) - K h (1 + q + q^2) / 3.
// (The second term is exact where delta is small.) So each vertex keeps, beside its distance, one number; flat meshes keep
// it at 0, however irregular they are. No paper has this that we know of.
//
// The same bits on every machine: only correctly rounded operations, in the order written, no fused ones.
#pragma once

#include <cstdint>

#include "surfaces/geodesic_blocks.h"

namespace flg {

// The wave at a vertex.
struct alignas(8) WaveState {
    float distance;  // metres, from the source; infinite where no wave has come yet
    float bend;      // 1/metres: the curvature of its front less 1/distance
};

// Changes of a distance below this part of it are not worth to go on with.
constexpr float least_improvement = 1e-5f;

struct WaveStep {
    WaveState states[lane_count];  // for each lane the least distance on the ways through the vertex
    int32_t sides
        [lane_count];  // which lane the way passes nearest to: the next one, the one before, or 0: the vertex. If labelled
    // Bits of lanes: those that are improved by it; of them, those to which the way crosses the edge to the next lane, or to
    // the one before. Else it goes along the edge.
    uint32_t improved, across_next, across_previous;
};

// Of the states by rank, that of rank 0 is -infinity. Bends stay below bend_max and above -bend_max - 1/d, which
// leaves the wave from a line, -1/d, as it is: fronts that are sharper, or more hollow, are noise of the mesh.
using WaveStepFunction = void (*)(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                  float bend_max, bool labelled, WaveStep& step);

void wave_step_portable(const GeodesicBlock& block, const WaveState* states, const WaveState& own, float bend_max,
                        bool labelled, WaveStep& step);
#ifdef __x86_64__
void wave_step_avx2(const GeodesicBlock& block, const WaveState* states, const WaveState& own, float bend_max,
                    bool labelled, WaveStep& step);
void wave_step_avx512(const GeodesicBlock& block, const WaveState* states, const WaveState& own, float bend_max,
                      bool labelled, WaveStep& step);
#endif

// The fastest for this machine.
WaveStepFunction choose_wave_step();

}  // namespace flg
