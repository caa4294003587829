// SPDX-License-Identifier: MIT
// Surfaces: made, refined, shown, released.
#include <algorithm>
#include <array>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/mesh_inputs.h"
#include "api/surface_inputs.h"
#include "surfaces/surface_jobs.h"

namespace flg {

namespace {

constexpr uint32_t max_levels = 8;
constexpr FlgMeshView no_mesh = sized<FlgMeshView>();

// Shown until there is a surface: hosts may read the counts without a look at the result.
FlgSurfaceView no_surface_view() {
    auto view = sized<FlgSurfaceView>();
    view.mesh = &no_mesh;
    return view;
}

FlgSurfaceRefineDesc default_refine_desc() {
    auto desc = sized<FlgSurfaceRefineDesc>();
    desc.levels = 1;
    return desc;
}

FlgSurfacePoint place_on_input(const FlgSurfaceProvenanceView& view, uint32_t triangle, uint32_t vertex) {
    const uint32_t source = view.triangles[triangle];
    const uint32_t* const corners = view.input_vertices + size_t{3} * source;
    const FlgSourceWeights& lies = view.weights[vertex];
    const std::array<float, 3> weights = {1 - lies.weights[0] - lies.weights[1], lies.weights[0], lies.weights[1]};
    std::array<float, 3> at = {};
    for (size_t i = 0; i < 3 && lies.vertices[i] != FLG_NO_INDEX; ++i) {
        const auto k = std::find(corners, corners + 3, lies.vertices[i]) - corners;
        if (k == 3)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "vertex is %u, which is none of triangle %u", vertex, triangle);
        at[static_cast<size_t>(k)] = weights[i];
    }
    return {source, at[1], at[2]};
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgMeshViewInit(FlgMeshView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgSurfaceDescInit(FlgSurfaceDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSurfaceDesc>());
}

FlgResult flgSurfaceViewInit(FlgSurfaceView* view, uint32_t struct_size) {
    return init(view, struct_size, no_surface_view(), "view");
}

FlgResult flgSurfaceRefineDescInit(FlgSurfaceRefineDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_refine_desc());
}

FlgResult flgSurfaceCreate(FlgContext context, const FlgSurfaceDesc* desc, FlgSurface* out_surface, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_surface, "out_surface", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSurfaceDesc read = read_struct(desc, sized<FlgSurfaceDesc>(), "desc");
        check_range(std::isfinite(read.weld_distance), "desc.weld_distance", read.weld_distance, "finite");
        Submission submission(self, read.job);
        auto input = copy_described_mesh(memory, read_struct(read.mesh, sized<FlgMeshView>(), "desc.mesh"));
        const auto surface = make_object<Surface>(memory, memory, self.memory[MemoryKind::caches]);
        surface->origin = read_origin(input->view.origin, "desc.mesh.origin");
        submission.job().strand.start(
            make_surface(submission.pace(), surface, std::move(input), read.weld_distance, read.provenance != 0));
        *out_surface = {submission.commit(self.surfaces, surface, out_job)};
    });
}

FlgResult flgSurfaceCreateFromTriangles(FlgContext context, const float* positions, uint32_t vertex_count,
                                        const uint32_t* triangles, uint32_t triangle_count, const FlgJobOptions* job,
                                        FlgSurface* out_surface, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_surface, "out_surface", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        require(positions, "positions");
        require(triangles, "triangles");
        const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions, 0, 0};
        FlgMeshView mesh = sized<FlgMeshView>();
        mesh.vertex_count = vertex_count;
        mesh.triangle_count = triangle_count;
        mesh.columns = &column;
        mesh.column_count = 1;
        mesh.triangles = triangles;
        Submission submission(self, job);
        auto input = copy_mesh(memory, mesh, [](uint32_t, const BadValue& bad) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "positions holds %g at vertex %u, %s",
                          static_cast<double>(bad.value), bad.row, bad.rule);
        });
        const auto surface = make_object<Surface>(memory, memory, self.memory[MemoryKind::caches]);
        submission.job().strand.start(
            make_surface(submission.pace(), surface, std::move(input), sized<FlgSurfaceDesc>().weld_distance, false));
        *out_surface = {submission.commit(self.surfaces, surface, out_job)};
    });
}

const FlgColumn* flgMeshViewGetColumn(const FlgMeshView* view, FlgAttribute attribute) {
    return view ? find_column(view->columns, view->column_count, attribute) : nullptr;
}

