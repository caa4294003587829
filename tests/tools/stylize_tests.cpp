// SPDX-License-Identifier: MIT
// filigree stylize: its files, its report, and that nothing but the input decides about the bits.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "cli_test.h"

namespace flg::test {
namespace {

using Stylize = Cli;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

template <class T>
std::vector<T> numbers_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<T> numbers;
    for (T number; stream >> number;) numbers.push_back(number);
    return numbers;
}

// A straight line of a metre along x, in two curves with a gap.
constexpr const char* kTwoLines = "0 0 0\n0.25 0 0\n0.5 0 0\n\n1 0 0\n1.25 0 0\n1.5 0 0\n";

TEST_F(Stylize, ReportHasTheSchema) {
    done({"stylize",
          "--style",
          "builtin:zigzag",
          "--target",
          "builtin:flourish",
          "-o",
          "out.xyz",
          "--report",
          "report.json",
          "--seed",
          "7",
          "--workers",
          "1",
          "--budget",
          "500",
          "--sigma",
          "0.1",
          "--tau",
          "0.25",
          "--quiet"});
    const nlohmann::json json = report();
    EXPECT_EQ(json.at("command"), "stylize");
    EXPECT_EQ(json.at("version"), "0.1.0");
    EXPECT_EQ(json.at("seed"), 7);
    EXPECT_EQ(json.at("workers"), 1);
    EXPECT_EQ(json.at("parameters").at("sigma"), 0.1);
    EXPECT_EQ(json.at("parameters").at("tau"), 0.25);
    EXPECT_EQ(json.at("parameters").at("frame"), "rmf");
    EXPECT_EQ(json.at("counts").at("target_points"), 500);
    EXPECT_GT(json.at("counts").at("result_points"), 500);
    ASSERT_FALSE(json.at("stages").empty());
    for (const auto& [name, stage] : json.at("stages").items()) {
        EXPECT_GE(stage.at("wall_ms"), 0.0) << name;
        EXPECT_GE(stage.at("cpu_ms"), 0.0) << name;
    }
    const nlohmann::json& ticks = json.at("ticks");
    EXPECT_GE(ticks.at("count"), 1);
    EXPECT_EQ(ticks.at("budget_us"), 500);
    EXPECT_LE(ticks.at("p50_us"), ticks.at("p99_us"));
    EXPECT_LE(ticks.at("p99_us"), ticks.at("max_us"));
    EXPECT_GT(ticks.at("longest_chunk_us"), 0.0);
    EXPECT_TRUE(json.at("warnings").empty());
    for (const char* key : {"mean_copied_run", "displacement_rms", "guide_length", "matching_energy"}) {
        EXPECT_GT(json.at("quality").at(key), 0.0) << key;
    }
    EXPECT_GE(json.at("quality").at("jumps"), 0);
}

TEST_F(Stylize, AStraightStyleHasNothingToLearn) {
    folder.write("line.xyz", "0 0 0\n1 0 0\n2.5 0 0\n");
    done({"stylize", "--style", "line.xyz", "--target", "builtin:flourish", "-o", "out.xyz", "--scale", "1", "--report",
          "report.json", "--quiet"});
    EXPECT_NE(report().at("warnings").dump().find("nothing to learn"), std::string::npos);
}

// Less of it leaves waves in the guide, which is longer then.
TEST_F(Stylize, SmoothingIsTheGuides) {
    double before = 1e9;
    for (const char* smoothing : {"0.001", "1"}) {
        done({"stylize", "--style", "builtin:curls", "--smoothing", smoothing, "--target", "builtin:flourish", "-o",
              "out.xyz", "--report", "report.json", "--quiet"});
        const double length = report().at("quality").at("guide_length");
        EXPECT_LT(length, 0.98 * before) << smoothing;
        before = length;
    }
    const Outcome outcome = run(
        {"stylize", "--style", "builtin:curls", "--smoothing", "0", "--target", "builtin:flourish", "-o", "out.xyz"});
    EXPECT_EQ(outcome.status, 2);
}

TEST_F(Stylize, SameBitsWhateverTheWorkersAndTheBudget) {
    const std::vector<std::string> work = {"stylize",
                                           "--style",
                                           "builtin:loops",
                                           "--target",
                                           "builtin:lorenz:3000",
                                           "--tau",
                                           "0.5",
                                           "--start",
                                           "random",
                                           "-o",
                                           "out.xyz",
                                           "--quiet",
                                           "--save-path",
                                           "path.txt",
                                           "--save-guide",
                                           "guide.xyz",
                                           "--save-matching",
                                           "matching.txt"};
    std::vector<std::string> first;
    for (const char* workers : {"0", "1", "2"}) {
        for (const char* budget : {"0", "100", "1500"}) {
            std::vector<std::string> arguments = work;
            arguments.insert(arguments.end(), {"--workers", workers, "--budget", budget});
            done(arguments);
            std::vector<std::string> files;
            for (const char* name : {"out.xyz", "path.txt", "guide.xyz", "matching.txt"}) {
                files.push_back(folder.read(name));
                EXPECT_FALSE(files.back().empty()) << name;
            }
            if (first.empty()) first = files;
            EXPECT_TRUE(files == first) << workers << " workers, budget " << budget;
        }
    }
}

TEST_F(Stylize, TheSeedDecidesAboutRandomStarts) {
    const std::vector<std::string> work = {"stylize", "--style", "builtin:loops", "--target", "builtin:spiral",
                                           "--start", "random",  "--tau",         "0.5",      "-o",
                                           "out.xyz", "--seed"};
    std::vector<std::string> results;
    for (const char* seed : {"1", "2", "1"}) {
        std::vector<std::string> arguments = work;
        arguments.push_back(seed);
        done(arguments);
        results.push_back(folder.read("out.xyz"));
    }
    EXPECT_NE(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST_F(Stylize, MatchingHasAnArcLengthOnTheStyleForEachGuidePoint) {
    done({"stylize", "--style", "builtin:curls", "--target", "builtin:s_curve", "-o", "out.xyz", "--save-matching",
          "m.txt", "--save-guide", "guide.xyz", "--report", "report.json"});
    const std::vector<double> matching = numbers_of<double>(folder.read("m.txt"));
    const nlohmann::json json = report();
    EXPECT_EQ(matching.size(), json.at("counts").at("style_points"));
    const double style_length = json.at("quality").at("style_length");
    for (size_t i = 0; i < matching.size(); ++i) {
        EXPECT_GE(matching[i], i == 0 ? 0.0 : matching[i - 1]) << "at " << i;
        EXPECT_LE(matching[i], style_length * 1.000001);
    }
    EXPECT_EQ(numbers_of<double>(folder.read("guide.xyz")).size(), 3 * matching.size());
}

TEST_F(Stylize, PathHasAStyleIndexForEachSampleAndALineForEachCurve) {
    folder.write("target.xyz", kTwoLines);
    done({"stylize", "--style", "builtin:zigzag", "--target", "target.xyz", "-o", "out.xyz", "--save-path", "p.txt",
          "--scale", "0.3", "--report", "report.json"});
    const nlohmann::json json = report();
    const std::vector<std::string> lines = lines_of(folder.read("p.txt"));
    EXPECT_EQ(lines.size(), 2u);
    EXPECT_EQ(json.at("counts").at("target_curves"), 2);
    size_t samples = 0, jumps = 0;
    for (const std::string& line : lines) {
        const std::vector<long> indices = numbers_of<long>(line);
        samples += indices.size();
        for (size_t i = 0; i < indices.size(); ++i) {
            EXPECT_GE(indices[i], 0);
            EXPECT_LT(indices[i], json.at("counts").at("style_points"));
            jumps += i > 0 && indices[i] != indices[i - 1] + 1;
        }
    }
    EXPECT_EQ(samples, json.at("counts").at("result_points"));
    EXPECT_EQ(jumps, json.at("quality").at("jumps"));
    EXPECT_DOUBLE_EQ(json.at("quality").at("mean_copied_run"),
                     static_cast<double>(samples) / static_cast<double>(jumps + 2));
}

TEST_F(Stylize, WithoutMagnitudeTheTargetComesBack) {
    folder.write("target.xyz", kTwoLines);
    done({"stylize", "--style", "builtin:zigzag", "--target", "target.xyz", "-o", "out.xyz", "--sigma", "0"});
    for (const std::string& line : lines_of(folder.read("out.xyz"))) {
        const std::vector<double> p = numbers_of<double>(line);
        if (line.empty() || line[0] == '#') continue;
        ASSERT_GE(p.size(), 3u);
        EXPECT_GE(p[0], -1e-6);
        EXPECT_LE(p[0], 1.5 + 1e-6);
        EXPECT_NEAR(p[1], 0.0, 1e-6);
        EXPECT_NEAR(p[2], 0.0, 1e-6);
    }
}

// A curve that is as large as the example's guide gets the style as it was drawn.
TEST_F(Stylize, TheStyleKeepsTheExamplesProportion) {
    done({"stylize", "--style", "builtin:curls", "--target", "builtin:s_curve", "-o", "any.xyz", "--save-guide",
          "guide.xyz"});
    const std::vector<std::string> work = {"stylize", "--style", "builtin:curls", "--target", "guide.xyz", "-o"};
    std::vector<std::string> as_drawn = work, relative = work;
    as_drawn.insert(as_drawn.end(), {"drawn.xyz", "--scale", "1"});
    relative.insert(relative.end(), {"relative.xyz", "--scale", "auto"});
    done(as_drawn);
    done(relative);
    EXPECT_EQ(folder.read("relative.xyz"), folder.read("drawn.xyz"));

    // And one ten times as large, the same ten times as large.
    std::string large;
    for (const std::string& line : lines_of(folder.read("guide.xyz"))) {
        std::vector<double> p = numbers_of<double>(line);
        ASSERT_GE(p.size(), 3u) << line;
        char text[96];
        std::snprintf(text, sizeof text, "%.9g %.9g %.9g\n", 10 * p[0], 10 * p[1], 10 * p[2]);
        large += text;
    }
    folder.write("guide.xyz", large);
    relative[6] = "large.xyz";
    done(relative);
    const std::vector<double> small = numbers_of<double>(folder.read("relative.xyz")),
                              tenfold = numbers_of<double>(folder.read("large.xyz"));
    ASSERT_EQ(small.size(), tenfold.size());
    for (size_t i = 0; i < small.size(); ++i) EXPECT_NEAR(tenfold[i], 10 * small[i], 1e-3) << i;
}

TEST_F(Stylize, SizesAreEachStrokesOwn) {
    // A stroke of 2 m, one of 2 cm, and a thick one of 2 m.
    folder.write("target.xyz",
                 "0 0 0 1\n1 0 0 1\n2 0 0 1\n\n0 3 0 1\n0.01 3 0 1\n0.02 3 0 1\n\n"
                 "0 6 0 0.02\n1 6 0 0.02\n2 6 0 0.02\n");
    done(
        {"stylize", "--style", "builtin:zigzag", "--target", "target.xyz", "-o", "out.xyz", "--report", "report.json"});
    EXPECT_EQ(report().at("parameters").at("scale"), "auto");
    double farthest[3] = {}, radius[3] = {};
    size_t curve = 0;
    for (const std::string& line : lines_of(folder.read("out.xyz"))) {
        const std::vector<double> p = numbers_of<double>(line);
        if (p.empty()) {
            ++curve;
            continue;
        }
        ASSERT_LT(curve, 3u);
        farthest[curve] = std::max(farthest[curve], std::hypot(p[1] - 3.0 * static_cast<double>(curve), p[2]));
        radius[curve] = p.at(3);
    }
    EXPECT_EQ(curve, 2u);
    EXPECT_GT(farthest[0], 0.02);
    EXPECT_NEAR(farthest[1], 0.01 * farthest[0], 0.2 * 0.01 * farthest[0]);  // in the proportion of the example
    EXPECT_LT(farthest[2], 0.2);                                             // some radii
    EXPECT_GT(farthest[2], 0.02);
    EXPECT_LT(radius[2], 0.3 * 0.02);  // thinner, so that turns stay apart
}

TEST_F(Stylize, TheLibraryIsListedAndWritten) {
    const std::string list = done({"styles"}).out;
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 24);
    EXPECT_TRUE(folder.list().empty());
    EXPECT_EQ(done({"styles", "-o", "library"}).out, list);
    done({"stylize", "--style", "builtin:hearts", "--target", "builtin:s_curve", "-o", "a.xyz"});
    done({"stylize", "--style", "library/hearts.xyz", "--target", "builtin:s_curve", "-o", "b.xyz"});
    EXPECT_EQ(folder.read("a.xyz"), folder.read("b.xyz"));

    // The SDK's copies are these.
    size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(FLG_SOURCES "/sdk/data/styles")) {
        if (entry.path().extension() != ".xyz") continue;
        ++files;
        std::ifstream stream(entry.path());
        const std::string kept{std::istreambuf_iterator<char>(stream), {}};
        const std::vector<std::string> theirs = lines_of(kept);
        const std::vector<std::string> ours = lines_of(folder.read("library/" + entry.path().filename().string()));
        ASSERT_EQ(ours.size(), theirs.size()) << entry.path();
        for (size_t i = 0; i < ours.size(); ++i) {
            const std::vector<double> a = numbers_of<double>(ours[i]), b = numbers_of<double>(theirs[i]);
            ASSERT_EQ(a.size(), b.size()) << entry.path() << ", line " << i + 1;
            for (size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-6) << entry.path() << ", line " << i + 1;
        }
    }
    EXPECT_EQ(files, 24u);
}

TEST_F(Stylize, ASketchKeepsItsColoursAndItsBrushesShapes) {
    const std::string sketch = FLG_SOURCES "/samples/data/snail.tilt";
    const std::vector<std::string> commands[] = {
        {"stylize", "--style", "builtin:loops", "--target", sketch, "-o", "out.glb"},
        {"replay", sketch, "--style", "builtin:loops", "-o", "out.glb", "--fast"}};
    for (const std::vector<std::string>& command : commands) {
        for (const char* quantize : {"", "--quantize"}) {
            std::vector<std::string> arguments = command;
            if (*quantize != '\0') arguments.push_back(quantize);
            done(arguments);
            const std::string glb = folder.read("out.glb");
            const uint32_t length = *reinterpret_cast<const uint32_t*>(glb.data() + 12);
            const nlohmann::json json = nlohmann::json::parse(glb.substr(20, length));
            std::set<bool> double_sided;
            for (const nlohmann::json& mesh : json.at("meshes")) {
                for (const nlohmann::json& primitive : mesh.at("primitives")) {
                    EXPECT_TRUE(primitive.at("attributes").contains("COLOR_0"));
                    const size_t material = primitive.at("material");
                    double_sided.insert(json.at("materials").at(material).value("doubleSided", false));
                }
            }
            EXPECT_EQ(double_sided.size(), 2u) << command[0];  // ribbons and tubes
            EXPECT_EQ(json.contains("extensionsRequired"), *quantize != '\0');
            const std::string info = done({"info", "out.glb"}).out;
            EXPECT_NE(info.find("columns: position color"), std::string::npos) << info;
        }
    }
    done({"stylize", "--style", "builtin:loops", "--target", sketch, "-o", "lines.glb", "--as", "lines"});
    EXPECT_NE(done({"info", "lines.glb"}).out.find("curves: 25"), std::string::npos);
    expect_refused({"stylize", "--style", "builtin:loops", "--target", sketch, "-o", "a.xyz", "--quantize"}, 2,
                   {"--quantize", "a.xyz"});
    expect_refused({"stylize", "--style", "builtin:loops", "--target", "builtin:flourish", "-o", "a.glb", "--quantize"},
                   2, {"--quantize", "a.glb", "--as"});
    expect_refused({"stylize", "--style", "builtin:loops", "--target", sketch, "-o", "a.glb", "--tolerance", "-1"}, 2,
                   {"--tolerance", "-1"});
}

TEST_F(Stylize, ToleranceLeavesTheLinesThePointsThatTheyNeed) {
    std::vector<uint64_t> counts;
    for (const char* tolerance : {"auto", "0", "0.0005", "0.01"}) {
        done({"stylize", "--style", "builtin:curls", "--target", "builtin:spiral", "-o", "out.xyz", "--columns",
              "--tolerance", tolerance, "--report", "report.json", "--save-path", "path.txt"});
        counts.push_back(report().at("counts").at("written_points"));
        const std::vector<std::string> lines = lines_of(folder.read("out.xyz"));
        EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& l) { return !l.empty() && l[0] != '#'; }),
                  static_cast<ptrdiff_t>(counts.back()));
        EXPECT_EQ(report().at("counts").at("result_points"), counts[0]);
    }
    EXPECT_EQ(counts[1], counts[0]);
    EXPECT_LT(counts[2], counts[1]);
    EXPECT_LT(counts[3], counts[2]);
}

