// SPDX-License-Identifier: MIT
// filigree skeleton --pull: scripts of handles, played into morph targets.
#include <cmath>
#include <cstring>

#include "cli_test.h"
#include "filigree/filigree_io.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

constexpr const char* bar = "0 0\n4 0\n4 1\n0 1\n";
constexpr const char* lift =
    R"({"pins": [[0.1, 0.5, 0.1]], "handles": [{"at": [3.9, 0.5, 0.1], "keys": [
    {"time": 0, "move": [0, 0, 0]}, {"time": 0.5, "move": [0, 1, 0]}, {"time": 1, "move": [0, 0, 0]}]}]})";

class PullCommand : public Cli {
protected:
    void SetUp() override {
        folder.write("bar.poly.txt", bar);
        folder.write("lift.json", lift);
    }
    std::vector<std::string> with(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"skeleton", "bar.poly.txt", "--vertices", "600",
                                              "--quiet",  "--report",     "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    // Expects a script to be refused, by one line that says all of these.
    void refused(const std::string& script, const std::vector<std::string>& words) const {
        folder.write("bad.json", script);
        std::vector<std::string> all = {"bad.json"};
        all.insert(all.end(), words.begin(), words.end());
        expect_refused({"skeleton", "bar.poly.txt", "--vertices", "600", "-o", "a.glb", "--pull", "bad.json"}, 1, all);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.glb"));
    }
};

// What a file has besides its skin; a vertex near a place at rest.
struct Pulled {
    explicit Pulled(const std::string& path) {
        EXPECT_EQ(flgSkinFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_EQ(flgSkinFileGetInfo(file, &info), FLG_OK);
        EXPECT_EQ(flgSkinFileGetView(file, &view), FLG_OK);
        for (uint32_t i = 0; i < info.morph_count; ++i)
            EXPECT_EQ(flgSkinFileGetMorphTarget(file, i, &targets.emplace_back(flgMorphTargetDefaults())), FLG_OK);
        EXPECT_EQ(info.morph_animation_count, 1u);
        EXPECT_EQ(flgSkinFileGetMorphAnimation(file, 0, &animation), FLG_OK);
    }
    ~Pulled() { flgSkinFileRelease(file); }
    uint32_t near(float x, float y, float z) const {
        uint32_t best = 0;
        const auto off = [&](uint32_t v) {
            const float* p = view.positions + size_t{3} * v;
            return std::hypot(p[0] - x, p[1] - y, p[2] - z);
        };
        for (uint32_t v = 0; v < view.vertex_count; ++v)
            if (off(v) < off(best)) best = v;
        return best;
    }
    // By how much a vertex is moved at key `key`.
    std::array<double, 3> move(uint32_t key, uint32_t vertex) const {
        std::array<double, 3> sum{};
        for (size_t i = 0; i < targets.size(); ++i)
            for (size_t k = 0; k < 3; ++k)
                sum[k] += double{animation.weights[key * targets.size() + i]} *
                          double{targets[i].moves[size_t{3} * vertex + k]};
        return sum;
    }
    uint32_t key_at(float time) const {
        for (uint32_t key = 0; key < animation.key_count; ++key)
            if (std::abs(animation.times[key] - time) < 1e-4f) return key;
        ADD_FAILURE() << "no key at " << time;
        return 0;
    }
    FlgSkinFile file = nullptr;
    FlgSkinFileInfo info = flgSkinFileInfoDefaults();
    FlgSkinView view = flgSkinViewDefaults();
    std::vector<FlgMorphTarget> targets;
    FlgMorphAnimation animation = flgMorphAnimationDefaults();
};

TEST_F(PullCommand, KeysBecomeMorphTargetsWithinTheTolerance) {
    std::string script = lift;
    script.insert(1, R"("tolerance": 0, )");
    folder.write("exact.json", script);
    done(with({"-o", "exact.glb", "--pull", "exact.json"}));
    const Json exact = report();
    EXPECT_EQ(exact.at("counts").at("pull_frames"), 31);
    EXPECT_EQ(exact.at("quality").at("pull_largest_error"), 0);
    const Pulled all((folder / "exact.glb").string());
    const uint32_t pinned = all.near(0.1f, 0.5f, 0.3f), lifted = all.near(3.9f, 0.5f, 0.3f);
    const uint32_t middle = all.key_at(0.5f);
    EXPECT_NEAR(all.move(middle, lifted)[1], 1, 0.15);
    EXPECT_NEAR(all.move(middle, pinned)[1], 0, 0.1);
    EXPECT_LT(std::abs(all.move(0, lifted)[1]), 1e-3);

    done(with({"-o", "loose.glb", "--pull", "lift.json"}));
    const Json loose = report();
    EXPECT_LT(loose.at("counts").at("morph_targets"), exact.at("counts").at("morph_targets"));
    const double size = std::hypot(4, 1, 0.6), error = loose.at("quality").at("pull_largest_error");
    EXPECT_GT(error, 0);
    EXPECT_LE(error, 0.002 * 1.1 * size);
    // What is between its keys is as near to the frames of the exact one.
    const Pulled few((folder / "loose.glb").string());
    ASSERT_EQ(few.view.vertex_count, all.view.vertex_count);
    double largest = 0;
    for (uint32_t key = 0; key < all.animation.key_count; ++key) {
        const float time = all.animation.times[key];
        uint32_t next = 0;
        while (few.animation.times[next] < time) ++next;
        const uint32_t before = next == 0 ? 0 : next - 1;
        const double span = double{few.animation.times[next]} - double{few.animation.times[before]};
        const double share = span > 0 ? (double{time} - double{few.animation.times[before]}) / span : 0;
        for (uint32_t v = 0; v < few.view.vertex_count; ++v) {
            const auto a = few.move(before, v), b = few.move(next, v), exactly = all.move(key, v);
            double square = 0;
            for (size_t k = 0; k < 3; ++k) square += std::pow(a[k] + share * (b[k] - a[k]) - exactly[k], 2);
            largest = std::max(largest, std::sqrt(square));
        }
    }
    EXPECT_NEAR(largest, error, 1e-4 * size);
}

TEST_F(PullCommand, TheSameScriptGivesTheSameBits) {
    for (const char* workers : {"0", "1", "2"})
        done(with({"-o", std::string("w") + workers + ".glb", "--pull", "lift.json", "--workers", workers}));
    EXPECT_EQ(folder.read("w0.glb"), folder.read("w1.glb"));
    EXPECT_EQ(folder.read("w0.glb"), folder.read("w2.glb"));
}

// With bones: what is pulled in a pose is undone through the joints, and they do it again.
TEST_F(PullCommand, BonesMoveMeanwhile) {
    std::string script = lift;
    script.insert(1, R"("motion": "swing", "name": "both", "tolerance": 0, )");
    folder.write("both.json", script);
    done(with({"-o", "both.glb", "--pull", "both.json", "--pulled", "both.ply", "--pulled-at", "0.5"}));
    const Pulled both((folder / "both.glb").string());
    EXPECT_EQ(both.info.animation_count, 2u);
    ASSERT_EQ(both.animation.animation, 1u);
    FlgSkinAnimation bones = flgSkinAnimationDefaults();
    ASSERT_EQ(flgSkinFileGetAnimation(both.file, 1, &bones), FLG_OK);
    EXPECT_STREQ(bones.name, "both");
    const uint32_t joints = both.view.joint_count, key = both.key_at(0.5f);
    std::vector<float> rotations(size_t{4} * joints), matrices(size_t{12} * joints),
        posed(size_t{3} * both.view.vertex_count);
    float translation[3];
    ASSERT_EQ(flgSkinAnimationSample(&bones, joints, 0.5f, rotations.data(), translation), FLG_OK);
    ASSERT_EQ(flgSkinPose(&both.view, rotations.data(), translation, matrices.data(), nullptr), FLG_OK);
    std::vector<float> shaped(both.view.positions, both.view.positions + posed.size());
    for (uint32_t v = 0; v < both.view.vertex_count; ++v)
        for (size_t k = 0; k < 3; ++k) shaped[size_t{3} * v + k] += static_cast<float>(both.move(key, v)[k]);
    FlgSkinView view = both.view;
    view.positions = shaped.data();
    ASSERT_EQ(flgSkinDeform(&view, FLG_SKINNING_LINEAR, matrices.data(), posed.data(), nullptr), FLG_OK);
    FlgMeshFile mesh = nullptr;
    ASSERT_EQ(flgMeshFileRead((folder / "both.ply").string().c_str(), nullptr, &mesh), FLG_OK);
    FlgMeshView pulled = flgMeshViewDefaults();
    ASSERT_EQ(flgMeshFileGetView(mesh, &pulled), FLG_OK);
    ASSERT_EQ(pulled.vertex_count, both.view.vertex_count);
    for (size_t i = 0; i < posed.size(); ++i) EXPECT_NEAR(posed[i], pulled.columns[0].data[i], 1e-4f) << i;
    flgMeshFileRelease(mesh);
}

// Each shape reaches as far on each level, and one animation moves them all.
TEST_F(PullCommand, LevelsOfDetailArePulledToo) {
    done(with({"-o", "levels.glb", "--pull", "lift.json", "--lod", "300,100"}));
    const std::string glb = folder.read("levels.glb");
    uint32_t size = 0;
    std::memcpy(&size, glb.data() + 12, sizeof size);
    const Json json = Json::parse(glb.substr(20, size));
    ASSERT_EQ(json.at("meshes").size(), 3u);
    const auto moves = [&](size_t mesh) {
        std::vector<Json> shapes;
        for (const Json& target : json.at("meshes").at(mesh).at("primitives").at(0).at("targets"))
            shapes.push_back(json.at("accessors").at(target.at("POSITION").get<size_t>()));
        return shapes;
    };
    const std::vector<Json> finest = moves(0);
    ASSERT_GE(finest.size(), 2u);
    for (const size_t level : {1, 2}) {
        const std::vector<Json> shapes = moves(level);
        ASSERT_EQ(shapes.size(), finest.size());
        for (size_t i = 0; i < shapes.size(); ++i) {
            for (const char* end : {"min", "max"})
                for (size_t k = 0; k < 3; ++k)
                    EXPECT_NEAR(shapes[i].at(end).at(k), finest[i].at(end).at(k), 0.15) << level << ' ' << i;
        }
        EXPECT_EQ(json.at("meshes").at(level).at("extras"), json.at("meshes").at(0).at("extras"));
    }
    size_t moved = 0;
    for (const Json& channel : json.at("animations").back().at("channels"))
        moved += channel.at("target").at("path") == "weights";
    EXPECT_EQ(moved, 3u);
    const Pulled again((folder / "levels.glb").string());
    EXPECT_EQ(again.info.warning_count, 0u);
}

// A point that is pulled hard takes what is around along.
TEST_F(PullCommand, ARadiusSaysHowMuchIsPulledAt) {
    std::vector<double> moved;
    for (const char* radius : {"0", "0.4"}) {
        folder.write("wide.json", std::string(R"({"radius": )") + radius +
                                      R"(, "pins": [[0.1, 0.1, 0.1], [0.1, 0.9, 0.1], [3.9, 0.1, 0.1], [3.9, 0.9, 0.1]],
            "handles": [{"at": [2, 0.5, 0.3],
                         "keys": [{"time": 0, "move": [0, 0, 0]}, {"time": 0.5, "move": [0, 0, 1]}]}]})");
        done(with({"-o", "wide.glb", "--pull", "wide.json"}));
        const Pulled wide((folder / "wide.glb").string());
        moved.push_back(wide.move(wide.key_at(0.5f), wide.near(2.25f, 0.5f, 0.3f))[2]);
    }
    EXPECT_GT(moved[1], moved[0] + 0.02);
}

TEST_F(PullCommand, MeshesArePulledToo) {
    done({"skeleton", "bar.poly.txt", "--vertices", "600", "-o", "bar.glb", "--quiet"});
    done({"skeleton", "--mesh", "bar.glb", "-o", "pulled.glb", "--pull", "lift.json", "--quiet"});
    const Pulled pulled((folder / "pulled.glb").string());
    EXPECT_GT(pulled.info.morph_count, 2u);
    EXPECT_NEAR(pulled.move(pulled.key_at(0.5f), pulled.near(3.9f, 0.5f, 0.3f))[1], 1, 0.15);
}

TEST_F(PullCommand, BadScriptsAreRefusedByPlaceAndValue) {
    const std::string key = R"({"time": 0, "position": [4, 0.5, 0]})";
    refused(R"({"handles": [{"at": [9, 0.5, 0], "keys": [)" + key + "]}]}",
            {"handles[0].at: (9, 0.5, 0) is ", "from the surface; at most"});
    refused(R"({"pins": [[4, 0.5, 0], [0, 7, 0]], "handles": [{"at": [4, 0.5, 0], "keys": [)" + key + "]}]}",
            {"pins[1]: (0, 7, 0) is ", "from the surface"});
    refused(R"({"handles": [{"at": [4, 0.5, 0], "keys": []}]})", {"handles[0].keys: is empty"});
    refused(R"({"handles": [{"at": [4, 0.5, 0]}]})", {"handles[0]: needs `keys`"});
    refused(R"({"handles": []})", {"handles: is empty"});
    refused(R"({"handles": [{"at": [4, 0.5, 0], "keys": [)" + key + ", " + key + "]}]}",
            {"handles[0].keys[1].time: is 0 after 0; times of a handle must rise"});
    refused(R"({"handles": [{"at": [4, 0.5, NaN], "keys": [)" + key + "]}]}", {"parse error", "last read: '0.5, N'"});
    refused(R"({"handles": [{"at": [4, 0.5, 1e99], "keys": [)" + key + "]}]}", {"handles[0].at[2]: "});
    refused(R"({"handles": [{"at": [4, 0.5, 0], "keys": [{"time": -1, "position": [0, 0, 0]}]}]})",
            {"handles[0].keys[0].time: "});
    refused(R"({"handles": [{"at": [4, 0.5, 0], "keys": [{"time": 0}]}]})",
            {"handles[0].keys[0]: needs `position` or `move`"});
    refused(R"({"handles": [{"at": [4, 0.5, 0], "keys": [)" + key + R"(, {"time": 1, "move": [0, 0, 0]}]}]})",
            {"handles[0].keys[1]: all keys of a handle must be positions, or all moves"});
    refused(R"({"radius": -2, "handles": [{"at": [4, 0.5, 0], "keys": [)" + key + "]}]}", {"radius: "});
    refused(R"({"motion": "dance", "handles": [{"at": [4, 0.5, 0], "keys": [)" + key + "]}]}",
            {"motion: the model has no motion 'dance'; it has swing"});
    const std::vector<std::string> plain = {"skeleton", "bar.poly.txt", "-o", "a.glb"};
    const auto usage = [&](std::vector<std::string> more, const std::string& words) {
        more.insert(more.begin(), plain.begin(), plain.end());
        expect_refused(more, 2, {words});
    };
    usage({"--pulled", "a.ply"}, "--pulled: needs --pull");
    usage({"--pull", "lift.json", "--pulled-at", "1"}, "--pulled-at: needs --pulled");
    usage({"--pull", "lift.json", "--pulled", "a.txt"}, "--pulled: a.txt must end with");
    expect_refused(with({"--pull", "lift.json", "--pulled", "a.ply", "--pulled-at", "3"}), 1,
                   {"--pulled-at: 3 is not within 0 to 1"});
}

}  // namespace
}  // namespace flg::test
