// SPDX-License-Identifier: MIT
// filigree contour: areas of regions and places of lines against closed forms.
#include <algorithm>
#include <numeric>

#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

const double kPi = std::acos(-1.0);

class Contour : public Cli {
protected:
    void cut(const std::string& mesh, const std::string& source, const std::string& every,
             const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"contour", mesh,      "--source", source,     "--every",    every,
                                              "-o",      "out.ply", "--quiet",  "--report", "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
    }

    std::vector<double> areas() const { return report().at("quality").at("region_areas"); }
};

TEST_F(Contour, RegionsOfASphereAreCapsAndBelts) {
    folder.write("sphere.off", sphere(24).off());
    cut("sphere.off", "312", "0.5");  // from the middle of the side -x
    EXPECT_EQ(report().at("command"), "contour");
    EXPECT_EQ(report().at("parameters").at("every"), 0.5);
    const std::vector<double> found = areas();
    ASSERT_EQ(found.size(), 7u);  // pi / 0.5 lines
    for (size_t k = 0; k < found.size(); ++k) {
        const double near = 0.5 * static_cast<double>(k), far = std::min(near + 0.5, kPi);
        const double belt = 2 * kPi * (std::cos(near) - std::cos(far));
        EXPECT_NEAR(found[k], belt, 0.02 * belt + 0.01) << "region " << k;
    }
    EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.0), report().at("quality").at("area").get<double>(),
                1e-5);
    EXPECT_EQ(report().at("counts").at("cut_regions"), 7);

    // It stays a sphere, with nothing to repair.
    const nlohmann::json cut_counts = report().at("counts");
    const Outcome outcome = done({"mesh", "info", "out.ply", "--report", "info.json"});
    EXPECT_NE(outcome.out.find("regions 7\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("repair: nothing to do\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("components: 1, borders: 0 (0 edges), Euler number: 2"), std::string::npos)
        << outcome.out;
    EXPECT_EQ(report("info.json").at("counts").at("vertices"), cut_counts.at("cut_vertices"));
    EXPECT_EQ(report("info.json").at("counts").at("triangles"), cut_counts.at("cut_triangles"));
}

TEST_F(Contour, LinesLieAtTheirDistances) {
    folder.write("sphere.off", sphere(24).off());
    cut("sphere.off", "312", "0.5", {"--curves", "lines.xyz"});
    EXPECT_EQ(report().at("counts").at("isolines"), 6);
    std::istringstream text(folder.read("lines.xyz"));
    size_t points = 0;
    std::vector<double> levels;  // of the lines
    for (std::string line; std::getline(text, line);) {
        if (line == "# closed") levels.push_back(0.0);
        if (line.empty() || line[0] == '#') continue;
        Point p;
        std::istringstream(line) >> p[0] >> p[1] >> p[2];
        const double angle = std::acos(-p[0] / distance(p, {0, 0, 0}));
        ASSERT_FALSE(levels.empty());
        if (levels.back() == 0.0) levels.back() = std::round(angle / 0.5) * 0.5;
        EXPECT_NEAR(angle, levels.back(), 0.02);
        ++points;
    }
    std::sort(levels.begin(), levels.end());
    EXPECT_EQ(levels, (std::vector<double>{0.5, 1.0, 1.5, 2.0, 2.5, 3.0}));
    EXPECT_EQ(report().at("counts").at("isoline_points"), points);
}

