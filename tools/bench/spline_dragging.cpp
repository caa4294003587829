// SPDX-License-Identifier: MIT
// One of ten points of a spline on a mesh is dragged: each curve begins at the last one.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "bench/splines.h"

namespace flg::bench {
namespace {

constexpr uint32_t kFrames = 60, kBudgetUs = 2000;
constexpr double kFirstMs = 10, kDraggedMs = 3;
constexpr double kBudgetMs = 2, kFrameMs = 1000.0 / 90, kReach = 0.15;  // radians around the torus, there and back

double aside_at(uint32_t frame) {
    return kReach * std::sin(2 * M_PI * frame / kFrames);
}

std::string text_of(const char* format, double value, double more = 0) {
    char text[96];
    std::snprintf(text, sizeof text, format, value, more);
    return text;
}

// Of each frame's job, in processor time.
struct Times {
    double first_ms = 0;
    double mean_ms = 0, max_ms = 0, mean_rounds = 0;
};

// `on_triangles`: the curve over the mesh's triangles, which is there first.
Times drag_times(const MeshArrays& mesh, bool on_triangles) {
    SplineBench bench(mesh);
    bench.make_manifold();
    FlgSplineView view{};
    FlgSpline last{};
    const std::vector<double> begin = winding_points();
    FlgSplineDesc first = bench.desc(begin);
    first.on_triangles = on_triangles;
    Times times;
    times.first_ms = bench.spline_ms(first, view, &last);
    for (uint32_t frame = 1; frame <= kFrames; ++frame) {
        const std::vector<double> points = winding_points(aside_at(frame));
        FlgSplineDesc desc = bench.desc(points);
        desc.warm_start = last;
        desc.on_triangles = on_triangles;
        FlgSpline next{};
        const double ms = bench.spline_ms(desc, view, &next);
        check(flgSplineRelease(bench.host().context(), last));
        last = next;
        times.mean_ms += ms / kFrames;
        times.max_ms = std::max(times.max_ms, ms);
        times.mean_rounds += static_cast<double>(view.rounds) / kFrames;
    }
    return times;
}

struct Frames {
    uint32_t without = 0;  // a new curve
    double max_tick_us = 0;
};

// At 90 Hz in real time: what was asked for after the last tick is to be there after this one. Without a worker all of
// it is done in ticks, whose budget is processor time then: what else the machine does is left out.
Frames drag_frames(const MeshArrays& mesh, uint32_t workers) {
    using Clock = std::chrono::steady_clock;
    SplineBench bench(mesh, workers,
                      workers > 0 ? flgClockDefaults() : FlgClock{sizeof(FlgClock), nullptr, processor_ns});
    bench.make_manifold();
    FlgContext context = bench.host().context();
    FlgSplineView view{};
    FlgSpline shown{}, asked{};
    bench.spline_ms(bench.desc(winding_points()), view, &shown);
    const auto ask = [&](uint32_t frame) {
        const std::vector<double> points = winding_points(aside_at(frame));
        FlgSplineDesc desc = bench.desc(points);
        desc.warm_start = shown;
        check(flgSplineCreate(context, &desc, &asked, nullptr));
    };
    Frames frames;
    ask(0);
    for (uint32_t frame = 1; frame <= kFrames; ++frame) {
        const Clock::time_point begin = Clock::now();
        std::this_thread::sleep_until(begin + std::chrono::duration<double, std::milli>(kFrameMs));
        const double us = 1000.0 * time_ms([&] { check(flgContextTick(context, kBudgetUs, nullptr)); });
        frames.max_tick_us = std::max(frames.max_tick_us, us);
        view = flgSplineViewDefaults();
        if (flgSplineGetView(context, asked, &view) != FLG_OK) {
            ++frames.without;
            continue;
        }
        check(flgSplineRelease(context, shown));
        shown = asked;
        ask(frame);
    }
    return frames;
}

}  // namespace

std::vector<Row> spline_first(const MeshArrays& mesh, const std::string& name) {
    const Times times = drag_times(mesh, true);
    return {
        below(name + ": first curve, over triangles, M = 288", times.first_ms, "ms", kFirstMs),
        below(name + ": the same, a point dragged, mean", times.mean_ms, "ms", kDraggedMs,
              text_of("longest %.1f ms", times.max_ms)),
    };
}

std::vector<Row> spline_dragging(const MeshArrays& mesh, const std::string& name) {
    const Times times = drag_times(mesh, false);
    const Frames one = drag_frames(mesh, 1), none = drag_frames(mesh, 0);
    return {
        below(name + ": a point dragged, M = 288, mean", times.mean_ms, "ms", kBudgetMs,
              text_of("%.1f rounds", times.mean_rounds)),
        below(name + ": a point dragged, M = 288, longest", times.max_ms, "ms", kBudgetMs),
        below(name + ": frames without a new curve, one worker", one.without, "of 60", 1,
              text_of("2 ms budget at 90 Hz, longest tick %.0f us", one.max_tick_us)),
        below(name + ": frames without a new curve, no worker", none.without, "of 60", 1,
              text_of("2 ms budget at 90 Hz, longest tick %.0f us", none.max_tick_us)),
    };
}

}  // namespace flg::bench
