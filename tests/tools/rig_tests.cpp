// SPDX-License-Identifier: MIT
// How far skins stretch, and how far weights jump from vertex to vertex, when each joint in turn is bent by 30 degrees:
// of drawings whose limbs lie beside or across others.
#include "cli_test.h"
#include "crossing_drawings.h"

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

// Parts of one plane that cross are welded where they do.
TEST_F(Rigs, CrossingPartsStretchLess) {
    for (const NamedDrawing& drawing : crossings()) {
        const Json rig = quality(drawing);
        EXPECT_LT(rig.at("largest_stretch").get<double>(), 10) << drawing.name << " " << rig;
        EXPECT_LT(rig.at("largest_weight_jump").get<double>(), 0.5) << drawing.name << " " << rig;
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
