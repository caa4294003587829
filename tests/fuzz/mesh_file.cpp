// SPDX-License-Identifier: MIT
// Files of meshes, of the format FLG_EXTENSION: refused, or a mesh as views promise it; what is written as .ply is read
// as the same bits.
#include <cmath>
#include <cstring>

#include "filigree/filigree_io.h"
#include "fuzz/fuzz.h"

namespace {

using flg::fuzz::InputFile;

void demand_sound(const FlgMeshView& view) {
    FLG_DEMAND(view.triangle_count > 0 && view.columns[0].attribute == FLG_ATTRIBUTE_POSITION);
    for (size_t i = 0; i < size_t{3} * view.triangle_count; ++i) FLG_DEMAND(view.triangles[i] < view.vertex_count);
    for (uint32_t k = 0; k < view.column_count; ++k) {
        const FlgColumn& column = view.columns[k];
        const size_t count = size_t{view.vertex_count} * column.components;
        for (size_t i = 0; i < count; ++i) FLG_DEMAND(std::isfinite(column.data[i]));
    }
}

void demand_same_when_written(const FlgMeshView& view) {
    static const InputFile copy(".copy.ply");
    const char* const path = copy.holding(nullptr, 0);
    FLG_DEMAND(flgMeshFileWrite(path, &view, nullptr) == FLG_OK);
    FlgMeshFile again = nullptr;
    FlgMeshView same = view;
    FLG_DEMAND(flgMeshFileRead(path, nullptr, &again) == FLG_OK && flgMeshFileGetView(again, &same) == FLG_OK);
    FLG_DEMAND(same.vertex_count == view.vertex_count && same.triangle_count == view.triangle_count);
    FLG_DEMAND(std::memcmp(same.columns[0].data, view.columns[0].data, size_t{3} * view.vertex_count * sizeof(float)) ==
               0);
    FLG_DEMAND(std::memcmp(same.triangles, view.triangles, size_t{3} * view.triangle_count * sizeof(uint32_t)) == 0);
    flgMeshFileRelease(again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const InputFile input(FLG_EXTENSION);
    FlgMeshFile file = nullptr;
    const FlgResult result = flgMeshFileRead(input.holding(data, size), nullptr, &file);
    if (result != FLG_OK) {
        FLG_DEMAND(file == nullptr);
        flg::fuzz::demand_refusal(result, flgIoErrorGetMessage());
        return 0;
    }
    FlgMeshView view = {};
    view.struct_size = sizeof view;
    FlgMeshFileInfo info = {};
    info.struct_size = sizeof info;
    FLG_DEMAND(flgMeshFileGetView(file, &view) == FLG_OK && flgMeshFileGetInfo(file, &info) == FLG_OK);
    for (uint32_t i = 0; i < info.warning_count; ++i) FLG_DEMAND(std::strlen(info.warnings[i]) > 0);
    for (uint32_t i = 0; i < info.material_count; ++i) {
        FlgMeshMaterial material = flgMeshMaterialDefaults();
        FLG_DEMAND(flgMeshFileGetMaterial(file, i, &material) == FLG_OK);
        FLG_DEMAND(material.metallic >= 0 && material.metallic <= 1);
    }
    for (uint32_t i = 0; i < info.face_column_count; ++i) {
        FlgMeshFaceColumn column = flgMeshFaceColumnDefaults();
        FLG_DEMAND(flgMeshFileGetFaceColumn(file, i, &column) == FLG_OK && column.values);
    }
    demand_sound(view);
    demand_same_when_written(view);
    flgMeshFileRelease(file);
    return 0;
}
