// SPDX-License-Identifier: MIT
// Meshes as text: OBJ and OFF, and how their polygons become triangles.
#include <algorithm>
#include <random>

#include "io/mesh_files.h"

namespace flg::test {
namespace {

TEST(ObjMesh, ReadsFacesInAllTheirWays) {
    const Folder folder;
    ReadMesh mesh = read_mesh(folder.put(
        "a.obj",
        "# comment\r\nmtllib a.mtl\nv 0 0 0\nv +1 0 0 1.0\nvt 0 0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\no part\ng one two\n"
        "f 1 2 3\nf 1/1 3/1 4/1\nf 1//1 2//1 \\\n 3//1 4//1\ns off\nf -4/1/1 -3/1/1 -1/1/1\nl 1 2\np 3\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.positions(), (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 1, 2, 0, 2, 3, 0, 1, 3}));
    EXPECT_EQ(mesh.regions, Indices{});
    EXPECT_EQ(mesh.info.polygon_count, 4u);
    EXPECT_EQ(mesh.info.region_count, 1u);
    EXPECT_EQ(mesh.format, "obj");
    EXPECT_EQ(mesh.columns.size(), 1u);
    EXPECT_EQ(mesh.warnings,
              "the materials of 'a.mtl' can't be read: left out\n"
              "2 lines: of lines or points (`l`, `p`), left out: only faces are read (first: line 17)\n");
}

TEST(ObjMesh, FacesMayComeBeforeTheirVertices) {
    const Folder folder;
    EXPECT_EQ(read_mesh(folder.put("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")).triangles, (Indices{0, 1, 2}));
}

TEST(ObjMesh, MaterialsAreRegionsByFirstUse) {
    const Folder folder;
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const ReadMesh mesh = read_mesh(folder.put(
        "a.obj",
        square + "usemtl unused\nusemtl red\nf 1 2 3\nf 1 3 4\nusemtl blue\nf 1 2 3 4\nusemtl red\nf 1 2 4\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.regions, (Indices{0, 0, 1, 1, 0}));
    EXPECT_EQ(mesh.info.region_count, 2u);
    // What comes before the first is a material too.
    EXPECT_EQ(read_mesh(folder.put("b.obj", square + "f 1 2 3\nusemtl red\nf 1 3 4\n")).regions, (Indices{0, 1}));
}

TEST(ObjMesh, ColoursOfSomeVerticesAreFilledUp) {
    const Folder folder;
    ReadMesh mesh =
        read_mesh(folder.put("a.obj", "v 0 0 0\nv 1 0 0 0.25 0.5 0.75\nv 0 1 0 1 0 0 1\nv 0 0 1\nf 1 2 3\nf 1 2 4\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.colors(), (Floats{1, 1, 1, 1, 0.25f, 0.5f, 0.75f, 1, 1, 0, 0, 1, 1, 1, 1, 1}));
}

TEST(ObjMesh, RefusesWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* place, const char* reason) {
        expect_mesh_refused(folder.put("a.obj", text), FLG_ERROR_FORMAT, place, reason);
    };
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    refuse(square + "f 1 2\n", "5", "a face of 2 vertices: it needs three");
    refuse(square + "f\n", "5", "a face of 0 vertices");
    refuse(square + "f 1 2 5\nf 1 2 3\nf 1 2 9\nf 1 2 9\n", "7", "vertex index 9 is out of range: the file has 4");
    refuse(square + "f 1 2 0\n", "5", "vertex index '0' is out of range: 4 vertices so far");
    refuse(square + "f 1 2 -5\n", "5", "vertex index '-5' is out of range");
    refuse(square + "f 1 2 99999999999999999999\n", "5", "out of range");
    refuse(square + "f 1 2 x\n", "5", "no vertex index: 'x'");
    refuse(square + "f 1 2 3.5\n", "5", "no vertex index: '3.5'");
    refuse("v 0 0\nf 1 1 1\n", "1", "the z is missing");
    refuse("v 0 0 nan\nf 1 1 1\n", "1", "finite");
    refuse("v 0 0 1e31\nf 1 1 1\n", "1", "at most 1e30");
    refuse("v 0 0 0 1 1\nf 1 1 1\n", "1", "the blue is missing");
    refuse("f 1 2 3\n", "1", "index 3 is out of range: the file has 0 vertices");
    refuse(square, "4", "the file holds no faces (`f`)");
    refuse("", "", "no faces");
    refuse(std::string("\x7f\0ELF\1\2\3\n", 9), "1", "no faces");
}

TEST(OffMesh, ReadsItsKeywords) {
    const Folder folder;
    ReadMesh mesh = read_mesh(folder.put("a.off",
                                         "OFF # comment\n\n4 2 0 # counts\n0 0 0\n1 0 0\n1 1 0\n\n0 1 0 # last\n"
                                         "3 0 1 2\n4  0 1 2 3  255 0 0\n"));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.positions(), (Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.info.polygon_count, 2u);
    EXPECT_EQ(mesh.format, "off");
    EXPECT_EQ(mesh.warnings, "");

    ReadMesh bytes = read_mesh(folder.put(
        "b.off", "CNOFF 3 1\n0 0 0 0 0 1 255 0 51\n1 0 0 0 0 1 0 0 0 102\n0 1 0 0 0 1 0 0 0\n3 0 1 2\nmore\n"));
    ASSERT_EQ(bytes.result, FLG_OK) << bytes.error;
    EXPECT_EQ(bytes.positions(), (Floats{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(bytes.colors(), (Floats{1, 0, 0.2f, 1, 0, 0, 0, 0.4f, 0, 0, 0, 1}));
    EXPECT_NE(bytes.warnings.find("1 line: after the last face"), std::string::npos) << bytes.warnings;
}

TEST(OffMesh, RefusesWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* place, const char* reason) {
        expect_mesh_refused(folder.put("a.off", text), FLG_ERROR_FORMAT, place, reason);
    };
    const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    refuse("", "", "ends too early: the keyword OFF is missing");
    refuse("OFF BINARY\n", "1", "the number of vertices is no whole number: 'BINARY'");
    refuse("4OFF\n", "1", "none of OFF, COFF, NOFF and CNOFF: '4OFF'");
    refuse("OFF\n", "1", "the line of counts is missing");
    refuse("OFF\n3\n", "2", "the number of faces is missing");
    refuse("OFF\n-3 1\n", "2", "the number of vertices is -3");
    refuse("OFF\n4294967295 1 0\n0 0 0\n", "2", "declares 4294967295 vertices, but at most 1 fit");
    refuse("OFF\n1 4294967295 0\n0 0 0\n", "2", "declares 4294967295 faces, but at most 1 fit");
    refuse("OFF\n8589934592 1 0\n", "2", "more than 32 bits");
    refuse(points, "5", "ends too early: a face is missing");
    refuse(points + "2 0 1", "6", "a face of 2 vertices: it needs three");
    refuse(points + "3 0 1", "6", "the vertex index is missing");
    refuse(points + "3 0 1 3", "6", "the vertex index 3 is out of range: the file has 3 vertices");
    refuse(points + "3 0 1 -1", "6", "the vertex index -1 is out of range");
    refuse("OFF\n1 0 0\n0 inf 0\n", "3", "finite");
    refuse("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "5", "no faces");
}

// Floats of all sizes, some ugly.
MeshInput ugly_mesh() {
    MeshInput mesh;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> digit(-1, 1), exponent(-30, 29);
    mesh.positions.clear();
    for (int i = 0; i < 300; ++i) mesh.positions.push_back(digit(random) * std::pow(10.0f, exponent(random)));
    mesh.triangles.clear();
    for (int i = 0; i < 600; ++i) mesh.triangles.push_back(static_cast<uint32_t>(random() % 100));
    for (int i = 0; i < 400; ++i) mesh.colors.push_back(std::abs(digit(random)));
    return mesh;
}

TEST(TextMesh, NineDigitsGiveTheSameFloatsBack) {
    const Folder folder;
    MeshInput mesh = ugly_mesh();
    for (size_t i = 0; i < 200; ++i) mesh.regions.push_back(static_cast<uint32_t>(i / 50));
    for (const char* name : {"a.obj", "a.off"}) {
        ASSERT_EQ(write_mesh(folder.at(name), mesh), FLG_OK) << flgIoErrorGetMessage();
        ReadMesh again = read_mesh(folder.at(name));
        ASSERT_EQ(again.result, FLG_OK) << again.error;
        EXPECT_EQ(again.positions(), mesh.positions) << name;
        EXPECT_EQ(again.triangles, mesh.triangles) << name;
        const bool obj = again.format == "obj";
        // OBJ has no alpha, OFF no regions.
        for (size_t i = 0; i < mesh.colors.size(); ++i) {
            EXPECT_EQ(again.colors()[i], obj && i % 4 == 3 ? 1.0f : mesh.colors[i]);
        }
        EXPECT_EQ(again.regions, obj ? mesh.regions : Indices{}) << name;
    }
}

// One face over given corners in the plane.
ReadMesh read_polygon(const Folder& folder, const std::vector<std::pair<double, double>>& corners) {
    std::string text, face = "f";
    for (const auto& [x, y] : corners) {
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
        face += " " + std::to_string(std::count(text.begin(), text.end(), '\n'));
    }
    return read_mesh(folder.put("polygon.obj", text + face + "\n"));
}

// All triangles turn the polygon's way: together with the right area they cover it once.
void expect_covered(ReadMesh& mesh, double area) {
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_NEAR(mesh.area_xy(), area, 1e-5);
    for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
        ReadMesh one = mesh;
        one.triangles.assign(mesh.triangles.begin() + static_cast<ptrdiff_t>(i),
                             mesh.triangles.begin() + static_cast<ptrdiff_t>(i) + 3);
        EXPECT_GE(one.area_xy() * (area > 0 ? 1 : -1), 0) << i / 3;
    }
}

TEST(Polygons, ConcaveOnesAreCovered) {
    const Folder folder;
    // A dart whose fan from the first corner would leave it.
    ReadMesh dart = read_polygon(folder, {{2, 0}, {0, 1}, {-2, 0}, {0, 0.5}});
    expect_covered(dart, 1);
    EXPECT_EQ(dart.triangles.size(), 6u);
    EXPECT_EQ(dart.info.polygon_count, 1u);
    EXPECT_EQ(dart.warnings, "");
    ReadMesh clockwise = read_polygon(folder, {{0, 0.5}, {-2, 0}, {0, 1}, {2, 0}});
    expect_covered(clockwise, -1);

    // A comb of 40 teeth: each one apart, on a back of height 1.
    std::vector<std::pair<double, double>> comb = {{80, 0}};
    for (int tooth = 39; tooth >= 0; --tooth) {
        for (double x : {2.0, 1.0}) comb.push_back({2 * tooth + x, x == 2.0 ? 1.0 : 5.0});
    }
    comb.push_back({0, 1});
    comb.push_back({0, 0});
    ReadMesh teeth = read_polygon(folder, comb);
    expect_covered(teeth, 80 + 40 * 4);
    EXPECT_EQ(teeth.info.triangle_count, comb.size() - 2);
    EXPECT_EQ(teeth.warnings, "");

    // A ring with a slit: two pairs of corners at the same place.
    ReadMesh ring =
        read_polygon(folder, {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});
    expect_covered(ring, 8);
}

TEST(Polygons, DoNotDependOnThePlane) {
    const Folder folder;
    const double dart[4][2] = {{2, 0}, {0, 1}, {-2, 0}, {0, 0.5}};
    for (int axis = 0; axis < 3; ++axis) {
        for (double sign : {1.0, -1.0}) {
            std::string text;
            for (const auto& [u, v] : dart) {
                double p[3] = {};
                p[(axis + 1) % 3] = 100 + sign * u;
                p[(axis + 2) % 3] = v;
                p[axis] = 100 + 0.1 * u;
                text += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
            }
            const ReadMesh mesh = read_mesh(folder.put("a.obj", text + "f 1 2 3 4\n"));
            // The diagonal between the second corner and the reflex fourth.
            for (size_t i = 0; i < 6; i += 3) {
                const auto begin = mesh.triangles.begin() + static_cast<ptrdiff_t>(i);
                EXPECT_NE(std::find(begin, begin + 3, 1u), begin + 3) << axis << sign;
                EXPECT_NE(std::find(begin, begin + 3, 3u), begin + 3) << axis << sign;
            }
        }
    }
}

TEST(Polygons, KnotsAndGiantsKeepTheirTrianglesAndWarn) {
    const Folder folder;
    const ReadMesh bow = read_polygon(folder, {{0, 0}, {4, 4}, {4, 0}, {0, 3}, {-1, 2}});
    ASSERT_EQ(bow.result, FLG_OK) << bow.error;
    EXPECT_EQ(bow.info.triangle_count, 3u);
    EXPECT_NE(bow.warnings.find("crosses itself (first: triangle 0)"), std::string::npos) << bow.warnings;
    // A star of 1026 corners.
    std::vector<std::pair<double, double>> star;
    for (int i = 0; i < 1026; ++i) {
        const double angle = i * 2 * 3.14159265358979 / 1026, radius = i % 2 == 0 ? 1 : 0.5;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const ReadMesh giant = read_polygon(folder, star);
    EXPECT_EQ(giant.info.triangle_count, 1024u);
    EXPECT_NE(giant.warnings.find("more than 1024 corners"), std::string::npos) << giant.warnings;
    star.resize(1024);
    EXPECT_EQ(read_polygon(folder, star).warnings, "");
    // All corners on a line.
    const ReadMesh line = read_polygon(folder, {{0, 0}, {1, 0}, {2, 0}, {1, 0}});
    EXPECT_EQ(line.info.triangle_count, 2u);
}

}  // namespace
}  // namespace flg::test
