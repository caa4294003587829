// SPDX-License-Identifier: MIT
#include "surfaces/surface_jobs.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t measure_chunk = 1000;  // vertices or triangles, about 10 us
constexpr uint32_t copy_chunk = 4000;     // elements, about 10 us

// The last that the jobs do.
Task<void> measure(Pace& pace, Surface& surface) {
    ExtentKernel extent(surface.mesh());
    while (!extent.run(measure_chunk)) co_await pace;
    surface.extent = extent.extent();
    surface.shaped_at = GrowingBuffer<uint32_t>(surface.mesh().triangles.size(), pace.memory());
    for (uint32_t t = 0; t < surface.mesh().triangle_count(); ++t) {
        surface.shaped_at[t] = 0;
        if (t % copy_chunk == 0) co_await pace;
    }
    surface.write_report();
}

// The input's columns beside the position, for the vertices as they are now.
Task<void> carry_columns(Pace& pace, Surface& surface, const MeshInput& input) {
    const GrowingBuffer<uint32_t>& to_input = surface.repaired.vertices.to_input;
    const uint32_t count = surface.mesh().vertex_count();
    for (size_t c = 0; c < input.columns.size(); ++c) {
        const FlgColumn& column = input.columns[c];
        if (column.attribute == FLG_ATTRIBUTE_POSITION) continue;
        MeshColumn carried{column.components, GrowingBuffer<float>(size_t{count} * column.components, pace.memory())};
        for (uint32_t v = 0; v < count; ++v) {
            const size_t from = to_input.size() == 0 ? v : to_input[v];
            std::copy_n(column.data + from * column.components, column.components,
                        carried.values.data() + size_t{v} * column.components);
            if (v % copy_chunk == 0) co_await pace;
        }
        surface.columns.push_back(std::move(carried));
        surface.attributes.push_back(column.attribute);
    }
}

template <class T>
Task<void> copy(Pace& pace, const GrowingBuffer<T>& from, GrowingBuffer<T>& to) {
    to = GrowingBuffer<T>(from.size(), pace.memory());
    for (size_t i = 0; i < from.size(); i += copy_chunk) {
        std::copy_n(from.data() + i, std::min<size_t>(copy_chunk, from.size() - i), to.data() + i);
        co_await pace;
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
    co_await copy(pace, coarse->mesh().positions, mesh.positions);
    co_await copy(pace, coarse->mesh().triangles, mesh.triangles);
    co_await copy(pace, coarse->mesh().neighbours, mesh.neighbours);
    co_await copy(pace, coarse->mesh().regions, mesh.regions);
    co_await copy(pace, coarse->mesh().corner_of_vertex, mesh.corner_of_vertex);
    for (size_t c = 0; c < coarse->columns.size(); ++c) {
        fine->columns.push_back({coarse->columns[c].components, {}});
        co_await copy(pace, coarse->columns[c].values, fine->columns.back().values);
        fine->attributes.push_back(coarse->attributes[c]);
    }
    pace.stage("refine");
    co_await refine_mesh(pace, mesh, fine->columns, rule, levels);
    pace.stage("measure");
    TopologyKernel topology(mesh, pace.memory());
    while (!topology.run(measure_chunk)) co_await pace;
    fine->repaired.report.topology = topology.topology();
    co_await measure(pace, *fine);
}

}  // namespace flg
