// SPDX-License-Identifier: MIT
// filigree render and the strokes sample, without a window.
#include <set>

#include "cli_test.h"

namespace flg::test {
namespace {

using Render = Cli;

uint32_t big_endian(const std::string& bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes.at(at + i));
    return value;
}

// Width and height of a PNG; 0 by 0 if it is none.
std::pair<uint32_t, uint32_t> size_of(const std::string& png) {
    if (png.size() < 24 || png.substr(1, 3) != "PNG") return {0, 0};
    return {big_endian(png, 16), big_endian(png, 20)};
}

TEST_F(Render, PictureHasTheSizeAskedFor) {
    for (const char* shape : {"lines", "ribbon", "tube"}) {
        done({"render", "builtin:spiral", "-o", "out.png", "--size", "160x90", "--as", shape, "--report",
              "report.json"});
        EXPECT_EQ(size_of(folder.read("out.png")), std::make_pair(160u, 90u)) << shape;
        EXPECT_EQ(report().at("counts").at("points"), 600);
    }
}

TEST_F(Render, PicturesThroughLinksKeepTheLinks) {
    std::filesystem::create_symlink("real.png", folder / "out.png");
    done({"render", "builtin:spiral", "-o", "out.png", "--size", "32x32"});
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "out.png"));
    EXPECT_EQ(size_of(folder.read("real.png")), std::make_pair(32u, 32u));
}

TEST_F(Render, ATurnAroundGivesDifferentPictures) {
    done({"render", "builtin:spiral", "builtin:loops", "-o", "turn.png", "--size", "96x96", "--frames", "3"});
    EXPECT_EQ(folder.list(), (std::vector<std::string>{"turn-0001.png", "turn-0002.png", "turn-0003.png"}));
    std::set<std::string> pictures;
    for (const std::string& name : folder.list()) pictures.insert(folder.read(name));
    EXPECT_EQ(pictures.size(), 3u);
}

TEST_F(Render, SameCameraSamePicture) {
    for (const char* name : {"a.png", "b.png"}) {
        done({"render", "builtin:flourish", "-o", name, "--size", "96x96", "--camera", "0.2,0.4,3,0,0,0"});
    }
    EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
    done({"render", "builtin:flourish", "-o", "c.png", "--size", "96x96", "--camera", "-40,10"});
    EXPECT_NE(folder.read("a.png"), folder.read("c.png"));
}

TEST_F(Render, BadUsageIsRefused) {
    for (const char* size : {"0x10", "10x0", "10", "10x", "10x10x10", "20000x10", "axb"}) {
        expect_refused({"render", "builtin:loops", "-o", "out.png", "--size", size}, 2, {"--size"});
    }
    expect_refused({"render", "builtin:loops", "-o", "out.bmp"}, 2, {"out.bmp"});
    expect_refused({"render", "builtin:loops", "-o", "out.png", "--frames", "0"}, 2, {"--frames"});
    for (const char* camera : {"1", "1,2,3,4", "1,2,0", "1,nan"}) {
        expect_refused({"render", "builtin:loops", "-o", "out.png", "--camera", camera}, 2, {"--camera"});
    }
    expect_refused({"render", "nosuch.xyz", "-o", "out.png"}, 1, {"nosuch.xyz"});
    expect_refused({"render", "builtin:loops", "-o", "nosuch/out.png"}, 1, {"nosuch/out.png"});
    EXPECT_TRUE(folder.list().empty());
}

