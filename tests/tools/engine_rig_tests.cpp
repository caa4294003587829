// SPDX-License-Identifier: MIT
// filigree skeleton for engines: bones by a standard's names, T-poses, test motions, refusals.
#include <cmath>

#include "api/drawings.h"
#include "cli_test.h"
#include "filigree/filigree_io.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

// Drawn from the front: a trunk with a head, slanting arms, legs.
constexpr const char* person = R"({
  "parts": [
    {"name": "trunk", "contour": [[-0.4, 0], [0.4, 0], [0.35, 0.9], [0.45, 1.7], [0.15, 1.75], [0.12, 1.95], [0.3, 2.1],
      [0.3, 2.5], [0, 2.65], [-0.3, 2.5], [-0.3, 2.1], [-0.12, 1.95], [-0.15, 1.75], [-0.45, 1.7], [-0.35, 0.9]]},
    {"name": "arm", "contour": [[0.25, 1.65], [1.35, 0.85], [1.45, 1.0], [0.35, 1.85]], "mirrored": true, "detail": 3},
    {"name": "leg", "contour": [[0.12, 0.2], [0.14, -1.8], [0.34, -1.8], [0.4, 0.2]], "mirrored": true, "detail": 3}
  ]
})";

// The outline of a stout person, in one contour: short legs, thick arms.
constexpr const char* stout = R"({
  "parts": [{"name": "stout", "contour": [[0, 0.62], [0.2, 0.1], [0.22, 0], [0.62, 0], [0.66, 0.12], [0.7, 0.8],
    [0.72, 1.3], [0.75, 1.62], [1.5, 1.42], [1.62, 1.62], [1.55, 1.78], [0.7, 2.0], [0.32, 2.05], [0.3, 2.15],
    [0.45, 2.4], [0.45, 2.8], [0, 3.05], [-0.45, 2.8], [-0.45, 2.4], [-0.3, 2.15], [-0.32, 2.05], [-0.7, 2.0],
    [-1.55, 1.78], [-1.62, 1.62], [-1.5, 1.42], [-0.75, 1.62], [-0.72, 1.3], [-0.7, 0.8], [-0.66, 0.12], [-0.62, 0],
    [-0.22, 0], [-0.2, 0.1]]}]
})";

// One arm up, the other hand on the hip.
constexpr const char* waving = R"({
  "parts": [{"name": "waving", "contour": [[-0.227, 0.025], [-0.2, 0.001], [-0.125, 0.005], [-0.082, 0.025],
    [-0.071, 0.05], [-0.053, 0.55], [-0.031, 0.775], [0, 0.816], [0.032, 0.775], [0.053, 0.55], [0.071, 0.05],
    [0.082, 0.025], [0.125, 0.005], [0.2, 0.001], [0.227, 0.025], [0.225, 0.057], [0.175, 0.092], [0.162, 0.125],
    [0.186, 0.9], [0.13, 1.1], [0.175, 1.297], [0.25, 1.344], [0.419, 1.575], [0.485, 1.925], [0.45, 1.955], [0.425,
    1.943], [0.373, 1.775], [0.3, 1.593], [0.195, 1.475], [0.125, 1.441], [0.075, 1.447], [0.065, 1.475], [0.139,
    1.6], [0.115, 1.7], [0.025, 1.758], [-0.075, 1.738], [-0.125, 1.682], [-0.14, 1.625], [-0.121, 1.55], [-0.065,
    1.475], [-0.072, 1.45], [-0.225, 1.44], [-0.469, 1.175], [-0.469, 1.125], [-0.325, 0.926], [-0.3, 0.915],
    [-0.265, 0.95], [-0.342, 1.1], [-0.347, 1.15], [-0.2, 1.286], [-0.175, 1.289], [-0.16, 1.25], [-0.13, 1.1],
    [-0.186, 0.9], [-0.162, 0.125], [-0.175, 0.092], [-0.225, 0.057]]}]
})";

class RigCommand : public Cli {
protected:
    void SetUp() override { folder.write("person.json", person); }