FlgResult flgSurfaceRefine(FlgContext context, const FlgSurfaceRefineDesc* desc, FlgSurface* out_surface,
                           FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_surface, "out_surface", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSurfaceRefineDesc read = read_struct(desc, default_refine_desc(), "desc");
        check_enum(read.scheme, FLG_SUBDIVISION_MIDPOINT, FLG_SUBDIVISION_LOOP, "desc.scheme", "FLG_SUBDIVISION_");
        check_range(read.levels >= 1 && read.levels <= max_levels, "desc.levels", read.levels, "1 to 8");
        Submission submission(self, read.job);
        const auto coarse = self.surfaces.get(read.surface.id, "desc.surface");
        submission.read_surface(coarse, "desc.surface");
        const auto fine = make_object<Surface>(memory, memory, self.memory[MemoryKind::caches]);
        fine->origin = coarse->origin;
        const RefineRule rule = read.scheme == FLG_SUBDIVISION_LOOP ? RefineRule::loop : RefineRule::midpoint;
        submission.job().strand.start(refine_surface(submission.pace(), coarse, fine, rule, read.levels));
        *out_surface = {submission.commit(self.surfaces, fine, out_job)};
    });
}

FlgResult flgSurfaceReportInit(FlgSurfaceReport* report, uint32_t struct_size) {
    return init(report, struct_size, sized<FlgSurfaceReport>(), "report");
}

FlgResult flgSurfaceGetReport(FlgContext context, FlgSurface surface, FlgSurfaceReport* out_report) {
    return guarded([&] {
        write_struct(out_report, sized<FlgSurfaceReport>(), "out_report");
        const Surface& self = *get_context(context).surfaces.get(surface.id, "surface");
        const FlgResult result = self.visible_result();
        if (result == FLG_OK) write_struct(out_report, self.report(), "out_report");
        return result < 0 ? set_last_error(result, self.error()) : result;
    });
}

FlgResult flgSurfaceGetView(FlgContext context, FlgSurface surface, FlgSurfaceView* out_view) {
    return show(
        out_view, "out_view", no_surface_view(),
        [&] { return get_context(context).surfaces.get(surface.id, "surface"); },
        [](const Surface& self) { return self.view(); });
}

FlgResult flgSurfaceProvenanceViewInit(FlgSurfaceProvenanceView* view, uint32_t struct_size) {
    return init(view, struct_size, sized<FlgSurfaceProvenanceView>(), "view");
}

FlgResult flgSurfaceGetProvenance(FlgContext context, FlgSurface surface, FlgSurfaceProvenanceView* out_view) {
    return show(
        out_view, "out_view", sized<FlgSurfaceProvenanceView>(),
        [&] { return get_context(context).surfaces.get(surface.id, "surface"); },
        [](const Surface& self) {
            if (!self.input_triangles) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "surface does not know what it was made of: set FlgSurfaceDesc.provenance");
            }
            return self.provenance();
        });
}

FlgResult flgSurfaceProvenanceViewGetPoint(const FlgSurfaceProvenanceView* view, uint32_t triangle, uint32_t vertex,
                                           FlgSurfacePoint* out_point) {
    return guarded([&] {
        require(out_point, "out_point") = {FLG_NO_INDEX, 0, 0};
        const FlgSurfaceProvenanceView read = read_struct(view, sized<FlgSurfaceProvenanceView>(), "view");
        check_range(triangle < read.triangle_count, "triangle", triangle, "below view.triangle_count");
        check_range(vertex < read.vertex_count, "vertex", vertex, "below view.vertex_count");
        *out_point = place_on_input(read, triangle, vertex);
    });
}

FlgResult flgSurfaceGetChanges(FlgContext context, FlgSurface surface, uint32_t since_revision, uint32_t* out_triangles,
                               uint32_t capacity, uint32_t* out_count) {
    return guarded([&] {
        require(out_count, "out_count") = 0;
        if (capacity > 0) require(out_triangles, "out_triangles");
        const Surface& self = *get_context(context).surfaces.get(surface.id, "surface");
        const FlgResult result = visible_result_now(self);
        if (result != FLG_OK) return result;
        check_range(since_revision <= self.order.revision(), "since_revision", since_revision,
                    "at most that of the surface");
        uint32_t count = 0;
        for (uint32_t t = 0; t < self.mesh().triangle_count(); ++t) {
            if (self.shape_revision(t) <= since_revision) continue;
            if (count < capacity) out_triangles[count] = t;
            ++count;
        }
        *out_count = count;
        return FLG_OK;
    });
}

FlgResult flgSurfaceRelease(FlgContext context, FlgSurface surface) {
    return release(context, &Context::surfaces, surface, "surface");
}

}  // extern "C"
