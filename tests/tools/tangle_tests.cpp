// SPDX-License-Identifier: MIT
// filigree tangle: scripts of operations, what they leave in files, and what is wrong with those that can't be run.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

class Tangle : public Cli {
protected:
    void SetUp() override { folder.write("sphere.off", sphere(16).off()); }

    std::vector<std::string> command(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"tangle",  "sphere.off", "script.json", "-o",
                                              "out.glb", "--report",   "report.json", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    void expect_refused(const std::string& script, const std::string& sentence) const {
        folder.write("script.json", script);
        const Outcome outcome = run(command());
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
        EXPECT_FALSE(folder.has("out.glb"));
    }
};

// Bands, each a group by turns; dots in every other one; these raised.
const char* const kScript = R"({
  "unit": "metres",
  "operations": [
    {"name": "bands", "op": "contour", "on": "root", "from": {"points": [312]}, "delta": 0.6, "count": 0},
    {"name": "dots", "op": "contour", "on": "bands.background", "each": true,
     "from": {"samples": {"radius": 0.35}}, "delta": 0.1},
    {"op": "displace", "on": "dots.foreground", "amount": 0.05, "bias": 0.7},
    {"name": "rest", "op": "outline", "on": "bands.foreground", "size": 0.05}
  ]})";

TEST_F(Tangle, RunsAScriptAndWritesMasks) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--curves", "borders.xyz"}));
    EXPECT_GT(report().at("counts").at("border_points"), 100);
    EXPECT_FALSE(folder.read("borders.xyz").empty());
    const nlohmann::json counts = report().at("counts");
    EXPECT_GT(counts.at("leaves"), 20);
    EXPECT_EQ(counts.at("depth"), 2);
    // Of 6 bands 3 are divided, each by itself, then the dots are raised and the others outlined.
    EXPECT_EQ(counts.at("steps"), 6);
    done({"mesh", "info", "masks.ply", "--report", "info.json"});
    const nlohmann::json info = report("info.json").at("counts");
    EXPECT_EQ(info.at("input_regions"), counts.at("leaves"));
    EXPECT_EQ(info.at("triangles"), counts.at("cut_triangles"));
    EXPECT_EQ(folder.read("out.glb").substr(0, 4), "glTF");
}

TEST_F(Tangle, SameBitsWithAnyWorkersAndBudget) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--workers", "0"}));
    const std::string expected = folder.read("masks.ply");
    done(command({"--masks", "masks.ply", "--workers", "3", "--budget", "200"}));
    EXPECT_TRUE(folder.read("masks.ply") == expected);
}

// Two squares side by side, of a material each, with a half of the texture each; or the second's is folded.
std::string panels(bool is_folded = false) {
    constexpr int cells = 10;
    std::ostringstream out;
    out << "mtllib panels.mtl\n";
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= 2 * cells; ++i) {
            const int u = is_folded ? std::min(i, 3 * cells - i) : i;
            out << "v " << 1.0 * i / cells << ' ' << 1.0 * j / cells << " 0\nvt " << 0.5 * u / cells << ' '
                << 1.0 * j / cells << '\n';
        }
    }
    const auto corner = [&](int i, int j) {
        const std::string number = std::to_string(1 + j * (2 * cells + 1) + i);
        return " " + number + "/" + number;
    };
    for (int panel = 0; panel < 2; ++panel) {
        out << (panel == 0 ? "usemtl wood\n" : "usemtl iron\n");
        for (int j = 0; j < cells; ++j)
            for (int i = panel * cells; i < (panel + 1) * cells; ++i)
                out << 'f' << corner(i, j) << corner(i + 1, j) << corner(i + 1, j + 1) << corner(i, j + 1) << '\n';
    }
    return out.str();
}
const char* const kPanelLooks = "newmtl wood\nKd 0.5 0.3 0.1\nnewmtl iron\nKd 0.2 0.2 0.2\n";
const char* const kPanelScript = R"({
  "unit": "metres",
  "operations": [{"name": "rim", "op": "contour", "on": "root", "from": {"borders": "outer"}, "delta": 0.2}],
  "materials": [{"name": "gold", "on": "rim.foreground", "color": "#f0c46a"}]})";

