// SPDX-License-Identifier: MIT
#include "gallery/forms.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "filigree/filigree_io.h"

namespace flg::gallery {

filigree::Surface surface_of(Workshop& workshop, const scenes::Mesh& mesh, float weld_distance) {
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    desc.mesh.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    desc.mesh.columns = &column;
    desc.mesh.column_count = 1;
    desc.mesh.triangles = mesh.triangles[0].data();
    desc.weld_distance = weld_distance;
    return workshop.finished(workshop.context().surface(desc));
}

filigree::Surface cat(Workshop& workshop, uint32_t levels) {
    const filigree::Surface coarse = surface_of(workshop, scenes::make_figure());
    FlgRefineDesc refine = flgRefineDefaults();
    refine.surface = coarse.get();
    refine.scheme = FLG_SUBDIVISION_LOOP;
    refine.levels = levels;
    return workshop.finished(workshop.context().refine(refine));
}

filigree::Surface vase(Workshop& workshop, uint32_t columns) {
    return surface_of(workshop, scenes::make_vase(columns));
}

filigree::Surface dish(Workshop& workshop) {
    return surface_of(workshop, scenes::make_dish());
}

filigree::Surface ball(Workshop& workshop) {
    return surface_of(workshop, scenes::make_ball_mesh(), scenes::kFaceSeam);
}

filigree::Surface egg(Workshop& workshop) {
    return surface_of(workshop, scenes::make_egg(), scenes::kFaceSeam);
}

filigree::Surface cloth(Workshop& workshop) {
    return surface_of(workshop, scenes::make_cloth());
}

void write_form(const filigree::Surface& surface, const std::string& path) {
    const FlgMeshView mesh = surface.view().mesh;
    if (flgMeshFileWrite(path.c_str(), &mesh, nullptr) != FLG_OK) throw std::runtime_error(flgIoLastError());
}

void write_forms(Workshop& workshop, const std::string& folder) {
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, const filigree::Surface& surface) {
        const std::string path = folder + "/" + name + ".ply";
        write_form(surface, path);
        std::printf("wrote %s\n", path.c_str());
    };
    write("cat", cat(workshop, kFineCat));
    write("vase", vase(workshop, kFineVase));
    write("ball", ball(workshop));
    write("dish", dish(workshop));
    write("egg", egg(workshop));
}

}  // namespace flg::gallery
