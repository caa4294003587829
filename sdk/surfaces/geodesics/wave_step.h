// SPDX-License-Identifier: MIT
// One step of the refined solver: what vertices whose distances are known tell their neighbours, some neighbours at a
// time; in a version for each instruction set.
//
// Unfolding. Let v be the vertex, V its distance, and n, t two neighbours that span a triangle with it. Where the
// distance D of n is known, the front that has passed v and n is taken for a circle of curvature k where it meets v:
// 1/V from a point, 0 from a line. With g = (V - D) / L, L the length of the edge v-n, its centre is seen from v at an
// angle phi from n,
//   cos(phi) = g + 1/2 k L (1 - g^2)
// (law of cosines: the centre lies 1/k from v and 1/k - V + D from n, on the other side of the edge). With the
// triangle's angle theta at v, the distance of t is
//   V + a / (1 + sqrt(1 + k a)),   a = k |vt|^2 - 2 |vt| cos(phi + theta),
// if the straight way crosses the edge; else the way to t goes along the edge, V + |vt|. Of a triangle's two corners
// the nearer one is n. In the plane this is exact for fronts from points and from lines.
//
// Curvature. On a curved surface a front is no circle about a point at the distance V. So each vertex keeps, beside its
// distance, the curvature of its front, k. On the way on it changes by the Riccati equation of geodesic deviation,
//   k' = -k^2 - K,
// where K is the Gaussian curvature, constant in a triangle: from c, over a way h, to
//   c / (1 + c h) - 1/3 K h (1 + q + q^2),   q = 1 / (1 + c h).
// (The second term is exact where K h^2 is small.) The front at n is carried back, or on, by V - D to compare it with
// that at v; of both the one that is nearer to the source is the surer and weighs more, V : D. No paper has this that
// we know of.
//
// The same bits on every machine: only correctly rounded operations, in the order written, no fused ones.
#pragma once

#include <cstdint>

#include "surfaces/geodesics/geodesic_blocks.h"

namespace flg {

// The wave at a vertex.
struct alignas(8) WaveState {
    float distance;  // metres, from the source; infinite where no wave has come yet
    float front;     // 1/metres: the curvature of its front, above 0 if it spreads
};

// Changes of a distance below this part of it are not worth to go on with.
constexpr float min_improvement = 1e-5f;
// The front at a source that is a point, 1/metres.
constexpr float sharpest_front = 1e15f;

// A vertex, or a part of a large fan, that tells its neighbours.
struct WaveVertex {
    const GeodesicBlock* block;
    WaveState state;
};
constexpr uint32_t wave_step_vertices = 4;

// What some vertices tell, by lane: eight of each, one behind the other.
struct alignas(64) WaveStep {
    static constexpr uint32_t lanes = wave_step_vertices * lane_count;
    // The least distance on the ways through the vertex, and the front there.
    float distances[lanes], fronts[lanes];
    int32_t sides
        [lanes];  // which lane the way passes nearest to: the next one, the one before, or 0: the vertex. If labelled
    // Bits of lanes: those that are improved by it; of them, those to which the way crosses the edge to the next lane,
    // or to the one before. Else it goes along the edge.
    uint32_t improved, across_next, across_previous;
};

// How much more hollow than bent a front may be: as one that closes in on a point half an edge ahead, as those do that
// meet opposite to their source.
constexpr float max_hollow = 12;
// A hollow front grows more so by itself, and the noise in it with it. So where the ends of an edge differ, what goes
// on from between them is at most that many times as hollow as the less hollow of both, or that share of bend_max.
constexpr float hollow_ratio = 1.5f;
constexpr float hollow_share = 0.25f;

// Of the states by rank, that of rank 0 is -infinity. Fronts stay between -max_hollow * bend_max and bend_max + 1/d,
// and a triangle bends them by at most bend_max: what is sharper, or more hollow, is noise of the mesh. `count` is from
// 1 to wave_step_vertices.
using WaveStepFunction = void (*)(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                                  bool labelled, WaveStep& step);

void wave_step_portable(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                        bool labelled, WaveStep& step);
// GCC does not align its stack for vectors of 32 bytes on Windows.
#if defined(__x86_64__) && !(defined(__MINGW32__) && !defined(__clang__))
#define FLG_WAVE_STEP_DISPATCH
#endif
#ifdef FLG_WAVE_STEP_DISPATCH
void wave_step_avx2(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max, bool labelled,
                    WaveStep& step);
void wave_step_avx512(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                      bool labelled, WaveStep& step);
#endif

// The fastest for this machine.
WaveStepFunction choose_wave_step();

}  // namespace flg
