// SPDX-License-Identifier: MIT
// A session of tangles on a mesh of 2 million triangles: what operators cost, everything included, what it costs to
// take them back, and how much memory the surface, its solvers and the history have in the end; and what a host's
// frames see of it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <string_view>
#include <thread>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/meshes.h"
#include "core/random.h"
#include "filigree/filigree_tangle.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTriangles = 2'000'000, kCells = 130, kSteps = 200;
constexpr double kOperatorMs = 20, kUndoMs = 30, kSamplesOverSolve = 2, kCellsOverSolve = 2.5, kMemoryMb = 400;
constexpr uint32_t kSmallCells = 200, kEachCells = 223, kRandomSteps = 500;
constexpr double kSmallMs = 2.5, kWorstMs = 400, kEachMs = 300, kPerturbed = 1.3, kDisplaceNs = 150;
constexpr float kNoiseFrequency = 20;
constexpr uint32_t kEditTriangles = 500'000, kEditSteps = 30, kEdits = 11;
constexpr double kEditMs = 150;
constexpr uint32_t kFrameSteps = 40, kBudgetUs = 2000;
constexpr double kTickUs = 2500, kVisibleMs = 200, kFrameMs = 1000.0 / 90;

// Counts what is held; without workers, so without locks.
class CountingMemory {
public:
    FlgAllocator hooks() { return {sizeof(FlgAllocator), this, allocate, release}; }
    double held_mb() const { return static_cast<double>(held_) * 1e-6; }

private:
    static void* allocate(void* self, size_t size, size_t alignment) {
        static_cast<CountingMemory*>(self)->held_ += size;
        return ::operator new(size, std::align_val_t(alignment), std::nothrow);
    }
    static void release(void* self, void* memory, size_t size, size_t alignment) {
        static_cast<CountingMemory*>(self)->held_ -= size;
        ::operator delete(memory, std::align_val_t(alignment));
    }

    size_t held_ = 0;
};

uint64_t processor_ns(void*) {
    return static_cast<uint64_t>(thread_ms() * 1e6);
}

class Session {
public:
    explicit Session(const FlgAllocator& memory = flgAllocatorDefaults(), const FlgClock& clock = flgClockDefaults(),
                     uint32_t workers = 0, uint32_t triangles = kTriangles)
        : host_(memory, clock, workers) {
        const MeshArrays mesh = bumpy_torus(triangles);
        FlgColumn column;
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        const FlgMeshView input = mesh.view(column);
        desc.mesh = &input;
        check(flgSurfaceCreate(host_.context(), &desc, &surface_, nullptr));
        check(flgTangleCreate(host_.context(), surface_, nullptr, &tangle_, nullptr));
        host_.run();
        solve_ms();  // builds what solvers need
    }

