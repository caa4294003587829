// SPDX-License-Identifier: MIT
// A surface made of a mesh file, repaired where it had to be.
#pragma once

#include "documents/mesh_file.h"
#include "documents/report.h"
#include "documents/session.h"

namespace flg::cli {

class MeshSurface {
public:
    // Reads the file and makes its surface, which lives as long as the session's context. Its sizes and repairs go into
    // the report's counts and quality. `with_provenance`: it can be written into the asset that the file is. Throws
    // InputError.
    MeshSurface(Session& session, const std::string& file, float weld_distance, Report& report,
                bool with_provenance = false);

    const std::string& name() const { return file_.name(); }
    const MeshFile& file() const { return file_; }
    FlgSurface handle() const { return surface_; }
    // As it was made.
    const FlgSurfaceReport& report() const { return report_; }
    // Its arrays, until the next change.
    FlgSurfaceView view() const;
    FlgSurfaceProvenanceView provenance() const;
    // What was wrong with the file, as `flipped triangles 2, ...`; empty: nothing.
    std::string defects() const;
    // Says that the surface isn't quite the file's, if so.
    void warn_of_repairs(Report& report) const;
    // Where a vertex of the file is; FLG_NO_INDEX if it was dropped.
    uint32_t vertex_of_input(uint32_t vertex) const {
        return report_.vertex_of_input == nullptr ? vertex : report_.vertex_of_input[vertex];
    }

private:
    FlgContext context_;
    MeshFile file_;
    bool has_provenance_;
    FlgSurface surface_ = {};
    FlgSurfaceReport report_ = {};
};

FlgSurfaceView view_of(FlgContext context, FlgSurface surface);

enum class Regions { kept, needed };

// Refuses files that meshes, with regions if these are needed, aren't written to, before any work is done. Throws
// UsageError, InputError.
void require_mesh_output(const std::string& path, Regions regions);

// Writes the .gltf or .glb file of a surface, made with its provenance, with the surface's triangles in place of its
// own; by `labels` with these materials, with the asset's from their number on. Throws InputError.
void write_asset(const std::string& path, const MeshSurface& surface, const std::vector<uint32_t>& labels,
                 std::span<const FlgMeshMaterial> materials);

// Writes a mesh by its extension; .glb with these materials, by region. Throws InputError.
void write_mesh(const std::string& path, const FlgMeshView& mesh, std::span<const FlgMeshMaterial> materials = {});

}  // namespace flg::cli
