// SPDX-License-Identifier: MIT
// Motions of a body through ten keys (the paper's table of times: 5 ms a position at M = 288).
#include <cmath>

#include "bench/splines.h"

namespace flg::bench {
namespace {

constexpr double kMotionMs = 5, kPositionUs = 17;
constexpr int kMotionRuns = 31;

struct Keys {
    std::vector<double> times, poses;
};

Keys ten_keys() {
    Keys keys;
    for (uint32_t i = 0; i < kSplinePoints; ++i) {
        keys.times.push_back(i + 0.3 * std::sin(i));
        // Turned by `a` about an axis that wanders.
        const double a = 1.1 * std::sin(1.7 * i + 0.4), p = 0.9 * i, q = 0.6 * i + 0.2;
        const double x = std::cos(p) * std::cos(q), y = std::sin(p) * std::cos(q), z = std::sin(q);
        const double c = std::cos(a), s = std::sin(a), d = 1 - c;
        keys.poses.insert(keys.poses.end(), {c + x * x * d, x * y * d - z * s, x * z * d + y * s, 3 * std::cos(0.6 * i),
                                             x * y * d + z * s, c + y * y * d, y * z * d - x * s, 3 * std::sin(0.6 * i),
                                             x * z * d - y * s, y * z * d + x * s, c + z * z * d, std::sin(2.3 * i)});
    }
    return keys;
}

}  // namespace

std::vector<Row> spline_motions() {
    Host host;
    const Keys keys = ten_keys();
    std::vector<Row> rows;
    const double target[3] = {0, 0, 0};
    struct Variant {
        const char* name;
        bool closed, timed;
    };
    for (const auto& [variant, closed, timed] : {Variant{"open", false, false}, Variant{"closed", true, false},
                                                 Variant{"a camera within limits", true, true}}) {
        FlgMotionDesc desc = flgMotionDefaults();
        desc.times = keys.times.data();
        desc.poses = keys.poses.data();
        desc.key_count = kSplinePoints;
        desc.closed = closed;
        desc.position_count = kSplineNodes;
        desc.tolerance = kSplineTolerance;
        const double box[3] = {4, 1, 2};
        std::copy_n(box, 3, desc.body_box);
        if (timed) {
            desc.pacing = FLG_MOTION_PACING_PATH;
            desc.max_speed = desc.max_turn = desc.max_acceleration = 2;
            desc.look = FLG_MOTION_LOOK_TARGET;
            desc.look_points = target;
            desc.look_count = 1;
            desc.bank = 1;
        }
        std::string note;
        const double ms = median_ms(kMotionRuns, [&] {
            FlgMotion motion{};
            FlgJob job{};
            const double took = time_ms([&] {
                check(flgMotionCreate(host.context(), &desc, &motion, &job));
                host.run();
            });
            host.check_done(job);
            check(flgJobRelease(host.context(), job));
            FlgMotionView view = flgMotionViewDefaults();
            check(flgMotionGetView(host.context(), motion, &view));
            char text[64];
            std::snprintf(text, sizeof text, "%u rounds, residual %.1e", view.rounds, view.residual);
            note = text;
            check(flgMotionRelease(host.context(), motion));
            return took;
        });
        const std::string name = std::string("motion, M = 288, ") + variant;
        rows.push_back(below(name, ms, "ms", kMotionMs, note));
        rows.push_back(below(name + ", a position", 1000 * ms / 288, "us", kPositionUs));
    }
    return rows;
}

}  // namespace flg::bench
