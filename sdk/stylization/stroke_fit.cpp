// SPDX-License-Identifier: MIT
#include "stylization/stroke_fit.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Targets have at most so many points.
constexpr double steps_max = 0x1.0p31;

}  // namespace

StrokeFit fit_stroke(const PatchGraph& graph, StrokeCaps caps, double wanted, uint32_t steps, double fit) {
    if (fit == 0) {
        // Without a start cap the first sample is the style's.
        const double cap_steps = caps.end + std::max(caps.start, 1U) - 1.0;
        if (steps > cap_steps || caps.start + caps.end == 0) return {steps, 1};
        const double needed = cap_steps + 1;
        return {static_cast<uint32_t>(needed), static_cast<float>(std::min(wanted / needed, 1.0))};
    }
    const double motif = graph.motif_end() - graph.start() - 1;
    const double fixed = caps.start + caps.end;
    const double room = std::max(wanted - fixed, 0.0);
    const double motifs = std::max(std::floor(room / motif + 0.5), 1.0);
    const bool shorter_than_a_patch = wanted < 2 * graph.patch + 1;
    // Where the caps leave no room, everything shrinks.
    const double stretch = std::max(room, 1.0) / (motifs * motif);
    const double left_over = shorter_than_a_patch || room < 1 ? 1.0 : std::pow(stretch, 1 - fit);
    const double whole = fixed + std::max(std::floor(motifs * motif * left_over + 0.5), 1.0);
    const double across = motifs == 1 ? std::min(wanted / whole, 1.0) : 1.0;
    return {static_cast<uint32_t>(std::min(whole, steps_max)), static_cast<float>(across)};
}

}  // namespace flg