    // Of one job, in processor time.
    double finish(FlgJob job) {
        host_.run();
        host_.check_done(job);
        last_ = job;
        FlgJobStatus status{};
        status.struct_size = sizeof status;
        check(flgJobGetStatus(host_.context(), job, &status));
        return status.busy_us * 1e-3;
    }
    // One full solve from a point.
    double solve_ms() {
        const uint32_t source = 0;
        FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
        desc.surface = surface_;
        desc.vertices = &source;
        desc.vertex_count = 1;
        FlgField field{};
        FlgJob job{};
        check(flgFieldCreateGeodesic(host_.context(), &desc, &field, &job));
        const double ms = finish(job);
        check(flgFieldRelease(host_.context(), field));
        return ms;
    }
    double samples_ms(uint32_t count) {
        FlgSurfaceSampleDesc desc = flgSurfaceSampleDefaults();
        desc.surface = surface_;
        desc.radius = 1e-6f;
        desc.max_count = count;
        FlgField field{};
        FlgJob job{};
        check(flgSurfaceSample(host_.context(), &desc, &field, &job));
        const double ms = finish(job);
        check(flgFieldRelease(host_.context(), field));
        return ms;
    }
    FlgJob divide(FlgTangleOperator kind, uint32_t region, const FlgTangleSeeds& seeds, float delta, uint32_t count,
                  float perturbation = 0) {
        FlgTangleDivideDesc desc = flgTangleDivideDefaults();
        desc.tangle = tangle_;
        desc.kind = kind;
        desc.regions = &region;
        desc.region_count = 1;
        desc.a = &seeds;
        desc.delta = delta;
        desc.count = count;
        desc.perturbation = perturbation;
        desc.frequency = kNoiseFrequency;
        FlgJob job{};
        check(flgTangleDivide(host_.context(), &desc, &job));
        return job;
    }
    FlgJob displace(uint32_t region, float amount) {
        FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
        desc.tangle = tangle_;
        desc.regions = &region;
        desc.region_count = 1;
        desc.amount = amount;
        FlgJob job{};
        check(flgTangleDisplace(host_.context(), &desc, &job));
        return job;
    }
    // A step of the history, counted from 0, with another distance between its lines.
    FlgJob edit(uint32_t step, float delta) {
        FlgTangleHistory history{};
        history.struct_size = sizeof history;
        check(flgTangleGetHistory(host_.context(), tangle_, &history));
        FlgTangleDivideDesc desc = *history.steps[step]->divide;
        desc.delta = delta;
        FlgTangleStep changed = *history.steps[step];
        changed.divide = &desc;
        FlgJob job{};
        check(flgTangleEditStep(host_.context(), tangle_, step, &changed, nullptr, &job));
        return job;
    }
    uint32_t vertex_count() {
        FlgSurfaceView view{};
        view.struct_size = sizeof view;
        check(flgSurfaceGetView(host_.context(), surface_, &view));
        return view.mesh->vertex_count;
    }
    // Of the last job that was finished: its stages of these names together.
    double stages_ms(std::initializer_list<std::string_view> names) {
        FlgStageTime stages[16];
        uint32_t count = 0;
        check(flgJobGetStages(host_.context(), last_, stages, 16, &count));
        double us = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (std::find(names.begin(), names.end(), stages[i].name) != names.end()) us += stages[i].busy_us;
        }
        return us * 1e-3;
    }
    // A frame: how long the tick took, by the host's clock.
    double tick(uint32_t budget_us, FlgFrameReport& report) {
        report = {};
        report.struct_size = sizeof report;
        const auto begin = std::chrono::steady_clock::now();
        check(flgContextTick(host_.context(), budget_us, &report));
        return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
    }
    void check_done(FlgJob job) { host_.check_done(job); }
    double undo() { return step(flgTangleUndo); }
    double redo() { return step(flgTangleRedo); }
    FlgTangleInfo info() {
        FlgTangleInfo info{};
        info.struct_size = sizeof info;
        check(flgTangleGetInfo(host_.context(), tangle_, &info));
        return info;
    }

private:
    double step(FlgResult (*go)(FlgContext, FlgTangle, const FlgJobOptions*, FlgJob*)) {
        FlgJob job{};
        check(go(host_.context(), tangle_, nullptr, &job));
        return finish(job);
    }

    Host host_;
    FlgSurface surface_{};
    FlgTangle tangle_{};
    FlgJob last_{};
};

FlgTangleSeeds borders(FlgTangleBorders which) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.borders = which;
    return seeds;
}

FlgTangleSeeds samples(float radius, uint32_t count) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.sample_radius = radius;
    seeds.sample_count = count;
    return seeds;
}

// As a designer goes on: the cells, a band along each, then one region after the other.
FlgJob begin_step(Session& session, uint32_t n) {
    constexpr uint32_t first = 1, cells = kCells;
    if (n == 0) return session.divide(FLG_TANGLE_OPERATOR_VORONOI, 0, samples(0.05f, kCells), 1, 1);
    if (n == 1) return session.divide(FLG_TANGLE_OPERATOR_CONTOUR, 0, borders(FLG_TANGLE_BORDERS_EACH), 0.02f, 1);
    const uint32_t cell = first + n % cells;
    if (n % 3 == 0) return session.divide(FLG_TANGLE_OPERATOR_CONTOUR, cell, samples(0.05f, 12), 0.015f, 1);
    const float delta = 0.03f + 0.002f * static_cast<float>(n);
    return session.divide(FLG_TANGLE_OPERATOR_CONTOUR, cell, borders(FLG_TANGLE_BORDERS_OUTER), delta, 2);
}

