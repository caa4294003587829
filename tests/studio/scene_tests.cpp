// SPDX-License-Identifier: MIT
// The studio's scene: things stand beside each other, what is on a mesh goes with it, and one history has all of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "scene/free_place.h"
#include "shell/document.h"
#include "tools/program.h"

namespace flg::test {
namespace {

Outcome play(const Folder& folder, const std::string& text, std::vector<std::string> more = {}) {
    folder.write("script.txt", text);
    more.insert(more.end(),
                {"--script", (folder / "script.txt").string(), "--offscreen", "--out", folder.path().string()});
    if (std::find(more.begin(), more.end(), "--size") == more.end())
        more.insert(more.end(), {"--validation", "--size", "1120x700"});
    return run_program(FLG_STUDIO_PROGRAM, more, FLG_SOURCES);
}

bool meet(const render::Box& a, const render::Box& b) {
    return glm::all(glm::lessThan(a.min, b.max)) && glm::all(glm::lessThan(b.min, a.max));
}

TEST(StudioScene, AFreePlaceIsOnTheFloorBesideAllThatIsThere) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-3.0f, 3.0f), size(0.2f, 1.5f);
    std::vector<render::Box> boxes = {{{-1.0f, -0.5f, -1.0f}, {1.0f, 1.0f, 1.0f}}};
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 low(place(random), place(random), place(random));
        const render::Box own{low, low + glm::vec3(size(random), size(random), size(random))};
        const render::Placement found = studio::free_place(own, boxes);
        EXPECT_EQ(found.scale, 1.0f) << "its size is not absurd";
        const render::Box put = found.box(own);
        EXPECT_NEAR(put.min.y, -0.5f, 1e-5f);
        for (const render::Box& other : boxes) EXPECT_FALSE(meet(put, other));
        boxes.push_back(put);
    }
}

TEST(StudioScene, WhatComesFirstStaysAndAbsurdSizesAreFitted) {
    const render::Box metre{{4.0f, 3.0f, 2.0f}, {5.0f, 4.0f, 3.0f}};
    EXPECT_TRUE(studio::free_place(metre, {}).is_identity());
    const render::Box none[] = {render::Box{}};
    EXPECT_TRUE(studio::free_place(metre, none).is_identity());
    const render::Box usual[] = {metre, {{0.0f, 0.0f, 0.0f}, {1.2f, 1.0f, 1.0f}}};
    for (const float unit : {1000.0f, 0.001f}) {
        const render::Box other_unit{unit * metre.min, unit * metre.max};
        const render::Placement found = studio::free_place(other_unit, usual);
        const float shown = found.box(other_unit).diagonal();
        EXPECT_GT(shown, 0.5f * metre.diagonal());
        EXPECT_LT(shown, 2.0f * metre.diagonal());
        for (const render::Box& other : usual) EXPECT_FALSE(meet(found.box(other_unit), other));
    }
}

TEST(StudioScene, MeshesStandBesideEachOtherAndCarryTheirStrokes) {
    const Folder folder;
    const std::string document = (folder / "scene.filigree").string();
    const Outcome outcome = play(folder, R"(open builtin:vase
wait
drag 0.48,0.4 0.52,0.5
wait
expect strokes.seen 1
click "ball##add"
frames 3
wait
click "torus##add"
frames 3
wait
expect scene.meshes 3
expect scene.overlaps 0
click "##see vase"
frames 2
expect strokes.seen 0
expect strokes.count 1
key ctrl+z
frames 2
expect strokes.seen 1
click "vase"
key m
frames 3
drag "gizmo x" 0.9,0.5
expect studio.steps 5
drag "gizmo ring y" 0.5,0.6
drag "gizmo scale" 0.9,0.2
expect studio.steps 7
key m
look -0.45,-0.32,-1
wait
shot moved
save )" + document + "\nload " + document + R"(
wait
look -0.45,-0.32,-1
expect strokes.seen 1
expect studio.steps 0
frames 3
wait
shot loaded
click "x##remove vase"
frames 2
expect strokes.count 0
key ctrl+z
wait
frames 3
expect strokes.seen 1
look -0.45,-0.32,-1
click "vase"
move 0.99,0.99
frames 3
)");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json scene = studio::read_document(document).at("scene").at("meshes");
    EXPECT_GT(std::abs(scene[0].at("placement").at("at")[0].get<float>()), 0.1f);
    EXPECT_NE(scene[0].at("placement").at("scale").get<float>(), 1.0f);
}