TEST_F(Stylize, RadiiAreCarriedOver) {
    folder.write("target.xyz", "0 0 0 0.25\n1 0 0 0.25\n2 0 0 0.25\n");
    done({"stylize", "--style", "builtin:zigzag", "--target", "target.xyz", "-o", "out.xyz", "--scale", "1"});
    for (const std::string& line : lines_of(folder.read("out.xyz"))) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<double> p = numbers_of<double>(line);
        ASSERT_EQ(p.size(), 4u) << line;
        EXPECT_NEAR(p[3], 0.25, 1e-6);
    }
}

TEST_F(Stylize, SeveralStyleCurvesBecomeOneStyle) {
    const std::string first = "0 0 0\n0.3 0.1 0\n0.6 -0.1 0\n1 0 0\n";
    folder.write("one.xyz", first);
    folder.write("two.xyz", first + "\n5 5 5\n6 5.5 5\n7 4.5 5\n9 5 5\n");
    done({"stylize", "--style", "one.xyz", "--target", "builtin:spiral", "-o", "a.xyz"});
    done({"stylize", "--style", "two.xyz", "--target", "builtin:spiral", "-o", "b.xyz", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("style_curves"), 2);
    EXPECT_GT(report().at("quality").at("style_length"), 4.0);
    EXPECT_NE(folder.read("a.xyz"), folder.read("b.xyz"));
}

TEST_F(Stylize, AStyleFileGivesTheSameBits) {
    done({"stylize", "--style", "builtin:curls", "--style-file", "curls.style", "--target", "builtin:spiral", "-o",
          "a.xyz"});
    done({"stylize", "--style-file", "curls.style", "--target", "builtin:spiral", "-o", "b.xyz", "--report",
          "report.json"});
    EXPECT_EQ(folder.read("a.xyz"), folder.read("b.xyz"));
    EXPECT_FALSE(report().at("stages").contains("guide_flow"));
}

TEST_F(Stylize, StyleFilesThatAreNoneAreRefused) {
    folder.write("no.style", "nothing of the kind");
    expect_refused({"stylize", "--style-file", "no.style", "--target", "builtin:spiral", "-o", "a.xyz"}, 1,
                   {"no.style"});
    expect_refused({"stylize", "--style-file", "absent.style", "--target", "builtin:spiral", "-o", "a.xyz"}, 1,
                   {"absent.style", "opened"});
    expect_refused(
        {"stylize", "--style-file", "no.style", "--alpha", "0.3", "--target", "builtin:spiral", "-o", "a.xyz"}, 2,
        {"--alpha"});
    expect_refused({"stylize", "--target", "builtin:spiral", "-o", "a.xyz"}, 2, {"--style"});
}

// First and last points of the curves of an .xyz file.
std::vector<std::string> ends_of(const std::string& text) {
    std::vector<std::string> ends;
    std::string last;
    const auto end_curve = [&] {
        if (!last.empty()) ends.push_back(last);
        last.clear();
    };
    for (const std::string& line : lines_of(text)) {
        if (line.empty()) {
            end_curve();
        } else if (line[0] != '#') {
            if (last.empty()) ends.push_back(line);
            last = line;
        }
    }
    end_curve();
    return ends;
}

TEST_F(Stylize, NetworksStayConnectedInTheFile) {
    const std::vector<std::string> work = {
        "stylize", "--style", "builtin:knots", "--target", "builtin:icosahedron", "--scale", "0.2", "-o"};
    std::vector<std::string> pinned = work, loose = work;
    pinned.insert(pinned.end(), {"net.xyz", "--network"});
    loose.push_back("loose.xyz");
    done(pinned);
    done(loose);
    const auto places = [&](const char* file) {
        const std::vector<std::string> ends = ends_of(folder.read(file));
        EXPECT_EQ(ends.size(), 180u) << file;
        return std::set<std::string>(ends.begin(), ends.end()).size();
    };
    EXPECT_EQ(places("net.xyz"), 60u);
    EXPECT_EQ(places("loose.xyz"), 180u);
}

TEST_F(Stylize, StrokesMultiplyTheCurvesAndClosedOnesComeBackClosed) {
    done({"stylize", "--style", "builtin:braid", "--target", "builtin:vine", "--strokes", "3", "-o", "vine.xyz"});
    const std::string vine = folder.read("vine.xyz");
    EXPECT_EQ(ends_of(vine).size(), 6u);
    size_t closed = 0;
    for (const std::string& line : lines_of(vine)) closed += line == "# closed";
    EXPECT_EQ(closed, 3u);

    folder.write("square.xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
    done({"stylize", "--style", "builtin:braid", "--target", "square.xyz", "--closed", "-o", "square-out.xyz"});
    EXPECT_NE(folder.read("square-out.xyz").find("# closed"), std::string::npos);
}

TEST_F(Stylize, AttributesComeFromTheStyle) {
    const auto radii = [&](const std::vector<std::string>& more) {
        std::vector<std::string> work = {"stylize", "--style", "builtin:beads", "--target", "builtin:tree", "--scale",
                                         "0.2",     "-o",      "out.xyz"};
        work.insert(work.end(), more.begin(), more.end());
        done(work);
        double most = 0.0;
        for (const std::string& line : lines_of(folder.read("out.xyz"))) {
            if (!line.empty() && line[0] != '#') most = std::max(most, numbers_of<double>(line).at(3));
        }
        return most;
    };
    // The trunk is as thick as it is; the thickest bead is below 24 mm, at a fifth of its size.
    EXPECT_GT(radii({}), 0.01);
    EXPECT_LT(radii({"--attributes", "radius,color"}), 0.005);
    EXPECT_LT(radii({"--attributes", "radius:0.5"}), 0.005);
}

// A coil of all kinds of columns, as text.
std::string rich_coil() {
    std::string text =
        "# columns x y z radius radii_0 radii_1 radii_2 angle width speed red green blue user0 user5_0 user5_1\n";
    char line[256];
    for (int i = 0; i < 200; ++i) {
        const double t = 0.25 * i, u = i / 199.0;
        std::snprintf(line, sizeof line, "%.6f %.6f %.6f %g %g %g %g %g %g %g %g %g %g %g %g %g\n", 0.02 * i,
                      0.1 * std::cos(t), 0.1 * std::sin(t), 0.01 + 0.01 * u, 0.02, 0.01 + 0.01 * u, t, t, 0.1 + u,
                      1 + u, u, 1 - u, 0.5, u, u, -u);
        text += line;
    }
    return text;
}

TEST_F(Stylize, EveryKindOfColumnGoesFromFileToFile) {
    folder.write("style.xyz", rich_coil());
    const char* all = "radius:0.5,radii,angle:0,width,speed,color:0,user0:0.1,user5";
    for (const std::string format : {"xyz", "glb"}) {
        done({"stylize", "--style", "style.xyz", "--target", "builtin:flourish", "-o", "out." + format, "--attributes",
              all, "--columns", "--quiet", "--report", "report.json"});
        EXPECT_EQ(report().at("parameters").at("attributes").back(), "user5");
        const std::string info = done({"info", "out." + format}).out;
        for (const char* name : {" radius", " radii", " angle", " width", " speed", " color", " user0", " user5",
                                 " normal", " time", " style_index", " displacement"}) {
            EXPECT_NE(info.find(name), std::string::npos) << name << " in " << info;
        }
        // What came out is a style as well.
        done({"stylize", "--style", "out." + format, "--target", "builtin:flourish", "-o", "again.xyz", "--attributes",
              all, "--quiet"});
    }
    EXPECT_EQ(folder.read("out.xyz").rfind("# columns x y z radius nx ny nz", 0), std::string::npos);
    EXPECT_EQ(folder.read("out.xyz").rfind("# columns x y z radius tangent_0", 0), 0u);
    // Without --columns the lines are plain; colours are comments.
    for (const std::string& line : lines_of(folder.read("again.xyz"))) {
        if (line.starts_with("# color ")) continue;
        ASSERT_EQ(numbers_of<float>(line).size(), 4u);
    }
    expect_refused(
        {"stylize", "--style", "style.xyz", "--target", "builtin:flourish", "-o", "x.xyz", "--attributes", "user1"}, 1,
        {"no column", "USER + 1"});
    expect_refused(
        {"stylize", "--style", "style.xyz", "--target", "builtin:flourish", "-o", "x.xyz", "--attributes", "user"}, 2,
        {"'user' is none of", "user0"});
    expect_refused({"stylize", "--style", "style.xyz", "--target", "builtin:flourish", "-o", "x.obj", "--columns"}, 2,
                   {"--columns", "x.obj holds no columns"});
}

TEST_F(Stylize, ColumnsOfTheTargetSteerTheStyle) {
    std::string target = "# columns x y z pressure\n";
    for (int i = 0; i <= 50; ++i) target += std::to_string(0.1 * i) + " 0 0 " + std::to_string(0.02 * i) + "\n";
    folder.write("target.xyz", target);
    const std::vector<std::string> stylize = {"stylize",    "--style", "builtin:loops", "--target",
                                              "target.xyz", "-o",      "out.xyz",       "--scale",
                                              "0.1",        "--quiet", "--report",      "report.json"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = stylize;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    done(with({"--drive", "pressure=magnitude:0:1,pressure:0.5:1=temperature:0:1"}));
    EXPECT_EQ(report().at("parameters").at("drive").size(), 2u);
    const std::vector<std::string> driven = lines_of(folder.read("out.xyz"));
    EXPECT_NEAR(numbers_of<float>(driven.front()).at(1), 0, 1e-6);
    EXPECT_GT(std::abs(numbers_of<float>(driven.back()).at(1)) + std::abs(numbers_of<float>(driven.back()).at(2)), 0);
    done(with({"--drive", "pressure=scale:0.5:0.5"}));
    EXPECT_GT(lines_of(folder.read("out.xyz")).size(), driven.size() * 19 / 10);
    for (const char* wrong : {"pressure", "pressure=size:0:1", "weight=scale:1:2", "pressure=scale:1",
                              "pressure:1=scale:1:2", "pressure=scale:a:2", "=", ""}) {
        expect_refused(with({"--drive", wrong}), 2, {"--drive"});
    }
    expect_refused(with({"--drive", "width=scale:1:2"}), 1, {"--drive width=scale:1:2", "no such column"});
    expect_refused(with({"--drive", "speed=scale:1:2"}), 1, {"--drive speed=scale:1:2", "no times"});
    expect_refused(with({"--drive", "pressure=scale:0:2"}), 1, {"--drive pressure=scale:0:2: A is 0", "above 0"});
}

TEST_F(Stylize, EndsAreFittedToTheTarget) {
    const auto indices = [&](std::vector<std::string> more) {
        std::vector<std::string> all = {"stylize",     "--style", "builtin:zigzag", "--target", "builtin:flourish",
                                        "-o",          "out.xyz", "--scale",        "0.05",     "--quiet",
                                        "--save-path", "path.txt"};
        all.insert(all.end(), more.begin(), more.end());
        done(all);
        return numbers_of<uint32_t>(folder.read("path.txt"));
    };
    const std::vector<uint32_t> copied = indices({}), fitted = indices({"--fit", "1"});
    EXPECT_EQ(fitted.front(), 0u);
    EXPECT_GT(fitted.back(), *std::max_element(copied.begin(), copied.end()) - 1);
    const std::vector<uint32_t> capped = indices({"--caps", "0.1:0.2"});
    EXPECT_EQ(capped.front(), 0u);
    EXPECT_EQ(capped.back(), fitted.back());
    indices({"--caps", "auto"});
    expect_refused(
        {"stylize", "--style", "builtin:zigzag", "--target", "builtin:flourish", "-o", "a.xyz", "--caps", "1"}, 2,
        {"--caps"});
    expect_refused(
        {"stylize", "--style", "builtin:zigzag", "--target", "builtin:flourish", "-o", "a.xyz", "--fit", "2"}, 2,
        {"--fit"});
    // What has no effect together.
    const auto refused = [&](const std::vector<std::string>& more, int status, const std::vector<std::string>& words) {
        std::vector<std::string> all = {"stylize", "--style", "builtin:zigzag", "--target", "builtin:flourish",
                                        "-o",      "a.xyz",   "--fit",          "1"};
        all.insert(all.end(), more.begin(), more.end());
        expect_refused(all, status, words);
    };
    refused({"--tau", "1"}, 2, {"--tau"});
    refused({"--start", "random"}, 2, {"--start"});
    refused({"--strokes", "3"}, 2, {"--strokes"});
    refused({"--closed"}, 2, {"--fit", "--closed"});
    expect_refused({"stylize", "--style", "builtin:zigzag", "--target", "builtin:ring", "-o", "a.xyz", "--fit", "1"}, 1,
                   {"--fit", "closed"});
    expect_refused(
        {"stylize", "--style", "builtin:zigzag", "--target", "builtin:flourish", "-o", "a.xyz", "--caps", "50:50"}, 1,
        {"--caps gives 50 and 50 m", "the example, ", " m long"});
}

constexpr const char* kSquare = "# closed\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n";

TEST_F(Stylize, CornersAreMitredOrGetMotifs) {
    folder.write("square.xyz", kSquare);
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = {"stylize",  "--style",     "builtin:zigzag", "--target", "square.xyz",
                                        "-o",       "out.xyz",     "--scale",        "0.1",      "--quiet",
                                        "--report", "report.json", "--save-path",    "path.txt"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    done(with({}));
    const std::string plain = folder.read("out.xyz");
    EXPECT_FALSE(report().at("parameters").contains("corners"));
    done(with({"--corners", "through"}));
    EXPECT_EQ(folder.read("out.xyz"), plain);
    done(with({"--corners", "mitre"}));
    EXPECT_NE(folder.read("out.xyz"), plain);
    EXPECT_EQ(report().at("parameters").at("corners"), "mitre");
    done(with({"--corners", "mitre", "--corner-angle", "100"}));
    EXPECT_EQ(folder.read("out.xyz"), plain);
    done(with({"--corners", "motif", "--fit", "0.5"}));
    const std::vector<uint32_t> index = numbers_of<uint32_t>(folder.read("path.txt"));
    for (size_t side = 0; side < 4; ++side) EXPECT_EQ(index[side * index.size() / 4], 0u);
    done(with({"--corners", "motif", "--corner-caps", "--caps", "0.1:0.2"}));
    EXPECT_EQ(report().at("parameters").at("corner_caps"), true);
    expect_refused(with({"--corners", "round"}), 2, {"--corners"});
    expect_refused(with({"--corners", "mitre", "--corner-caps", "--caps", "0.1:0.2"}), 2, {"--corner-caps"});
    expect_refused(with({"--corners", "motif", "--corner-caps"}), 2, {"--corner-caps", "--caps"});
    expect_refused(with({"--corner-angle", "40"}), 2, {"--corner-angle", "--corners"});
    expect_refused(with({"--corners", "motif", "--tau", "1"}), 2, {"--tau"});
    expect_refused(with({"--corner-angle", "180"}), 2, {"--corner-angle"});
    expect_refused(with({"--smooth-junctions"}), 2, {"--smooth-junctions"});
}

TEST_F(Stylize, JunctionsOfNetworksAreSmooth) {
    folder.write("network.xyz", "0 0 0\n1 0 0\n\n1 0 0\n2 0.2 0\n\n1 0 0\n1 1 0\n");
    const std::vector<std::string> network = {"stylize", "--style",   "builtin:wave", "--target", "network.xyz", "-o",
                                              "out.xyz", "--network", "--scale",      "0.02",     "--quiet"};
    done(network);
    const std::string plain = folder.read("out.xyz");
    std::vector<std::string> smooth = network;
    smooth.emplace_back("--smooth-junctions");
    done(smooth);
    EXPECT_NE(folder.read("out.xyz"), plain);
}

TEST_F(Stylize, SeveralStylesAreChosenAmong) {
    std::string target = "# columns x y z pressure\n";
    for (int i = 0; i <= 50; ++i) target += std::to_string(0.1 * i) + " 0 0 " + std::to_string(0.02 * i) + "\n";
    folder.write("target.xyz", target);
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = {"stylize", "--style", "builtin:loops", "--target", "target.xyz", "-o",
                                        "out.xyz", "--scale", "0.1",           "--quiet",  "--report",   "report.json"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    done(with({"--style", "builtin:zigzag", "--drive", "pressure=style:0:1", "--style-blend", "0.5"}));
    EXPECT_EQ(report().at("parameters").at("style").size(), 2u);
    EXPECT_EQ(report().at("parameters").at("style_blend"), 0.5);
    const std::string mixed = folder.read("out.xyz");
    done(with({"--style", "builtin:zigzag", "--drive", "pressure=style:0:0"}));
    EXPECT_NE(folder.read("out.xyz"), mixed);
    expect_refused(with({"--style", "builtin:zigzag"}), 2, {"--style", "no --drive"});
    expect_refused(with({"--drive", "pressure=style:0:1"}), 2, {"--drive pressure=style:0:1", "one --style"});
    const std::vector<std::string> two = {"--style", "builtin:zigzag", "--drive"};
    const auto choosing = [&](std::vector<std::string> more) {
        std::vector<std::string> all = two;
        all.insert(all.end(), more.begin(), more.end());
        return with(all);
    };
    expect_refused(choosing({"pressure=style:0:2"}), 2, {"--drive pressure=style:0:2", "0 to 1"});
    expect_refused(choosing({"pressure=style:0:1", "--save-guide", "g.xyz"}), 2, {"--save-guide"});
    expect_refused(choosing({"pressure=style:0:1", "--save-matching", "m.txt"}), 2, {"--save-matching"});
    expect_refused(with({"--style-blend", "1"}), 2, {"--style-blend", "one --style"});
    expect_refused(with({"--style", "builtin:zigzag", "--style-file", "s.flg"}), 2, {"--style-file"});
    expect_refused(with({"--style-blend", "-1"}), 2, {"--style-blend"});
}

TEST_F(Stylize, FramesComeFromTheTargetsFile) {
    folder.write("style.xyz", rich_coil());
    std::string target = "# columns x y z nx ny nz\n";
    for (int i = 0; i < 60; ++i) {
        char line[128];
        std::snprintf(line, sizeof line, "%g 0 0 0 %.7f %.7f\n", 0.1 * i, std::cos(0.1 * i), std::sin(0.1 * i));
        target += line;
    }
    folder.write("target.xyz", target);
    done({"stylize", "--style", "style.xyz", "--target", "target.xyz", "-o", "out.xyz", "--frame", "supplied",
          "--columns", "--quiet"});
    // x y z, tangent, normal: turned as the file says, up to its interpolation.
    size_t looked_at = 0;
    for (const std::string& line : lines_of(folder.read("out.xyz"))) {
        const std::vector<double> n = numbers_of<double>(line);
        if (n.size() < 9) continue;
        ++looked_at;
        EXPECT_NEAR(n[6], 0, 1e-6);
        EXPECT_NEAR(n[7] * n[7] + n[8] * n[8], 1, 1e-5);
    }
    EXPECT_GT(looked_at, 100u);
    const std::string supplied = folder.read("out.xyz");
    done({"stylize", "--style", "style.xyz", "--target", "target.xyz", "-o", "out.xyz", "--columns", "--quiet"});
    EXPECT_NE(folder.read("out.xyz"), supplied);
    folder.write("bare.xyz", kTwoLines);
    expect_refused({"stylize", "--style", "style.xyz", "--target", "bare.xyz", "-o", "x.xyz", "--frame", "supplied"}, 1,
                   {"NORMAL"});
}

TEST_F(Stylize, AllOptionsTogether) {
    done({"stylize",
          "--style",
          "builtin:twist",
          "--target",
          "builtin:coaster",
          "-o",
          "out.glb",
          "--as",
          "ribbon",
          "--frame",
          "supplied",
          "--attributes",
          "radius,angle",
          "--angle",
          "rp1",
          "--matching",
          "semi",
          "--multiresolution",
          "5:1,20:0.5",
          "--scale",
          "0.5",
          "--basis",
          "1,0,0,0,0,-1,0,1,0",
          "--report",
          "report.json"});
    const auto parameters = report().at("parameters");
    EXPECT_EQ(parameters.at("angle"), "rp1");
    EXPECT_EQ(parameters.at("matching"), "semi");
    EXPECT_EQ(parameters.at("multiresolution"), nlohmann::json::parse("[[5, 1.0], [20, 0.5]]"));
    EXPECT_EQ(parameters.at("attributes"), nlohmann::json::parse(R"(["radius", "angle"])"));
}

TEST_F(Stylize, NewOptionsRefuseWhatTheyCantUse) {
    const auto refused = [&](const std::vector<std::string>& more, int status, const std::vector<std::string>& words) {
        std::vector<std::string> work = {"stylize",      "--style", "builtin:loops", "--target",
                                         "builtin:ring", "-o",      "a.xyz"};
        work.insert(work.end(), more.begin(), more.end());
        expect_refused(work, status, words);
    };
    refused({"--attributes", "taste"}, 2, {"--attributes", "taste"});
    refused({"--attributes", "radius:-1"}, 2, {"--attributes", "-1"});
    refused({"--attributes", "angle"}, 1, {"builtin:loops"});  // the style has none
    refused({"--angle", "rp1"}, 2, {"--angle"});
    refused({"--multiresolution", "0:1"}, 2, {"--multiresolution"});
    refused({"--multiresolution", "5:0"}, 2, {"--multiresolution"});
    refused({"--strokes", "0"}, 2, {"--strokes"});
    refused({"--matching", "discrete"}, 2, {"--matching", "has left the product"});
    refused({"--matching", "full"}, 2, {"--matching", "full"});
    refused({"--basis", "1,2,3"}, 2, {"--basis"});
    refused({"--frame", "supplied"}, 1, {"builtin:ring"});  // the target has no normals
}

TEST_F(Stylize, AGuideOfOnesOwnIsUsed) {
    folder.write("style.xyz", "0 0 0\n0.2 0.1 0\n0.4 -0.1 0\n0.6 0.1 0\n0.8 -0.1 0\n1 0 0\n");
    folder.write("guide.xyz", "0 0 0\n0.5 0 0\n1 0 0\n");
    done({"stylize", "--style", "style.xyz", "--guide", "guide.xyz", "--target", "builtin:s_curve", "-o", "out.xyz",
          "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("flow_steps"), 0);
    EXPECT_NEAR(report().at("quality").at("guide_length"), 1.0, 1e-4);
}

TEST_F(Stylize, WritesAllFormatsAndShapes) {
    for (const char* out : {"a.xyz", "a.obj", "a.glb"}) {
        done({"stylize", "--style", "builtin:knots", "--target", "builtin:s_curve", "-o", out});
        EXPECT_FALSE(folder.read(out).empty()) << out;
    }
    std::vector<size_t> sizes;
    for (const char* shape : {"lines", "ribbon", "tube"}) {
        done({"stylize", "--style", "builtin:knots", "--target", "builtin:s_curve", "-o", "shape.glb", "--as", shape});
        EXPECT_EQ(folder.read("shape.glb").substr(0, 4), "glTF");
        sizes.push_back(folder.read("shape.glb").size());
    }
    EXPECT_LT(sizes[0], sizes[1]);
    EXPECT_LT(sizes[1], sizes[2]);
}

TEST_F(Stylize, QuietSaysNothing) {
    const Outcome outcome =
        done({"--quiet", "stylize", "--style", "builtin:loops", "--target", "builtin:s_curve", "-o", "a.xyz"});
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.list(), std::vector<std::string>{"a.xyz"});
}

}  // namespace
}  // namespace flg::test