    struct Written {
        std::vector<std::string> names, animations;
        std::vector<std::array<double, 3>> joints;
        std::vector<float> weights;
        std::array<double, 3> at(const std::string& name) const {
            for (size_t j = 0; j < names.size(); ++j)
                if (names[j] == name) return joints[j];
            ADD_FAILURE() << name << " is missing";
            return {};
        }
    };
    Written written(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"skeleton", "person.json", "-o",  "person.glb",
                                              "--quiet",  "--vertices",  "1000"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
        Written out;
        FlgSkinFile file = nullptr;
        EXPECT_EQ(flgSkinFileRead((folder / "person.glb").string().c_str(), nullptr, &file), FLG_OK)
            << flgIoErrorGetMessage();
        if (!file) return out;
        FlgSkinView view = {};
        view.struct_size = sizeof view;
        FlgSkinFileInfo info = flgSkinFileInfoDefaults();
        EXPECT_EQ(flgSkinFileGetView(file, &view), FLG_OK);
        EXPECT_EQ(flgSkinFileGetInfo(file, &info), FLG_OK);
        for (uint32_t j = 0; j < view.joint_count; ++j) {
            const float* p = view.joint_positions + size_t{3} * j;
            out.names.push_back(view.joint_names[j]);
            out.joints.push_back({p[0], p[1], p[2]});
        }
        out.weights.assign(view.vertex_weights, view.vertex_weights + size_t{4} * view.vertex_count);
        for (uint32_t i = 0; i < info.animation_count; ++i) {
            FlgSkinAnimation animation = {};
            animation.struct_size = sizeof animation;
            EXPECT_EQ(flgSkinFileGetAnimation(file, i, &animation), FLG_OK);
            out.animations.push_back(animation.name);
            // The last key is the first again.
            const size_t size = size_t{4} * view.joint_count, last = size * (animation.key_count - 1);
            for (size_t k = 0; k < size; ++k) EXPECT_NEAR(animation.rotations[k], animation.rotations[last + k], 1e-6f);
        }
        flgSkinFileRelease(file);
        return out;
    }
};

TEST_F(RigCommand, JointsHaveTheNamesOfAStandard) {
    const Written vrm = written({"--rig", "vrm"});
    EXPECT_GT(vrm.at("head")[1], vrm.at("hips")[1]);
    EXPECT_GT(vrm.at("leftHand")[0], 1);
    EXPECT_LT(vrm.at("rightFoot")[1], -1);
    EXPECT_EQ(vrm.animations, std::vector<std::string>{"swing"});
    EXPECT_GT(written({"--rig", "unity"}).at("LeftLowerArm")[0], 0.5);
    EXPECT_LT(written({"--rig", "unreal"}).at("calf_r")[0], 0);
}

TEST_F(RigCommand, InATPoseArmsAreLevel) {
    const Written rest = written({"--rig", "vrm"}), posed = written({"--rig", "vrm", "--t-pose"});
    for (const char* side : {"left", "right"}) {
        const std::string arm = side;
        const auto upper = posed.at(arm + "UpperArm"), hand = posed.at(arm + "Hand");
        EXPECT_NEAR(upper[1], hand[1], 1e-5);
        EXPECT_NEAR(upper[2], hand[2], 1e-5);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(upper[k], rest.at(arm + "UpperArm")[k], 1e-5);
            EXPECT_NEAR(posed.at(arm + "Foot")[k], rest.at(arm + "Foot")[k], 1e-5);
        }
    }
    EXPECT_GT(rest.at("leftUpperArm")[1], rest.at("leftHand")[1] + 0.3);
    EXPECT_EQ(rest.weights, posed.weights);
}

TEST_F(RigCommand, MotionsByName) {
    const std::vector<std::string> all = {"walk", "idle", "wave", "swing"};
    EXPECT_EQ(written({"--motion", "walk,idle,wave,swing"}).animations, all);
}

// One outline by default: a spine down to the pelvis, elbows and knees, so engines can have it.
TEST_F(RigCommand, TheOutlineOfAPersonIsAHumanoid) {
    folder.write("stout.json", stout);
    done({"skeleton", "stout.json", "-o", "stout.glb", "--quiet", "--rig", "vrm", "--bones", "bones.json"});
    const Json bones = report("bones.json");
    const size_t count = bones["joints"].size();
    EXPECT_GE(count, 16u);
    EXPECT_LE(count, 24u);
    // Joints mirror, and none but the spine's lies on the axis.
    size_t on_axis = 0;
    for (const Json& joint : bones["joints"]) {
        const double x = joint["position"][0], y = joint["position"][1];
        on_axis += std::abs(x) < 1e-6;
        const auto is_image = [&](const Json& other) {
            return std::hypot(other["position"][0].get<double>() + x, other["position"][1].get<double>() - y) < 3e-6;
        };
        EXPECT_TRUE(std::any_of(bones["joints"].begin(), bones["joints"].end(), is_image)) << joint;
    }
    EXPECT_GE(on_axis, 4u);  // pelvis, chest, neck, head
    // A star's arms are no legs: nothing but its middle is one trunk.
    Json star = {{"parts", {{{"name", "star"}, {"contour", Json::array()}}}}};
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 4 : 1.6, angle = 0.314159265358979 * 2 * i + 1.5707963267948966;
        star["parts"][0]["contour"].push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    folder.write("star.json", star.dump());
    done({"skeleton", "star.json", "--quiet", "--bones", "bones.json"});
    size_t in_the_middle = 0;
    const Json made = report("bones.json");
    EXPECT_GT(made["joints"].size(), 0u);
    for (const Json& joint : made["joints"])
        in_the_middle += std::hypot(joint["position"][0].get<double>(), joint["position"][1].get<double>()) < 1;
    EXPECT_LE(in_the_middle, 1u);  // or no joint there: the root is the middle of two arms
}