// Where a stroke begins beside all meshes it lies on the floor, which stays under the meshes whatever is drawn.
TEST(StudioScene, AStrokeBesideTheMeshesLandsOnTheFloor) {
    const Folder folder;
    const std::string document = (folder / "scene.filigree").string();
    const Outcome outcome = play(folder, R"(open builtin:vase
wait
click "style wave"
wait
drag 0.1,0.85 0.2,0.9 0.3,0.93
wait
click "View plane"
drag 0.6,0.95 0.7,0.97
wait
expect strokes.seen 2
click "ball##add"
frames 3
wait
save )" + document + "\n");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json whole = studio::read_document(document);
    const nlohmann::json& stroke = whole.at("strokes").at("layers")[0].at("strokes")[0];
    EXPECT_FALSE(stroke.contains("on"));
    const auto numbers = stroke.at("samples").get<std::vector<float>>();
    constexpr float kLift = 0.004f;
    for (size_t i = 1; i < numbers.size(); i += 8) EXPECT_NEAR(numbers[i], kLift, 1e-5f) << "the vase stands at 0";
    const nlohmann::json& ball = whole.at("scene").at("meshes")[1];
    EXPECT_NEAR(ball.at("placement").at("at")[1].get<float>(), 0.5f, 1e-3f) << "it stands there, too";
}

// A leg is lifted: nothing under the other one sinks.
TEST(StudioScene, TheFloorStaysWhileAModelIsPosedOrPlayed) {
    const Folder folder;
    folder.write("drawing.txt", R"(open builtin:vase
wait
click "Skeletons"
wait
drag 0.3,0.4 0.5,0.35 0.7,0.4 0.7,0.5 0.68,0.8 0.6,0.8 0.58,0.5 0.4,0.5 0.38,0.8 0.3,0.8 0.3,0.41
wait
move 0.98,0.98
frames 3
)");
    const auto drawn = folder.read("drawing.txt");
    // The sentence of a step that fails has the number.
    const std::string said = play(folder, drawn + "expect scene.floor 99\n").err, is = "scene.floor is ";
    ASSERT_NE(said.find(is), std::string::npos) << said;
    const std::string stays = "expect scene.floor " + said.substr(said.find(is) + is.size(), 8) + " 0.001\n";
    const Outcome posed = play(folder, drawn + R"(click "Pose"
frames 3
drag "joint part 1_2" 0.8,0.2
expect skeletons.turned > 0
frames 3
)" + stays + "click \"Test motion\"\nmove 0.98,0.98\nframes 28\n" +
                                           stays);
    EXPECT_EQ(posed.status, 0) << posed.err;
    const Outcome played = play(folder, drawn + R"(click "Strokes"
wait
expect scene.floor 0 0.001
click "Drawing"
click "Test motion##drawing"
move 0.98,0.98
frames 60
expect scene.bent 1
expect scene.floor 0 0.001
)");
    EXPECT_EQ(played.status, 0) << played.err;
}

// Tangles once gave a mesh the first colour of its palette when it was looked at.
TEST(StudioScene, AVisitToAWorkspaceChangesNothing) {
    const Folder folder;
    std::string text = "open builtin:vase\nwait\nmove 0.98,0.98\nframes 3\nshot before\n";
    for (const char* name : {"Tangles", "Skeletons", "Splines"}) text += "click \"" + std::string(name) + "\"\nwait\n";
    text += "click \"Strokes\"\nmove 0.98,0.98\nwait\nshot after\n";
    const Outcome outcome = play(folder, text);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder.read("before.png"), folder.read("after.png"));
}