TEST_F(Tangle, BakesASetOfMapsForEachMaterial) {
    folder.write("panels.obj", panels());
    folder.write("panels.mtl", kPanelLooks);
    folder.write("script.json", kPanelScript);
    done({"tangle", "panels.obj", "script.json", "-o", "baked", "--bake", "64", "--quiet"});
    const nlohmann::json said = report("baked.json");
    EXPECT_EQ(said.at("size"), 64);
    ASSERT_EQ(said.at("sets").size(), 2);
    EXPECT_EQ(said.at("sets")[0].at("material"), "wood");
    EXPECT_EQ(said.at("sets")[1].at("material"), "iron");
    for (const nlohmann::json& set : said.at("sets")) {
        ASSERT_EQ(set.at("maps").size(), 7);
        for (const auto& [map, about] : set.at("maps").items()) {
            const std::string png = folder.read(about.at("file"));
            EXPECT_EQ(png.substr(1, 3), "PNG") << map;
            const bool is_deep = map == "ids" || map == "distance" || map == "height";
            ASSERT_GT(png.size(), 33u);
            EXPECT_EQ(png[19], 64) << map;
            EXPECT_EQ(png[24], is_deep ? 16 : 8) << map;
        }
    }
    // The middle is 0.3 m from the border, which lies 0.2 m inside the edge. At corners it cuts off half a cell.
    const nlohmann::json& distance = said.at("sets")[0].at("maps").at("distance");
    const double most = distance.at("metres_per_step").get<double>() * 65534;
    EXPECT_GE(most, 0.3 - 1.0 / 64);
    EXPECT_LE(most, (0.2 + 0.1 / 2) * std::sqrt(2.0));
}

TEST_F(Tangle, BakesTheSameWithAnyWorkersAndBudget) {
    folder.write("panels.obj", panels());
    folder.write("panels.mtl", kPanelLooks);
    folder.write("script.json", kPanelScript);
    done({"tangle", "panels.obj", "script.json", "-o", "a", "--bake", "64", "--workers", "0", "--quiet"});
    done({"tangle", "panels.obj", "script.json", "-o", "b", "--bake", "64", "--workers", "3", "--budget", "100",
          "--quiet"});
    for (const std::string map : {"ids", "distance", "borders", "height", "normal", "color", "material"})
        EXPECT_TRUE(folder.read("a.0." + map + ".png") == folder.read("b.0." + map + ".png")) << map;
}

TEST_F(Tangle, ARefusedBakeWritesNothing) {
    folder.write("panels.obj", panels(true));
    folder.write("panels.mtl", kPanelLooks);
    folder.write("script.json", kPanelScript);
    const Outcome outcome = run({"tangle", "panels.obj", "script.json", "-o", "baked.glb", "--bake", "64", "--quiet"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("overlap at "), std::string::npos) << outcome.err;
    for (const std::string map : {"ids", "distance", "borders", "height", "normal", "color", "material"})
        EXPECT_FALSE(folder.has("baked.0." + map + ".png")) << map;
    EXPECT_FALSE(folder.has("baked.json"));
    EXPECT_FALSE(folder.has("baked.glb"));
}

TEST_F(Tangle, SaysWhyItCantBake) {
    folder.write("script.json", kScript);
    const Outcome outcome = run({"tangle", "sphere.off", "script.json", "-o", "baked", "--bake", "64", "--quiet"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("sphere.off: has no texture coordinates"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("unwrap it first"), std::string::npos) << outcome.err;
    for (const std::string size : {"0", "16385", "-1", "many"})
        EXPECT_EQ(run({"tangle", "sphere.off", "script.json", "-o", "baked", "--bake", size}).status, 2) << size;
    EXPECT_EQ(run({"tangle", "sphere.off", "script.json", "-o", "baked", "--bake", "64", "--maps", "hue"}).status, 2);
    EXPECT_EQ(run({"tangle", "sphere.off", "script.json", "-o", "out.glb", "--maps", "ids"}).status, 2);
}

TEST_F(Tangle, ScriptsThatCantBeRunSayWhere) {
    expect_refused("{", "script.json");
    expect_refused("[]", "must be an object");
    expect_refused("{}", "needs `operations`");
    expect_refused(R"({"operations": [], "colours": {}})", "does not know `colours`");
    expect_refused(R"({"operations": [{"op": "spiral", "on": "root"}]})", "operations[0].op: is `spiral`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "form": {}}]})", "does not know `form`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root"}]})", "operations[0]: needs `from`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "leaf", "from": {}}]})", "names no operation before");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"borders": "outer"}}]})",
                   "closed surface");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"points": [1]}, "delta": 0}]})",
                   "desc.delta");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"points": [1, 9999999]}}]})",
                   "there is no vertex 9999999");
    expect_refused(R"({"operations": [{"op": "join", "on": []}]})", "selects no region");
}