// Outlines with heads wider than the trunk, in skirts: humanoids as they are drawn, from the hips up.
TEST_F(RigCommand, PeopleWithLargeHeadsAndInSkirtsAreHumanoids) {
    const std::map<std::string, Line> drawn = {{"big_head", person_with_big_head()},    {"chibi", chibi()},
                                               {"level_arms", chibi_with_level_arms()}, {"ears", chibi_with_ears()},
                                               {"no_neck", chibi_without_neck()},       {"skirt", person_in_a_skirt()},
                                               {"dress", person_in_a_dress()},          {"thin", thin_person()}};
    for (const auto& [name, line] : drawn) {
        Json json = {{"parts", {{{"name", name}, {"curve", line}}}}};
        folder.write("person.json", json.dump());
        const Written vrm = written({"--rig", "vrm"});
        double top = -1e300, bottom = 1e300;
        for (const auto& point : line) top = std::max(top, point[1]), bottom = std::min(bottom, point[1]);
        const double height = top - bottom;
        EXPECT_GT(vrm.at("head")[1], bottom + 0.6 * height) << name;
        EXPECT_GT(vrm.at("head")[1], vrm.at("leftUpperArm")[1]) << name;
        EXPECT_GT(vrm.at("leftUpperArm")[1], vrm.at("hips")[1]) << name;
        EXPECT_LT(vrm.at("hips")[1], bottom + 0.55 * height) << name;
        EXPECT_LE(vrm.at("leftUpperLeg")[1], vrm.at("hips")[1] + 1e-5) << name;
        EXPECT_LT(vrm.at("leftFoot")[1], bottom + 0.15 * height) << name;
        EXPECT_NEAR(vrm.at("leftHand")[0], -vrm.at("rightHand")[0], 1e-5 * height) << name;
        // The hips are the root, so that engines can take all below for the legs.
        written({"--rig", "unity", "--motion", "walk", "--t-pose"});
        written({"--rig", "unreal"});
    }
}

TEST_F(RigCommand, ArmsNeedNotBeMirrorImages) {
    folder.write("person.json", waving);
    for (const char* standard : {"unity", "vrm", "unreal"}) written({"--rig", standard, "--t-pose"});
    const Written unity = written({"--rig", "unity"});
    EXPECT_GT(unity.at("LeftHand")[1], unity.at("Neck")[1]);
    EXPECT_LT(unity.at("RightHand")[1], unity.at("RightLowerArm")[1]);
}

TEST_F(RigCommand, ARootThatTheDrawingNamesStays) {
    Json json = {{"parts", {{{"name", "chibi"}, {"curve", chibi()}}}}};
    folder.write("chibi.json", json.dump());
    done({"skeleton", "chibi.json", "--bones", "bones.json", "--quiet"});
    const std::string root = report("bones.json")["joints"][0]["key"];
    json["root_joint"] = root;
    folder.write("chibi.json", json.dump());
    expect_refused({"skeleton", "chibi.json", "-o", "a.glb", "--rig", "vrm", "--quiet"}, 1,
                   {"chibi.json: no humanoid: its legs hang below its arms", "has to be the root"});
}

TEST_F(RigCommand, AnAvatarHasAnAuthor) {
    written({"--rig", "vrm", "--t-pose", "--author", "Jo Doe"});
    const std::string file = folder.read("person.glb");
    EXPECT_NE(file.find("\"authors\":[\"Jo Doe\"]"), std::string::npos);
    EXPECT_NE(file.find("\"filigree\":{\"limb\":\"leg\""), std::string::npos);
    expect_refused({"skeleton", "person.json", "-o", "a.glb", "--author", "Jo"}, 2, {"--author"});
}

TEST_F(RigCommand, BonesSayTheirLimbs) {
    done({"skeleton", "person.json", "--bones", "bones.json", "--quiet"});
    std::map<std::string, int> count;
    const Json bones = Json::parse(folder.read("bones.json"));
    for (const Json& joint : bones.at("joints"))
        ++count[joint.at("limb").get<std::string>() + std::to_string(joint.at("side").get<int>())];
    for (const char* limb : {"trunk0", "head0", "arm1", "arm-1", "leg1", "leg-1"}) EXPECT_GT(count[limb], 0) << limb;
}

