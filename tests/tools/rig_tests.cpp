// SPDX-License-Identifier: MIT
// How far skins stretch, and how far weights jump from vertex to vertex, when each joint in turn is bent by 30 degrees:
// of drawings whose limbs lie beside or across others.
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
        EXPECT_LT(rig.at("largest_stretch").get<double>(), 4) << drawing.name << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.35) << drawing.name << " " << rig;
    }
}

TEST_F(Rigs, CrossingPartsStretchLess) {
    for (const NamedDrawing& drawing : crossings()) {
        const Json rig = quality(drawing);
        EXPECT_LT(rig.at("largest_stretch").get<double>(), 4) << drawing.name << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.4) << drawing.name << " " << rig;
    }
}

struct Surface {
    size_t crossing = 0;  // pairs of triangles
    size_t open_sides = 0, pieces = 0;
};

Surface look_at(const std::string& path) {
    Surface out;
    FlgSkinFile file = {};
    EXPECT_EQ(flgSkinFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    FlgSkinView skin = {};
    skin.struct_size = sizeof skin;
    EXPECT_EQ(flgSkinFileGetView(file, &skin), FLG_OK);
    const std::span<const float> positions(skin.positions, size_t{3} * skin.vertex_count);
    const std::span<const uint32_t> triangles(skin.triangles, size_t{3} * skin.triangle_count);
    out.crossing = crossing_triangles(positions, triangles).size();
    std::map<std::pair<uint32_t, uint32_t>, int> sides;
    std::vector<uint32_t> piece(skin.vertex_count);
    for (uint32_t v = 0; v < skin.vertex_count; ++v) piece[v] = v;
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
    for (uint32_t v = 0; v < skin.vertex_count; ++v) out.pieces += piece[v] == v;
    flgSkinFileRelease(file);
    return out;
}

// In the order they were drawn, and the other way round.
TEST_F(Rigs, CrossingPartsPassWithoutCuttingThroughEachOther) {
    for (NamedDrawing& drawing : crossings())
        for (const bool reversed : {false, true}) {
            int depth = 0;
            for (Json& part : drawing.json["parts"]) part["depth"] = reversed ? --depth : 0;
            quality(drawing);
            const Surface surface = look_at((folder / "model.glb").string());
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

// Legs that are there twice, and overlap.
TEST_F(Rigs, MirrorImagesAreNotWelded) {
    for (const NamedDrawing& drawing : crossings()) {
        if (drawing.name != "trex" && drawing.name != "dog") continue;
        EXPECT_LT(quality(drawing).at("largest_stretch").get<double>(), 4) << drawing.name;
    }
}

}  // namespace
}  // namespace flg::test
