// SPDX-License-Identifier: MIT
// Skinned models on the command line: described, and drawn in their poses.
#include <set>

#include "cli_test.h"
#include "filigree/filigree_io.h"
#include "skins/test_skins.h"

namespace flg::test {
namespace {

class Skins : public Cli {
protected:
    void write_skin(const std::string& name, TestSkin skin, const std::vector<TestAnimation>& animations) {
        const FlgSkinView view = skin.view();
        std::vector<FlgSkinAnimation> views;
        for (const TestAnimation& animation : animations) views.push_back(animation.view());
        FlgSkinFileWriteDesc desc = {};
        ASSERT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
        desc.skin = &view;
        desc.animations = views.data();
        desc.animation_count = static_cast<uint32_t>(views.size());
        ASSERT_EQ(flgSkinFileWrite((folder / name).string().c_str(), &desc), FLG_OK) << flgIoErrorGetMessage();
    }
    // The bar curls up to one side, or by another animation to the other and twisted.
    void write_bar() {
        TestAnimation other = curl(4, -0.9f);
        other.name = "twist";
        turn(other.rotations, 4 + 2, about({1, 0, 0}, 2.5f));
        write_skin("bar.glb", bar(), {curl(4), other});
    }
    // Writes the file anew with a piece of its JSON exchanged for one as long.
    void exchange(const std::string& name, const std::string& from, const std::string& to) const {
        std::string bytes = folder.read(name);
        const size_t at = bytes.find(from);
        ASSERT_NE(at, std::string::npos);
        ASSERT_EQ(from.size(), to.size());
        folder.write(name, bytes.replace(at, from.size(), to));
    }
};

TEST_F(Skins, InfoTellsJointsAndAnimations) {
    write_bar();
    const Outcome outcome = done({"info", "bar.glb", "--report", "report.json"});
    EXPECT_NE(outcome.out.find("skin: 4 joints (1 without a parent), 3 bones, 1 parts"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("joints: bar 0, bar 1, bar 2, bar 3\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("animation: curl, 3 keys, 0 to 2 s\n"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("vertices: 530"), std::string::npos) << outcome.out;  // the mesh, as ever
    EXPECT_EQ(outcome.out.find("odd:"), std::string::npos) << outcome.out;
    EXPECT_EQ(report().at("counts").at("joints"), 4);
    EXPECT_EQ(report().at("counts").at("root_joints"), 1);
    EXPECT_EQ(report().at("parameters").at("joints").at(3), "bar 3");
    EXPECT_EQ(report().at("parameters").at("animations").size(), 2u);
    EXPECT_EQ(report().at("parameters").at("animations").at(1).at("name"), "twist");
    EXPECT_EQ(report().at("parameters").at("animations").at(1).at("end"), 2.0);
    const auto influences = report().at("counts").at("joints_of_vertices").get<std::vector<int>>();
    EXPECT_EQ(influences.at(0) + influences.at(1), 530);
    EXPECT_GT(influences.at(1), 0);
}

#if defined(FLG_WITH_RENDERER)

TEST_F(Skins, PicturesAreOfThePoseAtATime) {
    write_bar();
    const auto picture = [&](std::vector<std::string> options) {
        std::vector<std::string> all = {"render", "bar.glb",  "-o",          "out.png",  "--size",
                                        "96x64",  "--report", "report.json", "--camera", "2,1,9,2,1,0"};
        all.insert(all.end(), options.begin(), options.end());
        done(all);
        return folder.read("out.png");
    };
    const std::string rest = picture({});
    EXPECT_EQ(report().at("counts").at("skins"), 1);
    EXPECT_EQ(report().at("counts").at("meshes"), 0);
    EXPECT_EQ(report().at("counts").at("triangles"), 1056);
    const std::string late = picture({"--time", "2"}), middle = picture({"--time", "1"});
    EXPECT_EQ(report().at("parameters").at("time"), 1.0);
    const std::string twisted = picture({"--time", "1", "--animation", "twist"});
    const std::string thin = picture({"--time", "1", "--animation", "twist", "--skinning", "linear"});
    const std::string bones = picture({"--time", "1", "--bones"});
    EXPECT_EQ((std::set<std::string>{rest, late, middle, twisted, thin, bones}).size(), 6u);
    // It stays before the first key and after the last; the first is rest.
    EXPECT_EQ(picture({"--time", "99"}), late);
    EXPECT_EQ(picture({"--time", "0"}), rest);
    EXPECT_EQ(picture({"--time", "-5"}), rest);
    EXPECT_EQ(picture({"--time", "1", "--animation", "curl", "--skinning", "dual"}), middle);
}

TEST_F(Skins, TheCameraSeesThePose) {
    // Moved far away, the bar fills the picture as before.
    TestAnimation away = curl(4, 0);
    away.translations = {0, 0, 0, 100, 0, 0, 100, 0, 0};
    write_skin("bar.glb", bar(), {away});
    done({"render", "bar.glb", "-o", "a.png", "--size", "64x64"});
    done({"render", "bar.glb", "-o", "b.png", "--size", "64x64", "--time", "2", "--report", "report.json"});
    EXPECT_GT(folder.read("b.png").size(), folder.read("a.png").size() / 2);
}

TEST_F(Skins, BadUsageIsRefused) {
    write_bar();
    write_skin("still.glb", bar(), {});
    folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::vector<std::string> files = folder.list();
    const auto refused = [&](std::vector<std::string> options, int status, const std::vector<std::string>& words) {
        options.insert(options.begin(), {"render", "-o", "out.png"});
        expect_refused(options, status, words);
    };
    refused({"bar.glb", "--animation", "curl"}, 2, {"--animation", "--time"});
    refused({"bar.glb", "--time", "1", "--animation", "wave"}, 1, {"bar.glb", "'wave'", "curl, twist"});
    refused({"still.glb", "--time", "1"}, 1, {"still.glb", "no animations"});
    refused({"mesh.obj", "--time", "1"}, 2, {"--time", "no file has a skin"});
    refused({"builtin:spiral", "--bones"}, 2, {"--bones", "no file has a skin"});
    refused({"bar.glb", "--time", "nan"}, 2, {"--time"});
    refused({"bar.glb", "--skinning", "best"}, 2, {"--skinning", "'best'", "dual|linear"});
    EXPECT_EQ(folder.list(), files);
}

// A skin that can't be had is no reason not to draw the mesh, but one not to pose it.
TEST_F(Skins, MeshesOfUnreadableSkinsAreDrawn) {
    write_bar();
    exchange("bar.glb", "\"path\":\"rotation\"", "\"path\":\"scale\"   ");
    const Outcome outcome = done({"render", "bar.glb", "-o", "out.png", "--size", "32x32", "--report", "report.json"});
    EXPECT_NE(outcome.err.find("without its skin"), std::string::npos) << outcome.err;
    EXPECT_EQ(report().at("counts").at("meshes"), 1);
    expect_refused({"render", "bar.glb", "-o", "out.png", "--time", "1"}, 1, {"bar.glb:accessors["});
    EXPECT_NE(done({"info", "bar.glb"}).out.find("odd: no skin is read: bar.glb:accessors["), std::string::npos);
}

#endif

}  // namespace
}  // namespace flg::test
