// SPDX-License-Identifier: MIT
// Manifolds of meshes, clouds of points and grids, which jobs make.
#include "api/manifolds.h"

#include <cmath>

#include "api/descriptors.h"
#include "api/surface_inputs.h"
#include "splines/manifold_jobs.h"

namespace flg {

namespace {

FlgManifoldFromPointsDesc default_cloud_desc() {
    auto desc = sized<FlgManifoldFromPointsDesc>();
    desc.neighbours = 16;
    return desc;
}

FlgManifoldFromGridDesc default_grid_desc() {
    auto desc = sized<FlgManifoldFromGridDesc>();
    desc.spacing = 1;
    return desc;
}

GridInput read_grid(const FlgManifoldFromGridDesc& desc) {
    GridInput input;
    uint64_t all = 1;
    for (uint32_t c = 0; c < 3; ++c) {
        check_range(desc.counts[c] >= 2 && desc.counts[c] <= 65536, "desc.counts", desc.counts[c], "2 to 65536 each");
        check_range(std::abs(desc.corner[c]) <= 1e30, "desc.corner", desc.corner[c], "finite and at most 1e30 in size");
        input.counts[c] = desc.counts[c];
        input.origin[c] = desc.corner[c];
        all = std::min(all * desc.counts[c], uint64_t{1} << 40);
    }
    check_range(all <= uint64_t{1} << 31, "the product of desc.counts", static_cast<double>(all), "at most 2^31");
    check_length(desc.spacing, "desc.spacing");
    input.spacing = desc.spacing;
    return input;
}

void check_smoothing_scale(double scale) {
    check_range(scale >= 0 && std::isfinite(scale), "desc.smoothing_scale", scale, "0 or above, in metres");
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgManifoldFromSurfaceDescInit(FlgManifoldFromSurfaceDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgManifoldFromSurfaceDesc>());
}

FlgResult flgManifoldCreateFromSurface(FlgContext context, const FlgManifoldFromSurfaceDesc* desc,
                                       FlgManifold* out_manifold, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_manifold, "out_manifold", out_job);
        const FlgManifoldFromSurfaceDesc read = read_struct(desc, sized<FlgManifoldFromSurfaceDesc>(), "desc");
        check_smoothing_scale(read.smoothing_scale);
        Submission submission(self, read.job);
        const auto held = self.make(self.manifolds);
        held->kind = ManifoldKind::hypersurface;
        held->surface = self.surfaces.get(read.surface.id, "desc.surface");
        submission.read_surface(held->surface, "desc.surface");
        held->origin = held->surface->origin;
        // For the first curves of splines, which so need not wait.
        start_blocks(self, held->surface);
        submission.job().strand.start(make_mesh_manifold(submission.pace(), read.smoothing_scale, held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
    });
}

FlgResult flgManifoldFromPointsDescInit(FlgManifoldFromPointsDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_cloud_desc());
}

FlgResult flgManifoldCreateFromPoints(FlgContext context, const FlgManifoldFromPointsDesc* desc,
                                      FlgManifold* out_manifold, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_manifold, "out_manifold", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgManifoldFromPointsDesc read = read_struct(desc, default_cloud_desc(), "desc");
        check_range(read.point_count >= 4 && read.point_count <= 1u << 24, "desc.point_count", read.point_count,
                    "4 to 2^24");
        check_range(read.neighbours >= 6 && read.neighbours <= 32, "desc.neighbours", read.neighbours, "6 to 32");
        check_smoothing_scale(read.smoothing_scale);
        require(read.points, "desc.points");
        Submission submission(self, read.job);
        Buffer<Position> points = read_positions(read.points, read.point_count, "desc.points", memory), normals;
        if (read.normals) normals = read_positions(read.normals, read.point_count, "desc.normals", memory);
        const auto held = self.make(self.manifolds);
        held->kind = ManifoldKind::hypersurface;
        held->origin = read_origin(read.origin, "desc.origin");
        submission.job().strand.start(
            make_cloud_manifold(submission.pace(), std::move(points), std::move(normals), read, held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
    });
}

FlgResult flgManifoldFromGridDescInit(FlgManifoldFromGridDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_grid_desc());
}

FlgResult flgManifoldCreateFromGrid(FlgContext context, const FlgManifoldFromGridDesc* desc, FlgManifold* out_manifold,
                                    FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_manifold, "out_manifold", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgManifoldFromGridDesc read = read_struct(desc, default_grid_desc(), "desc");
        const GridInput input = read_grid(read);
        require(read.values, "desc.values");
        Submission submission(self, read.job);
        Buffer<float> values(size_t{input.counts[0]} * input.counts[1] * input.counts[2], memory);
        for (size_t i = 0; i < values.size(); ++i) {
            check_range(is_coordinate(read.values[i]), "a value in desc.values", read.values[i],
                        "finite and at most 1e30 in size");
            values[i] = read.values[i];
        }
        const auto held = self.make(self.manifolds);
        held->kind = ManifoldKind::hypersurface;
        held->origin = read_origin(read.origin, "desc.origin");
        submission.job().strand.start(make_grid_manifold(submission.pace(), std::move(values), input, held));
        *out_manifold = {submission.commit(self.manifolds, held, out_job)};
    });
}

}  // extern "C"
