// SPDX-License-Identifier: MIT
// filigree skeleton: drawings by hand and plain contours, bones as JSON, models as glTF, refusals.
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "api/drawings.h"
#include "cli_test.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

// A body with a leg that is there twice, either side of z = 0.
constexpr const char* animal = R"({
  "mirror": [0, 0, 1, 0],
  "parts": [
    {"name": "body", "curve": [[-3, 0], [-2, 1], [2, 1], [3, 0], [2, -1], [-2, -1]], "color": "#ff0000"},
    {"name": "leg", "contour": "leg.poly.txt", "at": [1, 0, 0.6], "thickness": 0.8, "mirrored": true}
  ]
})";
constexpr const char* leg = "-0.3 -3\n0.3 -3\n0.4 -0.2\n-0.4 -0.2\n";

class SkeletonCommand : public Cli {
protected:
    void SetUp() override {
        folder.write("animal.json", animal);
        folder.write("leg.poly.txt", leg);
    }
    Json bones(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"skeleton", "--bones",  "bones.json",
                                              "--quiet",  "--report", "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
        return Json::parse(folder.read("bones.json"));
    }
};

TEST_F(SkeletonCommand, ADrawingBecomesOneTree) {
    const Json json = bones({"animal.json"});
    ASSERT_EQ(json.at("parts").size(), 3u);
    EXPECT_EQ(json.at("parts")[0].at("event"), "root");
    EXPECT_EQ(json.at("parts")[1].at("parent"), 0);
    EXPECT_EQ(json.at("parts")[2].at("mirrored"), true);
    EXPECT_EQ(json.at("parts")[2].at("twin"), 1);
    uint32_t left = 0, right = 0;
    for (size_t j = 0; j < json.at("joints").size(); ++j) {
        const Json& joint = json.at("joints")[j];
        EXPECT_EQ(joint.at("parent").is_null(), j == 0);
        const std::string name = joint.at("name");
        left += name.ends_with(".L");
        right += name.ends_with(".R");
        const double side = name.ends_with(".L") ? 1 : name.ends_with(".R") ? -1 : 0;
        EXPECT_NEAR(joint.at("position")[2].get<double>(), 0.6 * side, 1e-6);
    }
    EXPECT_GE(left, 2u);
    EXPECT_EQ(left, right);
    EXPECT_EQ(report().at("counts").at("parts"), 3);
    EXPECT_EQ(report().at("counts").at("joints"), json.at("joints").size());
}

TEST_F(SkeletonCommand, AByteOrderMarkIsSkipped) {
    folder.write("marked.poly.txt", std::string("\xef\xbb\xbf") + leg);
    EXPECT_EQ(bones({"marked.poly.txt"}).at("joints").size(), bones({"leg.poly.txt"}).at("joints").size());
}

TEST_F(SkeletonCommand, ABadLineIsQuotedShortAndPrintable) {
    folder.write("bad.poly.txt", "1 2\n" + std::string(5000, 'x') + "\x01\n");
    const Outcome outcome = run({"skeleton", "bad.poly.txt", "--bones", "bones.json"});
    EXPECT_NE(outcome.err.find("bad.poly.txt:2: '" + std::string(80, 'x') + "...' is no point"), std::string::npos)
        << outcome.err;
    folder.write("odd.poly.txt", "1 2\n\x1b[2J\n");
    const Outcome odd = run({"skeleton", "odd.poly.txt", "--bones", "bones.json"});
    EXPECT_NE(odd.err.find("'?[2J' is no point"), std::string::npos) << odd.err;
}

