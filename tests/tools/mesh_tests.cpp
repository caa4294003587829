// SPDX-License-Identifier: MIT
// filigree mesh info, repair, refine.
#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

using MeshCommand = Cli;

// Everything that can be wrong: a triangle twice (the second time from behind), one that names a vertex twice, a third
// triangle at an edge, one wound against its neighbour, two fans at a vertex, a vertex in no triangle.
TestMesh defective() {
    TestMesh mesh = square(1);  // 0 1 3, 0 3 2
    mesh.triangles.push_back({3, 1, 0});
    mesh.triangles.push_back({0, 0, 3});
    mesh.points.insert(mesh.points.end(), {{2, 0, 0}, {9, 9, 9}, {-1, -1, 0}, {0, -1, 0}});
    mesh.triangles.push_back({1, 3, 4});  // should be 1 4 3
    mesh.triangles.push_back({0, 6, 7});  // meets the others at vertex 0 alone
    return mesh;
}

TEST_F(MeshCommand, InfoTellsTheSurfacesTopology) {
    folder.write("cube.off", cube(2).off());
    const Outcome outcome = done({"mesh", "info", "cube.off", "--report", "report.json"});
    EXPECT_NE(outcome.out.find("repair: welded vertices 28\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("components: 1, borders: 0 (0 edges), Euler number: 2, genus: 0\n"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(report().at("command"), "mesh info");
    const nlohmann::json counts = report().at("counts");
    EXPECT_EQ(counts.at("input_vertices"), 6 * 9);
    EXPECT_EQ(counts.at("vertices"), 26);
    EXPECT_EQ(counts.at("triangles"), 6 * 8);
    EXPECT_EQ(counts.at("welded_vertices"), 54 - 26);
    EXPECT_EQ(counts.at("euler_number"), 2);
    EXPECT_DOUBLE_EQ(report().at("quality").at("area"), 6.0);
    EXPECT_EQ(report().at("quality").at("box"), nlohmann::json({{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}));

    folder.write("square.off", square(3).off());
    const Outcome flat = done({"mesh", "info", "square.off", "--report", "report.json"});
    EXPECT_NE(flat.out.find("repair: nothing to do\n"), std::string::npos) << flat.out;
    EXPECT_EQ(report().at("counts").at("borders"), 1);
    EXPECT_EQ(report().at("counts").at("border_edges"), 12);
    EXPECT_EQ(report().at("counts").at("euler_number"), 1);

    TestMesh torus;
    torus.add_grid(8, [](double u, double v) {
        // Whole turns of rounded numbers, so that the seams meet to the bit.
        const double a = std::fmod(u, 1.0) * 2 * std::acos(-1.0), b = std::fmod(v, 1.0) * 2 * std::acos(-1.0);
        return Point{(2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)};
    });
    folder.write("torus.off", torus.off());
    done({"mesh", "info", "torus.off", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("vertices"), 64);
    EXPECT_EQ(report().at("counts").at("genus"), 1);
    EXPECT_EQ(report().at("counts").at("euler_number"), 0);
}

TEST_F(MeshCommand, InfoCountsWhatARepairWouldDo) {
    folder.write("bad.off", defective().off());
    const Outcome outcome = done({"mesh", "info", "bad.off", "--report", "report.json", "--quiet"});
    const nlohmann::json counts = report().at("counts");
    EXPECT_EQ(counts.at("unused_vertices"), 1);
    EXPECT_EQ(counts.at("degenerate_triangles"), 1);
    EXPECT_EQ(counts.at("duplicate_triangles"), 1);
    EXPECT_EQ(counts.at("flipped_triangles"), 1);
    EXPECT_EQ(counts.at("split_vertices"), 1);
    EXPECT_EQ(counts.at("crowded_edges"), 0);
    EXPECT_EQ(counts.at("components"), 2);
    EXPECT_NE(outcome.out.find("flipped triangles 1"), std::string::npos) << outcome.out;

    TestMesh book;  // four pages at one edge: two pairs
    book.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}};
    folder.write("book.off", book.off());
    done({"mesh", "info", "book.off", "--report", "report.json", "--quiet"});
    EXPECT_EQ(report().at("counts").at("crowded_edges"), 1);
    EXPECT_EQ(report().at("counts").at("components"), 2);
}

TEST_F(MeshCommand, ARepairedMeshHasNothingToRepair) {
    folder.write("bad.off", defective().off());
    for (const char* fixed : {"fixed.off", "fixed.obj", "fixed.ply"}) {
        done({"mesh", "repair", "bad.off", "-o", fixed, "--quiet"});
        const Outcome outcome = done({"mesh", "info", fixed, "--weld", "-1", "--report", "report.json"});
        EXPECT_NE(outcome.out.find("repair: nothing to do\n"), std::string::npos) << outcome.out;
        EXPECT_EQ(report().at("counts").at("triangles"), 4) << fixed;
        EXPECT_EQ(report().at("counts").at("components"), 2) << fixed;
        // The doubled vertex is moved by about a millionth of its triangles, so that readers don't weld it again.
        EXPECT_NEAR(report().at("quality").at("area"), 0.5 + 0.5 + 0.5 + 0.5, 1e-6) << fixed;
    }
    done({"mesh", "repair", "bad.off", "-o", "fixed.glb", "--quiet"});
    EXPECT_EQ(folder.read("fixed.glb").substr(0, 4), "glTF");
}

// Sheets that only touch, at vertices and edges that a repair has to double: readers weld them again.
TestMesh touching() {
    TestMesh mesh;
    mesh.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}};  // four pages at one edge
    const size_t strip = mesh.points.size();
    for (int i = 0; i < 8; ++i) {  // a Moebius strip of 16 triangles
        const double turn = i * std::acos(-1.0) / 4, twist = turn / 2;
        for (const double side : {-0.3, 0.3}) {
            const double r = 3 + side * std::cos(twist);
            mesh.points.push_back({r * std::cos(turn), r * std::sin(turn), side * std::sin(twist)});
        }
    }
    for (size_t i = 0; i < 8; ++i) {
        const bool seam = i == 7;
        const size_t a = strip + 2 * i, b = a + 1, c = seam ? strip + 1 : a + 2, d = seam ? strip : a + 3;
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({b, c, d});
    }
    const size_t tip = mesh.points.size();
    mesh.points.push_back({0, 5, 0});  // two fans at a tip, a hundred times over at 1000 m, where floats are coarse
    for (size_t i = 0; i < 100; ++i) {
        const double x = 1000 + 0.01 * static_cast<double>(i);
        mesh.points.insert(mesh.points.end(), {{x, 5, 0}, {x, 6, 0}, {x, 5, 1}});
        mesh.triangles.push_back({tip, tip + 3 * i + 1, tip + 3 * i + 2});
        mesh.triangles.push_back({tip, tip + 3 * i + 2, tip + 3 * i + 3});
    }
    return mesh;
}

