// SPDX-License-Identifier: MIT
// Fig. 14 of the paper redrawn: the energy that our semi-discrete matching, with steps of any length as in the paper,
// and the paper's discrete one, literally, reach and the time they take, for N = 300 and 600 points. Over all built-in
// styles, the worst counts.
#include <algorithm>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "curves/arc_length.h"
#include "curves/block_sampler.h"
#include "reference/literal_matching.h"
#include "runtime/run_now.h"
#include "stylization/guide_matching.h"

namespace flg::bench {
namespace {

constexpr double kEnergyBar = 1.0, kSpeedBar = 1.0;
constexpr int kKindRuns = 5;

struct Matched {
    double energy_sq_m;  // mean over the points
    double elapsed_ms;
};

std::vector<Vec3> guide_of(Host& host, FlgCurveSet curve, uint32_t points) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curve;
    desc.point_count = points;
    FlgStyle style = {};
    check(flgStyleCreate(host.context(), &desc, &style, nullptr));
    host.run();
    FlgCurveSet guide_set = {};
    check(flgStyleGetGuide(host.context(), style, &guide_set));
    const float* positions = host.view(guide_set).columns[0].data;
    std::vector<Vec3> guide(points);
    for (uint32_t i = 0; i < points; ++i) guide[i] = load_vec3(positions + size_t{3} * i);
    check(flgCurveSetRelease(host.context(), guide_set));
    check(flgStyleRelease(host.context(), style));
    return guide;
}

// As many points of the style as the guide has.
struct Sampled {
    std::vector<Vec3> points;
    double length = 0;
};

Sampled sampled(const FlgCurveSetView& view, uint32_t points) {
    const CurveView curve{view.columns[0].data, view.curve_offsets[1], false};
    Sampled style{std::vector<Vec3>(points)};
    style.length =
        run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return measure_curve(pace, curve); }).length;
    BlockSampler sampler(curve, style.length, points - 1);
    SampleBlock block;
    for (uint32_t i = 0; i < points;) {
        uint32_t units = ~0u;
        sampler.next(block, units);
        for (uint32_t k = 0; k < block.count; ++k) style.points[i++] = block.position_of(k);
    }
    return style;
}

template <class Energy>
Matched timed(const Energy& energy, size_t points) {
    Matched matched = {};
    matched.elapsed_ms = median_ms(kKindRuns, [&] {
        const double begin_ms = thread_ms();
        matched.energy_sq_m = energy() / static_cast<double>(points);
        return thread_ms() - begin_ms;
    });
    return matched;
}

}  // namespace

std::vector<Row> run_matching_kinds() {
    Host host;
    const double beta = flgStyleDefaults().beta;
    std::vector<Row> rows;
    for (const uint32_t points : {300U, 600U}) {
        double energy = 0.0, speed = 1e30;
        char energy_note[96] = "", speed_note[96] = "";
        for (const std::string& name : scenes::style_names()) {
            const FlgCurveSet curve = host.add(scenes::make_style(name));
            const std::vector<Vec3> guide = guide_of(host, curve, points);
            const Sampled style = sampled(host.view(curve), points);
            const SmoothStyleCurve smooth(style.points.data(), points, style.length);
            const Matched semi = timed(
                [&] {
                    const auto match = [&](Pace& pace) { return match_guide(pace, smooth, guide, beta, style.length); };
                    return run_now(std::pmr::new_delete_resource(), match).energy;
                },
                points);
            const Matched discrete =
                timed([&] { return reference::match_discrete(style.points, style.length, guide, beta, false).energy; },
                      points);
            if (semi.energy_sq_m / discrete.energy_sq_m > energy) {
                energy = semi.energy_sq_m / discrete.energy_sq_m;
                std::snprintf(energy_note, sizeof energy_note, "%s: %.6g of %.6g", name.c_str(), semi.energy_sq_m,
                              discrete.energy_sq_m);
            }
            if (discrete.elapsed_ms / semi.elapsed_ms < speed) {
                speed = discrete.elapsed_ms / semi.elapsed_ms;
                std::snprintf(speed_note, sizeof speed_note, "%s: %.3g ms against %.3g ms", name.c_str(),
                              semi.elapsed_ms, discrete.elapsed_ms);
            }
        }
        const std::string label = "Fig. 14, N = " + std::to_string(points) + ": ";
        rows.push_back(below(label + "semi-discrete energy over discrete", energy, "", kEnergyBar, energy_note));
        rows.push_back(at_least(label + "semi-discrete speed over discrete", speed, "x", kSpeedBar, speed_note));
    }
    return rows;
}

}  // namespace flg::bench
