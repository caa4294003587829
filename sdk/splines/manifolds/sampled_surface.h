// SPDX-License-Identifier: MIT
// What samples of a mesh or of a cloud make.
#pragma once

#include "splines/manifolds/oriented_samples.h"

namespace flg {

// How far the smooth surface is from what it was made of: from vertices and middles of triangles, or points.
struct SurfaceDeviation {
    void add(const OrientedSamples& surface, const Vec3& place) {
        double away = 0;
        if (!surface.distance_estimate(place, &away)) {
            ++uncovered;
            return;
        }
        largest = std::max(largest, away);
        sum += away;
        ++places;
    }
    double mean() const { return places > 0 ? sum / places : 0; }

    double largest = 0, sum = 0;  // metres
    uint32_t places = 0;          // where it was measured
    uint32_t uncovered = 0;       // those of them that no sample reaches, which the others leave out
};

struct SampledSurface {
    OrientedSamples surface;
    SurfaceDeviation deviation;
    // Of a cloud without normals: parts that were not joined by neighbours, and may be turned against each other.
    uint32_t parts = 0;
    uint32_t extras = 0;  // of a mesh: samples that are not at vertices
};

}  // namespace flg
