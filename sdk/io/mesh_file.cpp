// SPDX-License-Identifier: MIT
// The C ABI of mesh files, translated onto this room.
#include <algorithm>
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/box.h"
#include "io/base/checked_views.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_asset.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_mesh.h"
#include "io/text/obj.h"
#include "io/text/off.h"
#include "io/text/ply.h"
#include "io/text/polygons.h"

namespace flg::io {

// What all formats' meshes are asked: extent, number of regions, and oddities.
struct MeshMeasures {
    Box box;
    uint32_t region_count = 1;
};

}  // namespace flg::io

struct FlgMeshFileT : flg::io::HostFile {
    flg::io::MeshData data;
    flg::io::MeshMeasures measures;
    flg::io::Vector<FlgColumn> columns;
    flg::io::Vector<FlgMeshFaceColumn> face_columns;
    flg::io::Vector<FlgMeshMaterial> materials;
    flg::io::Vector<FlgTexture> textures;
    flg::io::Vector<const char*> warnings;
};

namespace flg::io {

namespace {

uint32_t count_different(const Vector<uint32_t>& labels) {
    // Neighbours mostly share their label: only where one changes it is kept.
    Vector<uint32_t> changes;
    for (uint32_t label : labels) {
        if (changes.empty() || changes.back() != label) changes.push_back(label);
    }
    std::sort(changes.begin(), changes.end());
    return static_cast<uint32_t>(std::unique(changes.begin(), changes.end()) - changes.begin());
}

// Adds warnings to `data` for what it finds odd.
MeshMeasures measure(MeshData& data) {
    MeshMeasures result;
    result.box = box_of(data.positions);
    if (!data.regions.empty()) result.region_count = count_different(data.regions);

    Vector<uint8_t> used(data.vertex_count());
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

MeshData read_from(const Path& path, const Origin& origin) {
    const String extension = path.extension();
    if (extension == ".gltf" || extension == ".glb") return read_gltf_mesh(path, origin);
    if (extension != ".ply" && extension != ".obj" && extension != ".off") {
        fail(FLG_ERROR_FORMAT, "", "is of no known format: %s is none of .ply .obj .off .gltf .glb",
             cited(extension).c_str());
    }
    const ByteBlock file = read_file(path, "");
    if (extension == ".ply") return read_ply(file.bytes(), path, origin);
    return extension == ".obj" ? read_obj_mesh(as_text(file.bytes()), path, origin)
                               : read_off(as_text(file.bytes()), origin);
}

MeshData read_mesh(const Path& path) {
    const auto visit_edges = [](const MeshData& data, const auto& visit) {
        for (size_t i = 0; i < data.triangles.size(); i += 3) {
            for (size_t k = 0; k < 3; ++k) visit(data.triangles[i + k], data.triangles[i + (k + 1) % 3]);
        }
    };
    return read_placed([&](const Origin& origin) { return read_from(path, origin); }, visit_edges);
}

void write_mesh(const Path& target, const CheckedMesh& mesh) {
    const String extension = target.extension();
    if (mesh.asset() && extension != ".glb") {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.asset", "is given, but %s is no .glb, which alone holds assets",
             cited(extension).c_str());
    }
    if (extension == ".ply") return write_file(target, write_ply(mesh));
    if (extension == ".glb" && mesh.asset())
        return write_file(target, write_glb_asset(Path(mesh.asset(), target.host()), mesh));
    if (extension == ".glb") return write_file(target, write_glb_mesh(mesh));
    const bool obj = extension == ".obj";
    if (!obj && extension != ".off")
        fail(FLG_ERROR_FORMAT, "", "can't be written: %s is none of .ply .obj .off .glb", cited(extension).c_str());
    FileWriter file(target);
    obj ? write_obj_mesh(mesh, file) : write_off(mesh, file);
    file.finish();
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;
using flg::sized;
using flg::write_origin;

extern "C" {

FlgResult flgMeshFileReadDescInit(FlgMeshFileReadDesc* desc, uint32_t struct_size) {
    return init("flgMeshFileReadDescInit", desc, struct_size, sized<FlgMeshFileReadDesc>());
}

FlgResult flgMeshFileRead(const char* path, const FlgMeshFileReadDesc* desc, FlgMeshFile* out_file) {
    return read_into(out_file, "flgMeshFileRead", path, desc, [](const Path& source) {
        auto file = make_owned<FlgMeshFileT>();
        file->data = read_mesh(source);
        MeshData& data = file->data;
        split_concave_polygons(data);
        file->measures = measure(data);
        file->columns.push_back({FLG_ATTRIBUTE_POSITION, 3, data.positions.data(), 0, 0});
        for (const VertexColumn& column : data.columns) {
            file->columns.push_back({column.attribute, column.components, column.values.data(), 0, 0});
        }
        for (const FaceColumn& column : data.face_columns) {
            auto& shown = file->face_columns.emplace_back(sized<FlgMeshFaceColumn>());
            shown.name = column.name.c_str();
            shown.values = column.values.data();
        }
        for (const MaterialData& material : data.materials) file->materials.push_back(material_view(material));
        for (const TextureData& texture : data.textures) file->textures.push_back(texture_view(texture));
        for (const String& warning : data.warnings) file->warnings.push_back(warning.c_str());
        return file;
    });
}

FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view) {
    return show("flgMeshFileGetView", file, out_view, "out_view", [](const FlgMeshFileT& shown) {
        const MeshData& data = shown.data;
        auto view = sized<FlgMeshView>();
        view.vertex_count = static_cast<uint32_t>(data.vertex_count());
        view.triangle_count = static_cast<uint32_t>(data.triangle_count());
        view.columns = shown.columns.data();
        view.column_count = static_cast<uint32_t>(shown.columns.size());
        view.triangles = data.triangles.data();
        view.regions = data.regions.empty() ? nullptr : data.regions.data();
        write_origin(data.placing.origin, view.origin);
        return view;
    });
}

FlgResult flgMeshFaceColumnInit(FlgMeshFaceColumn* column, uint32_t struct_size) {
    return init("flgMeshFaceColumnInit", column, struct_size, sized<FlgMeshFaceColumn>(), "column");
}

FlgResult flgMeshFileGetFaceColumn(FlgMeshFile file, uint32_t column, FlgMeshFaceColumn* out_column) {
    return show_one("flgMeshFileGetFaceColumn", file, &FlgMeshFileT::face_columns, column, "column", out_column,
                    "out_column");
}

FlgResult flgMeshMaterialInit(FlgMeshMaterial* material, uint32_t struct_size) {
    return init("flgMeshMaterialInit", material, struct_size, material_defaults(), "material");
}

FlgResult flgMeshFileGetMaterial(FlgMeshFile file, uint32_t material, FlgMeshMaterial* out_material) {
    return show_one("flgMeshFileGetMaterial", file, &FlgMeshFileT::materials, material, "material", out_material,
                    "out_material");
}

FlgResult flgTextureInit(FlgTexture* texture, uint32_t struct_size) {
    return init("flgTextureInit", texture, struct_size, sized<FlgTexture>(), "texture");
}

FlgResult flgMeshFileGetTexture(FlgMeshFile file, uint32_t texture, FlgTexture* out_texture) {
    return show_one("flgMeshFileGetTexture", file, &FlgMeshFileT::textures, texture, "texture", out_texture,
                    "out_texture");
}

FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info) {
    return show("flgMeshFileGetInfo", file, out_info, "out_info", [](const FlgMeshFileT& shown) {
        const MeshData& data = shown.data;
        auto info = sized<FlgMeshFileInfo>();
        info.vertex_count = static_cast<uint32_t>(data.vertex_count());
        info.triangle_count = static_cast<uint32_t>(data.triangle_count());
        info.region_count = shown.measures.region_count;
        info.polygon_count = data.polygon_count;
        info.format = data.format;
        shown.measures.box.show(info);
        info.warning_count = static_cast<uint32_t>(shown.warnings.size());
        info.warnings = shown.warnings.data();
        info.material_count = static_cast<uint32_t>(shown.materials.size());
        info.face_column_count = static_cast<uint32_t>(shown.face_columns.size());
        info.texture_count = static_cast<uint32_t>(shown.textures.size());
        if (!data.corner_uvs.empty()) info.corner_uvs = data.corner_uvs.data();
        return info;
    });
}

void flgMeshFileRelease(FlgMeshFile file) {
    release(file);
}

FlgResult flgMeshFileInfoInit(FlgMeshFileInfo* info, uint32_t struct_size) {
    return init("flgMeshFileInfoInit", info, struct_size, sized<FlgMeshFileInfo>(), "info");
}

FlgResult flgMeshFileWriteDescInit(FlgMeshFileWriteDesc* desc, uint32_t struct_size) {
    return init("flgMeshFileWriteDescInit", desc, struct_size, sized<FlgMeshFileWriteDesc>());
}

FlgResult flgMeshFileWrite(const char* path, const FlgMeshView* view, const FlgMeshFileWriteDesc* desc) {
    return write_to("flgMeshFileWrite", path, desc, [&](const Path& target) {
        const CheckedMesh mesh(view, desc);
        write_mesh(target, mesh);
    });
}

}  // extern "C"
