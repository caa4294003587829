// SPDX-License-Identifier: MIT
// The C ABI of mesh files, translated onto this room.
#include <algorithm>
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_mesh.h"
#include "io/text/obj.h"
#include "io/text/off.h"
#include "io/text/ply.h"
#include "io/text/polygons.h"

namespace flg::io {

// What all formats' meshes are asked: extent, number of regions, and oddities.
struct MeshMeasures {
    float box_min[3] = {0, 0, 0};
    float box_max[3] = {0, 0, 0};
    uint32_t region_count = 1;
};

}  // namespace flg::io

struct FlgMeshFileT {
    flg::io::MeshData data;
    flg::io::MeshMeasures measures;
    std::vector<FlgColumn> columns;
    std::vector<FlgMeshFaceColumn> face_columns;
    std::vector<FlgMeshMaterial> materials;
    std::vector<const char*> warnings;
};

namespace flg::io {

namespace {

uint32_t count_different(const std::vector<uint32_t>& labels) {
    // Neighbours mostly share their label: only where one changes it is kept.
    std::vector<uint32_t> changes;
    for (uint32_t label : labels) {
        if (changes.empty() || changes.back() != label) changes.push_back(label);
    }
    std::sort(changes.begin(), changes.end());
    return static_cast<uint32_t>(std::unique(changes.begin(), changes.end()) - changes.begin());
}

// Adds warnings to `data` for what it finds odd.
MeshMeasures measure(MeshData& data) {
    MeshMeasures result;
    std::copy_n(data.positions.data(), 3, result.box_min);
    std::copy_n(data.positions.data(), 3, result.box_max);
    for (size_t i = 0; i < data.positions.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            result.box_min[k] = std::min(result.box_min[k], data.positions[i + k]);
            result.box_max[k] = std::max(result.box_max[k], data.positions[i + k]);
        }
    }
    if (!data.regions.empty()) result.region_count = count_different(data.regions);

    std::vector<uint8_t> used(data.vertex_count());
    Tally repeats, unused;
    for (size_t i = 0; i < data.triangles.size(); i += 3) {
        const uint32_t a = data.triangles[i], b = data.triangles[i + 1], c = data.triangles[i + 2];
        if (a == b || b == c || c == a) repeats.add(i / 3);
        used[a] = used[b] = used[c] = 1;
    }
    for (size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) unused.add(i);
    }
    data.warn(repeats, "triangle", "names a vertex twice");
    data.warn(unused, "vertex", "in no triangle");
    return result;
}

MeshData read_mesh(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".gltf" || extension == ".glb") return read_gltf_mesh(path);
    if (extension != ".ply" && extension != ".obj" && extension != ".off") {
        fail(FLG_ERROR_FORMAT, "", "is of no known format: %s is none of .ply .obj .off .gltf .glb",
             cited(extension).c_str());
    }
    const ByteBlock file = read_file(path, "");
    if (extension == ".ply") return read_ply(file.bytes());
    return extension == ".obj" ? read_obj_mesh(as_text(file.bytes())) : read_off(as_text(file.bytes()));
}

