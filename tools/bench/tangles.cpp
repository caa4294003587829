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
#include "filigree/filigree_tangle.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTriangles = 2'000'000, kCells = 130, kSteps = 200;
constexpr double kOperatorMs = 100, kUndoMs = 30, kSamplesOverSolve = 2, kCellsOverSolve = 2.5, kMemoryMb = 400;
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
                     uint32_t workers = 0)
        : host_(memory, clock, workers) {
        const MeshArrays mesh = bumpy_torus(kTriangles);
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
    FlgJob divide(FlgTangleOperator kind, uint32_t region, const FlgTangleSeeds& seeds, float delta, uint32_t count) {
        FlgTangleDivideDesc desc = flgTangleDivideDefaults();
        desc.tangle = tangle_;
        desc.kind = kind;
        desc.regions = &region;
        desc.region_count = 1;
        desc.a = &seeds;
        desc.delta = delta;
        desc.count = count;
        FlgJob job{};
        check(flgTangleDivide(host_.context(), &desc, &job));
        return job;
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

struct Frames {
    std::vector<double> ticks_us, visible_ms;
    float max_slice_us = 0;
    std::string max_slice_stage;
};

// A host with one worker that ticks 90 times a second: how long ticks take, and how long until an edit is seen.
Frames play_frames() {
    using Clock = std::chrono::steady_clock;
    const auto ms = [](Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); };
    Session session({}, {}, 1);
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

std::vector<Row> run_tangles() {
    std::vector<Row> rows;
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
