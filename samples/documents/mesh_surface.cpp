// SPDX-License-Identifier: MIT
#include "documents/mesh_surface.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/text_file.h"

namespace flg::cli {
namespace {

std::vector<std::pair<const char*, uint32_t>> defects_of(const FlgSurfaceReport& report) {
    return {{"welded_vertices", report.welded_vertices},
            {"unused_vertices", report.unused_vertices},
            {"degenerate_triangles", report.degenerate_triangles},
            {"duplicate_triangles", report.duplicate_triangles},
            {"flipped_triangles", report.flipped_triangles},
            {"crowded_edges", report.crowded_edges},
            {"cut_edges", report.cut_edges},
            {"split_vertices", report.split_vertices}};
}

void describe(const MeshFile& file, const FlgSurfaceReport& made, Report& report) {
    const FlgMeshFileInfo& stored = file.info();
    report.counts["input_vertices"] = stored.vertex_count;
    report.counts["input_triangles"] = stored.triangle_count;
    report.counts["input_regions"] = stored.region_count;
    report.counts["vertices"] = made.vertex_count;
    report.counts["triangles"] = made.triangle_count;
    report.counts["components"] = made.component_count;
    report.counts["borders"] = made.border_count;
    report.counts["border_edges"] = made.border_edges;
    report.counts["euler_number"] = made.euler_number;
    report.counts["genus"] = made.genus;
    report.counts["flat_triangles"] = made.flat_triangles;
    for (const auto& [what, count] : defects_of(made)) report.counts[what] = count;
    report.quality["area"] = made.area;
    const float *low = made.box_min, *high = made.box_max;
    report.quality["box"] = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace

MeshSurface::MeshSurface(Session& session, const std::string& file, float weld_distance, Report& report,
                         bool with_provenance)
    : context_(session.context()), file_(file), has_provenance_(with_provenance) {
    // What the mesh alone leaves out is written with the asset.
    const uint32_t warnings = with_provenance ? 0 : file_.info().warning_count;
    for (uint32_t i = 0; i < warnings; ++i) report.warn(file + ": " + file_.info().warnings[i]);
    FlgSurfaceDesc desc;
    flgSurfaceDescInit(&desc, sizeof desc);
    desc.mesh = &file_.view();
    desc.weld_distance = weld_distance;
    desc.provenance = with_provenance;
    FlgJob job = {};
    check(flgSurfaceCreate(context_, &desc, &surface_, &job), file);
    session.finish({{{job, file}}}, report);
    report_.struct_size = sizeof report_;
    check(flgSurfaceGetReport(context_, surface_, &report_), file);
    describe(file_, report_, report);
}

FlgSurfaceView MeshSurface::view() const {
    return view_of(context_, surface_);
}

FlgSurfaceProvenanceView MeshSurface::provenance() const {
    FlgSurfaceProvenanceView view;
    flgSurfaceProvenanceViewInit(&view, sizeof view);
    check(flgSurfaceGetProvenance(context_, surface_, &view), name());
    return view;
}

std::string MeshSurface::defects() const {
    std::string text;
    for (const auto& [what, count] : defects_of(report_)) {
        // Vertices apart at seams are no defect of an asset, and are apart again when it is written.
        if (count == 0 || (has_provenance_ && std::string_view(what) == "welded_vertices")) continue;
        std::string words = what;
        std::replace(words.begin(), words.end(), '_', ' ');
        text += (text.empty() ? "" : ", ") + words + " " + std::to_string(count);
    }
    return text;
}

void MeshSurface::warn_of_repairs(Report& report) const {
    const std::string found = defects();
    if (!found.empty()) report.warn(name() + ": was repaired first: " + found);
}

FlgSurfaceView view_of(FlgContext context, FlgSurface surface) {
    FlgSurfaceView view;
    flgSurfaceViewInit(&view, sizeof view);
    check(flgSurfaceGetView(context, surface, &view), "surface");
    return view;
}

void require_mesh_output(const std::string& path, Regions regions) {
    if (!ends_with_one_of(path, {".ply", ".obj", ".off", ".glb"})) {
        throw UsageError(path + ": meshes are written as .ply, .obj, .off or .glb");
    }
    if (regions == Regions::needed && path.ends_with(".off")) {
        throw UsageError(path + ": .off has no place for regions; .ply, .obj and .glb do");
    }
    require_writable(path);
}

void write_mesh(const std::string& path, const FlgMeshView& mesh, std::span<const FlgMeshMaterial> materials) {
    say_step("writing " + path);
    FlgMeshFileWriteDesc desc;
    flgMeshFileWriteDescInit(&desc, sizeof desc);
    desc.split_regions = mesh.regions != nullptr;
    desc.materials = materials.data();
    desc.material_count = static_cast<uint32_t>(materials.size());
    if (flgMeshFileWrite(path.c_str(), &mesh, &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

void write_asset(const std::string& path, const MeshSurface& surface, const std::vector<uint32_t>& labels,
                 std::span<const FlgMeshMaterial> materials) {
    say_step("writing " + path);
    FlgMeshView mesh = *surface.view().mesh;
    mesh.regions = labels.data();
    const FlgSurfaceProvenanceView provenance = surface.provenance();
    FlgMeshFileWriteDesc desc;
    flgMeshFileWriteDescInit(&desc, sizeof desc);
    desc.materials = materials.data();
    desc.material_count = static_cast<uint32_t>(materials.size());
    desc.asset = surface.name().c_str();
    desc.provenance = &provenance;
    if (flgMeshFileWrite(path.c_str(), &mesh, &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

}  // namespace flg::cli
