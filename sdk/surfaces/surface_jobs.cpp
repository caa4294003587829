// SPDX-License-Identifier: MIT
#include "surfaces/surface_jobs.h"

#include <algorithm>

#include "runtime/each.h"
#include "surfaces/mesh/source_weights.h"

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

// Triangles and vertices lie where they came from.
Task<void> begin_provenance(Pace& pace, Surface& surface, const MeshInput& input) {
    const IndexMap &vertices = surface.repaired.vertices, &triangles = surface.repaired.triangles;
    Mesh& mesh = surface.mesh();
    // Of those that were welded, the one that was kept.
    const auto kept = [&](uint32_t v) {
        if (vertices.is_identity() || vertices.of_input[v] == no_index) return v;
        return vertices.to_input[vertices.of_input[v]];
    };
    const auto corners = std::allocate_shared<Buffer<Triple>>(std::pmr::polymorphic_allocator<>(pace.memory()),
                                                              input.view.triangle_count, pace.memory());
    co_await each(pace, corners->size(), Cost::some_ns, [&](uint32_t t) {
        for (uint32_t k = 0; k < 3; ++k) (*corners)[t][k] = kept(input.triangles[size_t{3} * t + k]);
    });
    surface.input_triangles = corners;
    mesh.source_triangles = GrowingBuffer<uint32_t>(mesh.triangles.size(), pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::some_ns,
                  [&](uint32_t t) { mesh.source_triangles[t] = triangles.is_identity() ? t : triangles.to_input[t]; });
    constexpr uint32_t words = sizeof(SourceWeights) / sizeof(float);
    MeshColumn column{words, GrowingBuffer<float>(words * mesh.positions.size(), pace.memory()), true};
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        store({{vertices.is_identity() ? v : vertices.to_input[v], no_index, no_index}, {}}, column, v);
    });
    surface.columns.push_back(std::move(column));
}

}  // namespace

Task<void> make_surface(Pace& pace, std::shared_ptr<Surface> surface, std::shared_ptr<MeshInput> input,
                        float weld_distance, bool with_provenance) {
    const RepairOptions options{.weld_distance = weld_distance < 0 ? std::nullopt : std::optional(weld_distance)};
    co_await repair_mesh(pace, input->view, options, surface->repaired);
    pace.stage("columns");
    co_await carry_columns(pace, *surface, *input);
    if (with_provenance) co_await begin_provenance(pace, *surface, *input);
    surface->repaired.triangles = {};
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
    mesh.source_triangles = co_await copy_values(pace, from.source_triangles);
    mesh.corner_of_vertex = co_await copy_values(pace, from.corner_of_vertex);
    for (size_t c = 0; c < coarse->columns.size(); ++c) {
        const MeshColumn& column = coarse->columns[c];
        GrowingBuffer<float> values = co_await copy_values(pace, column.values);
        fine->columns.push_back({column.components, std::move(values), column.of_sources});
    }
    fine->attributes = coarse->attributes;
    fine->input_triangles = coarse->input_triangles;
    pace.stage("refine");
    co_await refine_mesh(pace, mesh, fine->columns, rule, levels);
    pace.stage("measure");
    fine->repaired.report.topology = co_await find_topology(pace, mesh);
    co_await measure(pace, *fine);
}

}  // namespace flg
