// SPDX-License-Identifier: MIT
// What the tests of mesh files share: meshes to write, and meshes read with their arrays copied out.
#pragma once

#include <cmath>
#include <map>

#include "io/files.h"

namespace flg::test {

using Floats = std::vector<float>;
using Indices = std::vector<uint32_t>;

struct ReadMesh {
    FlgResult result = FLG_OK;
    std::string error;
    std::map<uint32_t, Floats> columns;  // by attribute
    Indices triangles, regions;
    std::map<std::string, Indices> face_columns;
    std::vector<FlgMeshMaterial> materials;  // whose names are in
    std::vector<std::string> material_names;
    std::string warnings, format;
    FlgMeshFileInfo info = {};

    const Floats& positions() { return columns[FLG_ATTRIBUTE_POSITION]; }
    const Floats& colors() { return columns[FLG_ATTRIBUTE_COLOR]; }

    uint32_t vertex_count() const { return info.vertex_count; }
    // Signed, of the triangles' projections along z.
    double area_xy() {
        double sum = 0;
        for (size_t i = 0; i < triangles.size(); i += 3) {
            const float *a = &positions()[3 * triangles[i]], *b = &positions()[3 * triangles[i + 1]],
                        *c = &positions()[3 * triangles[i + 2]];
            sum += 0.5 * (double{b[0] - a[0]} * (c[1] - a[1]) - double{b[1] - a[1]} * (c[0] - a[0]));
        }
        return sum;
    }
};

inline ReadMesh read_mesh(const std::string& path) {
    ReadMesh read;
    FlgMeshFile file = nullptr;
    read.result = flgMeshFileRead(path.c_str(), nullptr, &file);
    if (read.result != FLG_OK) {
        EXPECT_EQ(file, nullptr);
        read.error = flgIoErrorGetMessage();
        EXPECT_EQ(read.error.rfind(path, 0), 0u) << read.error;
        return read;
    }
    FlgMeshView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const FlgColumn& column = view.columns[i];
        EXPECT_TRUE(
            read.columns
                .try_emplace(column.attribute, column.data, column.data + size_t{view.vertex_count} * column.components)
                .second);
    }
    read.triangles.assign(view.triangles, view.triangles + 3 * size_t{view.triangle_count});
    if (view.regions) read.regions.assign(view.regions, view.regions + view.triangle_count);
    read.info.struct_size = sizeof read.info;
    EXPECT_EQ(flgMeshFileGetInfo(file, &read.info), FLG_OK);
    for (uint32_t i = 0; i < read.info.face_column_count; ++i) {
        FlgMeshFaceColumn column = flgMeshFaceColumnDefaults();
        EXPECT_EQ(flgMeshFileGetFaceColumn(file, i, &column), FLG_OK);
        read.face_columns[column.name].assign(column.values, column.values + view.triangle_count);
    }
    for (uint32_t i = 0; i < read.info.material_count; ++i) {
        EXPECT_EQ(flgMeshFileGetMaterial(file, i, &read.materials.emplace_back(flgMeshMaterialDefaults())), FLG_OK);
        read.material_names.emplace_back(read.materials[i].name);
    }
    EXPECT_EQ(read.info.vertex_count, view.vertex_count);
    EXPECT_EQ(read.info.triangle_count, view.triangle_count);
    read.format = read.info.format;
    for (uint32_t i = 0; i < read.info.warning_count; ++i) read.warnings += std::string(read.info.warnings[i]) + "\n";
    flgMeshFileRelease(file);
    return read;
}

inline FlgMeshFaceColumn face_column(const char* name, const Indices& values) {
    FlgMeshFaceColumn column = flgMeshFaceColumnDefaults();
    column.name = name;
    column.values = values.data();
    return column;
}

// A mesh to be written: the tetrahedron of the origin and the unit points, faces outwards.
struct MeshInput {
    Floats positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    Floats colors, normals, radii, user;
    Indices triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    Indices regions;
    std::vector<FlgMeshFaceColumn> face_columns;
    std::vector<FlgMeshMaterial> materials;
    bool split_regions = false;
    std::vector<FlgColumn> columns;

    FlgMeshView view() {
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        if (!colors.empty()) columns.push_back({FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0});
        if (!normals.empty()) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0});
        if (!radii.empty()) columns.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0});
        if (!user.empty()) {
            columns.push_back({static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 7), 2, user.data(), 0, 0});
        }
        FlgMeshView view = {};
        view.struct_size = sizeof view;
        view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        view.triangles = triangles.data();
        view.regions = regions.empty() ? nullptr : regions.data();
        return view;
    }
    FlgMeshFileWriteDesc desc() const {
        FlgMeshFileWriteDesc desc = {};
        EXPECT_EQ(flgMeshFileWriteDescInit(&desc, sizeof desc), FLG_OK);
        desc.face_columns = face_columns.data();
        desc.face_column_count = static_cast<uint32_t>(face_columns.size());
        desc.split_regions = split_regions;
        desc.materials = materials.data();
        desc.material_count = static_cast<uint32_t>(materials.size());
        return desc;
    }
};

inline FlgResult write_mesh(const std::string& path, MeshInput& mesh) {
    const FlgMeshView view = mesh.view();
    const FlgMeshFileWriteDesc desc = mesh.desc();
    return flgMeshFileWrite(path.c_str(), &view, &desc);
}

// Refused with this result and a sentence that starts with FILE:place and holds `reason`.
inline void expect_mesh_refused(const std::string& path, FlgResult result, const std::string& place,
                                const std::string& reason) {
    const ReadMesh refused = read_mesh(path);
    EXPECT_EQ(refused.result, result) << refused.error;
    EXPECT_EQ(refused.error.rfind(path + (place.empty() ? "" : ":" + place) + ": ", 0), 0u) << refused.error;
    EXPECT_NE(refused.error.find(reason), std::string::npos) << refused.error;
}

}  // namespace flg::test