TEST_F(RigCommand, WhatIsNoHumanoidIsRefused) {
    folder.write("bar.poly.txt", "-3 -1\n3 -1\n3 1\n-3 1\n");
    expect_refused({"skeleton", "bar.poly.txt", "-o", "a.glb", "--rig", "unity", "--quiet"}, 1,
                   {"bar.poly.txt: no humanoid: it has no legs"});
    folder.write("egg.poly.txt", "0 -1\n1 -0.5\n1 0.5\n0 1\n-1 0.5\n-1 -0.5\n");
    expect_refused({"skeleton", "egg.poly.txt", "-o", "a.glb", "--t-pose", "--quiet"}, 1, {"no T-pose"});
    expect_refused({"skeleton", "bar.poly.txt", "-o", "a.glb", "--motion", "walk", "--quiet"}, 1, {"no walk"});
    expect_refused({"skeleton", "bar.poly.txt", "-o", "a.glb", "--motion", "fly"}, 2, {"--motion"});
    expect_refused({"skeleton", "bar.poly.txt", "-o", "a.glb", "--rig", "blender"}, 2, {"--rig"});
}

// Drawn from the side, in one plane, nearly alike to both ends: head and tail tell them apart.
TEST_F(RigCommand, AnimalsFromTheSideHaveFourLegsAHeadAndATail) {
    const auto limb = [](const char* name, const std::vector<std::array<double, 3>>& way) {
        nlohmann::json contour = nlohmann::json::array();
        for (const auto& [x, y, r] : way) contour.push_back({x - r, y});
        for (size_t i = way.size(); i-- > 0;) contour.push_back({way[i][0] + way[i][2], way[i][1]});
        return nlohmann::json{{"name", name}, {"contour", contour}, {"thickness", 0.8}};
    };
    for (const double ahead : {1.0, -1.0}) {
        nlohmann::json parts = nlohmann::json::array();
        parts.push_back(
            {{"name", "body"}, {"curve", {{-2.2, 0}, {-1.5, 0.8}, {1.5, 0.9}, {2.3, 0.2}, {1.5, -0.7}, {-1.5, -0.7}}}});
        parts.push_back({{"name", "neck"}, {"contour", {{1.3, 0.2}, {2.1, 0}, {2.7, 1.5}, {2.0, 1.8}}}});
        parts.push_back({{"name", "head"}, {"contour", {{1.9, 1.7}, {2.5, 2.1}, {3.8, 1.4}, {3.7, 1.0}, {2.4, 1.1}}}});
        parts.push_back(
            {{"name", "tail"}, {"contour", {{-2.1, 0.3}, {-1.8, 0}, {-2.7, 1.4}, {-3.0, 2.2}, {-3.1, 1.4}}}});
        parts.push_back(limb("front", {{1.7, -0.2, 0.3}, {1.7, -1.5, 0.2}, {1.8, -2.8, 0.16}}));
        parts.push_back(limb("other", {{1.1, -0.2, 0.3}, {1.0, -1.5, 0.2}, {1.1, -2.75, 0.16}}));
        parts.push_back(limb("hind", {{-1.7, -0.2, 0.35}, {-1.9, -1.5, 0.22}, {-1.7, -2.8, 0.16}}));
        parts.push_back(limb("last", {{-1.1, -0.2, 0.35}, {-1.2, -1.5, 0.22}, {-1.0, -2.75, 0.16}}));
        for (auto& part : parts)
            for (auto& point : part[part.contains("curve") ? "curve" : "contour"])
                point[0] = ahead * point[0].get<double>();
        folder.write("dog.json", nlohmann::json{{"parts", parts}}.dump());
        done({"skeleton", "dog.json", "--bones", "dog-bones.json"});
        const nlohmann::json bones = nlohmann::json::parse(folder.read("dog-bones.json"));
        for (const auto& joint : bones.at("joints")) {
            const std::string name = joint.at("name"),
                              part = bones.at("parts")[joint.at("part").get<size_t>()].at("name");
            const std::string found = joint.at("limb");
            if (part == "tail") {
                EXPECT_EQ(found, "tail") << name << " " << ahead;
            }
            if (part == "head" || part == "neck") {
                EXPECT_TRUE(found == "head" || found == "neck") << name << " " << found;
            }
            if (part == "front" || part == "other" || part == "hind" || part == "last") {
                EXPECT_EQ(found, "leg") << name;
            }
            if (part == "body") {
                EXPECT_EQ(found, "trunk") << name;
            }
        }
    }
}

}  // namespace
}  // namespace flg::test
