// SPDX-License-Identifier: MIT
// filigree skeleton for engines: bones by a standard's names, T-poses, test motions, refusals.
#include <cmath>

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
    EXPECT_EQ(vrm.animations, std::vector<std::string>{"test"});
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
    const std::vector<std::string> all = {"walk", "idle", "wave", "test"};
    EXPECT_EQ(written({"--motion", "walk,idle,wave,swing"}).animations, all);
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

}  // namespace
}  // namespace flg::test