TEST(StudioScene, AColourIsThatOfTheNewPartsWhileAStepIsTried) {
    const Folder folder;
    const Outcome outcome = play(folder, R"(open builtin:vase
wait
click "Tangles"
wait
click "Polka dots"
wait
click "Gold"
wait
expect tangles.trying 1
expect tangles.acts 0
expect tangles.painted 0
slide "Radius" 0.6
wait
key enter
wait
expect tangles.acts 2
expect tangles.painted > 1
expect tangles.unpainted 1
key ctrl+z
wait
expect tangles.painted 0
expect tangles.leaves > 1
key ctrl+z
wait
expect tangles.leaves 1
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(StudioScene, WhoMissesAHandleByALittleDrawsNothing) {
    const Folder folder;
    const Outcome outcome = play(folder, R"(open builtin:ball
wait
key m
frames 3
drag 0.609,0.399 0.62,0.30
wait
expect strokes.count 0
expect studio.steps 1
key m
drag 0.609,0.399 0.62,0.30
wait
expect strokes.count 1
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(StudioScene, NothingOfTheSceneIsSeenOnThePaper) {
    const Folder folder;
    const Outcome outcome = play(folder, R"(open builtin:torus
wait
look -0.35,-0.75,-1
drag 0.40,0.58 0.48,0.61 0.56,0.60
click "Splines"
click 0.32,0.52
click 0.48,0.61
click 0.66,0.57
key enter
wait
click "Skeletons"
wait
key tab
move 0.98,0.98
wait
shot with
key tab
click "##see torus"
key tab
move 0.98,0.98
wait
shot without
key tab
click "##see torus"
click "Strokes"
wait
expect strokes.seen 1
)");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder.read("with.png"), folder.read("without.png"));
}

TEST(StudioScene, NoPartOfAStyleSinksIntoTheMesh) {
    const Folder folder;
    const Outcome outcome = play(folder, R"(open builtin:vase
wait
click "style wave"
wait
expect strokes.lift_mm 4 0.001
click "style curls"
wait
expect strokes.lift_mm > 15
click "Unstyled"
wait
expect strokes.lift_mm 4 0.001
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(StudioScene, AHiddenMeshIsNotDivided) {
    const Folder folder;
    const Outcome outcome = play(folder, R"(open builtin:ball
wait
click "Tangles"
wait
click "##see ball"
click "Contour"
wait
expect tangles.trying 0
expect studio.notices 1
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(StudioScene, AMeshThatWasTakenOutComesBackWithWhatWasOnIt) {
    const Folder folder;
    const std::string before = (folder / "before.filigree").string(), after = (folder / "after.filigree").string();
    const Outcome outcome = play(folder, R"(open builtin:ball
wait
open builtin:torus
wait
drag 0.45,0.45 0.55,0.55
click "ball"
click "Tangles"
wait
click "Contour"
wait
key enter
wait
expect tangles.acts 1
click "Strokes"
move 0.99,0.99
save )" + before + R"(
click "x##remove ball"
frames 3
click "x##remove torus"
frames 3
expect scene.meshes 0
key ctrl+z
key ctrl+z
wait
expect scene.meshes 2
move 0.99,0.99
save )" + after + R"(
load )" + after + R"(
wait
click "Tangles"
wait
expect tangles.leaves > 1
)");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder.read("before.filigree"), folder.read("after.filigree"));
}

TEST(StudioScene, TheDrawnModelIsAnObjectLikeOthers) {
    const Folder folder;
    const std::string document = (folder / "scene.filigree").string();
    const Outcome outcome = play(folder, R"(open builtin:vase
wait
click "Skeletons"
frames 3
drag 0.3,0.4 0.5,0.35 0.7,0.4 0.7,0.6 0.5,0.65 0.3,0.6 0.3,0.41
wait
expect skeletons.parts 1
expect scene.meshes 2
click "Strokes"
wait
expect scene.overlaps 0
click "##see vase"
click "Drawing"
look -0.1,-0.2,-1
wait
drag 0.48,0.45 0.52,0.55
wait
expect strokes.seen 1
click "##see Drawing"
frames 3
expect strokes.seen 0
click "##see Drawing"
frames 3
expect strokes.seen 1
click "Splines"
click 0.45,0.52
click 0.5,0.42
click 0.55,0.52
key enter
wait
expect splines.points 3
expect splines.nodes > 10
click "Tangles"
wait
click "Contour"
wait
key enter
wait
expect tangles.leaves > 1
move 0.99,0.99
frames 45
shot on_drawing
click "Skeletons"
frames 3
drag 0.6,0.3 0.75,0.2 0.8,0.3 0.65,0.45 0.6,0.31
wait
expect skeletons.parts 2
click "Tangles"
wait
expect tangles.leaves > 1
save )" + document + "\nload " + document + R"(
wait
expect strokes.seen 1
expect tangles.leaves > 1
key ctrl+2
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

// What a person might do, at random. Knows what is in the scene, so that what it clicks is there.
class RandomPerson {
public:
    explicit RandomPerson(uint32_t seed) : random_(seed) {}

    std::string act() {
        const uint32_t kind = pick(20);
        if (kind < 5) return go("Strokes") + "drag " + place() + " " + place() + "\n";
        if (kind < 7) return go("Strokes") + (pick(2) ? "click \"New layer\"\n" : "key ]\n");
        if (kind < 11) return go("Splines") + "click " + place() + "\nclick " + place() + "\nkey enter\n";
        if (kind < 12) return go("Skeletons") + outline();
        if (kind == 12) return go("Tangles") + "wait\nclick \"Contour\"\nwait\nkey enter\nwait\n";
        const size_t which = pick(static_cast<uint32_t>(meshes_.size()));
        const std::string name = meshes_[which];
        if (kind < 16) return "click \"##see " + name + "\"\nclick \"##see " + name + "\"\n";
        if (kind < 17 && meshes_.size() > 2) {
            meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(which));
            return "click \"x##remove " + name + "\"\nframes 3\nclick \"" + meshes_.front() + "\"\n";
        }
        if (kind < 18 && meshes_.size() < 4) {
            const char* source = pick(2) ? "ball" : "torus";
            meshes_.push_back(std::string(source) + " " + std::to_string(++count_[source]));
            return "click \"" + std::string(source) + "##add\"\nframes 3\nwait\n";
        }
        const char* grips[] = {"gizmo x", "gizmo z", "gizmo free", "gizmo scale", "gizmo ring y"};
        return go("Strokes") + "click \"" + name + "\"\nlook -0.3,-0.5,-1\nkey m\nframes 2\ndrag \"" + grips[pick(5)] +
               "\" " + place() + "\nkey m\n";
    }

private:
    uint32_t pick(uint32_t count) { return static_cast<uint32_t>(random_() % count); }
    std::string place() { return "0." + std::to_string(25 + pick(50)) + ",0." + std::to_string(25 + pick(50)); }
    std::string outline() {
        const uint32_t x = 25 + pick(30), y = 25 + pick(30);
        const auto at = [&](uint32_t right, uint32_t down) {
            return " 0." + std::to_string(x + right) + ",0." + std::to_string(y + down);
        };
        return "drag" + at(0, 0) + at(16, 2) + at(18, 14) + at(4, 18) + at(0, 1) + "\n";
    }
    std::string go(const std::string& workspace) { return "click \"" + workspace + "\"\n"; }

    std::mt19937 random_;
    std::vector<std::string> meshes_ = {"ball", "torus"};
    std::map<std::string, int> count_ = {{"ball", 1}, {"torus", 1}};
};

TEST(StudioScene, RandomActionsAreUndoneAndRedoneToTheByte) {
    const Folder folder;
    // A panel's border may have been dragged, which is no step: the camera is fitted to the picture without panels.
    const auto save = [&](const char* name) {
        return "wait\nkey ctrl+1\nkey tab\nlook -0.45,-0.32,-1\nkey tab\nmove 0.99,0.99\nframes 3\nsave " +
               (folder / name).string() + "\n";
    };
    // More or fewer of them by the environment.
    const char* asked = std::getenv("FLG_STUDIO_ACTIONS");
    const int actions = asked != nullptr ? std::atoi(asked) : 200;
    const auto repeat = [&](const char* key) {
        std::string text;
        for (int i = 0; i < 2 * actions; ++i) text += std::string("key ") + key + "\n";
        return text;
    };
    std::string text = "open builtin:ball\nwait\nopen builtin:torus\nwait\nclick \"ball\"\n" + save("made");
    text += "load " + (folder / "made").string() + "\n" + save("start");
    RandomPerson person(20);
    for (int i = 0; i < actions; ++i) text += person.act();
    text += save("end") + "expect studio.steps > " + std::to_string(actions / 2) + "\n" + repeat("ctrl+z") +
            "wait\nexpect studio.steps 0\n" + save("undone") + repeat("ctrl+shift+z") +
            "wait\nexpect studio.undone 0\n" + save("redone");
    const Outcome outcome = play(folder, text, {"--budget", "20000", "--size", "800x560"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(folder.read("start"), folder.read("end"));
    EXPECT_EQ(folder.read("start"), folder.read("undone"));
    // The camera is no step. It is fitted to what is drawn, where live strokes of many metres may lack points yet.
    const auto without_camera = [&](const char* name) {
        const std::string document = folder.read(name);
        const size_t begin = document.find("\"camera\""), end = document.find("\"filigree\"");
        EXPECT_LT(begin, end);
        return document.substr(0, begin) + document.substr(end);
    };
    EXPECT_EQ(without_camera("end"), without_camera("redone"));
}

}  // namespace
}  // namespace flg::test