// Any operator on any region, but the whole.
FlgJob begin_random_step(Session& session, uint32_t n) {
    const auto draw = [n](uint32_t which) { return random_unit(7, n, which); };
    const auto region = 1 + static_cast<uint32_t>(draw(0) * (session.info().region_count - 1));
    const float delta = 0.01f + 0.04f * static_cast<float>(draw(1));
    const double kind = draw(2);
    if (kind < 0.2) return session.divide(FLG_TANGLE_OPERATOR_CONTOUR, region, samples(0.04f, 12), delta / 2, 1);
    if (kind < 0.4) return session.divide(FLG_TANGLE_OPERATOR_VORONOI, region, samples(0.04f, 12), delta, 1);
    if (kind < 0.5)
        return session.divide(FLG_TANGLE_OPERATOR_STREAM, region, borders(FLG_TANGLE_BORDERS_OUTER), 0.1f, 1);
    const FlgTangleBorders which = kind < 0.7 ? FLG_TANGLE_BORDERS_EACH : FLG_TANGLE_BORDERS_OUTER;
    return session.divide(FLG_TANGLE_OPERATOR_CONTOUR, region, borders(which), delta, 2, kind < 0.9 ? 0 : 0.01f);
}

struct Frames {
    std::vector<double> ticks_us, visible_ms;
    float max_slice_us = 0;
    std::string max_slice_stage;
};

// A host with one worker that ticks 90 times a second: how long ticks take, and how long until an edit is seen.
Frames play_frames() {
    using Clock = std::chrono::steady_clock;
    const auto ms = [](Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); };
    Session session(flgAllocatorDefaults(), flgClockDefaults(), 1);
    Frames frames;
    for (uint32_t n = 0; n < kFrameSteps; ++n) {
        const Clock::time_point asked = Clock::now();
        const FlgJob job = begin_step(session, n);
        FlgFrameReport report = {};
        for (report.jobs_pending = 1; report.jobs_pending > 0;) {
            const Clock::time_point frame = Clock::now();
            frames.ticks_us.push_back(session.tick(kBudgetUs, report));
            if (report.max_slice_us > frames.max_slice_us) {
                frames.max_slice_us = report.max_slice_us;
                frames.max_slice_stage = report.max_slice_stage;
            }
            if (report.jobs_pending > 0)
                std::this_thread::sleep_until(frame + std::chrono::duration<double, std::milli>(kFrameMs));
        }
        session.check_done(job);
        frames.visible_ms.push_back(ms(Clock::now() - asked));
    }
    return frames;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

// What an operator on a small region costs, and one on each of many.
void measure_small_regions(std::vector<Row>& rows) {
    Session session(flgAllocatorDefaults(), {sizeof(FlgClock), nullptr, processor_ns});
    session.finish(session.divide(FLG_TANGLE_OPERATOR_VORONOI, 0, samples(0.03f, kSmallCells), 1, 1));
    const auto band = [&](uint32_t cell, float perturbation) {
        return session.finish(session.divide(FLG_TANGLE_OPERATOR_CONTOUR, cell, borders(FLG_TANGLE_BORDERS_OUTER),
                                             0.01f, 1, perturbation));
    };
    band(1, 0);
    std::vector<double> plain, perturbed, same, undo, redo, displaced_ns;
    for (uint32_t cell = 2; cell < 22; ++cell) {
        plain.push_back(band(cell, 0));
        undo.push_back(session.undo());
        redo.push_back(session.redo());
        session.undo();
        perturbed.push_back(band(cell, 0.003f));
        session.undo();
        same.push_back(band(cell, 0.003f));
    }
    char note[160];
    std::snprintf(note, sizeof note, "longest %.2f; undo %.2f, redo %.2f",
                  *std::max_element(plain.begin(), plain.end()), median(undo), median(redo));
    rows.push_back(
        below("2 M triangles: a band in a region of 10,000, median of 20", median(plain), "ms", kSmallMs, note));
    std::snprintf(note, sizeof note, "the same noise again %.2f", median(same) / median(plain));
    rows.push_back(below("2 M triangles: the same perturbed, over plain", median(perturbed) / median(plain), "x",
                         kPerturbed, note));
    const double displaced = session.finish(session.displace(0, 0.002f));
    std::snprintf(note, sizeof note, "all %.0f ms, of these %.0f ms a field", displaced,
                  session.stages_ms({"field", "sources", "solve"}));
    const double moved = session.stages_ms({"displace"}) * 1e6 / session.vertex_count();
    rows.push_back(below("2 M triangles: displacement, without the field", moved, "ns/vertex", kDisplaceNs, note));
}

