// SPDX-License-Identifier: MIT
// filigree panels, and what its pictures start from: built-in meshes, the first operations of a script, styles by their
// displacement.
#include "cli_test.h"

namespace flg::test {
namespace {

using Panels = Cli;

const char kDots[] =
    R"({"operations": [
      {"name": "bands", "op": "contour", "on": "root", "from": {"stretches": [{"loop": 0}]}, "delta": 0.05, "count": 3},
      {"name": "dots", "op": "contour", "on": "bands.part:1/2", "from": {"borders": "outer"}, "delta": 0.01}],
     "materials": [
      {"on": "default", "color": "#ffffff"},
      {"on": "bands.part:1/2", "color": "#ff0000"},
      {"on": ["bands", "dots.foreground"], "color": "#00ff00"}]})";

TEST_F(Panels, BuiltInMeshesAreReadWhereverMeshesAre) {
    done({"info", "builtin:dish", "--report", "report.json"});
    done({"mesh", "repair", "builtin:vase:40", "-o", "vase.ply", "--report", "vase.json"});
    const nlohmann::json vase = report("vase.json");
    EXPECT_GT(vase.at("counts").at("triangles"), 1000);
    EXPECT_EQ(vase.at("counts").at("borders"), 2);
    expect_refused({"mesh", "repair", "builtin:pot", "-o", "out.ply"}, 1, {"builtin:pot", "figure", "vase"});
    expect_refused({"mesh", "repair", "builtin:vase:many", "-o", "out.ply"}, 1, {"many"});
}

TEST_F(Panels, TheFirstOperationsOfAScriptTakeTheirMaterialsAlone) {
    folder.write("dots.json", kDots);
    done({"tangle", "builtin:dish", "dots.json", "--first", "1", "-o", "one.glb", "--report", "one.json"});
    done({"tangle", "builtin:dish", "dots.json", "-o", "two.glb", "--report", "two.json"});
    EXPECT_EQ(report("one.json").at("counts").at("steps"), 1);
    EXPECT_EQ(report("one.json").at("counts").at("materials"), 2);
    EXPECT_EQ(report("two.json").at("counts").at("steps"), 2);
    EXPECT_EQ(report("two.json").at("counts").at("materials"), 3);
    expect_refused({"tangle", "builtin:dish", "dots.json", "--first", "3", "-o", "out.glb"}, 2, {"--first", "2"});
}

TEST_F(Panels, DisplacementIsTheSizeOfTheStyle) {
    const std::vector<std::string> stylize = {"stylize",        "--style",  "builtin:curls", "--target",
                                              "builtin:spiral", "--report", "report.json"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), stylize.begin(), stylize.end());
        return more;
    };
    done(with({"--scale", "1", "-o", "drawn.xyz"}));
    const double rms = report().at("quality").at("displacement_rms");
    done(with({"--displacement", std::to_string(2.0 * rms), "-o", "large.xyz"}));
    done(with({"--scale", "2", "-o", "twice.xyz"}));
    EXPECT_NE(folder.read("large.xyz"), folder.read("drawn.xyz"));
    EXPECT_EQ(folder.read("large.xyz").size() / 100, folder.read("twice.xyz").size() / 100);
    expect_refused(with({"--displacement", "1", "--scale", "2", "-o", "out.xyz"}), 2, {"--displacement"});
}

#if defined(FLG_WITH_RENDERER)
TEST_F(Panels, DrawsWhatThePictureSays) {
    const auto draw = [&](const std::string& panel) {
        folder.write("picture.json", R"({"size": [120, 60], "all": {"camera": [20, 10]}, "panels": [)" + panel + "]}");
        done({"panels", "picture.json", "-o", "out.png"});
        return folder.read("out.png");
    };
    const std::string one = R"({"show": [{"file": "builtin:spiral", "color": "#ff0000", "radius": 0.02}]})";
    const std::string picture = draw(one);
    EXPECT_EQ(picture.substr(1, 3), "PNG");
    EXPECT_EQ(picture.substr(16, 8), std::string("\0\0\0\x78\0\0\0\x3c", 8));
    EXPECT_EQ(draw(one), picture);
    EXPECT_NE(draw(one + "," + one), picture);
    EXPECT_NE(draw(R"({"show": [{"file": "builtin:spiral", "color": "#00ff00", "radius": 0.02}]})"), picture);
    EXPECT_NE(draw(R"({"title": "Red", "show": [{"file": "builtin:spiral", "color": "#ff0000", "radius": 0.02}]})"),
              picture);
}

TEST_F(Panels, BadPicturesAreRefused) {
    const auto refuse = [&](const std::string& picture, const std::vector<std::string>& words) {
        folder.write("picture.json", picture);
        expect_refused({"panels", "picture.json", "-o", "out.png"}, 1, words);
    };
    refuse(R"({"size": [10], "panels": []})", {"picture.json", "size"});
    refuse(R"({"size": [10, 10], "panels": []})", {"panels"});
    refuse(R"({"size": [10, 10], "panels": [{"show": [{"file": "nosuch.xyz"}]}]})", {"nosuch.xyz"});
    refuse(R"({"size": [10, 10], "panels": [{"show": [{"file": "builtin:vase", "radius": 1}]}]})", {"radius"});
    refuse(R"({"size": [10, 10], "panels": [{"camera": [1], "show": []}]})", {"camera"});
    expect_refused({"panels", "picture.json", "-o", "out.bmp"}, 2, {"out.bmp"});
    EXPECT_FALSE(folder.has("out.png"));
}
#endif

}  // namespace
}  // namespace flg::test
