// SPDX-License-Identifier: MIT
// How the time of a spline grows with its nodes: a power law fitted over four decades.
#include <cmath>

#include "bench/splines.h"

namespace flg::bench {
namespace {

constexpr uint32_t kCounts[] = {100, 1'000, 10'000, 100'000}, kTriangles = 70'000;
constexpr double kExponent = 1.1;  // linear
constexpr double kMaxUs = 40;      // a node; all rounds

int runs_for(uint32_t count) {
    return count <= 1'000 ? 31 : count <= 10'000 ? 7 : 3;
}

}  // namespace

std::vector<Row> spline_growth() {
    SplineBench bench(wavy_torus(kTriangles, 0));
    bench.make_manifold();
    const std::vector<double> points = winding_points();
    std::vector<Row> rows;
    std::vector<double> counts, times;
    for (const uint32_t count : kCounts) {
        FlgSplineDesc desc = bench.desc(points);
        desc.node_count = count + kSplinePoints;
        FlgSplineView view{};
        bench.spline_ms(desc, view);
        const double ms = median_ms(runs_for(count), [&] { return bench.spline_ms(desc, view); });
        counts.push_back(count);
        times.push_back(ms);
        char name[64], note[96];
        std::snprintf(name, sizeof name, "spline on a torus, M = 1e%.0f, a node", std::log10(count));
        std::snprintf(note, sizeof note, "%.4g ms, %s%s", ms, rounds_note(view).c_str(),
                      view.ending == FLG_SPLINE_ENDING_CONVERGED ? "" : ", as near as rounding allows");
        rows.push_back(below(name, 1000 * ms / count, "us", kMaxUs, note));
    }
    rows.push_back(below("growth of splines with M, 1e2 to 1e5", growth_exponent(counts, times), "", kExponent));
    return rows;
}

}  // namespace flg::bench
