// SPDX-License-Identifier: MIT
#include "documents/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <utility>

#include "documents/failure.h"
#include "documents/progress.h"

namespace flg::cli {

namespace {

void check_io(FlgResult result) {
    if (result != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

constexpr std::string_view kPrefix = "builtin:";

// NAME and COUNT of `builtin:NAME:COUNT`; both empty of other names.
std::pair<std::string_view, std::string_view> parts_of(std::string_view name) {
    if (!name.starts_with(kPrefix)) return {};
    name.remove_prefix(kPrefix.size());
    const size_t colon = std::min(name.find(':'), name.size());
    return {name.substr(0, colon), name.substr(std::min(colon + 1, name.size()))};
}

}  // namespace

bool is_builtin_mesh(const std::string& name) {
    const std::vector<std::string>& names = scenes::mesh_names();
    return std::find(names.begin(), names.end(), parts_of(name).first) != names.end();
}

void MeshFile::make() {
    const auto [name, text] = parts_of(name_);
    uint32_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (!text.empty() && (error != std::errc() || end != text.data() + text.size()))
        throw InputError(name_ + ": '" + std::string(text) + "' is no number");
    builtin_ = std::make_unique<Builtin>();
    scenes::Mesh& mesh = builtin_->mesh;
    mesh = scenes::make_mesh(name, count);
    if (mesh.vertices.empty()) {
        std::string names;
        for (const std::string& known : scenes::mesh_names()) names += (names.empty() ? "" : ", ") + known;
        throw InputError(name_ + ": no such built-in mesh; there are " + names);
    }
    builtin_->columns[0] = {FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0};
    view_ = flgMeshViewDefaults();
    view_.columns = builtin_->columns;
    view_.column_count = 1;
    if (!mesh.normals.empty())
        builtin_->columns[view_.column_count++] = {FLG_ATTRIBUTE_NORMAL, 3, &mesh.normals[0].x, 0, 0};
    info_.format = "builtin";
    info_.region_count = 1;
    info_.polygon_count = mesh.triangles.size();
    std::fill_n(info_.box_min, 3, std::numeric_limits<float>::max());
    std::fill_n(info_.box_max, 3, std::numeric_limits<float>::lowest());
    for (const scenes::Point& p : mesh.vertices) {
        const float place[] = {p.x, p.y, p.z};
        for (size_t k = 0; k < 3; ++k) {
            info_.box_min[k] = std::min(info_.box_min[k], place[k]);
            info_.box_max[k] = std::max(info_.box_max[k], place[k]);
        }
    }
    info_.vertex_count = view_.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    info_.triangle_count = view_.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    view_.triangles = mesh.triangles[0].data();
}

MeshFile::MeshFile(const std::string& name) : name_(name) {
    say_step("reading " + name);
    if (name.starts_with(kPrefix)) {
        make();
        return;
    }
    FlgMeshFile file = nullptr;
    check_io(flgMeshFileRead(name.c_str(), nullptr, &file));
    file_.reset(file);
    view_.struct_size = sizeof view_;
    check_io(flgMeshFileGetView(file, &view_));
    info_.struct_size = sizeof info_;
    check_io(flgMeshFileGetInfo(file, &info_));
}

std::vector<FlgMeshFaceColumn> MeshFile::face_columns() const {
    std::vector<FlgMeshFaceColumn> columns(info_.face_column_count, flgMeshFaceColumnDefaults());
    for (uint32_t i = 0; i < columns.size(); ++i) check_io(flgMeshFileGetFaceColumn(file_.get(), i, &columns[i]));
    return columns;
}

std::vector<FlgMeshMaterial> MeshFile::materials() const {
    std::vector<FlgMeshMaterial> materials(info_.material_count, flgMeshMaterialDefaults());
    for (uint32_t i = 0; i < materials.size(); ++i) check_io(flgMeshFileGetMaterial(file_.get(), i, &materials[i]));
    return materials;
}

std::vector<FlgTexture> MeshFile::textures() const {
    std::vector<FlgTexture> textures(info_.texture_count, flgTextureDefaults());
    for (uint32_t i = 0; i < textures.size(); ++i) check_io(flgMeshFileGetTexture(file_.get(), i, &textures[i]));
    return textures;
}

const FlgColumn& positions_of(const FlgMeshView& mesh) {
    return *std::find_if(mesh.columns, mesh.columns + mesh.column_count,
                         [](const FlgColumn& column) { return column.attribute == FLG_ATTRIBUTE_POSITION; });
}

}  // namespace flg::cli