TEST_F(SkeletonCommand, DrawingsHangPartsAndKeepJoints) {
    folder.write("hung.json", R"({
      "mirror": [0, 0, 1, 0], "root": "leg", "detail": 0.5,
      "joints": [{"joint": "body_0", "edit": "rename", "name": "hips"},
                 {"joint": "leg_9", "edit": "pin", "at": [0, -1.5, 0]}],
      "parts": [
        {"name": "body", "curve": [[-3, 0], [-2, 1], [2, 1], [3, 0], [2, -1], [-2, -1]], "parent": "leg"},
        {"name": "leg", "contour": "leg.poly.txt", "at": [1, 0, 0.6], "thickness": 0.8}
      ]
    })");
    const Json json = bones({"hung.json"});
    EXPECT_EQ(json.at("parts")[0].at("parent"), 1);
    EXPECT_EQ(json.at("parts")[1].at("event"), "root");
    bool has_hips = false, has_pin = false;
    for (const Json& joint : json.at("joints")) {
        has_hips = has_hips || (joint.at("name") == "hips" && joint.at("key") == "body_0");
        if (joint.at("key") != "leg_9") continue;
        has_pin = joint.at("pinned").get<bool>();
        EXPECT_NEAR(joint.at("position")[1].get<double>(), -1.5, 1e-6);
    }
    EXPECT_TRUE(has_hips);
    EXPECT_TRUE(has_pin);
    const Outcome outcome = run({"skeleton", "animal.json", "--bones", "bones.json", "--root", "wing"});
    EXPECT_NE(outcome.err.find("there is no part wing"), std::string::npos) << outcome.err;
}

TEST_F(SkeletonCommand, PlainContoursArePartsInOnePlane) {
    folder.write("torso.poly.txt", "-3 -1\n3 -1\n3 1\n-3 1\n");
    const Json json = bones({"torso.poly.txt", "leg.poly.txt"});
    ASSERT_EQ(json.at("parts").size(), 2u);
    EXPECT_EQ(json.at("joints")[0].at("name"), "torso_root");
    EXPECT_EQ(json.at("parts")[1].at("event"), "bone_split");
    for (const Json& joint : json.at("joints")) EXPECT_EQ(joint.at("position")[2], 0.0);
}

TEST_F(SkeletonCommand, OutlinesOfAnSvgArePartsWithHoles) {
    // A torso with a hole and an island in it, a leg over its edge, a dot of the pen, and no picture.
    folder.write("animal.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='60'>"
                 "<path d='M10 10 H90 V30 H10 Z M40 12 V28 H70 V12 Z'/><rect x='45' y='15' width='20' height='10'/>"
                 "<rect x='15' y='25' width='8' height='30'/><circle cx='95' cy='5' r='0.2'/><line x2='9'/>"
                 "<rect width='99' height='59' style='fill:red; display : none'/><text>a name</text></svg>");
    const Json json = bones({"animal.svg", "-o", "animal.glb"});
    ASSERT_EQ(json.at("parts").size(), 3u);
    EXPECT_EQ(json.at("parts")[0].at("name"), "animal");
    EXPECT_EQ(json.at("parts")[1].at("name"), "animal-2");
    EXPECT_EQ(json.at("parts")[2].at("name"), "animal-3");
    EXPECT_EQ(json.at("parts")[2].at("parent"), 0);
    EXPECT_EQ(report().at("warnings"),
              Json::array({"animal.svg: 1 element: text and image are not read (first: element 7)",
                           "animal.svg: 1 outline is a line and left out",
                           "animal.svg: 1 outline is smaller than 1/100 of the drawing and left out"}));
    // Bones pass by the hole.
    for (const Json& joint : json.at("joints")) {
        const double x = joint.at("position")[0], y = joint.at("position")[1];
        EXPECT_FALSE(joint.at("part") == 0 && x > 40 && x < 70 && y > -28 && y < -12) << joint;
    }
}

TEST_F(SkeletonCommand, SketchesHaveADepth) {
    folder.write("SketchPolyline0.txt", "4\n0 0 26\n9 0 26\n9 2 26\n0 0 26\n");
    const Json lifted = bones({"SketchPolyline0.txt"});
    EXPECT_GT(lifted.at("joints").size(), 0u);
    for (const Json& joint : lifted.at("joints")) EXPECT_EQ(joint.at("position")[2], 26.0);
    folder.write("SketchPolyline1.txt", "4\n0 0 26\n9 0 27\n9 2 26\n0 0 26\n");
    expect_refused({"skeleton", "SketchPolyline1.txt", "--bones", "out.json"}, 1, {"SketchPolyline1.txt:3", "plane"});
}

