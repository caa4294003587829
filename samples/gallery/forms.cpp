// SPDX-License-Identifier: MIT
#include "gallery/forms.h"

namespace flg::gallery {

filigree::Surface surface_of(Workshop& workshop, const scenes::Mesh& mesh, float weld_distance) {
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgMeshView input = flgMeshViewDefaults();
    input.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    input.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    input.columns = &column;
    input.column_count = 1;
    input.triangles = mesh.triangles[0].data();
    desc.mesh = &input;
    desc.weld_distance = weld_distance;
    return workshop.finished(workshop.context().surface(desc));
}

filigree::Surface cat(Workshop& workshop, uint32_t levels) {
    const filigree::Surface coarse = surface_of(workshop, scenes::make_figure());
    filigree::SurfaceRefineDesc refine;
    refine.scheme = FLG_SUBDIVISION_LOOP;
    refine.levels = levels;
    return workshop.finished(coarse.refine(refine));
}

}  // namespace flg::gallery