// A square of two triangles, of different regions.
const char kSquare[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty int region\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 0\n3 0 2 3 4\n";
const char kSquareWithoutRegions[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

TEST_F(Render, MeshesAndCurvesComeInOnePicture) {
    folder.write("square.ply", kSquare);
    folder.write("plain.obj", kSquareWithoutRegions);
    folder.write("both.obj", std::string(kSquareWithoutRegions) + "v 0 0 0.3\nv 1 1 0.3\nl 5 6\n");
    std::set<std::string> pictures;
    for (const char* mesh : {"square.ply", "plain.obj", "both.obj"}) {
        done({"render", mesh, "-o", "out.png", "--size", "64x64", "--report", "report.json"});
        EXPECT_EQ(report().at("counts").at("meshes"), 1);
        EXPECT_EQ(report().at("counts").at("triangles"), 2);
        EXPECT_EQ(report().at("counts").at("curves"), mesh == std::string("both.obj") ? 1 : 0);
        pictures.insert(folder.read("out.png"));
    }
    done({"render", "plain.obj", "builtin:spiral", "-o", "out.png", "--size", "64x64", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("curves"), 1);
    pictures.insert(folder.read("out.png"));
    EXPECT_EQ(pictures.size(), 4u);
}

TEST_F(Render, FieldsColourTheMesh) {
    folder.write("square.ply", kSquare);
    folder.write("field.txt", "0\n30\ninf\n-7.5e0\n");
    std::set<std::string> pictures;
    const std::vector<std::string> plain = {"render", "square.ply", "-o",       "out.png",
                                            "--size", "64x64",      "--report", "report.json"};
    const auto picture = [&](std::vector<std::string> options) {
        options.insert(options.begin(), plain.begin(), plain.end());
        done(options);
        pictures.insert(folder.read("out.png"));
    };
    picture({});
    picture({"--field", "field.txt"});
    const nlohmann::json field = report().at("quality").at("field");
    EXPECT_EQ(field.at("low"), -7.5);
    EXPECT_EQ(field.at("high"), 30.0);
    EXPECT_EQ(field.at("every"), 2.0) << "37.5 in up to 20 steps of 1, 2 or 5 times a power of ten";
    picture({"--field", "field.txt", "--every", "10"});
    EXPECT_EQ(report().at("quality").at("field").at("every"), 10.0);
    EXPECT_EQ(pictures.size(), 3u);
    folder.write("field.txt", "inf\ninf\ninf\ninf\n");
    picture({"--field", "field.txt"});
    EXPECT_FALSE(report().at("quality").contains("field"));
}

TEST_F(Render, BadFieldsAreRefused) {
    folder.write("square.ply", kSquare);
    folder.write("field.txt", "0\n1\n2\n");
    const std::vector<std::string> files = folder.list();
    const auto refused = [&](const std::vector<std::string>& meshes, int status,
                             const std::vector<std::string>& words) {
        std::vector<std::string> arguments = {"render", "-o", "out.png", "--field", "field.txt"};
        arguments.insert(arguments.end(), meshes.begin(), meshes.end());
        expect_refused(arguments, status, words);
    };
    refused({"square.ply"}, 1, {"field.txt", "3 values", "square.ply", "4 vertices"});
    refused({"builtin:spiral"}, 2, {"--field"});
    refused({"square.ply", "square.ply"}, 2, {"--field"});
    for (const char* bad : {"x", "", "nan", "1 2", "0x10"}) {
        folder.write("field.txt", "0\n" + std::string(bad) + "\n2\n3\n");
        refused({"square.ply"}, 1, {"field.txt:2", std::string("'") + bad + "'"});
    }
    expect_refused({"render", "square.ply", "-o", "out.png", "--field", "nosuch.txt"}, 1, {"nosuch.txt"});
    expect_refused({"render", "square.ply", "-o", "out.png", "--every", "1"}, 2, {"--every"});
    expect_refused({"render", "square.ply", "-o", "out.png", "--every", "-1"}, 2, {"--every"});
    expect_refused({"render", "nosuch.ply", "-o", "out.png"}, 1, {"nosuch.ply"});
    EXPECT_EQ(folder.list(), files);
}

// From before the square, upright, to its right, where it is seen from the side.
const char kFlight[] = R"({"keys": [{"time": 1, "position": [0.5, 0.5, 3]},
    {"time": 3, "position": [3.5, 0.5, 0.5], "rotation": [0, 0.5, 0, 0.8660254037844386]}]})";

TEST_F(Render, ACameraFollowsAMotion) {
    folder.write("square.ply", kSquare);
    folder.write("flight.json", kFlight);
    const auto picture = [&](std::vector<std::string> options) {
        options.insert(options.begin(),
                       {"render", "square.ply", "-o", "out.png", "--size", "64x48", "--report", "report.json"});
        done(options);
        return folder.read("out.png");
    };
    const std::string first = picture({"--camera-motion", "flight.json"});
    EXPECT_TRUE(first == picture({"--camera", "0.5,0.5,3,0.5,0.5,0"})) << "along -z, +y upwards";
    EXPECT_TRUE(first == picture({"--camera-motion", "flight.json", "--time", "1"}));
    EXPECT_EQ(report().at("parameters").at("camera_motion"), "flight.json");
    EXPECT_EQ(report().at("counts").at("keys"), 2);
    const std::string middle = picture({"--camera-motion", "flight.json", "--time", "2"});
    const std::string last = picture({"--camera-motion", "flight.json", "--time", "3"});
    EXPECT_EQ((std::set<std::string>{first, middle, last}).size(), 3u);
    done({"render", "square.ply", "-o", "way.png", "--size", "64x48", "--camera-motion", "flight.json", "--frames",
          "3"});
    EXPECT_TRUE(folder.read("way-0001.png") == first);
    EXPECT_TRUE(folder.read("way-0002.png") == middle);
    EXPECT_TRUE(folder.read("way-0003.png") == last);
}

