// SPDX-License-Identifier: MIT
// Displacement reconstruction of Minarcik, Fiser, Sykora, sec. 4.5, the plain way: a search for each destination, on
// whatever graph is given. Oracle of sdk/stylization/synthesis.h and baseline of the benchmarks.
#pragma once

#include <functional>
#include <vector>

#include "reference/literal_frames.h"
#include "reference/literal_shortest_path.h"

namespace flg::literal {

// How paths begin and where they may go.
struct Walk {
    std::vector<int> destinations;  // rising
    bool from_start = false;        // from node 0 to the last destination first; otherwise from a random destination
    int patch = 0;
    int node_count = 0;  // of the one style curve
    // Draw number `index`: a random whole number below `count`.
    std::function<int(int index, int count)> draw;
};

// The style points that `samples` samples copy.
std::vector<int> style_indices(const Graph& graph, const Walk& walk, int samples);

// The displacement of each sample: that of the style point it copies, blended in value and step over `patch` samples
// behind each seam (beyond the paper: sdk/stylization/seam_blend.h).
std::vector<Vec3> copied_displacement(const std::vector<Vec3>& displacement, const std::vector<int>& indices,
                                      int patch);

// target + factor * displacement in the target's frame.
std::vector<Vec3> displace(const std::vector<FramedPoint>& target, const std::vector<Vec3>& displacement,
                           double factor);

}  // namespace flg::literal