TEST_F(Tangle, NoFileTakesTheOthersPlace) {
    folder.write("script.json", kScript);
    const std::vector<std::vector<std::string>> mistakes = {
        {"--document", "script.json"}, {"--document", "./out.glb"}, {"--masks", "m.ply", "--document", "m.ply"}};
    for (const std::vector<std::string>& mistake : mistakes) {
        const Outcome outcome = run(command(mistake));
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("is both the"), std::string::npos) << outcome.err;
        EXPECT_EQ(folder.read("script.json"), kScript);
        EXPECT_FALSE(folder.has("out.glb"));
    }
}

TEST_F(Tangle, WhatDividesNothingIsSaid) {
    folder.write("script.json", R"({"operations": [
        {"op": "contour", "on": "root", "from": {"points": [312]}, "delta": 1000}]})");
    done(command({"--curves", "borders.xyz"}));
    const std::string warnings = report().at("warnings").dump();
    EXPECT_NE(warnings.find("operations[0] divides nothing"), std::string::npos) << warnings;
    EXPECT_NE(warnings.find("borders.xyz: not written, no border is seen"), std::string::npos) << warnings;
    EXPECT_FALSE(folder.has("borders.xyz"));
    EXPECT_TRUE(folder.has("out.glb"));
}

TEST_F(Tangle, DefaultsAreInTheScriptsUnit) {
    const std::string operation = R"("operations": [{"op": "polka_dots", "on": "root")";
    folder.write("script.json", R"({"unit": "size", )" + operation + "}]}");
    done(command());
    const nlohmann::json with_defaults = report().at("counts");
    folder.write("script.json", R"({"unit": "size", )" + operation + R"(, "size": 0.1, "spacing": 0.3}]})");
    done(command());
    EXPECT_EQ(report().at("counts"), with_defaults);
}

// The materials of a .glb file, by name, and the indices of their primitives.
std::map<std::string, nlohmann::json> materials_of(const std::string& glb) {
    uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    const nlohmann::json json = nlohmann::json::parse(glb.substr(20, length));
    std::map<std::string, nlohmann::json> found;
    for (const nlohmann::json& primitive : json.at("meshes").at(0).at("primitives")) {
        nlohmann::json material = json.at("materials").at(primitive.at("material").get<size_t>());
        material["triangles"] =
            json.at("accessors").at(primitive.at("indices").get<size_t>()).at("count").get<uint32_t>() / 3;
        const std::string name = material.at("name");
        EXPECT_TRUE(found.emplace(name, std::move(material)).second) << name << " has two primitives";
    }
    return found;
}

