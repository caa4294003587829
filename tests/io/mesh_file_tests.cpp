// SPDX-License-Identifier: MIT
// The functions for mesh files: arguments, files, and what is refused before anything is written.
#include <limits>

#include "io/mesh_files.h"

namespace flg::test {
namespace {

void expect_unwritable(const std::string& name, MeshInput& mesh, FlgResult result, const std::string& sentence) {
    const Folder folder;
    folder.put(name, "as it was");
    const FlgMeshView view = mesh.view();
    const FlgMeshFileWriteDesc desc = mesh.desc();
    EXPECT_EQ(flgMeshFileWrite(folder.at(name).c_str(), &view, &desc), result);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find(folder.at(name) + ":" + sentence), std::string::npos)
        << flgIoErrorGetMessage();
    EXPECT_EQ(slurp(folder.at(name)), "as it was");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(MeshFile, RefusesFilesThatAreNone) {
    const Folder folder;
    expect_mesh_refused(folder.at("none.ply"), FLG_ERROR_FILE, "", "can't be opened");
    std::filesystem::create_directory(folder.at("folder.obj"));
    expect_mesh_refused(folder.at("folder.obj"), FLG_ERROR_FILE, "", "not a regular file");
    expect_mesh_refused(folder.put("a.stl", "solid"), FLG_ERROR_FORMAT, "",
                        "'.stl' is none of .ply .obj .off .gltf .glb");
    expect_mesh_refused(folder.put("none", "ply"), FLG_ERROR_FORMAT, "", "'' is none of");
    const std::string big = folder.put("big.off", "OFF\n");
    std::filesystem::resize_file(big, (uint64_t{1} << 31) + 1);
    expect_mesh_refused(big, FLG_ERROR_LIMIT, "", "more than the limit of 2 GiB");
    // Extensions in any case.
    EXPECT_EQ(read_mesh(folder.put("a.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).result, FLG_OK);
}

TEST(MeshFile, ArgumentsAreChecked) {
    FlgMeshFile file = reinterpret_cast<FlgMeshFile>(1);
    EXPECT_EQ(flgMeshFileRead(nullptr, nullptr, &file), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgIoErrorGetMessage(), "flgMeshFileRead:path: is null");
    EXPECT_EQ(file, nullptr);
    EXPECT_EQ(flgMeshFileRead("a.ply", nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgIoErrorGetMessage(), "a.ply:out_file: is null");

    FlgMeshView view = {};
    view.struct_size = sizeof view - 1;
    EXPECT_EQ(flgMeshFileGetView(nullptr, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("out_view: struct_size is"), std::string::npos);
    view.struct_size = sizeof view;
    view.vertex_count = 7;
    EXPECT_EQ(flgMeshFileGetView(nullptr, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgIoErrorGetMessage(), "flgMeshFileGetView:file: is null");
    EXPECT_EQ(view.vertex_count, 0u);
    EXPECT_EQ(flgMeshFileGetView(nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);

    FlgMeshFileInfo info = {};
    EXPECT_EQ(flgMeshFileGetInfo(nullptr, &info), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("out_info: struct_size is 0"), std::string::npos);
    EXPECT_EQ(flgMeshFileGetInfo(nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);

    FlgMeshFaceColumn column = flgMeshFaceColumnDefaults();
    column.name = "a";
    EXPECT_EQ(flgMeshFileGetFaceColumn(nullptr, 0, &column), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(column.name, nullptr);
    FlgMeshMaterial material = flgMeshMaterialDefaults();
    EXPECT_EQ(material.color[2], 1.0f);
    EXPECT_EQ(material.roughness, 0.6f);
    EXPECT_EQ(flgMeshFileGetMaterial(nullptr, 0, &material), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgIoErrorGetMessage(), "flgMeshFileGetMaterial:file: is null");
    EXPECT_EQ(material.color[2], 0.0f);

    FlgMeshFileWriteDesc desc = {};
    EXPECT_EQ(flgMeshFileWriteDescInit(nullptr, sizeof desc), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgMeshFileWriteDescInit(&desc, 4), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgMeshFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    EXPECT_EQ(desc.struct_size, sizeof desc);
    flgMeshFileRelease(nullptr);
}

TEST(MeshFile, RefusesMeshesThatCannotBe) {
    const FlgResult invalid = FLG_ERROR_INVALID_ARGUMENT;
    MeshInput mesh;
    expect_unwritable("a.stl", mesh, FLG_ERROR_FORMAT, " can't be written: '.stl' is none of .ply .obj .off .glb");
    expect_unwritable("a.gltf", mesh, FLG_ERROR_FORMAT, " can't be written: '.gltf'");
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.glb"}) {
        mesh = {};
        mesh.triangles[5] = 4;
        expect_unwritable(name, mesh, invalid, "view.triangles[5]: is 4, but there are 4 vertices");
        mesh = {};
        mesh.positions[4] = std::numeric_limits<float>::quiet_NaN();
        expect_unwritable(name, mesh, invalid, "view.columns[0].data: has nan at point 1");
    }
    mesh = {};
    mesh.positions[4] = 2e30f;
    expect_unwritable("a.ply", mesh, invalid, "view.columns[0].data: has 2e+30 at point 1");
    mesh = {};
    mesh.triangles.clear();
    expect_unwritable("a.ply", mesh, invalid, "view.triangle_count: is 0: there is nothing to write");

    const Indices values(4);
    const auto refuse_columns = [&](const std::vector<FlgMeshFaceColumn>& columns, const char* sentence) {
        MeshInput labelled;
        labelled.face_columns = columns;
        expect_unwritable("a.ply", labelled, invalid, sentence);
    };
    FlgMeshFaceColumn without_values = face_column("a", values), other_size = without_values;
    without_values.values = nullptr;
    other_size.struct_size += 8;
    refuse_columns({face_column(nullptr, values)}, "desc.face_columns[0].name: is null");
    refuse_columns({without_values}, "desc.face_columns[0].values: is null");
    refuse_columns({face_column("b", values), other_size}, " desc.face_columns[1]: struct_size is");
    refuse_columns({face_column("", values)}, "desc.face_columns[0].name: is '', which is no name");
    refuse_columns({face_column("two words", values)}, "desc.face_columns[0].name: is 'two words'");
    refuse_columns({face_column("region", values)}, "desc.face_columns[0].name: is 'region'");
    refuse_columns({face_column("vertex_indices", values)}, "desc.face_columns[0].name: is 'vertex_indices'");
    refuse_columns({face_column(std::string(64, 'a').c_str(), values)}, "desc.face_columns[0].name: is 'aaa");
    refuse_columns({face_column("a", values), face_column("b", values), face_column("a", values)},
                   "desc.face_columns[2].name: is 'a', as that of column 0");
    refuse_columns(std::vector<FlgMeshFaceColumn>(17, face_column("a", values)), "desc.face_column_count: is 17");
}

TEST(MeshFile, RefusesNullsOnWriting) {
    const Folder folder;
    const std::string path = folder.at("a.ply");
    MeshInput mesh;
    const FlgMeshView whole = mesh.view();
    const auto refuse = [&](const FlgMeshView* view, const FlgMeshFileWriteDesc* desc, const char* sentence) {
        EXPECT_EQ(flgMeshFileWrite(path.c_str(), view, desc), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(std::string(flgIoErrorGetMessage()).rfind(path + ":" + sentence, 0), 0u) << flgIoErrorGetMessage();
    };
    EXPECT_EQ(flgMeshFileWrite(nullptr, &whole, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgIoErrorGetMessage(), "flgMeshFileWrite:path: is null");
    refuse(nullptr, nullptr, "view: is null");
    FlgMeshView view = whole;
    view.struct_size = 8;
    refuse(&view, nullptr, " view: struct_size is 8");
    view = whole;
    view.columns = nullptr;
    refuse(&view, nullptr, "view.columns: is null");
    view = whole;
    view.column_count = 0;
    refuse(&view, nullptr, "view.column_count: is 0");
    view = whole;
    view.triangles = nullptr;
    refuse(&view, nullptr, "view.triangles: is null");
    FlgMeshFileWriteDesc desc = mesh.desc();
    desc.struct_size = 0;
    refuse(&whole, &desc, " desc: struct_size is 0");
    desc = mesh.desc();
    desc.face_column_count = 1;
    desc.face_columns = nullptr;
    refuse(&whole, &desc, "desc.face_columns: is null");
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_EQ(flgMeshFileWrite(path.c_str(), &whole, nullptr), FLG_OK);
    EXPECT_EQ(flgMeshFileWrite(folder.at("none/a.ply").c_str(), &whole, nullptr), FLG_ERROR_FILE);
}

TEST(MeshFile, StridedColumnsArePacked) {
    const Folder folder;
    MeshInput mesh;
    const Floats rows = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9, 0, 0, 1, 9};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, rows.data(), 16, 0};
    FlgMeshView view = mesh.view();
    view.columns = &column;
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.glb"}) {
        ASSERT_EQ(flgMeshFileWrite(folder.at(name).c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_EQ(read_mesh(folder.at(name)).positions(), mesh.positions) << name;
    }
}

TEST(MeshFile, OdditiesAreSaidOnceAKind) {
    const Folder folder;
    const ReadMesh mesh =
        read_mesh(folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\nf 1 2 2\nf 3 3 3\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.info.triangle_count, 3u);
    EXPECT_EQ(mesh.warnings,
              "2 triangles: names a vertex twice (first: triangle 1)\n1 vertex: in no triangle (first: vertex 3)\n");
    EXPECT_EQ(mesh.info.box_max[2], 5.0f);
}

}  // namespace
}  // namespace flg::test
