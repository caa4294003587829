// SPDX-License-Identifier: MIT
// filigree geodesic: distances against closed forms, and whose they are.
#include <algorithm>
#include <limits>

#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Geodesic : public Cli {
protected:
    // The distances that a run with these arguments writes.
    std::vector<double> distances(const std::string& mesh, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"geodesic", mesh,       "-o",         "field.txt",
                                              "--quiet",  "--report", "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
        std::istringstream text(folder.read("field.txt"));
        std::vector<double> values;
        for (std::string line; std::getline(text, line);) values.push_back(std::strtod(line.c_str(), nullptr));
        return values;
    }

    // Expects distances to be those in `expected`, up to a share of each.
    template <class Expected>
    void expect_distances(const TestMesh& mesh, const std::vector<double>& values, double share, Expected expected) {
        ASSERT_EQ(values.size(), mesh.points.size());
        for (size_t v = 0; v < values.size(); ++v) {
            const double wanted = expected(mesh.points[v]);
            EXPECT_NEAR(values[v], wanted, share * wanted + 1e-6) << "vertex " << v;
        }
    }
};

TEST_F(Geodesic, DistancesInThePlaneAreEuclidean) {
    const TestMesh mesh = square(16);
    folder.write("square.off", mesh.off());
    expect_distances(mesh, distances("square.off", {"--source", "0"}), 0.005,
                     [&](const Point& p) { return distance(p, mesh.points[0]); });
    EXPECT_EQ(report().at("command"), "geodesic");
    EXPECT_EQ(report().at("parameters").at("accuracy"), "refined");
    EXPECT_EQ(report().at("parameters").at("source"), nlohmann::json({"0"}));
    EXPECT_EQ(report().at("counts").at("sources"), 1);
    EXPECT_EQ(report().at("counts").at("reached_vertices"), mesh.points.size());
    EXPECT_NEAR(report().at("quality").at("furthest").get<double>(), std::sqrt(2.0), 0.005);

    // The nearest of several.
    expect_distances(mesh, distances("square.off", {"--source", "0;288;100"}), 0.005, [&](const Point& p) {
        return std::min({distance(p, mesh.points[0]), distance(p, mesh.points[288]), distance(p, mesh.points[100])});
    });
    EXPECT_EQ(report().at("counts").at("sources"), 3);
}

#if defined(FLG_WITH_PICK)
TEST_F(Geodesic, PointsInSpaceStandForTheNearestOfTheSurface) {
    const TestMesh mesh = square(16);
    folder.write("square.off", mesh.off());
    expect_distances(mesh, distances("square.off", {"--source", "0.37,0.61,0.25"}), 0.005, [](const Point& p) {
        return distance(p, {0.37, 0.61, 0.0});
    });
    EXPECT_NEAR(report().at("quality").at("source_gap").get<double>(), 0.25, 1e-6);
    expect_distances(mesh, distances("square.off", {"--source", "-3,0.5,4;288"}), 0.005, [](const Point& p) {
        return std::min(distance(p, {0.0, 0.5, 0.0}), distance(p, {1.0, 1.0, 0.0}));
    });
    EXPECT_NEAR(report().at("quality").at("source_gap").get<double>(), 5.0, 1e-6);
}
#endif

TEST_F(Geodesic, DistancesOnASphereAreAngles) {
    const TestMesh mesh = sphere(16);
    folder.write("sphere.off", mesh.off());
    const Point pole = mesh.points[8 * 17 + 8];  // the middle of the side -x
    // The polyhedron itself is up to 0.12 % smaller.
    expect_distances(mesh, distances("sphere.off", {"--source", "144"}), 0.003,
                     [&](const Point& p) { return 2 * std::asin(std::min(1.0, distance(p, pole) / 2)); });
}

TEST_F(Geodesic, AccuracyIsRefinedOrExact) {
    folder.write("square.off", square(16).off());
    const std::vector<double> unnamed = distances("square.off", {"--source", "0"});
    EXPECT_EQ(distances("square.off", {"--source", "0", "--accuracy", "refined"}), unnamed);
    EXPECT_EQ(report().at("parameters").at("accuracy"), "refined");
    const TestMesh round = sphere(8);
    folder.write("sphere.off", round.off());
    const std::vector<double> near = distances("sphere.off", {"--source", "3"});
    const std::vector<double> exact = distances("sphere.off", {"--source", "3", "--accuracy", "exact"});
    EXPECT_EQ(report().at("parameters").at("accuracy"), "exact");
    ASSERT_EQ(near.size(), exact.size());
    for (size_t v = 0; v < near.size(); ++v) EXPECT_NEAR(near[v], exact[v], 0.01 * exact[v]);
    EXPECT_NE(near, exact);
    expect_refused({"geodesic", "square.off", "--source", "0", "-o", "other.txt", "--accuracy", "graph"}, 2,
                   {"--accuracy", "'graph' is none of exact|refined"});
}

