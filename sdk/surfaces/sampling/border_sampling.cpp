// SPDX-License-Identifier: MIT
#include "surfaces/sampling/border_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double least_steps = 3, max_points = 0x1p24;

Task<void> sample_stretch(Pace& pace, const Mesh& mesh, const RegionLoops& loops, BorderStretch stretch, float spacing,
                          uint32_t multiple, SurfaceCurves& curves) {
    const double whole = loops.lengths[stretch.loop], length = whole * (stretch.end - stretch.begin);
    const bool has_room = multiple <= std::max(least_steps + 1, 2 * length / spacing);
    const double of = stretch.is_whole() && has_room ? multiple : 1;
    const double steps = of * std::max(std::round(length / spacing / of), std::ceil(least_steps / of));
    if (!(steps <= max_points)) {
        throw Failure(FLG_ERROR_LIMIT, "spacing %g makes more than 2^24 points of a border of %g m", double{spacing},
                      length);
    }
    const auto count = static_cast<uint32_t>(steps);
    uint32_t placed = stretch.is_whole() ? 0 : 1;
    uint32_t edge = loops.offsets[stretch.loop];
    double walked = 0;  // metres, from the loop's beginning up to the edge
    // A point, or on to the next edge. A border without length has all its points in one place.
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        const double place = whole * (stretch.begin + (stretch.end - stretch.begin) * placed / count);
        const double along = edge_length(mesh, loops.edges[edge]);
        if (place < walked + along || whole == 0) {
            const double t = along > 0 ? std::clamp((place - walked) / along, 0.0, 1.0) : 0;
            curves.points.push_back(point_on_edge(loops.edges[edge], round_on_edge(t)));
            return ++placed < count;
        }
        walked += along;
        if (++edge == loops.offsets[stretch.loop + 1]) edge = loops.offsets[stretch.loop];
        return true;
    });
    curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
    curves.closed.push_back(stretch.is_whole());
    curves.values.push_back(static_cast<float>(length));
}

}  // namespace

Task<void> sample_stretches(Pace& pace, const Mesh& mesh, const RegionLoops& loops,
                            std::span<const BorderStretch> stretches, float spacing, uint32_t multiple,
                            SurfaceCurves& curves) {
    for (const BorderStretch& stretch : stretches)
        co_await sample_stretch(pace, mesh, loops, stretch, spacing, multiple, curves);
}

}  // namespace flg
