// SPDX-License-Identifier: MIT
// filigree motion: keyframes by hand, positions as text, animations as glTF, refusals.
#include <cmath>
#include <sstream>

#include "cli_test.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

constexpr const char* tumble = R"({
  "energy": "e2", "positions": 61,
  "body": {"points": [[-2, 0, 0], [2, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 0.5], [0, 0, -0.5]]},
  "keys": [
    {"time": 0, "position": [0, 0, 0]},
    {"time": 1, "position": [3, 1, 0], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752]},
    {"time": 3, "pose": [1, 0, 0, 6,  0, 0, -1, 0,  0, 1, 0, 2]}
  ]
})";

class MotionCommand : public Cli {
protected:
    void SetUp() override { folder.write("tumble.json", tumble); }

    std::vector<std::vector<double>> poses(const std::string& name = "poses.txt") const {
        std::vector<std::vector<double>> all;
        std::istringstream lines(folder.read(name));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            all.emplace_back();
            for (double value = 0; words >> value;) all.back().push_back(value);
        }
        return all;
    }
};

TEST_F(MotionCommand, KeysBecomePositions) {
    done({"motion", "tumble.json", "--poses", "poses.txt", "--quiet", "--report", "report.json"});
    const auto all = poses();
    ASSERT_EQ(all.size(), 61u);
    for (const auto& pose : all) ASSERT_EQ(pose.size(), 12u);
    const std::vector<double> first{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, second{0, -1, 0, 3, 1, 0, 0, 1, 0, 0, 1, 0},
        third{1, 0, 0, 6, 0, 0, -1, 0, 0, 1, 0, 2};
    for (size_t c = 0; c < 12; ++c) {
        EXPECT_NEAR(all[0][c], first[c], 1e-14);
        EXPECT_NEAR(all[20][c], second[c], 1e-14);  // a third of the time
        EXPECT_NEAR(all[60][c], third[c], 1e-14);
    }
    const Json json = report();
    EXPECT_EQ(json.at("counts").at("keys"), 3);
    EXPECT_EQ(json.at("counts").at("positions"), 61);
    EXPECT_EQ(json.at("quality").at("ending"), "converged");
    EXPECT_LE(json.at("quality").at("residual").get<double>(), 1e-6);
    EXPECT_TRUE(json.at("stages").contains("rotations"));
    const auto& q = json.at("quality");
    EXPECT_NEAR(q.at("energy").get<double>(),
                q.at("barycentre_energy").get<double>() + q.at("rotation_energy").get<double>(), 1e-9);
}

TEST_F(MotionCommand, SameBytesWhateverRunsIt) {
    done({"motion", "tumble.json", "--poses", "a.txt", "-o", "a.glb", "--quiet", "--workers", "0"});
    done({"motion", "tumble.json", "--poses", "b.txt", "-o", "b.glb", "--quiet", "--workers", "2", "--budget", "100"});
    EXPECT_EQ(folder.read("a.txt"), folder.read("b.txt"));
    EXPECT_EQ(folder.read("a.glb"), folder.read("b.glb"));
    EXPECT_FALSE(folder.read("a.glb").empty());
}

TEST_F(MotionCommand, AnimatesABoxAMeshOrACamera) {
    folder.write("body.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    done({"motion", "tumble.json", "-o", "box.glb", "--quiet"});
    done({"motion", "tumble.json", "-o", "mesh.glb", "--mesh", "body.obj", "--quiet"});
    done({"motion", "tumble.json", "-o", "camera.glb", "--camera", "50", "--quiet"});
    EXPECT_NE(done({"info", "box.glb"}).out.find("12"), std::string::npos);
    const auto json_of = [&](const std::string& name) {
        const std::string glb = folder.read(name);
        uint32_t length = 0;
        std::copy_n(glb.data() + 12, sizeof length, reinterpret_cast<char*>(&length));
        return Json::parse(glb.substr(20, length));
    };
    const Json box = json_of("box.glb"), mesh = json_of("mesh.glb"), camera = json_of("camera.glb");
    EXPECT_EQ(box.at("accessors")[0].at("count"), 24);
    EXPECT_EQ(box.at("accessors")[0].at("min"), Json({-2, -1, -0.5}));
    EXPECT_EQ(mesh.at("accessors")[0].at("count"), 4);
    EXPECT_FALSE(camera.contains("meshes"));
    EXPECT_NEAR(camera.at("cameras")[0].at("perspective").at("yfov").get<double>(), 50 * std::acos(-1.0) / 180, 1e-6);
    for (const Json& json : {box, mesh, camera}) EXPECT_EQ(json.at("animations")[0].at("channels").size(), 2u);
}

TEST_F(MotionCommand, ClosedAndSmoothedAndInTension) {
    Json json = Json::parse(tumble);
    json["closed"] = true;
    json["end_time"] = 5;
    json["energy"] = "et";
    json["tension"] = 4;
    folder.write("closed.json", json.dump());
    done({"motion", "closed.json", "--poses", "poses.txt", "-o", "a.glb", "--quiet", "--report", "report.json"});
    EXPECT_EQ(report().at("parameters").at("closed"), true);
    EXPECT_EQ(report().at("parameters").at("tension"), 4.0);
    EXPECT_EQ(poses().size(), 61u);
    json["smoothing"] = 0.5;
    json["energy"] = "e1";
    folder.write("smooth.json", json.dump());
    done({"motion", "smooth.json", "--poses", "smooth.txt", "--quiet"});
    EXPECT_GT(std::abs(poses("smooth.txt")[0][3]), 0.01);
}

TEST_F(MotionCommand, KeepsOutOfObstacles) {
    folder.write("ball.json",
                 R"({"clearance": 0.2, "obstacles": [{"ball": {"centre": [1.6, 0.7, 0], "radius": 0.4}}]})");
    done({"motion", "tumble.json", "--poses", "poses.txt", "--obstacles", "ball.json", "--quiet", "--report",
          "report.json"});
    const auto all = poses();
    ASSERT_EQ(all.size(), 61u);
    double least = 1e9;
    // The barycentre is the body's origin.
    for (const auto& p : all) least = std::min(least, std::hypot(p[3] - 1.6, p[7] - 0.7, p[11]));
    EXPECT_GT(least, 0.599);
    EXPECT_LT(least, 0.65);
    EXPECT_EQ(report().at("counts").at("obstacles"), 1);
    EXPECT_NEAR(report().at("quality").at("body_radius").get<double>(), 2, 1e-12);
    folder.write("ball.json", R"({"clearance": 0.2, "obstacles": [{"ball": {"centre": [3, 1, 0], "radius": 0.4}}]})");
    expect_refused({"motion", "tumble.json", "--poses", "out.txt", "--obstacles", "ball.json"}, 1,
                   {"tumble.json: keys[1] has its barycentre in obstacle 0"});
    expect_refused({"motion", "tumble.json", "--poses", "out.txt", "--obstacles", "none.json"}, 1, {"none.json"});
}

TEST_F(MotionCommand, ACameraGlidesPastAnObstacle) {
    folder.write("ball.json",
                 R"({"clearance": 0.1, "obstacles": [{"ball": {"centre": [1.6, 0.7, 0], "radius": 0.4}}]})");
    Json json = Json::parse(tumble);
    json["timing"] = "chord";
    json["pacing"] = "path";
    json["speed"] = 2;
    json["limits"] = {{"acceleration", 1}};
    json["look"] = {{"at", {1.6, 0.7, 0}}, {"up", {0, 0, 1}}, {"bank", 0.5}};
    json["positions"] = 400;
    for (Json& key : json["keys"]) key.erase("time");
    folder.write("camera.json", json.dump());
    done({"motion", "camera.json", "--poses", "poses.txt", "-o", "camera.glb", "--camera", "50", "--near", "0.1",
          "--obstacles", "ball.json", "--quiet", "--report", "report.json"});
    double least = 1e9;
    for (const auto& p : poses()) least = std::min(least, std::hypot(p[3] - 1.6, p[7] - 0.7, p[11]));
    const double up = std::tan(25 * std::acos(-1.0) / 180), near = 0.1 * std::sqrt(1 + up * up * (1 + 256.0 / 81));
    EXPECT_GT(least, 0.5 + near - 1e-3);
    EXPECT_LT(least, 0.5 + near + 0.05);
    const Json json_report = report();
    const auto& q = json_report.at("quality");
    EXPECT_LE(q.at("greatest_speed").get<double>(), 2.01);
    EXPECT_LE(q.at("greatest_acceleration").get<double>(), 1.1);
    EXPECT_NEAR(q.at("duration").get<double>(), q.at("key_times")[2].get<double>(), 1e-9);
}

TEST_F(MotionCommand, RefusesWhatItCantUse) {
    const auto refused = [&](const std::string& pointer, const Json& value, const std::string& words) {
        Json json = Json::parse(tumble);
        json[Json::json_pointer(pointer)] = value;
        folder.write("bad.json", json.dump());
        expect_refused({"motion", "bad.json", "--poses", "out.txt", "-o", "out.glb"}, 1, {"bad.json: ", words});
        EXPECT_FALSE(folder.has("out.txt") || folder.has("out.glb"));
    };
    refused("/keys", Json::array(), "desc.key_count is 0");
    refused("/keys/1/time", 0, "keys[1] has the time 0 after 0; times must rise");
    refused("/keys/1/rotation", {0, 0, 1, 1}, "motion.keys[1].rotation: must be a quaternion of length 1");
    refused("/keys/1/rotation", {0, 0, 1}, "motion.keys[1].rotation: must be 4 numbers");
    refused("/keys/1/pose", {0, 0, 1}, "motion.keys[1]: has a `pose` and another one");
    refused("/keys/2/pose/0", -1, "keys[2] has a pose that is a reflection");
    refused("/keys/2/pose/0", 1.5, "keys[2] has a pose that stretches by 1 to 1.5");
    refused("/keys/2/pose/0", "x", "motion.keys[2].pose[0]: must be a number");
    refused("/keys/1", {{"time", 1}}, "motion.keys[1]: needs `position`");
    refused("/keys/1", {{"position", {0, 0, 0}}}, "motion.keys[1]: needs `time`");
    refused("/keys/1/ease_in", 2, "motion.keys[1].ease_in: must be a number from 0");
    refused("/timing", "late", "motion.timing: is `late`, must be one of given, chord, centripetal");
    refused("/timing", std::string(500, 'x'), "motion.timing: is `" + std::string(80, 'x') + "...`");
    refused("/pacing", "slow", "motion.pacing: is `slow`, must be one of keys, path, body");
    refused("/limits", {{"force", 1}}, "motion.limits: does not know `force`");
    refused("/limits", {{"speed", -1}}, "motion.limits.speed: must be a number from 0");
    refused("/look", Json::object(), "motion.look: needs one of `at`, `points` and `path`");
    refused("/look", {{"at", {0, 0, 0}}, {"path", true}}, "motion.look: needs one of `at`, `points` and `path`");
    refused("/look", {{"points", {{0, 0, 0}}}, {"times", {1, 2}}}, "motion.look.times: must be as many as `points`");
    refused("/look", {{"at", {0, 0, 0}}, {"times", {1}}}, "motion.look.times: are those of `points`");
    refused("/look", {{"points", {{0, 0, 0}, {1, 0, 0}}}, {"times", {2, 1}}}, "look_times[1] is 1 after 2");
    refused("/keys/1/place", 1, "motion.keys[1]: does not know `place`");
    refused("/energy", "e3", "motion.energy: is `e3`");
    refused("/tension", -1, "motion.tension: must be a number");
    refused("/positions", 2, "desc.position_count is 2");
    refused("/positions", 1.5, "motion.positions: must be a whole number");
    refused("/end_time", 5, "motion.end_time: is for closed motions");
    refused("/body/box", {1, 1, 1}, "motion.body: needs `points` or `box`, and not both");
    refused("/body", Json::object(), "motion.body: needs `points` or `box`");
    refused("/body", {{"box", {1, 1}}}, "motion.body.box: must be 3 numbers");
    refused("/body/points", Json::array(), "motion.body.points: is empty");
    refused("/body/masses", {1, 2}, "motion.body.masses: must be as many as `points`");
    refused("/haste", 1, "motion: does not know `haste`");
    folder.write("broken.json", "{");
    expect_refused({"motion", "broken.json", "--poses", "out.txt"}, 1, {"broken.json: "});
    expect_refused({"motion", "none.json", "--poses", "out.txt"}, 1, {"none.json: can't be opened"});
    expect_refused({"motion", "tumble.json", "-o", "a.glb", "--mesh", "none.obj"}, 1, {"none.obj"});
    expect_refused({"motion", "tumble.json"}, 2, {"motion needs -o or --poses"});
    expect_refused({"motion", "tumble.json", "-o", "a.gltf"}, 2, {"must end with .glb"});
}

}  // namespace
}  // namespace flg::test
