// SPDX-License-Identifier: MIT
#include "surfaces/surface_jobs.h"

#include <algorithm>

#include "runtime/each.h"
namespace flg {

namespace {

// The last that the jobs do.
Task<void> measure(Pace& pace, Surface& surface) {
    const Mesh& mesh = surface.mesh();
    surface.extent = co_await measure_extent(pace, mesh);
    surface.shaped_at = GrowingBuffer<uint32_t>(mesh.triangles.size(), pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) { surface.shaped_at[t] = 0; });
    surface.write_report();
}

// The input's columns beside the position, for the vertices as they are now.
Task<void> carry_columns(Pace& pace, Surface& surface, const MeshInput& input) {
    const GrowingBuffer<uint32_t>& to_input = surface.repaired.vertices.to_input;
    const uint32_t count = surface.mesh().vertex_count();
    for (const FlgColumn& column : input.columns) {
        if (column.attribute == FLG_ATTRIBUTE_POSITION) continue;
        const uint32_t components = column.components;
        MeshColumn carried{components, GrowingBuffer<float>(size_t{count} * components, pace.memory())};
        co_await each(pace, count, Cost::some_ns, [&](uint32_t v) {
            const size_t from = to_input.size() == 0 ? v : to_input[v];
            std::copy_n(column.data + from * components, components, carried.values.data() + size_t{v} * components);
        });
        surface.columns.push_back(std::move(carried));
        surface.attributes.push_back(column.attribute);
    }
}

}  // namespace

Task<void> make_surface(Pace& pace, std::shared_ptr<Surface> surface, std::shared_ptr<MeshInput> input,
                        float weld_distance) {
    const RepairOptions options{.weld_distance = weld_distance < 0 ? std::nullopt : std::optional(weld_distance)};
    co_await repair_mesh(pace, input->view, options, surface->repaired);
    surface->repaired.triangles = {};
    pace.stage("columns");
    co_await carry_columns(pace, *surface, *input);
    co_await measure(pace, *surface);
}

Task<void> refine_surface(Pace& pace, std::shared_ptr<const Surface> coarse, std::shared_ptr<Surface> fine,
                          RefineRule rule, uint32_t levels) {
    pace.stage("copy");
    Mesh& mesh = fine->mesh();
    const Mesh& from = coarse->mesh();
    mesh.positions = co_await copy_values(pace, from.positions);
    mesh.triangles = co_await copy_values(pace, from.triangles);
    mesh.neighbours = co_await copy_values(pace, from.neighbours);
    mesh.regions = co_await copy_values(pace, from.regions);
    mesh.corner_of_vertex = co_await copy_values(pace, from.corner_of_vertex);
    for (size_t c = 0; c < coarse->columns.size(); ++c) {
        const MeshColumn& column = coarse->columns[c];
        GrowingBuffer<float> values = co_await copy_values(pace, column.values);
        fine->columns.push_back({column.components, std::move(values)});
        fine->attributes.push_back(coarse->attributes[c]);
    }
    pace.stage("refine");
    co_await refine_mesh(pace, mesh, fine->columns, rule, levels);
    pace.stage("measure");
    fine->repaired.report.topology = co_await find_topology(pace, mesh);
    co_await measure(pace, *fine);
}

}  // namespace flg
