// SPDX-License-Identifier: MIT
#include "surfaces/surface.h"

#include <algorithm>

namespace flg {

// ---- order -------------------------------------------------------------------------------------------------------

void SurfaceOrder::forget_published(Jobs& jobs) {
    std::erase_if(jobs, [](const auto& listed) {
        const auto job = listed.lock();
        return !job || job->status.state == FLG_JOB_STATE_FINISHED;
    });
}

void SurfaceOrder::add_prerequisites(bool changes, std::pmr::vector<Prerequisite>& prerequisites) {
    forget_published(changes_);
    forget_published(readers_);
    for (const auto& change : changes_) prerequisites.push_back({change.lock(), true});
    for (const auto& reader : readers_) {
        if (changes) prerequisites.push_back({reader.lock(), true});
    }
    Jobs& own = changes ? changes_ : readers_;
    if (own.size() == own.capacity()) own.reserve(std::max(size_t{8}, 2 * own.size()));
}

void SurfaceOrder::enter(const std::shared_ptr<Job>& job, bool changes) noexcept {
    (changes ? changes_ : readers_).push_back(job);
    if (!changes) return;
    ++revision_;
    ++pending_changes_;
}

// ---- what the host sees --------------------------------------------------------------------------------------------

void Surface::write_report() {
    const MeshReport& found = repaired.report;
    report_ = {.struct_size = sizeof report_,
               .welded_vertices = found.welded_vertices,
               .unused_vertices = found.unused_vertices,
               .degenerate_triangles = found.degenerate_triangles,
               .duplicate_triangles = found.duplicate_triangles,
               .flipped_triangles = found.flipped_triangles,
               .crowded_edges = found.crowded_edges,
               .cut_edges = found.cut_edges,
               .split_vertices = found.split_vertices,
               .flat_triangles = found.flat_triangles,
               .vertex_count = mesh().vertex_count(),
               .triangle_count = mesh().triangle_count(),
               .component_count = found.topology.components,
               .border_count = found.topology.border_loops,
               .border_edges = found.topology.border_edges,
               .genus = found.topology.genus,
               .euler_number = found.topology.euler_number,
               .area = extent.area,
               .box_min = {},
               .box_max = {},
               .vertex_of_input = repaired.vertices.of_input.data(),
               .input_vertex_count = repaired.vertices.is_identity()
                                         ? mesh().vertex_count()
                                         : static_cast<uint32_t>(repaired.vertices.of_input.size()),
               .reserved = 0,
               .origin = {}};
    write_origin(origin, report_.origin);
    store_vec3(extent.lower, report_.box_min);
    store_vec3(extent.upper, report_.box_max);
}

void Surface::warn(const Host& host) const noexcept {
    host.warn("surface", handle, "was repaired",
              {{report_.welded_vertices, "vertices welded"},
               {report_.unused_vertices, "unused vertices dropped"},
               {report_.degenerate_triangles, "degenerate triangles dropped"},
               {report_.duplicate_triangles, "duplicate triangles dropped"},
               {report_.flipped_triangles, "triangles flipped"},
               {report_.crowded_edges, "crowded edges parted"},
               {report_.cut_edges, "edges cut"},
               {report_.split_vertices, "vertices split"}});
}

void Surface::show_if_at_rest() noexcept {
    if (order.is_changing() || visible_result() != FLG_OK) return;
    const Mesh& shown = mesh();
    const auto column_count = static_cast<uint32_t>(attributes.size() + 1);
    view_columns_[0] = {FLG_ATTRIBUTE_POSITION, 3, shown.positions.data()->data(), 0, 0};
    for (uint32_t c = 1; c < column_count; ++c) {
        const MeshColumn& column = columns[c - 1];
        view_columns_[c] = {attributes[c - 1], column.components, column.values.data(), 0, 0};
    }
    view_mesh_ = {.struct_size = sizeof view_mesh_,
                  .vertex_count = shown.vertex_count(),
                  .triangle_count = shown.triangle_count(),
                  .column_count = column_count,
                  .columns = view_columns_,
                  .triangles = shown.triangles.data()->data(),
                  .regions = shown.regions.data(),
                  .origin = {}};
    write_origin(origin, view_mesh_.origin);
    view_ = {.struct_size = sizeof view_,
             .revision = order.revision(),
             .mesh = &view_mesh_,
             .neighbours = shown.neighbours.data()->data()};
    if (!input_triangles) return;
    provenance_ = {.struct_size = sizeof provenance_,
                   .revision = order.revision(),
                   .vertex_count = shown.vertex_count(),
                   .triangle_count = shown.triangle_count(),
                   .input_triangle_count = static_cast<uint32_t>(input_triangles->size()),
                   .reserved = 0,
                   .triangles = shown.source_triangles.data(),
                   .input_vertices = input_triangles->data()->data(),
                   .weights = reinterpret_cast<const FlgSourceWeights*>(columns.back().values.data())};
}

}  // namespace flg