TEST_F(Geodesic, VerticesAreTheFilesAndInfWhereNoWayLeads) {
    // A strip of two triangles whose middle edge is there twice, a vertex in no triangle, and a piece apart.
    TestMesh mesh;
    mesh.points = {{7, 7, 7}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                   {0, 1, 0}, {1, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
    mesh.triangles = {{1, 2, 3}, {4, 6, 5}, {7, 8, 9}};
    folder.write("parts.off", mesh.off());
    const std::vector<double> values = distances("parts.off", {"--source", "1"});
    const std::vector<double> expected = {kInfinity, 0, 1, 1, 1, 1, std::sqrt(2.0), kInfinity, kInfinity, kInfinity};
    ASSERT_EQ(values.size(), expected.size());
    for (size_t v = 0; v < values.size(); ++v) {
        if (std::isinf(expected[v])) {
            EXPECT_EQ(values[v], expected[v]) << "vertex " << v;
        } else {
            EXPECT_NEAR(values[v], expected[v], 1e-6) << "vertex " << v;
        }
    }
    EXPECT_EQ(report().at("counts").at("reached_vertices"), 4);  // of the surface's
    const Outcome said = done({"geodesic", "parts.off", "--source", "4", "-o", "field.txt"});
    EXPECT_NE(said.err.find("was repaired first: welded vertices 2, unused vertices 1"), std::string::npos) << said.err;
}

TEST_F(Geodesic, FartherThanMaxDistanceIsInf) {
    const TestMesh mesh = square(16);
    folder.write("square.off", mesh.off());
    const std::vector<double> all = distances("square.off", {"--source", "0"});
    const std::vector<double> near = distances("square.off", {"--source", "0", "--max-distance", "0.6"});
    EXPECT_EQ(report().at("parameters").at("max_distance"), 0.6);
    size_t left_out = 0;
    for (size_t v = 0; v < all.size(); ++v) {
        EXPECT_EQ(near[v], all[v] <= 0.6 ? all[v] : kInfinity) << "vertex " << v;
        left_out += std::isinf(near[v]);
    }
    EXPECT_EQ(report().at("counts").at("reached_vertices"), all.size() - left_out);
    EXPECT_GT(left_out, 0u);
}

TEST_F(Geodesic, SameBitsWhateverTheWorkersAndTheBudget) {
    folder.write("sphere.off", sphere(20).off());
    std::string first;
    for (const char* workers : {"0", "2"}) {
        for (const char* budget : {"0", "100"}) {
            distances("sphere.off",
                      {"--source", "17;" + std::string(kPlace), "--workers", workers, "--budget", budget});
            const std::string field = folder.read("field.txt");
            if (first.empty()) first = field;
            EXPECT_TRUE(field == first) << workers << " workers, budget " << budget;
        }
    }
}

TEST_F(Geodesic, BadUsageExitsWithTwo) {
    folder.write("square.off", square(1).off());
    for (const char* source : {"", ";", "0;", "1;;2", "a", "1.5", "-1", "4294967296", "1,2", "1,2,3,4", "1,,3",
                               "nan,0,0", "0,inf,0", "1e31,0,0", "0,0,0x1", "0 "}) {
        expect_refused({"geodesic", "square.off", "--source", source, "-o", "field.txt"}, 2,
                       {"--source", "neither a vertex, V, nor a point, x,y,z"});
    }
    expect_refused({"geodesic", "square.off", "-o", "field.txt"}, 2, {"--source"});
    expect_refused({"geodesic", "square.off", "--source", "0"}, 2, {"--output"});
    expect_refused({"geodesic", "square.off", "--source", "0", "-o", "field.txt", "--accuracy", "graph"}, 2,
                   {"--accuracy", "graph"});
    for (const char* most : {"0", "-1", "nan", "inf"}) {
        expect_refused({"geodesic", "square.off", "--source", "0", "-o", "field.txt", "--max-distance", most}, 2,
                       {"--max-distance"});
    }
    expect_refused({"geodesic", "square.off", "--source", "0", "-o", "a.txt", "--report", "a.txt"}, 2, {"a.txt"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"square.off"});
}

TEST_F(Geodesic, BadInputExitsWithOneAndIsNamed) {
    TestMesh mesh = square(1);
    mesh.points.push_back({5, 5, 5});
    folder.write("square.off", mesh.off());
    const auto refused = [&](const std::string& file, const std::string& source,
                             const std::vector<std::string>& words) {
        expect_refused({"geodesic", file, "--source", source, "-o", "field.txt", "--quiet"}, 1, words);
    };
    refused("square.off", "5", {"square.off: --source: there is no vertex 5, they are 0 to 4"});
    if (!kHasPicking) refused("square.off", "0,0,0", {"square.off: --source: this build has no picking"});
    refused("square.off", "0;4", {"square.off: --source: vertex 4 is in no triangle"});
    refused("nosuch.off", "0", {"nosuch.off"});
    folder.write("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
    refused("points.off", "0", {"points.off", "no faces"});
    expect_refused({"geodesic", "square.off", "--source", "0", "-o", "nosuch/field.txt"}, 1, {"nosuch/field.txt"});
    EXPECT_FALSE(folder.has("field.txt"));
}

}  // namespace
}  // namespace flg::test