TEST_F(Tangle, MaterialsGoToTheirRegions) {
    nlohmann::json script = nlohmann::json::parse(kScript);
    script["materials"] = nlohmann::json::parse(R"([
        {"on": "default", "color": [0.5, 0.25, 0.125], "border": {"color": "#ff0000", "width": 2}},
        {"on": "bands.foreground", "name": "clay", "color": "#808080", "roughness": 0.75},
        {"on": "dots.foreground", "name": "gold", "color": "#ffffff", "metallic": 1, "border": {"width": 0}},
        {"on": {"of": "rest.foreground", "in": "bands.part:0"}, "name": "first", "color": [0, 0, 1]}])");
    folder.write("script.json", script.dump());
    done(command({"--masks", "masks.ply"}));
    const auto found = materials_of(folder.read("out.glb"));
    ASSERT_EQ(found.size(), 4u);
    const auto& pbr = [&](const char* name) { return found.at(name).at("pbrMetallicRoughness"); };
    EXPECT_EQ(pbr("default").at("baseColorFactor"), nlohmann::json::parse("[0.5, 0.25, 0.125, 1]"));
    // Half of 255 in sRGB is 0.2159 of the light.
    EXPECT_NEAR(pbr("clay").at("baseColorFactor")[0].get<double>(), 0.2159, 1e-4);
    EXPECT_EQ(pbr("clay").at("roughnessFactor"), 0.75);
    EXPECT_EQ(pbr("clay").at("metallicFactor"), 0);
    EXPECT_EQ(pbr("gold").at("metallicFactor"), 1);
    EXPECT_EQ(found.at("clay").at("extras").at("border_width_px"), 2) << "the default's";
    EXPECT_EQ(found.at("clay").at("extras").at("border_color"), nlohmann::json::parse("[1.0, 0.0, 0.0]"));
    EXPECT_FALSE(found.at("gold").contains("extras"));
    // The outline of the first band is around its middle; of the other bands it is clay, as all of theirs.
    uint32_t triangles = 0;
    for (const auto& [name, material] : found) triangles += material.at("triangles").get<uint32_t>();
    EXPECT_EQ(report().at("counts").at("cut_triangles"), triangles);
    EXPECT_EQ(report().at("counts").at("materials"), 4);
    EXPECT_LT(found.at("first").at("triangles"), found.at("clay").at("triangles"));
}

TEST_F(Tangle, RenderDrawsMaterials) {
    const auto drawn = [&](const std::string& materials) {
        nlohmann::json script = nlohmann::json::parse(kScript);
        if (!materials.empty()) script["materials"] = nlohmann::json::parse(materials);
        folder.write("script.json", script.dump());
        done(command());
        done({"render", "out.glb", "-o", "out.png", "--size", "64x64"});
        return folder.read("out.png");
    };
    // Nothing said; one material, of two colours; dots of another colour, of metal, within a line.
    const std::string scripts[] = {
        "",
        R"([{"on": "default", "color": "#902010"}])",
        R"([{"on": "default", "color": "#102090"}])",
        R"([{"on": "dots.foreground", "color": "#ff0000"}])",
        R"([{"on": "dots.foreground", "color": "#ff0000", "metallic": 1, "roughness": 0.1}])",
        R"([{"on": "dots.foreground", "color": "#ff0000", "border": {"width": 3}}])"};
    std::set<std::string> pictures;
    for (const std::string& script : scripts) pictures.insert(drawn(script));
    EXPECT_EQ(pictures.size(), std::size(scripts));
    EXPECT_TRUE(pictures.contains(drawn(scripts[5])));
}

// A grid on a belt around the sphere: half of it is light.
TEST_F(Tangle, GridsHaveLightAndDarkSquares) {
    folder.write("script.json", R"({"operations": [
        {"name": "belt", "op": "contour", "on": "root", "from": {"points": [312]}, "delta": 0.8, "count": 2},
        {"name": "grid", "op": "grid", "on": "belt.part:1", "count": 4, "size": 0.3}],
        "materials": [{"on": "grid.regions", "name": "none", "color": "#000000"},
                      {"on": ["grid.light", "grid.light"], "name": "light", "color": "#ffffff"},
                      {"on": "grid.dark", "name": "dark", "color": "#203040"}]})");
    done(command());
    const auto found = materials_of(folder.read("out.glb"));
    ASSERT_EQ(found.size(), 3u) << "the last entry that names a region wins";
    ASSERT_TRUE(found.contains("light") && found.contains("dark") && found.contains("default"));
    const double light = found.at("light").at("triangles"), dark = found.at("dark").at("triangles");
    EXPECT_NEAR(light / dark, 1.0, 0.2);
}

