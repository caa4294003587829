// SPDX-License-Identifier: MIT
// filigree.hpp over filigree_io, filigree_pick and brush meshes: curves written, read, picked, and made triangles of.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "filigree/filigree.hpp"

namespace {

bool files_work(const filigree::CurveSetView& view) {
    filigree::CurveFileWriteDesc desc;
    desc.all_columns = 1;
    filigree::CurveFile::write("wrapper_line.xyz", view, desc);
    const filigree::CurveFile file = filigree::CurveFile::read("wrapper_line.xyz");
    const filigree::CurveFileInfo info = file.info();
    const filigree::CurveSetView read = file.view();
    if (info.point_count != 2 || info.warnings.size() != info.warning_count || read.curve_offsets.size() != 2)
        return false;
    if (read.rows<3>(FLG_ATTRIBUTE_POSITION)[1][0] != 2) return false;
    try {
        const filigree::CurveFile none = filigree::CurveFile::read("none.xyz");
        return false;
    } catch (const filigree::Error& error) {
        return error.result() == FLG_ERROR_FILE && std::strstr(error.what(), "none.xyz");
    }
}

bool picking_works(const filigree::CurveSetView& view) {
    const filigree::PickScene scene = filigree::PickScene::create();
    scene.set_curves(7, view, 0.5f);
    scene.commit();
    const filigree::Ray rays[] = {{{1, 0, 5}, 0, {0, 0, -1}, 100}, {{1, 9, 5}, 0, {0, 0, -1}, 100}};
    filigree::Hit hits[2];
    scene.cast_rays(rays, hits);
    const float above[] = {1, 2, 0};
    const filigree::Hit nearest = scene.find_nearest(above, 10);
    try {
        scene.remove(8);
        return false;
    } catch (const filigree::Error& error) {
        return hits[0].object == 7 && hits[1].object == FLG_NO_INDEX && nearest.object == 7 && *error.what() &&
               std::strcmp(error.what(), filigree::pick_error_message()) == 0;
    }
}

// A tube of 8 sides, written into arrays of the host.
bool brush_meshes_work(const filigree::CurveSetView& view) {
    filigree::BrushMeshDesc desc;
    desc.curves = &view.get();
    desc.sides = 8;
    desc.default_radius = 0.1f;
    filigree::BrushMeshSizes sizes = filigree::brush_mesh_sizes(desc);
    std::vector<float> positions(3 * sizes.vertex_count);
    std::vector<uint32_t> indices(sizes.index_count);
    const FlgBufferColumn column = {
        FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0};
    filigree::BrushMeshOutput output;
    output.set_columns({&column, 1});
    output.vertex_capacity = sizes.vertex_count;
    output.indices = indices.data();
    output.index_capacity = indices.size();
    output.index_format = FLG_NUMBER_FORMAT_UINT32;
    filigree::BrushMeshState state;
    sizes = filigree::brush_mesh_write(desc, &state, output);
    return sizes.vertex_count >= 16 && sizes.index_count >= 48 &&
           std::abs(std::hypot(positions[1], positions[2])) < 0.11;
}

}  // namespace

int main() {
    try {
        const filigree::Context context = filigree::Context::create();
        const filigree::CurveSet line = context.curve_set_from_points({0, 0, 0, 2, 0, 0});
        const filigree::CurveSetView view = line.view();
        if (!files_work(view)) return std::fprintf(stderr, "files: %s\n", filigree::io_error_message()), 1;
        if (!picking_works(view)) return std::fprintf(stderr, "picking: %s\n", filigree::pick_error_message()), 1;
        if (!brush_meshes_work(view)) return std::fprintf(stderr, "brushes: %s\n", filigree::error_message()), 1;
        return 0;
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
