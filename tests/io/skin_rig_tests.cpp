// SPDX-License-Identifier: MIT
// What skin files say of rigs, as another reader sees it: extras of joints, VRM avatars; and refusals.
#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

const std::vector<const char*> vrm_bones = {"hips",          "spine",         "head",          "leftUpperLeg",
                                            "leftLowerLeg",  "leftFoot",      "rightUpperLeg", "rightLowerLeg",
                                            "rightFoot",     "leftUpperArm",  "leftLowerArm",  "leftHand",
                                            "rightUpperArm", "rightLowerArm", "rightHand",     nullptr};

// A bar with as many joints as a humanoid has bones, and one more.
struct Avatar {
    Avatar() {
        skin = bar();
        while (skin.joint_count() < vrm_bones.size())
            skin.add_joint(1, 2, 3, 0, "more " + std::to_string(skin.joint_count()));
        FlgRigJoint joint = {};
        joint.limit_axis[1] = 1;
        joint.next = FLG_NO_INDEX;
        joints.resize(skin.joint_count(), joint);
        joints[1].limb = FLG_LIMB_LEG;
        joints[1].place = FLG_LIMB_PLACE_MIDDLE;
        joints[1].side = -1;
        joints[1].pair = 1;
        joints[1].index = 2;
        joints[1].capsule_start[0] = skin.joint_positions[3];
        joints[1].capsule_end[0] = skin.joint_positions[3] + 0.5f;
        joints[1].capsule_radius = 0.25f;
        joints[1].limit_twist_min = -0.5f;
        joints[1].limit_twist_max = 2;
        rig.struct_size = sizeof rig;
        rig.joint_count = skin.joint_count();
        rig.joints = joints.data();
        EXPECT_EQ(flgVrmInit(&vrm, sizeof vrm), FLG_OK);
        vrm.authors = authors.data();
        vrm.author_count = 2;
        vrm.bones = bones.data();
    }
    FlgResult write(const std::string& path, bool as_avatar) {
        const FlgSkinView view = skin.view();
        FlgSkinFileWriteDesc desc = flgSkinFileWriteDefaults();
        desc.skin = &view;
        desc.rig = &rig;
        desc.vrm = as_avatar ? &vrm : nullptr;
        desc.name = "bar";
        return flgSkinFileWrite(path.c_str(), &desc);
    }

    TestSkin skin;
    std::vector<FlgRigJoint> joints;
    FlgRig rig = {};
    FlgVrm vrm = {};
    std::vector<const char*> authors = {"Jo \"J\" Doe", "Ann"}, bones = vrm_bones;
};

TEST(SkinRigs, JointsHaveExtras) {
    const Folder folder;
    Avatar avatar;
    ASSERT_EQ(avatar.write(folder.at("a.glb"), false), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    EXPECT_TRUE(model.extensionsUsed.empty());
    const tinygltf::Value knee = model.nodes.at(3).extras.Get("filigree");
    EXPECT_EQ(knee.Get("limb").Get<std::string>(), "leg");
    EXPECT_EQ(knee.Get("place").Get<std::string>(), "middle");
    EXPECT_EQ(knee.Get("side").Get<std::string>(), "right");
    EXPECT_EQ(knee.Get("pair").GetNumberAsInt(), 1);
    EXPECT_EQ(knee.Get("index").GetNumberAsInt(), 2);
    const tinygltf::Value capsule = knee.Get("capsule");
    EXPECT_EQ(capsule.Get("start").Get(0).GetNumberAsDouble(), 0);
    EXPECT_EQ(capsule.Get("end").Get(0).GetNumberAsDouble(), 0.5);
    EXPECT_EQ(capsule.Get("radius").GetNumberAsDouble(), 0.25);
    const tinygltf::Value limit = knee.Get("limit");
    EXPECT_EQ(limit.Get("axis").Get(1).GetNumberAsDouble(), 1);
    EXPECT_EQ(limit.Get("swing").GetNumberAsDouble(), 0);
    EXPECT_EQ(limit.Get("twist").Get(0).GetNumberAsDouble(), -0.5);
    const tinygltf::Value root = model.nodes.at(2).extras.Get("filigree");
    for (const char* none : {"place", "side", "pair", "capsule"}) EXPECT_FALSE(root.Has(none)) << none;
    // Our own reader passes over them.
    EXPECT_EQ(read_skin(folder.at("a.glb")).skin.names, avatar.skin.names);
}

TEST(SkinRigs, AvatarsNameAuthorsAndBones) {
    const Folder folder;
    Avatar avatar;
    ASSERT_EQ(avatar.write(folder.at("a.glb"), true), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    EXPECT_EQ(model.extensionsUsed, std::vector<std::string>{"VRMC_vrm"});
    const tinygltf::Value& vrm = model.extensions.at("VRMC_vrm");
    EXPECT_EQ(vrm.Get("specVersion").Get<std::string>(), "1.0");
    const tinygltf::Value meta = vrm.Get("meta");
    EXPECT_EQ(meta.Get("name").Get<std::string>(), "bar");
    EXPECT_EQ(meta.Get("authors").Get(0).Get<std::string>(), "Jo \"J\" Doe");
    EXPECT_EQ(meta.Get("authors").Get(1).Get<std::string>(), "Ann");
    EXPECT_EQ(meta.Get("licenseUrl").Get<std::string>(), "https://vrm.dev/licenses/1.0/");
    const tinygltf::Value bones = vrm.Get("humanoid").Get("humanBones");
    EXPECT_EQ(bones.Size(), 15u);
    for (size_t j = 0; j < 15; ++j)
        EXPECT_EQ(bones.Get(vrm_bones[j]).Get("node").GetNumberAsInt(), static_cast<int>(2 + j)) << vrm_bones[j];
}

TEST(SkinRigs, WhatIsNotWritten) {
    const Folder folder;
    const auto refused = [&](auto change, const std::string& words) {
        Avatar avatar;
        change(avatar);
        EXPECT_EQ(avatar.write(folder.at("a.glb"), true), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgIoErrorGetMessage()).find(words), std::string::npos) << flgIoErrorGetMessage();
        EXPECT_EQ(folder.entries(), 0u);
    };
    refused([](Avatar& a) { a.rig.joint_count = 1; }, "desc.rig.joint_count: is 1");
    refused([](Avatar& a) { a.rig.joints = nullptr; }, "desc.rig.joints: is null");
    refused([](Avatar& a) { a.joints[2].capsule_end[1] = NAN; }, "desc.rig.joints[2].capsule_end");
    refused([](Avatar& a) { a.vrm.author_count = 0; }, "desc.vrm.author_count: is 0");
    refused([](Avatar& a) { a.vrm.authors = nullptr; }, "desc.vrm.authors: is null");
    refused([](Avatar& a) { a.authors[1] = nullptr; }, "desc.vrm.authors[1]: is null");
    refused([](Avatar& a) { a.vrm.bones = nullptr; }, "desc.vrm.bones: is null");
    refused([](Avatar& a) { a.bones[4] = nullptr; }, "desc.vrm.bones: has no leftLowerLeg");
    refused([](Avatar& a) { a.bones[15] = "hips"; }, "desc.vrm.bones: has two joints that are hips");
}

}  // namespace
}  // namespace flg::test