void measure_each(std::vector<Row>& rows) {
    Session session(flgAllocatorDefaults(), {sizeof(FlgClock), nullptr, processor_ns});
    session.finish(session.divide(FLG_TANGLE_OPERATOR_VORONOI, 0, samples(0.02f, kEachCells), 1, 1));
    double each = 0;
    for (uint32_t cell = 1; cell <= kEachCells; ++cell)
        each += session.finish(
            session.divide(FLG_TANGLE_OPERATOR_CONTOUR, cell, borders(FLG_TANGLE_BORDERS_OUTER), 0.01f, 1));
    for (uint32_t cell = 0; cell < kEachCells; ++cell) session.undo();
    const double together =
        session.finish(session.divide(FLG_TANGLE_OPERATOR_CONTOUR, 0, borders(FLG_TANGLE_BORDERS_EACH), 0.01f, 1));
    char note[160];
    std::snprintf(note, sizeof note, "all at once %.0f ms", together);
    rows.push_back(below("2 M triangles: a band in each of 223 regions", each, "ms", kEachMs, note));
}

void measure_random_steps(std::vector<Row>& rows) {
    Session session(flgAllocatorDefaults(), {sizeof(FlgClock), nullptr, processor_ns});
    session.finish(begin_step(session, 0));
    std::vector<double> steps, undo, redo;
    for (uint32_t n = 0; n < kRandomSteps; ++n) steps.push_back(session.finish(begin_random_step(session, n)));
    const std::vector<double> first(steps.begin(), steps.begin() + kSteps);
    const uint32_t made = session.info().undo_count - 1;
    for (uint32_t i = 0; i < made; ++i) undo.push_back(session.undo());
    for (uint32_t i = 0; i < made; ++i) redo.push_back(session.redo());
    char note[160];
    std::snprintf(note, sizeof note, "median %.1f ms", median(first));
    rows.push_back(below("2 M triangles: random operators, mean of 200", mean(first), "ms", kOperatorMs, note));
    std::snprintf(note, sizeof note, "mean %.1f ms; %u regions", mean(steps), session.info().region_count);
    rows.push_back(below("2 M triangles: random operators, worst of 500", *std::max_element(steps.begin(), steps.end()),
                         "ms", kWorstMs, note));
    std::snprintf(note, sizeof note, "mean %.2f ms", mean(undo));
    rows.push_back(
        below("2 M triangles: undo of these, worst", *std::max_element(undo.begin(), undo.end()), "ms", kUndoMs, note));
    std::snprintf(note, sizeof note, "mean %.2f ms", mean(redo));
    rows.push_back(
        below("2 M triangles: redo of these, worst", *std::max_element(redo.begin(), redo.end()), "ms", kUndoMs, note));
}

// Step 3 of 30 with another number: cells, then a band along the border of one after the other. And
// the first one, which all others need.
void measure_edits(std::vector<Row>& rows) {
    const FlgClock clock = {sizeof(FlgClock), nullptr, processor_ns};
    Session session(flgAllocatorDefaults(), clock, 0, kEditTriangles);
    session.finish(session.divide(FLG_TANGLE_OPERATOR_VORONOI, 0, samples(0.05f, kEditSteps), 1, 1));
    for (uint32_t cell = 1; cell < kEditSteps; ++cell)
        session.finish(session.divide(FLG_TANGLE_OPERATOR_CONTOUR, cell, borders(FLG_TANGLE_BORDERS_OUTER), 0.01f, 1));
    std::vector<double> edits;
    for (uint32_t i = 0; i < kEdits; ++i)
        edits.push_back(session.finish(session.edit(2, 0.012f + 0.001f * static_cast<float>(i))));
    const uint32_t computed = session.info().computed_count;
    const double undo = session.undo();
    const double all = session.finish(session.edit(0, 1));
    char note[160];
    std::snprintf(note, sizeof note, "longest %.1f; %u computed; undo of it %.1f; first step edited %.1f (%u computed)",
                  *std::max_element(edits.begin(), edits.end()), computed, undo, all, session.info().computed_count);
    rows.push_back(below("500,000 triangles: step 3 of 30 edited, median of 11", median(edits), "ms", kEditMs, note));
}

