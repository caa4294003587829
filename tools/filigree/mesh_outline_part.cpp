// SPDX-License-Identifier: MIT
#include "mesh_outline_part.h"

#include <filesystem>

#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/mesh_surface.h"

namespace flg::cli {

bool is_mesh_file(const std::string& path) {
    return ends_with_one_of(path, {".obj", ".ply", ".off", ".gltf", ".glb"});
}

DrawnPart read_mesh_part(Session& session, const std::string& path, const std::array<float, 3>& direction,
                         Report& report) {
    const MeshSurface surface(session, path, 0, report);
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = surface.handle();
    std::copy(direction.begin(), direction.end(), desc.direction);
    FlgOutline outline = {};
    FlgJob job = {};
    check(flgOutlineCreate(session.context(), &desc, &outline, &job), path);
    session.finish({{{job, path}}}, report);
    FlgOutlineView view = flgOutlineViewDefaults();
    check(flgOutlineGetView(session.context(), outline, &view), path);
    DrawnPart part;
    part.name = std::filesystem::path(path).stem().string();
    part.contour.points.assign(view.contour->points, view.contour->points + 2 * size_t{view.contour->point_count});
    part.contour.offsets.assign(view.contour->ring_offsets, view.contour->ring_offsets + view.contour->ring_count + 1);
    std::copy(std::begin(view.placement), std::end(view.placement), part.placement.begin());
    return part;
}

}  // namespace flg::cli