TEST_F(SkeletonCommand, MeshesArePartsByTheirSilhouettes) {
    // A bar along x, closed.
    folder.write("bar.obj",
                 "v -5 -1 2\nv 5 -1 2\nv 5 1 2\nv -5 1 2\nv -5 -1 4\nv 5 -1 4\nv 5 1 4\nv -5 1 4\n"
                 "f 5 6 7 8\nf 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    const Json json = bones({"bar.obj", "--prune", "0.1"});
    ASSERT_GE(json.at("joints").size(), 2u);
    for (const Json& joint : json.at("joints")) {
        EXPECT_NEAR(joint.at("position")[1].get<double>(), 0, 1e-5);
        EXPECT_NEAR(joint.at("position")[2].get<double>(), 3, 1e-5);
    }
    const Json aside = bones({"bar.obj", "--prune", "0.1", "--from", "1,0,0"});
    EXPECT_GT(aside.at("joints").size(), 0u);
    for (const Json& joint : aside.at("joints")) EXPECT_NEAR(joint.at("position")[0].get<double>(), 0, 1e-5);
}

TEST_F(SkeletonCommand, CrossingsAreRepairedOnRequest) {
    folder.write("knot.poly.txt", "0 0\n6 6\n6 0\n0 6\n-2 3\n");
    expect_refused({"skeleton", "knot.poly.txt", "--bones", "out.json"}, 1,
                   {"cross at (3, 3); --repair takes the largest piece within"});
    EXPECT_GE(bones({"knot.poly.txt", "--repair"}).at("joints").size(), 1u);
}

// A hand that is drawn again a little to the side: what did not go away keeps its name, from run to run.
TEST_F(SkeletonCommand, NamesLastWhenALimbMoves) {
    const auto named = [&](double hand, const std::vector<std::string>& more) {
        Line line = person();
        for (auto& point : line)
            if (point[0] > 3 && point[1] < 5.2) point[0] += hand, point[1] += hand / 2;
        folder.write("person.json", Json{{"parts", {{{"name", "person"}, {"curve", line}}}}}.dump());
        std::vector<std::string> arguments = {"person.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        std::map<std::string, std::array<double, 2>> out;
        const Json made = bones(arguments);
        for (const Json& joint : made.at("joints"))
            out[joint.at("name")] = {joint.at("position")[0], joint.at("position")[1]};
        return out;
    };
    const auto first = named(0, {});
    folder.write("before.json", folder.read("bones.json"));
    uint32_t moved = 0;
    for (int step = 1; step <= 4; ++step) {
        const auto now = named(0.15 * step, {"--previous", "before.json"});
        folder.write("before.json", folder.read("bones.json"));
        for (const auto& [name, at] : now) {
            const auto was = first.find(name);
            if (was == first.end()) continue;
            EXPECT_LT(std::hypot(at[0] - was->second[0], at[1] - was->second[1]), 1.6) << name << " " << step;
            moved += at != was->second;
        }
        EXPECT_GE(now.size() + 2, first.size());
    }
    EXPECT_GT(moved, 0u);
    done({"skeleton", "person.json", "-o", "person.glb", "--vertices", "500", "--previous", "before.json", "--quiet"});
    done({"info", "person.glb", "--report", "info.json"});
    const Json info = report("info.json");
    const Json& joints = info.at("parameters").at("joints");
    for (const auto& [name, at] : named(0.6, {"--previous", "before.json"}))
        EXPECT_NE(std::find(joints.begin(), joints.end(), name), joints.end()) << name;
    folder.write("no.json", R"({"joints": []})");
    expect_refused({"skeleton", "person.json", "--bones", "b.json", "--previous", "no.json"}, 1, {"no.json: bones"});
    expect_refused({"skeleton", "person.json", "--bones", "b.json", "--previous", "none.json"}, 1, {"none.json"});
}

// Symmetric, with one arm lowered by `low` at its end.
Line person_with_arm(double low) {
    const Line half = {{0, 3},      {0.35, 2.9},  {0.5, 2.5},   {0.35, 2.15}, {0.17, 2},    {0.3, 1.85},  {0.75, 1.75},
                       {1.3, 1.45}, {1.9, 1.05},  {2.15, 0.95}, {2.2, 0.75},  {1.95, 0.75}, {1.3, 1.1},   {0.75, 1.3},
                       {0.62, 1},   {0.6, 0.3},   {0.68, -0.2}, {0.72, -0.9}, {0.65, -1.8}, {0.9, -1.95}, {0.88, -2.1},
                       {0.3, -2.1}, {0.28, -1.8}, {0.25, -1},   {0.12, -0.35}};
    Line whole = half;
    for (size_t i = half.size() - 1; i > 0; --i) {
        const auto [x, y] = half[i];
        whole.push_back({-x, x > 0.8 && y > 0.6 && y < 1.6 ? y - low * (x - 0.8) : y});
    }
    return whole;
}

// What was set about a joint stays with it, although joints are numbered anew where the drawing is symmetric no more.
TEST_F(SkeletonCommand, EditsStayWithTheirJointsFromRunToRun) {
    Json drawing = {{"parts", {{{"name", "me"}, {"curve", person_with_arm(0)}}}}};
    // Where joints are by the name that they were given.
    const auto made = [&](const std::vector<std::string>& more) {
        folder.write("me.json", drawing.dump());
        std::vector<std::string> arguments = {"me.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        std::map<std::string, std::array<double, 2>> out;
        const Json model = bones(arguments);
        for (const Json& joint : model.at("joints"))
            if (joint.at("name").get<std::string>().starts_with("my_"))
                out[joint.at("name")] = {joint.at("position")[0], joint.at("position")[1]};
        return out;
    };
    made({});
    const Json plain = Json::parse(folder.read("bones.json"));
    for (const Json& joint : plain.at("joints"))
        drawing["joints"].push_back(
            {{"joint", joint.at("key")}, {"edit", "rename"}, {"name", "my_" + joint.at("key").get<std::string>()}});
    const auto first = made({});
    folder.write("before.json", folder.read("bones.json"));
    constexpr double same_place = 0.5;
    const auto elsewhere = [&](const auto& now) {
        size_t count = 0;
        for (const auto& [name, at] : now)
            count += std::hypot(at[0] - first.at(name)[0], at[1] - first.at(name)[1]) > same_place;
        return count;
    };
    for (const double low : {0.05, 0.1, 0.15}) {
        drawing["parts"][0]["curve"] = person_with_arm(low);
        EXPECT_GT(elsewhere(made({})), first.size() / 2) << "this drawing shows nothing";
        const auto now = made({"--previous", "before.json"});
        folder.write("before.json", folder.read("bones.json"));
        EXPECT_EQ(elsewhere(now), 0u) << low;
        EXPECT_GE(now.size() + 5, first.size());
        size_t gone = 0;
        const Json warnings = report().at("warnings");
        for (const Json& warning : warnings) gone += warning.get<std::string>().find("waits") != std::string::npos;
        EXPECT_EQ(now.size() + gone, first.size());
    }
}

Line block(double x, double y, double width, double height) {
    const double w = width / 2, h = height / 2;
    return {{x - w, y - h}, {x + w, y - h}, {x + w, y + h}, {x - w, y + h}};
}

// A person of blocks whose arms hang beside the torso and reach into it all along: by the shoulders, not by the hands.
TEST_F(SkeletonCommand, ArmsOfBlocksHangByTheirShouldersAndBend) {
    const auto drawn = [&](const Line& left, const Line& right) {
        Json parts = Json::array();
        const auto add = [&](const char* name, const Line& line) {
            parts.push_back({{"name", name}, {"contour", line}, {"thickness", 0.8}});
        };
        add("torso", block(0, 0, 2, 3));
        add("head", block(0, 2.1, 1.2, 1.4));
        add("left_arm", left);
        add("right_arm", right);
        add("left_leg", block(0.55, -2.6, 0.8, 2.6));
        add("right_leg", block(-0.55, -2.6, 0.8, 2.6));
        folder.write("blocks.json", Json{{"parts", parts}}.dump());
        return bones({"blocks.json"});
    };
    for (const bool hangs : {true, false}) {
        const Json made = hangs ? drawn(block(1.2, 0.1, 0.7, 2.8), block(-1.2, 0.1, 0.7, 2.8))
                                : drawn(block(2, 1.1, 2.4, 0.7), block(-2, 1.1, 2.4, 0.7));
        for (const size_t part : {2, 3, 4, 5}) {
            std::vector<std::array<double, 3>> limb;
            for (const Json& joint : made["joints"])
                if (joint["part"] == part) limb.push_back(joint["position"]);
            ASSERT_EQ(limb.size(), 3u) << hangs << part;
            // From the shoulder or hip on, with the elbow or knee about half way.
            const auto from = limb[0], to = limb[2];
            const bool is_level = part < 4 && !hangs;
            EXPECT_GT(is_level ? std::abs(to[0]) : from[1], is_level ? std::abs(from[0]) : to[1]) << hangs << part;
            EXPECT_NEAR(std::hypot(limb[1][0] - from[0], limb[1][1] - from[1]),
                        std::hypot(to[0] - limb[1][0], to[1] - limb[1][1]), 0.3);
        }
    }
    done({"skeleton", "blocks.json", "-o", "blocks.vrm.glb", "--rig", "vrm", "--quiet"});
}

// One outline of blocks, arms down: the elbow is in the straight of the arm, not where the arm leaves the chest.
TEST_F(SkeletonCommand, AnArmThatHangsFromAShoulderBends) {
    const Line right = {{0.1, -1.5}, {0.1, -4}, {0.9, -4},   {0.9, -1.4}, {1, -1.4},  {1, 0.75}, {1.1, 0.75},
                        {1.1, -1},   {1.8, -1}, {1.8, 1.45}, {1, 1.5},    {0.6, 1.5}, {0.6, 2.9}};
    Line whole = right;
    for (auto point = right.rbegin(); point != right.rend(); ++point) whole.push_back({-(*point)[0], (*point)[1]});
    folder.write("man.json", Json{{"parts", {{{"name", "man"}, {"contour", whole}}}}}.dump());
    const Json made = bones({"man.json"});
    std::array<int, 2> elbows{};
    for (const Json& joint : made["joints"]) {
        const double x = joint["position"][0], y = joint["position"][1];
        if (std::abs(x) > 1.1 && y > -0.4 && y < 0.8) ++elbows[x > 0];
    }
    EXPECT_EQ(elbows[0], 1);
    EXPECT_EQ(elbows[1], 1);
}

// A vest across the chest hangs by its middle, and what hangs on the chest on both sides is as it were without.
TEST_F(SkeletonCommand, WhatLiesAcrossTheMiddleHangsByIt) {
    folder.write("vest.json", R"({"parts": [
      {"name": "torso", "curve": [[-1.7, -0.6], [-1.6, 0.7], [-1, 1.7], [0, 2], [1, 1.7], [1.6, 0.7], [1.7, -0.6],
                                  [1.1, -1.7], [0, -2], [-1.1, -1.7]]},
      {"name": "vest", "thickness": 1.4, "curve": [[-1.75, 0.95], [-1.3, 1.75], [-0.4, 2.05], [0.4, 2.05], [1.3, 1.75],
                                                   [1.75, 0.95], [0.9, 0.75], [0, 0.7], [-0.9, 0.75]]},
      {"name": "arm", "mirrored": true, "curve": [[1.352, 1.667], [2.344, 1.129], [3.029, 0.115], [3.237, -0.791],
        [2.909, -1.337], [2.363, -1.009], [2.171, -0.315], [1.656, 0.271], [0.848, 0.533], [0.533, 1.352]]}]})");
    const Json made = bones({"vest.json"});
    const Json& joints = made["joints"];
    bool has_vest = false;
    std::map<std::string, std::string> parents;
    for (const Json& joint : joints) {
        const std::string name = joint["name"];
        parents[name] = joint["parent"].is_null() ? "" : std::string(joints[joint["parent"].get<size_t>()]["name"]);
        if (joint["part"] != 1 || joints[joint["parent"].get<size_t>()]["part"] == 1) continue;
        has_vest = true;
        EXPECT_NEAR(joint["position"][0].get<double>(), 0, 1e-6) << name;
    }
    EXPECT_TRUE(has_vest);
    // Mirror images hang on one joint, or on two that are.
    const std::string left = parents.at("arm_0.L"), right = parents.at("arm_0.R");
    const auto at = [&](const std::string& name) {
        for (const Json& joint : joints)
            if (joint["name"] == name) return joint["position"].get<std::array<double, 3>>();
        return std::array<double, 3>{};
    };
    EXPECT_NEAR(at(left)[0], -at(right)[0], 1e-6) << left << " " << right;
    EXPECT_NEAR(at(left)[1], at(right)[1], 1e-6) << left << " " << right;
}

// As maps have them, in metres from the equator.
TEST_F(SkeletonCommand, DrawingsMayLieFarFromTheOrigin) {
    const std::vector<std::array<double, 2>> near = {{-3, -1}, {0, -1.2}, {3, -1}, {3, 1}, {0, 0.8}, {-3, 1}};
    const auto written = [&](double x, double y) {
        std::ostringstream text;
        text << std::setprecision(17);
        for (const auto& point : near) text << x + point[0] << " " << y + point[1] << "\n";
        folder.write("bar.poly.txt", text.str());
        done({"skeleton", "bar.poly.txt", "-o", "bar.glb", "--vertices", "500", "--quiet"});
        return bones({"bar.poly.txt"}).at("joints");
    };
    const Json here = written(0, 0), there = written(1e7, -2e7);
    ASSERT_EQ(here.size(), there.size());
    for (size_t j = 0; j < here.size(); ++j) {
        EXPECT_NEAR(there[j].at("position")[0].get<double>() - 1e7, here[j].at("position")[0].get<double>(), 1e-5);
        EXPECT_NEAR(there[j].at("position")[1].get<double>() + 2e7, here[j].at("position")[1].get<double>(), 1e-5);
    }
}

TEST_F(SkeletonCommand, ThresholdsMakeItCoarser) {
    const size_t fine = bones({"animal.json", "--simplify", "0", "--merge", "0", "--prune", "0", "--collapse", "0"})
                            .at("joints")
                            .size();
    const size_t coarse = bones({"animal.json", "--simplify", "0.1", "--collapse", "0.1"}).at("joints").size();
    EXPECT_GT(fine, 2 * coarse);
}

TEST_F(SkeletonCommand, WritesAModelThatMoves) {
    done({"skeleton", "animal.json", "-o", "animal.glb", "--vertices", "1500", "--quiet", "--report", "report.json"});
    const int vertices = report().at("counts").at("vertices");
    EXPECT_NEAR(vertices, 1500, 225);
    EXPECT_EQ(report().at("counts").at("triangles"), 2 * (vertices - 2)) << "closed, without handles";
    EXPECT_NE(done({"info", "animal.glb"}).out.find("leg_0.L"), std::string::npos);
}

TEST_F(SkeletonCommand, RefusesWhatItCantUse) {
    const auto refused = [&](const std::string& drawing, const std::string& words) {
        folder.write("bad.json", drawing);
        expect_refused({"skeleton", "bad.json", "--bones", "out.json"}, 1, {words});
        EXPECT_FALSE(folder.has("out.json"));
    };
    refused("{}", "bad.json: model");
    refused(R"({"parts": []})", "model.parts: is empty");
    refused(R"({"parts": [{"name": "a"}]})", "must have either a contour or a curve");
    refused(R"({"parts": [{"name": "a", "contour": [[0, 0], [1, 0]]}]})", "has fewer than three points");
    refused(R"({"parts": [{"name": "a", "contour": "none.poly.txt"}]})", "none.poly.txt: can't be opened");
    refused(R"({"parts": [{"name": "knot", "contour": [[0, 0], [4, 4], [4, 0], [0, 4]]}]})", "cross at (2, 2)");
    refused(R"({"parts": [{"name": "a", "contour": [[0, 0], [1, 0], [0, 1]], "colour": "red"}]})",
            "does not know `colour`");
    refused(R"({"parts": [{"name": "a", "contour": [[0, 0], [1, 0], [0, 1]], "color": "red"}]})", "must be `#rrggbb`");
    refused(R"({"parts": [{"name": "a", "contour": [[0, 0], [1, 0], [0, 1]], "at": [1, 2]}]})", "must be 3 numbers");
    for (const char* detail : {"nan", "0.01", "21", "-1"})
        expect_refused({"skeleton", "animal.json", "--bones", "out.json", "--detail", detail}, 2, {"--detail", detail});
    expect_refused({"skeleton", "animal.json", "--bones", "out.json", "--prune", "nan"}, 2,
                   {"--prune", "not a number"});
    expect_refused({"skeleton", "animal.json", "--bones", "out.json", "--previous", "leg.poly.txt"}, 1,
                   {"leg.poly.txt: is no JSON: parse error at line 1"});
}

}  // namespace
}  // namespace flg::test