TEST_F(MeshCommand, ARepairSettlesWhereSheetsTouch) {
    folder.write("touching.off", touching().off());
    done({"mesh", "info", "touching.off", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("crowded_edges"), 1);
    EXPECT_GT(report().at("counts").at("cut_edges"), 0);
    EXPECT_EQ(report().at("counts").at("split_vertices").get<int>() > 99, true);
    const double area = report().at("quality").at("area");
    for (const char* fixed : {"fixed.off", "fixed.obj", "fixed.ply", "fixed.glb"}) {
        const Outcome repaired = done({"mesh", "repair", "touching.off", "-o", fixed, "--report", "report.json"});
        EXPECT_NE(repaired.out.find("touching.off: crowded edges 1, cut edges "), std::string::npos) << repaired.out;
        EXPECT_NE(repaired.out.find("vertices moved apart: "), std::string::npos) << repaired.out;
        EXPECT_LT(report().at("quality").at("farthest_move"), 0.01);
        const nlohmann::json counts = report().at("counts");
        const Outcome read = done({"mesh", "info", fixed, "--report", "report.json"});
        EXPECT_NE(read.out.find("repair: nothing to do\n"), std::string::npos) << fixed << ": " << read.out;
        for (const char* what : {"vertices", "triangles", "components", "borders", "euler_number"})
            EXPECT_EQ(report().at("counts").at(what), counts.at(what)) << fixed << ": " << what;
        EXPECT_NEAR(report().at("quality").at("area"), area, 1e-3 * area);
    }
}

TEST_F(MeshCommand, TheSampleIsMendedAndClosed) {
    const Outcome repaired = done({"mesh", "repair", FLG_SOURCES "/samples/data/owl.obj", "-o", "owl.ply"});
    for (const char* what : {"welded vertices", "duplicate triangles 1", "flipped triangles", "borders 0"})
        EXPECT_NE(repaired.out.find(what), std::string::npos) << repaired.out;
    done({"mesh", "info", "owl.ply", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("border_edges"), 0);
    EXPECT_EQ(report().at("counts").at("components"), 1);
}

// Two triangles of two regions; `tag` is of no use to a surface.
constexpr const char* kColumns =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property float radius\nelement face 2\nproperty list uchar int vertex_indices\nproperty int region\n"
    "property int tag\nend_header\n0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n3 0 1 2 7 1\n3 0 2 3 8 2\n";

TEST_F(MeshCommand, ColumnsAndRegionsAreCarriedAlong) {
    folder.write("a.ply", kColumns);
    for (const char* work : {"repair", "refine"}) {
        const Outcome outcome = done({"mesh", work, "a.ply", "-o", "b.ply"});
        EXPECT_NE(outcome.err.find("'tag' is not carried over"), std::string::npos) << outcome.err;
        done({"info", "b.ply", "--report", "report.json"});
        EXPECT_EQ(report().at("parameters").at("columns"), nlohmann::json({"position", "radius"})) << work;
        EXPECT_EQ(report().at("parameters").at("face_columns"), nlohmann::json({"region"})) << work;
        EXPECT_EQ(report().at("counts").at("regions"), 2) << work;
    }
    folder.write("square.off", square(1).off());
    done({"mesh", "repair", "square.off", "-o", "c.ply"});
    done({"info", "c.ply", "--report", "report.json"});
    EXPECT_TRUE(report().at("parameters").at("face_columns").empty());
}

TEST_F(MeshCommand, WeldingDecidesWhatHangsTogether) {
    const auto components = [&](const std::string& mesh, const std::string& weld) {
        done({"mesh", "info", mesh, "--weld", weld, "--report", "report.json"});
        return report().at("counts").at("components").get<int>();
    };
    TestMesh gap = square(1);
    gap.add_grid(1, [](double u, double v) { return Point{1.01 + u, v, 0.0}; });
    folder.write("gap.off", gap.off());
    EXPECT_EQ(components("gap.off", "0"), 2);
    EXPECT_EQ(components("gap.off", "0.02"), 1);
    folder.write("cube.off", cube(1).off());
    EXPECT_EQ(components("cube.off", "0"), 1);
    EXPECT_EQ(components("cube.off", "-1"), 6);
}

TEST_F(MeshCommand, RefiningMakesFourOfEach) {
    folder.write("cube.off", cube(1).off());
    done({"mesh", "refine", "cube.off", "-o", "fine.off", "--levels", "3", "--quiet", "--report", "report.json"});
    EXPECT_EQ(report().at("parameters").at("scheme"), "midpoint");
    EXPECT_EQ(report().at("counts").at("refined_triangles"), 12 * 64);
    EXPECT_EQ(report().at("counts").at("refined_vertices"), 12 * 64 / 2 + 2);  // Euler's formula
    EXPECT_DOUBLE_EQ(report().at("quality").at("refined_area"), 6.0);
    done({"mesh", "info", "fine.off", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("triangles"), 12 * 64);
    EXPECT_EQ(report().at("counts").at("welded_vertices"), 0);
    EXPECT_DOUBLE_EQ(report().at("quality").at("area"), 6.0);
}

TEST_F(MeshCommand, LoopsSchemeSmoothes) {
    // An octahedron. The four neighbours of a corner cancel each other; its own weight, by Loop, is
    // 1 - (5/8 - (3/8 + cos(2 pi / 4) / 4)^2) = 33/64.
    TestMesh octahedron;
    octahedron.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const size_t x : {0, 1}) {
        for (const size_t y : {2, 3}) {
            for (const size_t z : {4, 5}) {
                const bool outside = (x + y + z) % 2 == 0;
                octahedron.triangles.push_back({x, outside ? y : z, outside ? z : y});
            }
        }
    }
    folder.write("octahedron.off", octahedron.off());
    done({"mesh", "refine", "octahedron.off", "-o", "round.off", "--scheme", "loop", "--quiet"});
    std::istringstream text(folder.read("round.off"));
    std::string header;
    size_t vertices = 0, triangles = 0, edges = 0;
    text >> header >> vertices >> triangles >> edges;
    EXPECT_EQ(vertices, 6u + 12u);
    EXPECT_EQ(triangles, 32u);
    double x = 0, y = 0, z = 0;
    text >> x >> y >> z;
    EXPECT_NEAR(x, 33.0 / 64.0, 1e-6);
    EXPECT_EQ(y, 0.0);
    EXPECT_EQ(z, 0.0);
}

TEST_F(MeshCommand, SameBitsWhateverTheWorkersAndTheBudget) {
    folder.write("sphere.off", sphere(12).off());
    std::vector<std::string> first;
    for (const char* workers : {"0", "2"}) {
        for (const char* budget : {"0", "100"}) {
            done({"mesh", "repair", "sphere.off", "-o", "a.ply", "--quiet", "--workers", workers, "--budget", budget});
            done({"mesh", "refine", "sphere.off", "-o", "b.ply", "--scheme", "loop", "--quiet", "--workers", workers,
                  "--budget", budget});
            const std::vector<std::string> files = {folder.read("a.ply"), folder.read("b.ply")};
            if (first.empty()) first = files;
            EXPECT_TRUE(files == first) << workers << " workers, budget " << budget;
        }
    }
}

TEST_F(MeshCommand, BadUsageExitsWithTwo) {
    folder.write("square.off", square(1).off());
    expect_refused({"mesh"}, 2, {"subcommand"});
    expect_refused({"mesh", "mend"}, 2, {"mend"});
    expect_refused({"mesh", "info"}, 2, {"MESH"});
    expect_refused({"mesh", "repair", "square.off"}, 2, {"--output"});
    expect_refused({"mesh", "repair", "square.off", "-o", "out.stl"}, 2, {"out.stl", ".ply, .obj, .off or .glb"});
    for (const char* levels : {"0", "9", "-1", "many"}) {
        expect_refused({"mesh", "refine", "square.off", "-o", "out.off", "--levels", levels}, 2, {"--levels"});
    }
    expect_refused({"mesh", "refine", "square.off", "-o", "out.off", "--scheme", "butterfly"}, 2,
                   {"--scheme", "butterfly"});
    expect_refused({"mesh", "info", "square.off", "--weld", "nan"}, 2, {"--weld"});
    expect_refused({"mesh", "repair", "square.off", "-o", "out.off", "--report", "out.off"}, 2, {"out.off"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"square.off"});
}

TEST_F(MeshCommand, BadMeshesExitWithOneAndAreNamed) {
    expect_refused({"mesh", "info", "nosuch.ply"}, 1, {"nosuch.ply"});
    expect_refused({"mesh", "repair", "nosuch.ply", "-o", "out.ply"}, 1, {"nosuch.ply"});
    folder.write("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
    expect_refused({"mesh", "info", "points.off"}, 1, {"points.off", "no faces"});
    folder.write("lines.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 0\n3 2 2 2\n");
    expect_refused({"mesh", "repair", "lines.off", "-o", "out.ply", "--quiet"}, 1,
                   {"lines.off: ", "names a vertex twice"});
    folder.write("range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
    expect_refused({"mesh", "info", "range.off"}, 1, {"range.off:6: "});
    folder.write("square.off", square(1).off());
    expect_refused({"mesh", "repair", "square.off", "-o", "nosuch/out.ply"}, 1, {"nosuch/out.ply"});
    EXPECT_FALSE(folder.has("out.ply"));
}

TEST_F(MeshCommand, TooManyTrianglesAreRefused) {
    folder.write("large.off", square(96).off());  // 18,432 triangles, of which 8 levels would make 2^30 and more
    expect_refused({"mesh", "refine", "large.off", "-o", "out.ply", "--levels", "8"}, 1, {"large.off"});
    EXPECT_FALSE(folder.has("out.ply"));
}

}  // namespace
}  // namespace flg::test
