// SPDX-License-Identifier: MIT
// A session of tangles on a mesh of 2 million triangles: what operators cost, everything included, what it costs to take
// them back, and how much memory the surface, its solvers and the history have in the end.
#include <algorithm>
#include <cstdio>
#include <new>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/meshes.h"
#include "filigree/filigree_tangle.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTriangles = 2'000'000, kCells = 130, kSteps = 200;
constexpr double kOperatorMs = 100, kUndoMs = 30, kSamplesOverSolve = 2, kCellsOverSolve = 2.5, kMemoryMb = 400;

// Counts what is held; without workers, so without locks.
class CountingMemory {
public:
    FlgAllocator hooks() { return {this, allocate, release}; }
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
    Session() : host_(memory_.hooks(), FlgClock{nullptr, processor_ns}) {
        const MeshArrays mesh = bumpy_torus(kTriangles);
        FlgColumn column;
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        desc.mesh = mesh.view(column);
        check(flgSurfaceCreate(host_.context(), &desc, &surface_, nullptr));
        check(flgTangleCreate(host_.context(), surface_, &tangle_, nullptr));
        host_.run();
        solve_ms();  // builds what solvers need
    }

    // Of one job, in processor time.
    double finish(FlgJob job) {
        host_.run();
        host_.check_done(job);
        FlgJobStatus status{};
        status.struct_size = sizeof status;
        check(flgJobGetStatus(host_.context(), job, &status));
        return status.busy_us * 1e-3;
    }
    // One full solve from a point.
    double solve_ms() {
        const uint32_t source = 0;
        FlgGeodesicDesc desc = flgGeodesicDefaults();
        desc.surface = surface_;
        desc.vertices = &source;
        desc.vertex_count = 1;
        FlgField field{};
        FlgJob job{};
        check(flgGeodesic(host_.context(), &desc, &field, &job));
        const double ms = finish(job);
        check(flgFieldRelease(host_.context(), field));
        return ms;
    }
    double samples_ms(uint32_t count) {
        FlgSamplingDesc desc = flgSamplingDefaults();
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
    double divide(FlgTangleOperator kind, uint32_t region, const FlgTangleSeeds& seeds, float delta, uint32_t count) {
        FlgTangleDivideDesc desc = flgTangleDivideDefaults();
        desc.tangle = tangle_;
        desc.kind = kind;
        desc.regions = &region;
        desc.region_count = 1;
        desc.a = seeds;
        desc.delta = delta;
        desc.count = count;
        FlgJob job{};
        check(flgTangleDivide(host_.context(), &desc, &job));
        return finish(job);
    }
    double undo() { return step(flgTangleUndo); }
    double redo() { return step(flgTangleRedo); }
    FlgTangleInfo info() {
        FlgTangleInfo info{};
        info.struct_size = sizeof info;
        check(flgTangleGetInfo(host_.context(), tangle_, &info));
        return info;
    }
    double held_mb() const { return memory_.held_mb(); }

private:
    double step(FlgResult (*go)(FlgContext, FlgTangle, FlgJob*)) {
        FlgJob job{};
        check(go(host_.context(), tangle_, &job));
        return finish(job);
    }

    CountingMemory memory_;
    Host host_;
    FlgSurface surface_{};
    FlgTangle tangle_{};
};

FlgTangleSeeds borders(FlgTangleBorders which) {
    FlgTangleSeeds seeds{};
    seeds.borders = which;
    return seeds;
}

FlgTangleSeeds samples(float radius, uint32_t count) {
    FlgTangleSeeds seeds{};
    seeds.sample_radius = radius;
    seeds.sample_count = count;
    return seeds;
}

// As a designer goes on: the cells, a band along each, then one region after the other.
std::vector<double> run_steps(Session& session) {
    std::vector<double> ms;
    ms.push_back(session.divide(FLG_TANGLE_VORONOI, 0, samples(0.05f, kCells), 1, 1));
    ms.push_back(session.divide(FLG_TANGLE_CONTOUR, 0, borders(FLG_TANGLE_BORDERS_EACH), 0.02f, 1));
    const uint32_t first = 1, cells = kCells;
    while (ms.size() < kSteps) {
        const auto n = static_cast<uint32_t>(ms.size());
        const uint32_t cell = first + n % cells;
        if (n % 3 == 0) {
            ms.push_back(session.divide(FLG_TANGLE_CONTOUR, cell, samples(0.05f, 12), 0.015f, 1));
        } else {
            ms.push_back(
                session.divide(FLG_TANGLE_CONTOUR, cell, borders(FLG_TANGLE_BORDERS_OUTER), 0.03f + 0.002f * n, 2));
        }
    }
    return ms;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

std::vector<Row> run_tangles() {
    std::vector<Row> rows;
    Session session;
    const double solve = median_ms(3, [&] { return session.solve_ms(); });
    const double sampling = session.samples_ms(kCells);
    char note[160];
    std::snprintf(note, sizeof note, "solve %.0f ms; 10: %.2f, 30: %.2f, 65: %.2f, 130: %.2f solves", solve,
                  session.samples_ms(10) / solve, session.samples_ms(30) / solve, session.samples_ms(65) / solve,
                  sampling / solve);
    rows.push_back(below("2 M triangles: 130 samples over a solve", sampling / solve, "x", kSamplesOverSolve, note));

    const std::vector<double> steps = run_steps(session);
    std::snprintf(note, sizeof note, "cells %.0f ms, a band along each %.0f ms, slowest of the rest %.0f ms", steps[0],
                  steps[1], *std::max_element(steps.begin() + 2, steps.end()));
    rows.push_back(below("2 M triangles: 130 cells over a solve", (steps[0] - sampling) / solve, "x", kCellsOverSolve,
                         "without the sampling"));
    rows.push_back(below("2 M triangles: an operator, mean of 200", mean(steps), "ms", kOperatorMs, note));
    const FlgTangleInfo info = session.info();
    std::snprintf(note, sizeof note, "%u regions", info.region_count);
    rows.push_back(below("2 M triangles: memory after 200 steps", session.held_mb(), "MB", kMemoryMb, note));

    std::vector<double> undo, redo;
    for (uint32_t i = 0; i < info.undo_count; ++i) undo.push_back(session.undo());
    for (uint32_t i = 0; i < info.undo_count; ++i) redo.push_back(session.redo());
    std::snprintf(note, sizeof note, "mean %.1f ms; of the cells %.0f ms", mean(undo), undo.back());
    rows.push_back(below("2 M triangles: undo, median of 200", median(undo), "ms", kUndoMs, note));
    std::snprintf(note, sizeof note, "mean %.1f ms; of the cells %.0f ms", mean(redo), redo.front());
    rows.push_back(below("2 M triangles: redo, median of 200", median(redo), "ms", kUndoMs, note));
    return rows;
}

}  // namespace flg::bench
