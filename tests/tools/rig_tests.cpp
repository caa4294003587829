// SPDX-License-Identifier: MIT
// How far skins stretch, and how far weights jump from vertex to vertex, when each joint in turn is bent by 30 degrees:
// of drawings whose limbs lie beside or across others.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "cli_test.h"
#include "crossing_drawings.h"
#include "filigree/filigree_io.h"
#include "inflation/crossing_triangles.h"

namespace flg::test {
namespace {

class Rigs : public Cli {
protected:
    Json quality(const NamedDrawing& drawing) const {
        folder.write("drawing.json", drawing.json.dump());
        done({"skeleton", "drawing.json", "-o", "model.glb", "--quiet", "--report", "report.json"});
        return report().at("quality");
    }
};

TEST_F(Rigs, SilhouettesKeepTheirLimbsApart) {
    for (const NamedDrawing& drawing : silhouettes()) {
        const Json rig = quality(drawing);
        EXPECT_LT(rig.at("largest_stretch").get<double>(), 2) << drawing.name << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.35) << drawing.name << " " << rig;
    }
}

TEST_F(Rigs, CrossingPartsStretchLess) {
    std::vector<double> stretches;
    for (const NamedDrawing& drawing : crossings()) {
        const Json rig = quality(drawing);
        stretches.push_back(rig.at("largest_stretch"));
        EXPECT_LT(stretches.back(), 3) << drawing.name << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.35) << drawing.name << " " << rig;
    }
    std::sort(stretches.begin(), stretches.end());
    EXPECT_LT(stretches[stretches.size() / 2], 2);
}

// Fat bodies whose vertices many joints matter to, cut along the borders of colours.
TEST_F(Rigs, SamplesStretchLittle) {
    for (const auto& entry : std::filesystem::directory_iterator(FLG_SOURCES "/samples/models")) {
        if (entry.path().extension() != ".json") continue;
        std::ifstream file(entry.path());
        const Json rig = quality({entry.path().stem(), Json::parse(file)});
        EXPECT_LT(rig.at("largest_stretch").get<double>(), 3) << entry.path() << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.35) << entry.path() << " " << rig;
    }
}

// A tail drawn so near to its body that no triangle fits between them.
TEST_F(Rigs, WhatTearsIsSaid) {
    const auto warned = [&](double gap) {
        const Outline notch = {{0, 0},        {10, 0}, {10, 4},  {1, 4},  {1, 4 + gap},
                               {12, 4 + gap}, {12, 5}, {0.5, 5}, {0, 4.5}};
        const Json rig = quality({"notch", Drawing().add("notch", notch)});
        const std::string warnings = report().at("warnings").dump();
        const bool is_said = warnings.find("turns by 30 degrees the surface stretches") != std::string::npos;
        EXPECT_EQ(is_said, rig.at("largest_stretch").get<double>() > 3) << rig;
        return is_said;
    };
    EXPECT_TRUE(warned(0.02));
    EXPECT_FALSE(warned(0.1));
}

struct SkinSurface {
    std::vector<float> positions;
    std::vector<uint32_t> triangles, parts;  // parts: by vertex
};