std::vector<Row> run_tangles() {
    std::vector<Row> rows;
    measure_edits(rows);
    measure_small_regions(rows);
    measure_each(rows);
    measure_random_steps(rows);
    CountingMemory memory;
    Session session(memory.hooks(), {sizeof(FlgClock), nullptr, processor_ns});
    const double solve = median_ms(3, [&] { return session.solve_ms(); });
    const double sampling = session.samples_ms(kCells);
    char note[160];
    std::snprintf(note, sizeof note, "solve %.0f ms; 10: %.2f, 30: %.2f, 65: %.2f, 130: %.2f solves", solve,
                  session.samples_ms(10) / solve, session.samples_ms(30) / solve, session.samples_ms(65) / solve,
                  sampling / solve);
    rows.push_back(below("2 M triangles: 130 samples over a solve", sampling / solve, "x", kSamplesOverSolve, note));

    std::vector<double> steps;
    double cells = 0;
    for (uint32_t n = 0; n < kSteps; ++n) {
        steps.push_back(session.finish(begin_step(session, n)));
        if (n == 0) cells = session.stages_ms({"sources", "solve", "cells"});
    }
    std::snprintf(note, sizeof note, "field and borders; sampled, cut and labelled in %.0f ms", steps[0]);
    rows.push_back(below("2 M triangles: 130 cells over a solve", cells / solve, "x", kCellsOverSolve, note));
    std::snprintf(note, sizeof note, "cells %.0f ms, a band along each %.0f ms, slowest of the rest %.0f ms", steps[0],
                  steps[1], *std::max_element(steps.begin() + 2, steps.end()));
    rows.push_back(below("2 M triangles: an operator, mean of 200", mean(steps), "ms", kOperatorMs, note));
    const FlgTangleInfo info = session.info();
    std::snprintf(note, sizeof note, "%u regions", info.region_count);
    rows.push_back(below("2 M triangles: memory after 200 steps", memory.held_mb(), "MB", kMemoryMb, note));

    std::vector<double> undo, redo;
    for (uint32_t i = 0; i < info.undo_count; ++i) undo.push_back(session.undo());
    for (uint32_t i = 0; i < info.undo_count; ++i) redo.push_back(session.redo());
    std::snprintf(note, sizeof note, "mean %.1f ms; of the cells %.0f ms", mean(undo), undo.back());
    rows.push_back(below("2 M triangles: undo, median of 200", median(undo), "ms", kUndoMs, note));
    std::snprintf(note, sizeof note, "mean %.1f ms; of the cells %.0f ms", mean(redo), redo.front());
    rows.push_back(below("2 M triangles: redo, median of 200", median(redo), "ms", kUndoMs, note));

    const Frames frames = play_frames();
    std::snprintf(note, sizeof note, "%zu ticks, median %.0f us; the worker's longest chunk %.0f us (%s)",
                  frames.ticks_us.size(), median(frames.ticks_us), static_cast<double>(frames.max_slice_us),
                  frames.max_slice_stage.c_str());
    rows.push_back(below("2 M triangles: longest tick at 2 ms, one worker",
                         *std::max_element(frames.ticks_us.begin(), frames.ticks_us.end()), "us", kTickUs, note));
    std::snprintf(note, sizeof note, "longest %.0f ms but for the cells (%.0f ms) and a band along each (%.0f ms)",
                  *std::max_element(frames.visible_ms.begin() + 2, frames.visible_ms.end()), frames.visible_ms[0],
                  frames.visible_ms[1]);
    rows.push_back(
        below("2 M triangles: until an edit is seen, mean of 40", mean(frames.visible_ms), "ms", kVisibleMs, note));
    return rows;
}

}  // namespace flg::bench
