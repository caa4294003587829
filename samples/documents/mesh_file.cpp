// SPDX-License-Identifier: MIT
#include "documents/mesh_file.h"

#include <algorithm>

#include "documents/failure.h"
#include "documents/progress.h"

namespace flg::cli {

namespace {

void check_io(FlgResult result) {
    if (result != FLG_OK) throw InputError(flgIoLastError());
}

}  // namespace

MeshFile::MeshFile(const std::string& name) : name_(name) {
    say_step("reading " + name);
    FlgMeshFile file = nullptr;
    check_io(flgMeshFileRead(name.c_str(), &file));
    file_.reset(file);
    view_.struct_size = sizeof view_;
    check_io(flgMeshFileGetView(file, &view_));
    info_.struct_size = sizeof info_;
    check_io(flgMeshFileGetInfo(file, &info_));
}

std::vector<FlgMeshFaceColumn> MeshFile::face_columns() const {
    const FlgMeshFaceColumn* columns = nullptr;
    uint32_t count = 0;
    check_io(flgMeshFileGetFaceColumns(file_.get(), &columns, &count));
    return {columns, columns + count};
}

std::vector<FlgMeshMaterial> MeshFile::materials() const {
    const FlgMeshMaterial* materials = nullptr;
    uint32_t count = 0;
    check_io(flgMeshFileGetMaterials(file_.get(), &materials, &count));
    return {materials, materials + count};
}

const FlgColumn& positions_of(const FlgMeshView& mesh) {
    return *std::find_if(mesh.columns, mesh.columns + mesh.column_count,
                         [](const FlgColumn& column) { return column.attribute == FLG_ATTRIBUTE_POSITION; });
}

}  // namespace flg::cli