std::string write_mesh(const std::string& extension, const CheckedMesh& mesh) {
    if (extension == ".ply") return write_ply(mesh);
    if (extension == ".obj") return write_obj_mesh(mesh);
    if (extension == ".off") return write_off(mesh);
    if (extension == ".glb") return write_glb_mesh(mesh);
    fail(FLG_ERROR_FORMAT, "", "can't be written: %s is none of .ply .obj .off .glb", cited(extension).c_str());
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;

extern "C" {

FlgResult flgMeshFileRead(const char* path, FlgMeshFile* out_file) {
    if (out_file) *out_file = nullptr;
    return guarded(path ? path : "flgMeshFileRead", [&] {
        check_argument(path, "path");
        check_argument(out_file, "out_file");
        auto file = std::make_unique<FlgMeshFileT>();
        file->data = read_mesh(to_path(path));
        MeshData& data = file->data;
        split_concave_polygons(data);
        file->measures = measure(data);
        file->columns.push_back({FLG_ATTRIBUTE_POSITION, 3, data.positions.data(), 0, 0});
        for (const VertexColumn& column : data.columns) {
            file->columns.push_back({column.attribute, column.components, column.values.data(), 0, 0});
        }
        for (const FaceColumn& column : data.face_columns) {
            file->face_columns.push_back({column.name.c_str(), column.values.data()});
        }
        for (const MaterialData& material : data.materials) file->materials.push_back(material_view(material));
        for (const std::string& warning : data.warnings) file->warnings.push_back(warning.c_str());
        *out_file = file.release();
    });
}

FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view) {
    return guarded("flgMeshFileGetView", [&] {
        const uint32_t struct_size = open_out(out_view, "out_view");
        check_argument(file, "file");
        const MeshData& data = file->data;
        FlgMeshView view = {};
        view.vertex_count = static_cast<uint32_t>(data.vertex_count());
        view.triangle_count = static_cast<uint32_t>(data.triangle_count());
        view.columns = file->columns.data();
        view.column_count = static_cast<uint32_t>(file->columns.size());
        view.triangles = data.triangles.data();
        view.regions = data.regions.empty() ? nullptr : data.regions.data();
        hand_out(view, out_view, struct_size);
    });
}

FlgResult flgMeshFileGetFaceColumns(FlgMeshFile file, const FlgMeshFaceColumn** out_columns, uint32_t* out_count) {
    if (out_columns) *out_columns = nullptr;
    if (out_count) *out_count = 0;
    return guarded("flgMeshFileGetFaceColumns", [&] {
        check_argument(file, "file");
        check_argument(out_columns, "out_columns");
        check_argument(out_count, "out_count");
        if (file->face_columns.empty()) return;
        *out_columns = file->face_columns.data();
        *out_count = static_cast<uint32_t>(file->face_columns.size());
    });
}

FlgResult flgMeshFileGetMaterials(FlgMeshFile file, const FlgMeshMaterial** out_materials, uint32_t* out_count) {
    if (out_materials) *out_materials = nullptr;
    if (out_count) *out_count = 0;
    return guarded("flgMeshFileGetMaterials", [&] {
        check_argument(file, "file");
        check_argument(out_materials, "out_materials");
        check_argument(out_count, "out_count");
        if (file->materials.empty()) return;
        *out_materials = file->materials.data();
        *out_count = static_cast<uint32_t>(file->materials.size());
    });
}

FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info) {
    return guarded("flgMeshFileGetInfo", [&] {
        const uint32_t struct_size = open_out(out_info, "out_info");
        check_argument(file, "file");
        const MeshData& data = file->data;
        FlgMeshFileInfo info = {};
        info.vertex_count = static_cast<uint32_t>(data.vertex_count());
        info.triangle_count = static_cast<uint32_t>(data.triangle_count());
        info.region_count = file->measures.region_count;
        info.polygon_count = data.polygon_count;
        info.format = data.format;
        std::copy_n(file->measures.box_min, 3, info.box_min);
        std::copy_n(file->measures.box_max, 3, info.box_max);
        info.warning_count = static_cast<uint32_t>(file->warnings.size());
        info.warnings = file->warnings.data();
        hand_out(info, out_info, struct_size);
    });
}

void flgMeshFileRelease(FlgMeshFile file) {
    delete file;
}

FlgResult flgMeshWriteDescInit(FlgMeshWriteDesc* desc, uint32_t struct_size) {
    return guarded("flgMeshWriteDescInit", [&] {
        check_argument(desc, "desc");
        check_size<FlgMeshWriteDesc>(struct_size, "desc");
        std::memset(desc, 0, struct_size);
        hand_out(mesh_write_defaults(), desc, struct_size);
    });
}

FlgResult flgMeshFileWrite(const char* path, const FlgMeshView* view, const FlgMeshWriteDesc* desc) {
    return guarded(path ? path : "flgMeshFileWrite", [&] {
        check_argument(path, "path");
        const CheckedMesh mesh(view, desc);
        const std::filesystem::path target = to_path(path);
        write_file(target, write_mesh(extension_of(target), mesh));
    });
}

}  // extern "C"
