// SPDX-License-Identifier: MIT
#include "stylization/live_jobs.h"

#include <array>
#include <cinttypes>
#include <cstring>
#include <span>

#include "core/failure.h"
#include "runtime/each.h"
#include "runtime/fork.h"

namespace flg {

namespace {

constexpr uint32_t trees_per_branch = 8;
constexpr uint32_t tree_chunk = 120;    // units, about 10 us
constexpr uint32_t point_chunk = 100;   // units, about 10 us
constexpr size_t copy_chunk = 4096;     // floats, about 10 us on pages not touched before
constexpr uint32_t check_chunk = 1024;  // samples, about 10 us

// A path tree that is being made: goes back if the job is cancelled.
struct UnfinishedTree {
    PathTrees& trees;
    uint16_t* hops = nullptr;
    ~UnfinishedTree() { trees.discard(hops); }
};

Task<void> make_trees(Pace& pace, PathTrees& trees, uint32_t batch) {
    const uint32_t first = batch * trees_per_branch;
    const uint32_t last = std::min(first + trees_per_branch, trees.destination_count());
    PathTreeKernel kernel(pace.memory());
    UnfinishedTree tree{trees};
    for (uint32_t k = first; k < last; ++k) {
        if (trees.find(k)) continue;
        tree.hops = trees.allocate();
        kernel.begin(trees.graph(), trees.temperature(), trees.destination(k), tree.hops);
        for (uint32_t units = tree_chunk; !kernel.run(units); units = tree_chunk) co_await pace;
        trees.publish(k, std::exchange(tree.hops, nullptr));
        co_await pace;
    }
}

Task<std::shared_ptr<PathTrees>> warm_trees(Pace& pace, Style& style, double temperature) {
    pace.stage("path_trees");
    std::shared_ptr<PathTrees> trees = style.trees(style.prepared.temperature(temperature));
    const uint32_t batches = (trees->destination_count() + trees_per_branch - 1) / trees_per_branch;
    co_await fork(pace, batches, &make_trees, *trees);
    co_return trees;
}

Task<void> copy(Pace& pace, const float* from, float* to, size_t count) {
    for (size_t done = 0; done < count; done += copy_chunk) {
        std::memcpy(to + done, from + done, std::min(copy_chunk, count - done) * sizeof(float));
        co_await pace;
    }
}

// What strokes with end caps are led home by: the styles as they are applied.
struct CappedStyles {
    std::array<Buffer<Vec3>, styles_max> displacements;
    bool any = false;  // has an end cap, and it is wanted

