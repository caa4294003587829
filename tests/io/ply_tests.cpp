// SPDX-License-Identifier: MIT
// PLY: bit for bit round trips, files of other programs, strips, and what is refused.
#include <cstring>
#include <limits>

#include "io/mesh_files.h"

namespace flg::test {
namespace {

const std::string square_vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string square_points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string corner_list = "property list uchar int vertex_indices\n";

std::string ascii(const std::string& header) {
    return "ply\nformat ascii 1.0\n" + header + "end_header\n";
}

template <class T>
void append(std::string& bytes, T value, bool turned) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    for (size_t i = 0; i < sizeof value; ++i) bytes += raw[turned ? sizeof value - 1 - i : i];
}

MeshInput full_mesh() {
    MeshInput mesh;
    mesh.positions = {0.1f, -0.0f, 1e-42f, 1e30f, 0.3f, 0, -7.7f, 1, 0.125f, 3, 4, 5};
    mesh.colors = {0.1f, 0.2f, 0.3f, 0.4f, 1, 0, 0, 1, 2, -1, 0, 0.5f, 0, 0, 0, 0};
    mesh.normals = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6f, 0.8f, 0};
    mesh.radii = {1, 2, 3, 0.1f};
    mesh.user = {1, 2, 3, 4, 5, 6, 7, 0.7f};
    mesh.regions = {7, 7, 0, 0xffffffff};
    return mesh;
}

TEST(Ply, RoundTripsEveryBit) {
    const Folder folder;
    MeshInput mesh = full_mesh();
    const Indices group = {1, 2, 3, 0x80000000}, tag_2 = {9, 8, 7, 6};
    mesh.face_columns = {face_column("group", group), face_column("tag_2", tag_2)};
    ASSERT_EQ(write_mesh(folder.at("a.ply"), mesh), FLG_OK) << flgIoErrorGetMessage();
    ReadMesh again = read_mesh(folder.at("a.ply"));
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    const auto same_bits = [](const Floats& a, const Floats& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
    };
    EXPECT_TRUE(same_bits(again.positions(), mesh.positions));
    EXPECT_TRUE(same_bits(again.colors(), mesh.colors));
    EXPECT_TRUE(same_bits(again.columns[FLG_ATTRIBUTE_NORMAL], mesh.normals));
    EXPECT_TRUE(same_bits(again.columns[FLG_ATTRIBUTE_RADIUS], mesh.radii));
    EXPECT_TRUE(same_bits(again.columns[FLG_ATTRIBUTE_USER + 7], mesh.user));
    EXPECT_EQ(again.columns.size(), 5u);
    EXPECT_EQ(again.triangles, mesh.triangles);
    EXPECT_EQ(again.regions, mesh.regions);
    EXPECT_EQ(again.face_columns, (std::map<std::string, Indices>{{"group", group}, {"tag_2", tag_2}}));
    EXPECT_EQ(again.info.region_count, 3u);
    EXPECT_EQ(again.format, "ply");
    EXPECT_EQ(again.warnings, "");
    EXPECT_EQ(again.info.box_min[0], -7.7f);
    EXPECT_EQ(again.info.box_max[0], 1e30f);
    // Writing what was read gives the same file.
    const std::string first = slurp(folder.at("a.ply"));
    MeshInput twice = full_mesh();
    twice.face_columns = {face_column("group", again.face_columns["group"]),
                          face_column("tag_2", again.face_columns["tag_2"])};
    ASSERT_EQ(write_mesh(folder.at("b.ply"), twice), FLG_OK);
    EXPECT_EQ(slurp(folder.at("b.ply")), first);
}

