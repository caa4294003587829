// SPDX-License-Identifier: MIT
// The smooth surface of a point cloud: a sample at each point, with the normal and the curvature of a quadric through
// its neighbours. Noise is smoothed over the distance of the neighbours: samples lie on the quadrics, not at the
// points. Normals that the host has not given are those of the neighbours' best planes, turned to one side along a
// spanning tree of the neighbours graph that prefers neighbours whose normals are nearly parallel (Hoppe, DeRose,
// Duchamp, McDonald, Stuetzle: Surface reconstruction from unorganized points, 1992). Of each connected part, the
// normal of its highest point (along z) points up: outwards, if the part is closed.
#pragma once

#include <span>

#include "splines/manifolds/sampled_surface.h"

namespace flg {

struct CloudOptions {
    uint32_t neighbours = 16;  // of each point, 6 to 32: more smooth more; a sample reaches as far as the last of them
    double smoothing_scale = 0;  // metres, that smoothed_samples() see it through; 0: none
};

// `points`: metres, finite. `normals`: outwards, of any length; may be empty. Both outlive the task.
// A Failure says so if there are fewer than 4 points, or fewer than 4 that have a sample: points in whose neighbourhood
// there is no plane have none. The deviation is that of points of the cloud: their noise. About 6 us and 300 bytes a
// point.
Task<SampledSurface> sample_cloud(Pace& pace, std::span<const Position> points, std::span<const Position> normals,
                                  CloudOptions options);

}  // namespace flg
