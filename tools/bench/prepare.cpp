// SPDX-License-Identifier: MIT
// Preparing a style of 600 points (guide, matching, displacement, patch graph) within 1.5 ms of
// processor time. The paper's own implementation takes 5.5 s.
#include <algorithm>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStylePoints = 600;
constexpr double kBarMs = 1.5;
constexpr int kPrepareRuns = 15;

}  // namespace

std::vector<Row> run_prepare() {
    Host host;
    std::vector<Row> rows;
    for (const std::string& name : scenes::style_names()) {
        const FlgCurveSet curve = host.add(scenes::make_style(name));
        const double ms = median_ms(kPrepareRuns, [&] {
            FlgStyle style = {};
            const double elapsed_ms = time_ms([&] {
                style = host.prepare(curve, kStylePoints);
                host.run();
            });
            host.info(style);  // throws if the job failed
            check(flgStyleRelease(host.context(), style));
            return elapsed_ms;
        });
        rows.push_back(below("prepare 600 points: " + name, ms, "ms", kBarMs));
    }
    return rows;
}

}  // namespace flg::bench