TEST_F(Tangle, MaterialsThatCantBeReadSayWhere) {
    const auto refuse = [&](const std::string& entries, const std::string& sentence) {
        expect_refused(R"({"operations": [], "materials": )" + entries + "}", "script.materials" + sentence);
    };
    const auto refuse_entry = [&](const std::string& rest, const std::string& sentence) {
        refuse(R"([{"on": "root", "color": "#123456"}, {"on": "root")" + rest + "}]", "[1]" + sentence);
    };
    refuse("{}", ": must be a list");
    refuse("[3]", "[0]: must be an object");
    refuse(R"([{"on": "root", "colour": "#123456"}])", "[0]: does not know `colour`");
    refuse(R"([{"color": "#123456"}])", "[0]: needs `on`");
    refuse(R"([{"on": "dots", "color": "#123456"}])", "[0].on: names no operation");
    refuse(R"([{"on": "root", "color": "#123456"}, {"on": "default", "color": "#123456"}])",
           "[1].on: `default` must come first");
    refuse(R"([{"on": {"of": "root"}, "color": "#123456"}])", "[0].on: needs `in`");
    refuse_entry("", ": needs `color`");
    for (const char* color : {"\"red\"", "\"#12345\"", "\"#12345g\"", "[1, 1]", "7"}) {
        refuse_entry(R"(, "color": )" + std::string(color), ".color: must be `#rrggbb` or three numbers");
    }
    refuse_entry(R"(, "color": [0, 1.5, 0])", ".color[1]: must be a number from 0.0 to 1.0");
    refuse_entry(R"(, "color": "#123456", "metallic": 2)", ".metallic: must be a number from 0.0 to 1.0");
    refuse_entry(R"(, "color": "#123456", "roughness": -1)", ".roughness: must be a number from 0.0 to 1.0");
    refuse_entry(R"(, "color": "#123456", "name": 7)", ".name: must be a text");
    refuse_entry(R"(, "color": "#123456", "border": {})", ".border: needs `width`");
    refuse_entry(R"(, "color": "#123456", "border": {"width": 100})",
                 ".border.width: must be a number from 0.0 to 64.0");
    refuse_entry(R"(, "color": "#123456", "border": {"width": 1, "color": "blue"})", ".border.color: must be");
    expect_refused(R"({"operations": [{"name": "default", "op": "cells", "on": "root"}]})", "is taken by the material");
}

// A document, and what it leaves on a mesh.
TEST_F(Tangle, DocumentsComeToTheSameFiles) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--document", "doc.json"}));
    const nlohmann::json document = nlohmann::json::parse(folder.read("doc.json"));
    EXPECT_EQ(document.at("filigree"), "tangle");
    EXPECT_EQ(document.at("steps").size(), 6u);
    const std::string masks = folder.read("masks.ply"), text = folder.read("doc.json");
    const std::string side = document.at("arrays").at("file");
    EXPECT_EQ(folder.read(side).size(), document.at("arrays").at("bytes"));
    for (const std::vector<std::string>& way :
         {std::vector<std::string>{"--workers", "0"}, {"--workers", "2", "--budget", "100"}}) {
        std::vector<std::string> arguments = {"tangle",  "sphere.off", "doc.json",  "-o",         "out.glb",
                                              "--quiet", "--masks",    "again.ply", "--document", "again.json"};
        arguments.insert(arguments.end(), way.begin(), way.end());
        done(arguments);
        EXPECT_TRUE(folder.read("again.ply") == masks);
        // But for the name of its side file it is the same document.
        nlohmann::json again = nlohmann::json::parse(folder.read("again.json")), expected = document;
        again["arrays"].erase("file");
        expected["arrays"].erase("file");
        EXPECT_EQ(again, expected);
    }
}

TEST_F(Tangle, DocumentsAreMadeAgainOnFinerMeshes) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--document", "doc.json"}));
    const nlohmann::json coarse = report().at("counts");
    done({"mesh", "refine", "sphere.off", "-o", "fine.ply", "--levels", "1", "--quiet"});
    done({"tangle", "fine.ply", "doc.json", "-o", "fine.glb", "--report", "fine.json", "--quiet"});
    const nlohmann::json fine = report("fine.json").at("counts");
    for (const char* count : {"regions", "leaves", "groups", "steps", "depth"}) {
        EXPECT_EQ(fine.at(count), coarse.at(count)) << count;
    }
    EXPECT_GT(fine.at("cut_triangles"), 3 * coarse.at("cut_triangles").get<int>());
}

TEST_F(Tangle, MutedOperationsDoNothingAndStayInTheDocument) {
    folder.write("script.json", R"({
      "operations": [
        {"name": "bands", "op": "contour", "on": "root", "from": {"points": [312]}, "delta": 0.6, "count": 0},
        {"name": "dots", "op": "contour", "on": "bands.background", "each": true, "mute": true,
         "from": {"samples": {"radius": 0.35}}, "delta": 0.1},
        {"op": "displace", "on": "dots.foreground", "amount": 0.05, "bias": 0.7},
        {"name": "rest", "op": "outline", "on": "bands.foreground", "size": 0.05}
      ]})");
    const Outcome outcome = run(command({"--document", "doc.json"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(report().at("warnings").dump().find("is left out: what it is on is made by"), std::string::npos);
    const nlohmann::json document = nlohmann::json::parse(folder.read("doc.json"));
    EXPECT_EQ(document.at("version"), 2);
    uint32_t muted = 0;
    for (const nlohmann::json& step : document.at("steps")) muted += step.value("mute", false) ? 1 : 0;
    EXPECT_EQ(muted, 3u) << "a step for each of three bands";
    EXPECT_EQ(document.at("steps").size(), 5u);
    // It comes to the same file again.
    const std::string first = folder.read("out.glb");
    done({"tangle", "sphere.off", "doc.json", "-o", "again.glb", "--document", "again.json", "--quiet"});
    EXPECT_TRUE(folder.read("again.glb") == first);
    EXPECT_EQ(nlohmann::json::parse(folder.read("again.json")).at("steps"), document.at("steps"));
}

TEST_F(Tangle, DocumentsThatCantBeMadeSayWhy) {
    folder.write("script.json", kScript);
    done(command({"--document", "doc.json"}));
    const std::string text = folder.read("doc.json");
    const nlohmann::json document = nlohmann::json::parse(text);
    const auto refused = [&](const nlohmann::json& changed, const std::vector<std::string>& words) {
        folder.write("bad.json", changed.dump());
        Cli::expect_refused({"tangle", "sphere.off", "bad.json", "-o", "bad.glb", "--quiet"}, 1, words);
        EXPECT_FALSE(folder.has("bad.glb"));
    };
    nlohmann::json bad = document;
    bad["version"] = 3;
    refused(bad, {"bad.json", "version", "only 1 and 2 are known"});
    bad = document;
    bad["steps"][1]["on"] = {4000};
    refused(bad, {"bad.json", "steps[1]", "is 4000, the tangle has"});
    bad = document;
    bad["steps"][0]["delta"] = 0;
    refused(bad, {"bad.json", "steps[0]", "desc.delta"});
    // Another mesh.
    bad = document;
    bad["base"] = "0000000000000000";
    bad["box"] = {5, 5, 5, 9, 9, 9};
    refused(bad, {"bad.json", "another shape"});
}

}  // namespace
}  // namespace flg::test