TEST_F(Contour, RegionsCountTheLinesToTheNearestSource) {
    // Quarter discs about two corners.
    folder.write("square.off", square(24).off());
    cut("square.off", "0;624", "0.4");
    const std::vector<double> found = areas();
    ASSERT_EQ(found.size(), 3u);  // the furthest corners are at 1
    EXPECT_NEAR(found[0], 2 * kPi * 0.16 / 4, 0.01);
    EXPECT_NEAR(found[0] + found[1] + found[2], 1.0, 1e-6);

    // The triangles of the result, by their distances.
    done({"contour", "square.off", "--source", "0;624", "--every", "0.4", "-o", "out.obj", "--quiet"});
    std::istringstream text(folder.read("out.obj"));
    std::vector<Point> points;
    size_t region = 0, triangles = 0;
    std::vector<std::string> materials;
    for (std::string word; text >> word;) {
        if (word == "v") {
            Point p;
            text >> p[0] >> p[1] >> p[2];
            points.push_back(p);
        } else if (word == "usemtl") {
            std::string name;
            text >> name;
            const auto known = std::find(materials.begin(), materials.end(), name);
            region = static_cast<size_t>(known - materials.begin());
            if (known == materials.end()) materials.push_back(name);
        } else if (word == "f") {
            Point centre = {0, 0, 0};
            for (size_t k = 0; k < 3; ++k) {
                std::string corner;
                text >> corner;
                for (size_t i = 0; i < 3; ++i) centre[i] += points.at(std::stoul(corner) - 1)[i] / 3;
            }
            const double away = std::min(distance(centre, {0, 0, 0}), distance(centre, {1, 1, 0}));
            EXPECT_GT(away, 0.4 * static_cast<double>(region) - 0.01);
            EXPECT_LT(away, 0.4 * static_cast<double>(region + 1) + 0.01);
            ++triangles;
        }
    }
    EXPECT_EQ(materials.size(), 3u);
    EXPECT_EQ(triangles, report().at("counts").at("cut_triangles"));
}

TEST_F(Contour, SameBitsWhateverTheWorkersAndTheBudget) {
    folder.write("sphere.off", sphere(16).off());
    std::vector<std::string> first;
    for (const char* workers : {"0", "2"}) {
        for (const char* budget : {"0", "100"}) {
            cut("sphere.off", "17;" + std::string(kPlace), "0.1",
                {"--curves", "lines.xyz", "--workers", workers, "--budget", budget});
            const std::vector<std::string> files = {folder.read("out.ply"), folder.read("lines.xyz")};
            if (first.empty()) first = files;
            EXPECT_TRUE(files == first) << workers << " workers, budget " << budget;
        }
    }
}

TEST_F(Contour, BadUsageExitsWithTwo) {
    folder.write("square.off", square(1).off());
    const auto refused = [&](const std::vector<std::string>& more, const std::vector<std::string>& words) {
        std::vector<std::string> arguments = {"contour", "square.off"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_refused(arguments, 2, words);
    };
    for (const char* every : {"0", "-1", "nan", "inf", "wide"}) {
        refused({"--source", "0", "--every", every, "-o", "out.ply"}, {"--every"});
    }
    refused({"--source", "0", "-o", "out.ply"}, {"--every"});
    refused({"--every", "1", "-o", "out.ply"}, {"--source"});
    refused({"--source", "0", "--every", "1"}, {"--output"});
    refused({"--source", "0", "--every", "1", "-o", "out.off"}, {"out.off", "no place for regions"});
    refused({"--source", "0", "--every", "1", "-o", "out.xyz"}, {"out.xyz"});
    refused({"--source", "0", "--every", "1", "-o", "out.ply", "--curves", "lines.ply"}, {"lines.ply"});
    refused({"--source", "0", "--every", "1", "-o", "out.obj", "--curves", "out.obj"}, {"out.obj", "--curves"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"square.off"});
}

TEST_F(Contour, BadInputExitsWithOneAndIsNamed) {
    folder.write("square.off", square(1).off());
    const auto refused = [&](const std::string& every, const std::vector<std::string>& words) {
        expect_refused(
            {"contour", "square.off", "--source", "0", "--every", every, "-o", "out.ply", "--curves", "lines.xyz"}, 1,
            words);
    };
    refused("2", {"square.off: --every: the first line would be at 2", "furthest vertex is at 1.41"});
    refused("0.001", {"square.off: ", "more than 256"});
    expect_refused({"contour", "nosuch.ply", "--source", "0", "--every", "1", "-o", "out.ply"}, 1, {"nosuch.ply"});
    expect_refused({"contour", "square.off", "--source", "4", "--every", "1", "-o", "out.ply"}, 1,
                   {"square.off: --source: there is no vertex 4"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"square.off"});
}

}  // namespace
}  // namespace flg::test
