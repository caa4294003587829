// SPDX-License-Identifier: MIT
// Ornament as maps: what drawing 100 regions of a torus into its texture coordinates costs, and its longest slice.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree/filigree_bake.h"

namespace flg::bench {
namespace {

constexpr uint32_t triangles = 278'000, regions = 100, map_size = 2048, runs = 5;
constexpr double bake_ms = 400, slice_us = 100;

uint64_t busy_ns(void*) {
    return static_cast<uint64_t>(thread_ms() * 1e6);
}

// Cut open along two circles: its coordinates are the square's.
struct Torus {
    std::vector<float> positions, uvs;
    std::vector<uint32_t> corners;
};

Torus unwrapped_torus() {
    const auto rings = static_cast<uint32_t>(std::lround(std::sqrt(triangles / 4.0))), around = 2 * rings;
    const double pi = std::acos(-1.0);
    Torus torus;
    for (uint32_t j = 0; j < rings; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            const double u = 2 * pi * i / around, v = 2 * pi * j / rings, out = 1 + 0.4 * std::cos(v);
            for (const double value : {out * std::cos(u), out * std::sin(u), 0.4 * std::sin(v)})
                torus.positions.push_back(static_cast<float>(value));
        }
    }
    const auto add = [&](uint32_t i, uint32_t j) {
        torus.corners.push_back(j % rings * around + i % around);
        torus.uvs.push_back(static_cast<float>(i) / static_cast<float>(around));
        torus.uvs.push_back(static_cast<float>(j) / static_cast<float>(rings));
    };
    for (uint32_t j = 0; j < rings; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            add(i, j), add(i + 1, j), add(i + 1, j + 1);
            add(i, j), add(i + 1, j + 1), add(i, j + 1);
        }
    }
    return torus;
}

}  // namespace

std::vector<Row> run_baking() {
    Host host(flgAllocatorDefaults(), {sizeof(FlgClock), nullptr, busy_ns});
    const Torus torus = unwrapped_torus();
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, torus.positions.data(), 0, 0};
    FlgMeshView mesh = flgMeshViewDefaults();
    mesh.vertex_count = static_cast<uint32_t>(torus.positions.size() / 3);
    mesh.triangle_count = static_cast<uint32_t>(torus.corners.size() / 3);
    mesh.columns = &column;
    mesh.column_count = 1;
    mesh.triangles = torus.corners.data();
    FlgSurfaceDesc made = flgSurfaceDefaults();
    made.mesh = &mesh;
    made.provenance = 1;
    FlgSurface surface{};
    FlgTangle tangle{};
    check(flgSurfaceCreate(host.context(), &made, &surface, nullptr));
    check(flgTangleCreate(host.context(), surface, nullptr, &tangle, nullptr));
    FlgTangleSeeds samples = flgTangleSeedsDefaults();
    samples.sample_radius = 0.01f;
    samples.sample_count = regions;
    const uint32_t root = 0;
    FlgTangleDivideDesc divide = flgTangleDivideDefaults();
    divide.tangle = tangle;
    divide.kind = FLG_TANGLE_OPERATOR_VORONOI;
    divide.regions = &root;
    divide.region_count = 1;
    divide.a = &samples;
    divide.delta = 1;
    check(flgTangleDivide(host.context(), &divide, nullptr));
    host.run();

    constexpr size_t texels = size_t{map_size} * map_size;
    std::vector<uint32_t> ids(texels);
    std::vector<float> distances(texels);
    std::vector<uint8_t> borders(texels);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = map_size;
    desc.tangle = tangle;
    desc.mesh = &mesh;
    desc.corner_uvs = torus.uvs.data();
    desc.ids = ids.data();
    desc.distances = distances.data();
    desc.borders = borders.data();
    std::vector<double> times, slices;
    std::string longest;
    for (uint32_t i = 0; i < runs; ++i) {
        FlgJob job{};
        check(flgTangleBake(host.context(), &desc, &job));
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        check(flgContextTick(host.context(), FLG_UNLIMITED, &report));
        host.check_done(job);
        FlgJobStatus status = flgJobStatusDefaults();
        check(flgJobGetStatus(host.context(), job, &status));
        times.push_back(status.busy_us * 1e-3);
        if (slices.empty() || double{report.max_slice_us} <= *std::min_element(slices.begin(), slices.end()))
            longest = report.max_slice_stage;
        slices.push_back(double{report.max_slice_us});
    }
    char note[160];
    std::snprintf(note, sizeof note, "ids, distances, borders; %u triangles", mesh.triangle_count);
    const double slice = *std::min_element(slices.begin(), slices.end());
    return {below("100 regions baked at 2048 x 2048, median of 5", median(times), "ms", bake_ms, note),
            below("its longest slice, least of 5", slice, "us", slice_us, longest)};
}

}  // namespace flg::bench
