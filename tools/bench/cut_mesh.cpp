// SPDX-License-Identifier: MIT
#include "bench/cut_mesh.h"

#include <algorithm>
#include <string>

#include "bench/bench.h"

namespace flg::bench {

namespace {

double stage_ms(Host& host, FlgJob job, const std::string& name) {
    FlgStageTime stages[16];
    uint32_t count = 0;
    check(flgJobGetStages(host.context(), job, stages, 16, &count));
    for (uint32_t i = 0; i < count; ++i) {
        if (stages[i].name == name) return stages[i].busy_us * 1e-3;
    }
    return 0;
}

// Processor time of this thread, so that stages are what they cost whatever else the machine does.
uint64_t processor_ns(void*) {
    return static_cast<uint64_t>(thread_ms() * 1e6);
}

}  // namespace

CutMesh::CutMesh(uint32_t triangle_count)
    : host_(pool_.hooks(), FlgClock{sizeof(FlgClock), nullptr, processor_ns}), mesh_(bumpy_torus(triangle_count)) {
    reset();
}

void CutMesh::reset() {
    if (surface_.id != 0) check(flgSurfaceRelease(host_.context(), surface_));
    FlgColumn column;
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView input = mesh_.view(column);
    desc.mesh = &input;
    FlgJob job = {};
    check(flgSurfaceCreate(host_.context(), &desc, &surface_, &job));
    host_.run();
    host_.check_done(job);
}

FlgField CutMesh::measure() {
    const uint32_t source = 0;
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    desc.surface = surface_;
    desc.vertices = &source;
    desc.vertex_count = 1;
    FlgField field = {};
    FlgJob job = {};
    check(flgFieldCreateGeodesic(host_.context(), &desc, &field, &job));
    host_.run();
    host_.check_done(job);
    return field;
}

CutMesh::Times CutMesh::cut_isolines(uint32_t count) {
    const FlgField field = measure();
    FlgFieldView values = flgFieldViewDefaults();
    check(flgFieldGetView(host_.context(), field, &values));
    const float largest = *std::max_element(values.values, values.values + values.vertex_count);
    FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
    desc.field = field;
    desc.level_count = count;
    desc.level_every = largest / static_cast<float>(count + 1);
    desc.level_first = desc.level_every;
    FlgJob job = {};
    check(flgSurfaceCutIsolines(host_.context(), &desc, nullptr, &job));
    host_.run();
    host_.check_done(job);
    FlgJobStatus status{};
    status.struct_size = sizeof status;
    check(flgJobGetStatus(host_.context(), job, &status));
    check(flgFieldRelease(host_.context(), field));
    return {stage_ms(host_, job, "cut"), stage_ms(host_, job, "update"), status.max_slice_us};
}

FlgSurfaceView CutMesh::view() {
    FlgSurfaceView view = flgSurfaceViewDefaults();
    check(flgSurfaceGetView(host_.context(), surface_, &view));
    return view;
}

std::vector<uint32_t> CutMesh::changes() {
    uint32_t count = 0;
    check(flgSurfaceGetChanges(host_.context(), surface_, 0, nullptr, 0, &count));
    std::vector<uint32_t> changed(count);
    check(flgSurfaceGetChanges(host_.context(), surface_, 0, changed.data(), count, &count));
    return changed;
}

}  // namespace flg::bench