TEST(Ply, AllAttributesHaveNames) {
    const Folder folder;
    MeshInput mesh;
    const FlgMeshView plain = mesh.view();
    const Floats values(16, 0.5f);
    std::vector<FlgColumn> columns = {plain.columns[0]};
    const std::pair<int, uint32_t> all[] = {
        {FLG_ATTRIBUTE_RADIUS, 1}, {FLG_ATTRIBUTE_COLOR, 4},       {FLG_ATTRIBUTE_TANGENT, 3},
        {FLG_ATTRIBUTE_NORMAL, 3}, {FLG_ATTRIBUTE_TIME, 1},        {FLG_ATTRIBUTE_PRESSURE, 1},
        {FLG_ATTRIBUTE_ANGLE, 1},  {FLG_ATTRIBUTE_ORIENTATION, 4}, {FLG_ATTRIBUTE_STYLE_INDEX, 1},
        {FLG_ATTRIBUTE_RADII, 3},  {FLG_ATTRIBUTE_WIDTH, 1},       {FLG_ATTRIBUTE_SPEED, 1},
        {FLG_ATTRIBUTE_USER, 1},   {FLG_ATTRIBUTE_USER + 12, 3},   {FLG_ATTRIBUTE_DISPLACEMENT, 3}};
    for (const auto& [attribute, components] : all) {
        columns.push_back({static_cast<FlgAttribute>(attribute), components, values.data(), 0, 0});
    }
    FlgMeshView view = plain;
    view.columns = columns.data();
    view.column_count = static_cast<uint32_t>(columns.size());
    ASSERT_EQ(flgMeshFileWrite(folder.at("a.ply").c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
    const ReadMesh again = read_mesh(folder.at("a.ply"));
    EXPECT_EQ(again.columns.size(), columns.size());
    for (const auto& [attribute, components] : all) {
        const auto found = again.columns.find(static_cast<uint32_t>(attribute));
        ASSERT_NE(found, again.columns.end()) << attribute;
        EXPECT_EQ(found->second.size(), 4 * components) << attribute;
    }
}

TEST(Ply, ReadsTextOfOtherPrograms) {
    const Folder folder;
    ReadMesh mesh = read_mesh(folder.put(
        "a.ply",
        "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info 7\r\nelement camera 1\r\nproperty double focus\r\n"
        "property list uint8 float32 lens\r\nelement empty 4294967295\r\n"
        "element vertex 4\r\nproperty uchar red\r\nproperty double x\r\nproperty list int int neighbours\r\n"
        "property int16 y\r\nproperty uchar green\r\nproperty float z\r\nproperty uchar blue\r\nproperty float "
        "other\r\n"
        "element face 2\r\nproperty int material\r\nproperty list uint8 uint32 vertex_index\r\nproperty float area\r\n"
        "property short region\r\nelement edge 1\r\nproperty int a\r\nend_header\r\n"
        "0.5 2 nan inf\r\n\r\n255 0 0 0 0 0 51 nan\r\n0 1 3 7 8 9 0 0 0 0 1\r\n0 1 0 1 0 0 0 1\r\n0 0 0 1 0 0.25 0 "
        "1\r\n"
        "-1 3 0 1 2 0.5 4\r\n5 4 0 1 2 3 0.5 -2\r\n12\r\nthe rest\r\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.positions(), (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.25f}));
    EXPECT_EQ(mesh.colors(), (Floats{1, 0, 0.2f, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.regions, (Indices{4, 0xfffffffe, 0xfffffffe}));
    EXPECT_EQ(mesh.face_columns, (std::map<std::string, Indices>{{"material", {0xffffffff, 5, 5}}}));
    EXPECT_EQ(mesh.info.polygon_count, 2u);
    EXPECT_EQ(mesh.columns.size(), 2u);
    EXPECT_EQ(mesh.warnings, "10 bytes after the last row, left out\n");
}

TEST(Ply, BothByteOrdersAndAllTypesGiveTheSame) {
    const Folder folder;
    for (bool big : {false, true}) {
        std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                           "_endian 1.0\nelement face 1\nproperty list uint16 uint vertex_indices\n"
                           "property int8 region\nproperty ushort tag\nelement vertex 3\nproperty double x\n"
                           "property short y\nproperty float z\nproperty list ushort double weights\nproperty int8 "
                           "radius\nproperty ushort "
                           "red\nproperty uint green\nproperty short blue\nproperty int alpha\nend_header\n";
        append<uint16_t>(file, 3, big);
        for (uint32_t index : {2u, 1u, 0u}) append(file, index, big);
        append<int8_t>(file, -1, big);
        append<uint16_t>(file, 0x1234, big);
        for (int i = 0; i < 3; ++i) {
            append(file, i * 0.5, big);
            append<int16_t>(file, static_cast<int16_t>(-300 * i), big);
            append(file, 0.1f * static_cast<float>(i), big);
            append<uint16_t>(file, static_cast<uint16_t>(i), big);
            for (int k = 0; k < i; ++k) append(file, std::numeric_limits<double>::quiet_NaN(), big);
            append<int8_t>(file, static_cast<int8_t>(i), big);
            append<uint16_t>(file, 65535, big);
            append<uint32_t>(file, 0xffffffff, big);
            append<int16_t>(file, 0, big);
            append<int32_t>(file, std::numeric_limits<int32_t>::max(), big);
        }
        ReadMesh mesh = read_mesh(folder.put("a.ply", file));
        ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
        EXPECT_EQ(mesh.positions(), (Floats{0, 0, 0, 0.5f, -300, 0.1f, 1, -600, 0.2f}));
        EXPECT_EQ(mesh.columns[FLG_ATTRIBUTE_RADIUS], (Floats{0, 1, 2}));
        EXPECT_EQ(mesh.colors(), (Floats{1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1}));
        EXPECT_EQ(mesh.triangles, (Indices{2, 1, 0}));
        EXPECT_EQ(mesh.regions, (Indices{0xffffffff}));
        EXPECT_EQ(mesh.face_columns["tag"], (Indices{0x1234}));
        EXPECT_EQ(mesh.warnings, "");
    }
}

TEST(Ply, StripsTurnEveryOtherTriangle) {
    const Folder folder;
    const std::string header = ascii(
        "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 2\nproperty list int int vertex_indices\n");
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    // A ladder; the same from its other side, twice, as two strips in one list; and stitched by repeated vertices.
    ReadMesh mesh = read_mesh(folder.put("a.ply", header + points + "6 0 1 2 3 4 5\n11 1 0 3 2 -1 0 1 2 2 5 5\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5, 1, 0, 3, 3, 0, 2, 0, 1, 2}));
    EXPECT_EQ(mesh.info.polygon_count, 7u);
    mesh.triangles.resize(12);
    EXPECT_NEAR(mesh.area_xy(), 2, 1e-6);
    expect_mesh_refused(folder.put("a.ply", header + points + "3 0 1 6\n0\n"), FLG_ERROR_FORMAT, "16",
                        "the vertex index 6 is out of range: the file has 6 vertices");
    expect_mesh_refused(folder.put("a.ply", header + points + "3 0 1 -2\n0\n"), FLG_ERROR_FORMAT, "16", "-2");
}

TEST(Ply, StripsAndFacesKeepTheirLabels) {
    const Folder folder;
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const std::string faces = "element face 1\n" + corner_list + "property int region\nproperty int tag\n";
    const std::string strip = "4 0 1 3 2\n", face = "3 0 1 2 5 6\n";
    const ReadMesh before =
        read_mesh(folder.put("a.ply", ascii(square_vertices + strips + faces) + square_points + strip + face));
    EXPECT_EQ(before.regions, (Indices{0, 0, 5}));
    EXPECT_EQ(before.face_columns.at("tag"), (Indices{0, 0, 6}));
    const ReadMesh after =
        read_mesh(folder.put("a.ply", ascii(square_vertices + faces + strips) + square_points + face + strip));
    EXPECT_EQ(after.regions, (Indices{5, 0, 0}));
    EXPECT_EQ(after.face_columns.at("tag"), (Indices{6, 0, 0}));
}

TEST(Ply, RefusesHeadersWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* place, const char* reason) {
        expect_mesh_refused(folder.put("a.ply", text), FLG_ERROR_FORMAT, place, reason);
    };
    const std::string start = "ply\nformat ascii 1.0\n";
    refuse("", "", "ends within the header");
    refuse("plya\n", "1", "no PLY file: its first word is not 'ply': 'plya'");
    refuse("ply\nelement vertex 1\n", "2", "`format` must come second: 'element'");
    refuse("ply\nformat ascii 2.0\n", "2", "only the version 1.0 is known: '2.0'");
    refuse("ply\nformat text 1.0\n", "2", "no format of a PLY file: 'text'");
    refuse(start + "vertex 4\n", "3", "no keyword of a PLY header: 'vertex'");
    refuse(start + "element vertex four\n", "3", "no count of rows: 'four'");
    refuse(start + "element vertex -4\n", "3", "no count of rows: '-4'");
    refuse(start + "element vertex 99999999999999999999\n", "3", "no count of rows");
    refuse(start + "element vertex\n", "3", "no count of rows: ''");
    refuse(start + "element \x01 4\n", "3", "no name: '?'");
    refuse(start + "property float x\n", "3", "a property before the first element");
    refuse(start + "element vertex 4\nproperty real x\n", "4", "no type of a PLY property: 'real'");
    refuse(start + "element vertex 4\nproperty float\n", "4", "no name: ''");
    refuse(start + "element vertex 4\nproperty list float int x\n", "4", "counted by integers");
    refuse(start + "element vertex 4\nproperty float x\nproperty int x\n", "5", "a second property of this name: 'x'");
    refuse(start + square_vertices + square_vertices, "7", "a second element of this name: 'vertex'");
    refuse(start + square_vertices, "6", "no end_header");
    refuse(start + "end_header\n", "", "has no element vertex");
    refuse(start + "element vertex 1\nproperty float x\nproperty float z\nend_header\n0 0\n", "3", "no property y");
    refuse(start + "element vertex 1\nproperty float x\nproperty float z\nproperty list int int y\nend_header\n", "3",
           "no property y");
    refuse(ascii(square_vertices + "element face 1\nproperty list uchar float vertex_indices\n") + square_points, "7",
           "the element face has no list of integers vertex_indices");
    refuse(ascii(square_vertices + "element tristrips 1\nproperty int vertex_indices\n") + square_points, "7",
           "the element tristrips has no list of integers vertex_indices");
    refuse(ascii(square_vertices) + square_points, "11", "the file holds no faces");
    refuse(ascii(square_vertices + "element face 0\n" + corner_list) + square_points, "13", "the file holds no faces");

    std::string many = start + "element vertex 4\n";
    for (int i = 0; i <= 256; ++i) many += "property int p" + std::to_string(i) + "\n";
    expect_mesh_refused(folder.put("a.ply", many), FLG_ERROR_LIMIT, "260", "more than 256 elements");
}

TEST(Ply, RefusesRowsWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& rows, const char* place, const char* reason) {
        const std::string header = ascii(square_vertices + "element face 1\n" + corner_list);
        expect_mesh_refused(folder.put("a.ply", header + rows), FLG_ERROR_FORMAT, place, reason);
    };
    refuse("0 0 0\n1 0\n1 1 0\n0 1 0\n3 0 1 2\n", "11", "the z is missing");
    refuse("0 0 0\n1 0 0 0\n1 1 0\n0 1 0\n3 0 1 2\n", "11", "more values than the element has: '0'");
    refuse("0 0 0\n1 zero 0\n1 1 0\n0 1 0\n3 0 1 2\n", "11", "the y is no number: 'zero'");
    refuse("0 0 0\n1 nan 0\n1 1 0\n0 1 0\n3 0 1 2\n", "11", "finite");
    refuse("0 0 0\n1 1 -1e31\n1 1 0\n0 1 0\n3 0 1 2\n", "11", "at most 1e30");
    refuse(square_points + "2 0 1\n", "14", "a face of 2 vertices: it needs three");
    refuse(square_points + "0\n", "14", "a face of 0 vertices");
    refuse(square_points + "-1 0 1\n", "14", "the list vertex_indices has -1 values");
    refuse(square_points + "3 0 1 4\n", "14", "the vertex index 4 is out of range: the file has 4 vertices");
    refuse(square_points + "3 0 1 -1\n", "14", "the vertex index -1 is out of range");
    refuse(square_points + "3 0 1 99999999999\n", "14", "more than 32 bits: '99999999999'");
    refuse(square_points + "3 0 1 1.5\n", "14", "the vertex index is no whole number: '1.5'");
    refuse(square_points + "3 0 1\n", "14", "the vertex index is missing");
    refuse(square_points, "7", "declares 1 rows of the element 'face', but at most 0 fit");
    refuse(square_points + "\n\n", "15", "ends too early: rows of the element 'face' are missing");
}

TEST(Ply, HeadersCannotAskForMemoryTheFileHasNoRoomFor) {
    const Folder folder;
    const std::string vertices = "\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar int n\n";
    for (const char* count : {"4294967296", "4294967295", "18446744073709551615", "9"}) {
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
            expect_mesh_refused(folder.put("a.ply", std::string("ply\nformat ") + format + " 1.0\nelement vertex " +
                                                        count + vertices + "end_header\n0 0 0 0\n1 0 0 0\n"),
                                FLG_ERROR_FORMAT, "3", "rows of the element 'vertex', but at most");
        }
    }
    // A list that claims more than is there.
    std::string file = "ply\nformat binary_little_endian 1.0\n" + square_vertices +
                       "element face 1\nproperty list uint int vertex_indices\nend_header\n" + std::string(48, '\0');
    const size_t body = file.size();
    append<uint32_t>(file, 0xffffffff, false);
    append<uint32_t>(file, 0, false);
    expect_mesh_refused(folder.put("a.ply", file), FLG_ERROR_FORMAT, "@" + std::to_string(body + 8),
                        "ends too early: vertex index takes 4 bytes, 0 are left");
}

TEST(Ply, RefusesBytesWithTheirOffset) {
    const Folder folder;
    MeshInput mesh;
    ASSERT_EQ(write_mesh(folder.at("a.ply"), mesh), FLG_OK);
    const std::string whole = slurp(folder.at("a.ply"));
    const size_t body = whole.find("end_header\n") + 11;
    for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e31f}) {
        std::string damaged = whole;
        std::memcpy(damaged.data() + body + 16, &bad, sizeof bad);
        expect_mesh_refused(folder.put("b.ply", damaged), FLG_ERROR_FORMAT, "@" + std::to_string(body + 16),
                            "the y is");
    }
    std::string damaged = whole;
    damaged[body + 48] = 2;
    expect_mesh_refused(folder.put("b.ply", damaged), FLG_ERROR_FORMAT, "@" + std::to_string(body + 49),
                        "a face of 2 vertices");
    damaged = whole;
    damaged[body + 49] = 4;
    expect_mesh_refused(folder.put("b.ply", damaged), FLG_ERROR_FORMAT, "@" + std::to_string(body + 53),
                        "the vertex index 4 is out of range");
}

TEST(Ply, IsRefusedAtEveryLengthButItsOwn) {
    const Folder folder;
    MeshInput mesh = full_mesh();
    ASSERT_EQ(write_mesh(folder.at("a.ply"), mesh), FLG_OK);
    const std::string whole = slurp(folder.at("a.ply"));
    for (size_t size = 0; size < whole.size(); ++size) {
        ASSERT_EQ(read_mesh(folder.put("cut.ply", std::string_view(whole).substr(0, size))).result, FLG_ERROR_FORMAT)
            << size;
    }
}

}  // namespace
}  // namespace flg::test