SkinSurface read_surface(const std::string& path) {
    SkinSurface out;
    FlgSkinFile file = {};
    EXPECT_EQ(flgSkinFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    FlgSkinView skin = {};
    skin.struct_size = sizeof skin;
    EXPECT_EQ(flgSkinFileGetView(file, &skin), FLG_OK);
    out.positions.assign(skin.positions, skin.positions + size_t{3} * skin.vertex_count);
    out.triangles.assign(skin.triangles, skin.triangles + size_t{3} * skin.triangle_count);
    out.parts.assign(skin.vertex_parts, skin.vertex_parts + skin.vertex_count);
    flgSkinFileRelease(file);
    return out;
}

struct Defects {
    size_t crossing = 0;  // pairs of triangles
    size_t open_sides = 0, pieces = 0;
};

Defects look_at(const std::string& path) {
    Defects out;
    const SkinSurface skin = read_surface(path);
    const std::vector<uint32_t>& triangles = skin.triangles;
    out.crossing = crossing_triangles<float>(skin.positions, triangles).size();
    std::map<std::pair<uint32_t, uint32_t>, int> sides;
    std::vector<uint32_t> piece(skin.parts.size());
    for (uint32_t v = 0; v < piece.size(); ++v) piece[v] = v;
    const auto first = [&](uint32_t v) {
        while (piece[v] != v) v = piece[v] = piece[piece[v]];
        return v;
    };
    for (size_t i = 0; i < triangles.size(); ++i) {
        const uint32_t a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
        ++sides[{std::min(a, b), std::max(a, b)}];
        piece[first(a)] = first(b);
    }
    for (const auto& [side, count] : sides) out.open_sides += count != 2;
    for (uint32_t v = 0; v < piece.size(); ++v) out.pieces += piece[v] == v;
    return out;
}

// In the order they were drawn, and the other way round.
TEST_F(Rigs, CrossingPartsPassWithoutCuttingThroughEachOther) {
    for (NamedDrawing& drawing : crossings())
        for (const bool reversed : {false, true}) {
            int depth = 0;
            for (Json& part : drawing.json["parts"]) part["depth"] = reversed ? --depth : 0;
            quality(drawing);
            const Defects surface = look_at((folder / "model.glb").string());
            EXPECT_EQ(surface.open_sides, 0u) << drawing.name << reversed;
            EXPECT_EQ(surface.pieces, 1u) << drawing.name << reversed;
            // Some triangles fold in creases, where limbs that are cut off each other meet the body. Limbs that cut
            // through each other would be hundreds.
            EXPECT_LE(surface.crossing, 4u) << drawing.name << reversed;
        }
}

TEST_F(Rigs, DepthAndPairsAreTheHosts) {
    const std::vector<NamedDrawing> all = crossings();
    folder.write("drawing.json",
                 std::find_if(all.begin(), all.end(), [](const auto& d) { return d.name == "scissors"; })->json.dump());
    done({"skeleton", "drawing.json", "-o", "a.glb", "--quiet"});
    done({"skeleton", "--depth", "one,1", "--depth", "two,0", "--apart", "one,two", "drawing.json", "-o", "b.glb",
          "--quiet"});
    EXPECT_NE(folder.read("a.glb"), folder.read("b.glb"));
    expect_refused({"skeleton", "drawing.json", "-o", "c.glb", "--depth", "three,1"}, 2, {"--depth", "three"});
    expect_refused({"skeleton", "drawing.json", "-o", "c.glb", "--depth", "one,deep"}, 2, {"--depth", "deep"});
    expect_refused({"skeleton", "drawing.json", "-o", "c.glb", "--apart", "one"}, 2, {"--apart", "PART,PART", "one"});
    expect_refused({"skeleton", "drawing.json", "-o", "c.glb", "--apart", "one,three"}, 1, {"no part three"});
}

// Arms that lie over the chest hang by their shoulders, and hands lie on it: or behind, as the host says.
TEST_F(Rigs, HandsLieOnTheChestOrBehindIt) {
    const std::vector<NamedDrawing> all = crossings();
    const auto chest = std::find_if(all.begin(), all.end(), [](const auto& d) { return d.name == "arms_on_chest"; });
    for (const int depth : {0, 1, -1}) {
        Json drawing = chest->json;
        if (depth != 0)
            for (const size_t arm : {5, 6}) drawing["parts"][arm]["depth"] = depth;
        folder.write("drawing.json", drawing.dump());
        done({"skeleton", "drawing.json", "-o", "model.glb", "--bones", "bones.json", "--quiet"});
        const Json bones = report("bones.json");
        for (const size_t part : {5, 6}) {
            std::vector<std::array<double, 3>> joints;
            for (const Json& joint : bones["joints"])
                if (joint["part"] == part) joints.push_back(joint["position"]);
            ASSERT_GE(joints.size(), 3u);
            EXPECT_GT(joints.front()[1], 2.2) << "of part " << part;
            EXPECT_LT(joints.back()[1], 1) << "of part " << part;
        }
        const SkinSurface surface = read_surface((folder / "model.glb").string());
        // By the side of the drawing's plane that a hand's middle is on.
        std::array<double, 2> sums{}, counts{};
        for (size_t v = 0; v < surface.parts.size(); ++v) {
            const float* at = surface.positions.data() + 3 * v;
            if (surface.parts[v] < 5 || at[1] > 1.2f) continue;
            sums[surface.parts[v] - 5] += at[2];
            ++counts[surface.parts[v] - 5];
        }
        for (size_t arm = 0; arm < 2; ++arm) {
            ASSERT_GT(counts[arm], 20) << "a hand sank";
            // The torso is some 0.64 thick there, to either side.
            EXPECT_GT((depth < 0 ? -1 : 1) * sums[arm] / counts[arm], 0.5) << depth;
        }
    }
}

// All of both arms lies over the chest: they cross in front of it, and do not vanish in it.
TEST_F(Rigs, ArmsAcrossTheChestAreSeen) {
    const std::vector<NamedDrawing> all = crossings();
    quality(*std::find_if(all.begin(), all.end(), [](const auto& d) { return d.name == "arms_across"; }));
    const SkinSurface surface = read_surface((folder / "model.glb").string());
    for (const uint32_t arm : {5u, 6u}) {
        uint32_t in_front = 0;
        for (size_t v = 0; v < surface.parts.size(); ++v) {
            const float* at = surface.positions.data() + 3 * v;
            // Beyond the middle of the chest, on the other side.
            in_front += surface.parts[v] == arm && at[1] < 1.8f && (at[0] > 0) != (arm == 5) && at[2] > 0.6f;
        }
        EXPECT_GT(in_front, 50u) << arm;
    }
}

// Legs that are there twice, and overlap.
TEST_F(Rigs, MirrorImagesAreNotWelded) {
    for (const NamedDrawing& drawing : crossings()) {
        if (drawing.name != "trex" && drawing.name != "dog") continue;
        EXPECT_LT(quality(drawing).at("largest_stretch").get<double>(), 4) << drawing.name;
    }
}

}  // namespace
}  // namespace flg::test