TEST_F(Render, AClosedMotionComesRound) {
    folder.write("square.ply", kSquare);
    folder.write("round.json", "{\"closed\": true, \"end_time\": 5, " + std::string(kFlight).substr(1));
    for (const char* time : {"1", "5", "-3"}) {
        done({"render", "square.ply", "-o", std::string("at") + time + ".png", "--size", "64x48", "--camera-motion",
              "round.json", "--time", time});
        EXPECT_TRUE(folder.read(std::string("at") + time + ".png") == folder.read("at1.png")) << time;
    }
    done(
        {"render", "square.ply", "-o", "way.png", "--size", "64x48", "--camera-motion", "round.json", "--frames", "2"});
    done({"render", "square.ply", "-o", "at3.png", "--size", "64x48", "--camera-motion", "round.json", "--time", "3"});
    EXPECT_TRUE(folder.read("way-0001.png") == folder.read("at1.png"));
    EXPECT_TRUE(folder.read("way-0002.png") == folder.read("at3.png"));
}

TEST_F(Render, BadCameraMotionsAreRefused) {
    folder.write("flight.json", kFlight);
    folder.write("one.json", R"({"keys": [{"time": 1, "position": [0, 0, 3]}]})");
    folder.write("broken.json", "{");
    const std::vector<std::string> files = folder.list();
    const auto refused = [&](const std::vector<std::string>& options, int status, const std::string& words) {
        std::vector<std::string> arguments = {"render", "builtin:loops", "-o", "out.png", "--camera-motion"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_refused(arguments, status, {words});
    };
    refused({"nosuch.json"}, 1, "nosuch.json: can't be opened");
    refused({"broken.json"}, 1, "broken.json: ");
    refused({"one.json"}, 1, "one.json: desc.key_count is 1");
    refused({"flight.json", "--time", "0.5"}, 1, "flight.json: --time: 0.5 is not within the motion, 1 to 3");
    refused({"flight.json", "--camera", "10,20"}, 2, "--camera");
    EXPECT_EQ(folder.list(), files);
}

class Strokes : public ::testing::Test {
protected:
    Folder folder;
};

TEST_F(Strokes, HeadlessRunLeavesItsResults) {
    for (const char* workers : {"0", "2"}) {
        const Outcome outcome = run_program(
            FLG_STROKES_PROGRAM,
            {"builtin:spiral", "builtin:s_curve", "--no-window", "--out", "out", "--workers", workers}, folder.path());
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        for (const char* picture : {"out/before.png", "out/styled_ribbons.png", "out/styled_tubes.png"}) {
            // As wide as the strokes ask for.
            const auto [width, height] = size_of(folder.read(picture));
            EXPECT_EQ(height, 720u) << picture;
            EXPECT_TRUE(width >= 540 && width <= 1280) << picture << ": " << width;
        }
        EXPECT_EQ(folder.read("out/result.glb").substr(0, 4), "glTF");
        const nlohmann::json frames = nlohmann::json::parse(folder.read("out/frames.json"));
        EXPECT_EQ(frames.at("budget_us"), 2000);
        EXPECT_GE(frames.at("frames"), 1);
        EXPECT_GT(frames.at("points").at("result"), 800);
        EXPECT_GT(frames.at("tick_us").at("max"), 0.0);
        EXPECT_FALSE(frames.at("longest_chunk").at("stage").get<std::string>().empty());
    }
}

TEST_F(Strokes, UnknownStylesAreToldTheKnownOnes) {
    const Outcome outcome = run_program(FLG_STROKES_PROGRAM, {"--style", "nosuch", "--no-window"}, folder.path());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("strokes: --style: 'nosuch'")) << outcome.err;
    EXPECT_NE(outcome.err.find("loops, zigzag"), std::string::npos) << outcome.err;
}

TEST_F(Strokes, BadInputIsOneLine) {
    const Outcome outcome = run_program(FLG_STROKES_PROGRAM, {"nosuch.tilt", "--no-window"}, folder.path());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("strokes: nosuch.tilt")) << outcome.err;
}

}  // namespace
}  // namespace flg::test