    // Of a stroke with so many points.
    void tell(LiveSettings& settings, uint32_t points) const {
        for (uint32_t i = 0; any && i < settings.style_count; ++i) {
            if (displacements[i].empty()) continue;
            LiveStyle& style = settings.styles[i];
            const double samples = (points - 1) * (settings.spacing() / style.spacing());
            style.point_count = static_cast<uint32_t>(samples) + 1;
            style.displacement = {displacements[i].data(), displacements[i].size()};
        }
    }
};

Task<CappedStyles> fit_caps(Pace& pace, const LiveSettings& settings) {
    CappedStyles capped;
    for (uint32_t i = 0; settings.end_cap && i < settings.style_count; ++i) {
        const LiveStyle& style = settings.styles[i];
        if (style.style->graph.end_cap == 0) continue;
        capped.any = true;
        const Eigen::Matrix3d basis = scaled_basis(style.scale, settings.basis);
        Buffer<Vec3>& displacement = capped.displacements[i];
        displacement = Buffer<Vec3>(style.style->point_count(), pace.memory());
        co_await each(pace, displacement.size(), Cost::tens_of_ns, [&](uint32_t node) {
            std::construct_at(&displacement[node], fitted(basis, style.style->displacement, node));
        });
    }
    co_return capped;
}

// A set of one open curve.
void lay_out(CurveSet& set, uint32_t points, const std::pmr::vector<CurveSet::ColumnLayout>& layout) {
    set.allocate_curves(1);
    set.offsets()[0] = 0;
    set.offsets()[1] = points;
    set.begin_curve(0, 0);
    set.allocate_columns(layout);
}

Task<void> copy_points(Pace& pace, const LiveStroke& stroke, uint32_t first, uint32_t count, CurveSet& out) {
    const LiveColumns& columns = stroke.columns();
    lay_out(out, count, {columns.layout.begin(), columns.layout.begin() + columns.count, pace.memory()});
    for (uint32_t k = 0; k < columns.count; ++k) {
        const size_t components = columns.layout[k].components;
        co_await copy(pace, columns.data[k] + first * components, out.columns()[k].values.data(), count * components);
    }
    out.complete_curve(0);
}

// All of a closed kernel's samples.
Task<void> draw(Pace& pace, LiveKernel& kernel, uint32_t samples) {
    for (uint32_t units = point_chunk; !kernel.run(samples, units); units = point_chunk) co_await pace;
}

// The whole stroke once more, `points` long, with end caps.
Task<void> draw_capped(Pace& pace, const LiveStroke& stroke, uint32_t points, const CappedStyles& caps, CurveSet& out) {
    LiveColumns columns = stroke.columns();
    lay_out(out, points, {columns.layout.begin(), columns.layout.begin() + columns.count, pace.memory()});
    for (uint32_t k = 0; k < columns.count; ++k) columns.data[k] = out.columns()[k].values.data();
    LiveSettings settings = stroke.settings();
    caps.tell(settings, points);
    LiveMixStates mix(settings.style_count, 1, pace.memory());
    LiveKernel kernel(settings, stroke.samples(), columns, mix[0]);
    kernel.close();
    co_await draw(pace, kernel, stroke.sample_count());
    out.complete_curve(0);
}

Task<void> copy_samples(Pace& pace, const LiveStroke& stroke, CurveSet& out) {
    const uint32_t count = stroke.sample_count();
    const CurveSet::ColumnLayout layout[] = {{FLG_ATTRIBUTE_POSITION, 3},
                                             {FLG_ATTRIBUTE_ORIENTATION, 4},
                                             {FLG_ATTRIBUTE_PRESSURE, 1},
                                             {FLG_ATTRIBUTE_TIME, 1},
                                             {FLG_ATTRIBUTE_RADIUS, 1}};
    lay_out(out, count, {std::begin(layout), std::end(layout), pace.memory()});
    const LiveSamples& samples = stroke.samples();
    const float* columns[] = {samples.positions, samples.orientations, samples.pressures, samples.times};
    for (size_t k = 0; k < std::size(columns); ++k) {
        co_await copy(pace, columns[k], out.columns()[k].values.data(), size_t{count} * layout[k].components);
    }
    // What the hand makes of it alone, so that what drives the radius finds one.
    const LiveSettings& settings = stroke.settings();
    co_await each(pace, count, Cost::some_ns, [&, radii = out.columns().back().values.data()](uint32_t i) {
        radii[i] = static_cast<float>(settings.min_radius +
                                      (settings.max_radius - settings.min_radius) * double{samples.pressures[i]});
    });
    out.complete_curve(0);
}

// ---- replay ----

struct Replay {
    const LiveReplayRequest& request;
    LiveSettings settings;
    LiveColumns columns;
    CappedStyles caps{};
};

LiveSamples samples_of_curve(const CurveSet& set, uint32_t curve) {
    const auto column = [&](FlgAttribute attribute) -> const float* {
        const Column* found = set.find(attribute);
        return found ? found->values.data() + size_t{set.offsets()[curve]} * found->components : nullptr;
    };
    return {column(FLG_ATTRIBUTE_POSITION), column(FLG_ATTRIBUTE_ORIENTATION), column(FLG_ATTRIBUTE_PRESSURE),
            column(FLG_ATTRIBUTE_TIME)};
}

uint32_t sample_count_of(const CurveSet& set, uint32_t curve) {
    return set.offsets()[curve + 1] - set.offsets()[curve];
}

LiveSettings settings_of_curve(const Replay& replay, uint32_t curve) {
    LiveSettings settings = replay.settings;
    settings.seed += curve;
    return settings;
}

LiveSample sample_at(const LiveSamples& samples, uint32_t i) {
    LiveSample sample;
    std::copy_n(samples.positions + 3 * size_t{i}, 3, sample.position);
    if (samples.pressures) sample.pressure = samples.pressures[i];
    if (samples.times) sample.time = samples.times[i];
    return sample;
}

// Refuses what a live stroke would, and counts the points.
Task<void> measure_curve(Pace& pace, Replay& replay, uint32_t curve) {
    const LiveSamples samples = samples_of_curve(*replay.request.samples, curve);
    const uint32_t count = sample_count_of(*replay.request.samples, curve);
    for (uint32_t i = 0; i < count; ++i) {
        const LiveSample sample = sample_at(samples, i);
        try {
            check_sample(sample, i);
            if (i > 0) {
                const LiveSample before = sample_at(samples, i - 1);
                check_next_sample(before.position, before.time, sample, replay.request.desc.max_jump, i);
            }
        } catch (const Failure& failure) {
            throw Failure(failure.result(), "curve %u: %.200s", curve, failure.what());
        }
        if ((i + 1) % check_chunk == 0) co_await pace;
    }
    LiveColumns none = replay.columns;
    none.data = {};
    LiveKernel kernel(settings_of_curve(replay, curve), samples, none);
    kernel.close();
    co_await draw(pace, kernel, count);
    if (kernel.state().cut) {
        throw Failure(FLG_ERROR_LIMIT, "curve %u comes to more than max_points, %u", curve, replay.settings.max_points);
    }
    replay.request.out->offsets()[curve + 1] = kernel.state().points;
}

Task<void> draw_curve(Pace& pace, Replay& replay, uint32_t curve) {
    CurveSet& out = *replay.request.out;
    LiveColumns columns = replay.columns;
    for (uint32_t k = 0; k < columns.count; ++k) {
        columns.data[k] = out.columns()[k].values.data() + size_t{out.offsets()[curve]} * columns.layout[k].components;
    }
    LiveSettings settings = settings_of_curve(replay, curve);
    replay.caps.tell(settings, out.offsets()[curve + 1] - out.offsets()[curve]);
    LiveMixStates mix(settings.style_count, 1, pace.memory());
    LiveKernel kernel(settings, samples_of_curve(*replay.request.samples, curve), columns, mix[0]);
    kernel.close();
    co_await draw(pace, kernel, sample_count_of(*replay.request.samples, curve));
    out.complete_curve(curve);
    pace.advance(1);
}

}  // namespace

Task<void> warm_style(Pace& pace, std::shared_ptr<Style> style, double temperature) {
    co_await warm_trees(pace, *style, temperature);
}

void LiveEnding::publish(const Job& job) noexcept {
    stroke->settle(job.result == FLG_OK);
    if (stylized) stylized->publish(job);
    if (samples) samples->publish(job);
}

void LiveEnding::warn(const Host& host) const noexcept {
    if (!stroke->cut()) return;
    host.log(FLG_LOG_LEVEL_WARNING,
             "live stroke (0x%" PRIx64 ") was cut at %u points: its samples need more than max_points", handle,
             stroke->point_count());
}

Task<void> end_stroke(Pace& pace, LiveEnding& ending) {
    LiveStroke& stroke = *ending.stroke;
    pace.stage("live_stroke");
    co_await draw(pace, stroke.kernel(), stroke.sample_count());
    pace.stage("copy");
    const uint32_t points = stroke.kernel().state().points;
    const CappedStyles caps = co_await fit_caps(pace, stroke.settings());
    if (ending.stylized && !caps.any) {
        co_await copy_points(pace, stroke, 0, points, *ending.stylized);
    } else if (ending.stylized) {
        co_await draw_capped(pace, stroke, points, caps, *ending.stylized);
    }
    if (ending.samples) co_await copy_samples(pace, stroke, *ending.samples);
}

void LiveSplit::publish(const Job& job) noexcept {
    --stroke->readers;
    if (first) first->publish(job);
    if (second) second->publish(job);
}

Task<void> split_stroke(Pace& pace, LiveSplit& split) {
    const LiveStroke& stroke = *split.stroke;
    const uint32_t points = stroke.point_count();
    pace.stage("copy");
    if (split.first) co_await copy_points(pace, stroke, 0, split.point + 1, *split.first);
    if (split.second) co_await copy_points(pace, stroke, split.point, points - split.point, *split.second);
}

Task<void> replay_strokes(Pace& pace, LiveReplayRequest request) {
    const auto temperatures = request.drives.temperatures(request.desc.temperature);
    const std::span<LiveStyleRequest> styles(request.styles.data(), request.style_count);
    for (LiveStyleRequest& style : styles) {
        style.trees = co_await warm_trees(pace, *style.style, temperatures[0]);
        style.hot_trees = co_await warm_trees(pace, *style.style, temperatures[1]);
    }
    Replay replay{request, live_settings(request.desc, styles, request.drives),
                  live_columns(styles[0].style->prepared)};
    replay.caps = co_await fit_caps(pace, replay.settings);

    pace.stage("check");
    CurveSet& out = *request.out;
    const uint32_t curves = request.samples->curve_count();
    if (replay.settings.smoothing > 0 && !request.samples->find(FLG_ATTRIBUTE_TIME)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.smoothing is %g, but samples have no TIME column",
                      replay.settings.smoothing);
    }
    if (request.drives.drive_by(FLG_ATTRIBUTE_SPEED) && !request.samples->find(FLG_ATTRIBUTE_TIME)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.drives drive by SPEED, but samples have no TIME column");
    }
    out.allocate_curves(curves);
    co_await fork(pace, curves, &measure_curve, replay);
    out.offsets()[0] = 0;
    constexpr uint64_t points_max = uint64_t{1} << 31;
    uint64_t points = 0;
    for (uint32_t c = 0; c < curves; ++c) {
        points += out.offsets()[c + 1];
        if (points > points_max) throw Failure(FLG_ERROR_LIMIT, "the result would have more than 2^31 points");
        out.offsets()[c + 1] = static_cast<uint32_t>(points);
        out.begin_curve(c, 0);
        if ((c + 1) % check_chunk == 0) co_await pace;
    }
    pace.expect(curves);
    out.allocate_columns(
        {replay.columns.layout.begin(), replay.columns.layout.begin() + replay.columns.count, pace.memory()});

    pace.stage("live_stroke");
    co_await fork(pace, curves, &draw_curve, replay);
}

}  // namespace flg
