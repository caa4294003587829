// SPDX-License-Identifier: MIT
// The studio used through mouse and keys (samples/studio/scripts), its pictures held against those that were looked at.
#include <gtest/gtest.h>

#include <fstream>

#include "studio/pictures.h"
#include "tools/program.h"

namespace flg::test {
namespace {

// Room for another Mesa's rounding; a widget that moved, or a stroke that is missing, is far beyond.
constexpr double kMean = 0.6, kBlock = 12.0;
// Text and lines of twice the size have other edges.
constexpr double kMeanScaled = 3.0;

const std::filesystem::path kScripts = FLG_STUDIO_SCRIPTS;
const std::filesystem::path kGoldens = FLG_STUDIO_GOLDENS;

std::string script(const std::string& name) {
    return (kScripts / (name + ".txt")).string();
}

Outcome studio(const Folder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--validation", "--out", folder.path().string()});
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
        arguments.insert(arguments.end(), {"--size", "1120x700"});
    return run_program(FLG_STUDIO_PROGRAM, arguments, FLG_SOURCES);
}

// Runs a script that leaves pictures; each that has a golden one is compared, and there is at least one.
void plays(const std::string& name, const Folder& folder) {
    const Outcome outcome = studio(folder, {"--script", script(name)});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    int compared = 0;
    for (const std::string& file : folder.list()) {
        const std::filesystem::path golden = kGoldens / file;
        if (!std::filesystem::exists(golden)) continue;
        // Golden ones are kept at half the size.
        const Difference difference = compare_pictures(folder / file, golden, 2, 1);
        EXPECT_LT(difference.mean, kMean) << file;
        EXPECT_LT(difference.block, kBlock) << file;
        ++compared;
    }
    EXPECT_GT(compared, 0) << "no golden picture of " << name;
}

Outcome play_text(const Folder& folder, const std::string& text, std::vector<std::string> more = {}) {
    folder.write("script.txt", text);
    more.insert(more.end(), {"--script", (folder / "script.txt").string(), "--offscreen"});
    return studio(folder, more);
}

TEST(Studio, DrawsStrokes) {
    plays("strokes", Folder());
}

TEST(Studio, OrnamentsAVase) {
    plays("tangles", Folder());
}

TEST(Studio, ChangesStepsOfAnOrnamentBeforeTheLast) {
    plays("tangle_history", Folder());
}

TEST(Studio, DrawsAnAnimalThatIsMovedRefinedAndPosed) {
    plays("skeletons", Folder());
}

TEST(Studio, SetsJointsThatStayAsTheyWereSet) {
    plays("joints", Folder());
}

TEST(Studio, DragsThePointsOfALineAndKeepsTheLastGoodBody) {
    plays("points", Folder());
}

TEST(Studio, PaintsWeightsThatLast) {
    plays("weights", Folder());
}

TEST(Studio, PullsABodyAndPlaysWhatWasRecorded) {
    plays("pull", Folder());
}

// A body with a limb, and the joint of the limb painted onto the body and pinned.
constexpr const char* kPainted = R"(click "Skeletons"
wait
drag 0.700,0.500 0.640,0.600 0.500,0.630 0.360,0.600 0.300,0.500 0.360,0.400 0.500,0.370 0.640,0.400 0.700,0.500
drag 0.640,0.450 0.760,0.420 0.880,0.300 0.900,0.330 0.800,0.500 0.660,0.550 0.640,0.450
wait
click "Weights"
wait
click "joint part 2_1"
slide "Strength" 0.9
drag 0.420,0.450 0.500,0.550
wait
click "Pull"
wait
click "Record drags"
drag 0.360,0.500 0.300,0.560
wait
)";

TEST(Studio, DocumentsKeepPaintedWeightsAndPins) {
    const Folder folder;
    const std::string file = (folder / "a.filigree").string();
    const Outcome outcome = play_text(folder, kPainted + ("save " + file) + R"(
key ctrl+n
wait
load )" + file + R"(
click "Skeletons"
click "Weights"
wait
expect skeletons.weight_strokes 1
expect skeletons.lost_strokes 0
click "joint part 2_1"
expect skeletons.weight > 0.08
expect skeletons.pins 1
expect skeletons.keys > 2
click "Pull"
wait
expect skeletons.pulled > 0.1
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, PaintsBothSidesOfASymmetricBody) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(click "Skeletons"
wait
drag 0.560,0.500 0.550,0.650 0.500,0.700 0.450,0.650 0.440,0.500 0.450,0.350 0.500,0.300 0.550,0.350 0.560,0.500
wait
click 0.05,0.1
click "Left, right"
drag 0.530,0.400 0.700,0.360 0.800,0.350 0.800,0.410 0.700,0.430 0.530,0.470 0.530,0.400
wait
expect skeletons.mirrored 1
click "Weights"
wait
click "joint part 2_2.R"
frames 2
expect skeletons.weight < 0.001
click "joint part 2_2.L"
frames 2
expect skeletons.weight < 0.001
click "Both sides"
slide "Strength" 0.9
drag 0.520,0.550 0.520,0.650
wait
expect skeletons.weight_strokes 1
expect skeletons.weight > 0.02
click "joint part 2_2.R"
frames 2
expect skeletons.weight > 0.02
)");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, ExportedModelsHaveThePaintedWeights) {
    const Folder folder;
    const std::string painted = (folder / "painted.glb").string(), plain = (folder / "plain.glb").string();
    const Outcome outcome = play_text(folder, kPainted + ("export \"Model\" " + painted) + R"(
click "Weights"
click "Reset all weights"
wait
export "Model" )" + plain + "\n");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    // The mesh stays, the weights differ.
    const std::string with = folder.read("painted.glb"), without = folder.read("plain.glb");
    EXPECT_EQ(with.size(), without.size());
    EXPECT_NE(with, without);
}

TEST(Studio, LaysCurvesAroundObstaclesAndPlaysAMotion) {
    plays("splines", Folder());
}

TEST(Studio, DecoratesADrawnAnimalBesideAVaseAndPlaysItsMotion) {
    const Folder folder;
    plays("scene", folder);
    // What is on it moves with it, and is back where it was at the end.
    const auto differs = [&](const char* a, const char* b) {
        return compare_pictures(folder / (std::string(a) + ".png"), folder / (std::string(b) + ".png"), 1, 1).block;
    };
    EXPECT_GT(differs("scene_decorated", "scene_playing"), kBlock);
    EXPECT_GT(differs("scene_playing", "scene_playing_on"), kBlock);
    EXPECT_LT(differs("scene_decorated", "scene_at_rest"), kBlock);
}

TEST(Studio, TwoRunsOfAScriptLeaveTheSameBits) {
    const Folder first, second;
    ASSERT_EQ(studio(first, {"--script", script("strokes"), "--offscreen"}).status, 0);
    ASSERT_EQ(studio(second, {"--script", script("strokes"), "--offscreen", "--workers", "0"}).status, 0);
    ASSERT_FALSE(first.list().empty());
    for (const std::string& file : first.list()) EXPECT_EQ(first.read(file), second.read(file)) << file;
}

TEST(Studio, TwiceTheScaleShowsTheSame) {
    const Folder one, two;
    const std::string text = "open builtin:torus\nwait\nframes 3\nshot view\n";
    ASSERT_EQ(play_text(one, text, {"--scale", "1"}).status, 0);
    ASSERT_EQ(play_text(two, text, {"--scale", "2"}).status, 0);
    EXPECT_LT(compare_pictures(one / "view.png", two / "view.png", 1, 2).mean, kMeanScaled);
}

TEST(Studio, SaysWhichStepFailedAndWhy) {
    const Folder folder;
    const std::pair<const char*, const char*> bad[] = {
        {"wait\nclick \"Nowhere\"\n", "script.txt:2: there is no widget \"Nowhere\"; there are: "},
        {"jump 1\n", "script.txt:1: there is no step \"jump\"."},
        {"click 0.5\n", "script.txt:1: \"0.5\" is no place"},
        {"click \"Strokes\n", "script.txt:1: a quotation mark is missing."},
        {"key ctrl+pling\n", "script.txt:1: there is no key \"pling\"."},
        {"expect strokes.count 1\n", "script.txt:1: strokes.count is 0; expected = 1."},
        {"expect strokes.nonsense 1\n", "script.txt:1: strokes has the values "},
        {"open no/such.obj\n", "no/such.obj"},
        {"open builtin:pyramid\n", "There is no built-in mesh \"pyramid\"; there are ball, "},
        {"slide \"Magnitude\" much\n", "script.txt:1: \"much\" is no number."},
    };
    for (const auto& [text, sentence] : bad) {
        const Outcome outcome = play_text(folder, text);
        EXPECT_EQ(outcome.status, 1) << text;
        EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    }
    const Outcome none = studio(folder, {"--script", (folder / "absent.txt").string(), "--offscreen"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("cannot be read"), std::string::npos) << none.err;
}

// A slider once changed all strokes of the layer.
TEST(Studio, SettingsAreTheNextStrokesUntilTheyAreApplied) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(open builtin:ball
wait
drag 0.4,0.4 0.5,0.42 0.6,0.4
drag 0.4,0.5 0.5,0.52 0.6,0.5
wait
expect strokes.looks 1
slide "Magnitude" 0.9
click "style knit"
click "Gold"
wait
expect strokes.looks 1
drag 0.4,0.6 0.5,0.62 0.6,0.6
wait
expect strokes.looks 2
key v
click 0.5,0.42
expect strokes.selected 1
click "Apply to selection"
wait
expect strokes.looks 2
click "Apply to layer"
wait
expect strokes.looks 1
key ctrl+z
wait
expect strokes.looks 2
key ctrl+z
key ctrl+z
wait
expect strokes.count 2
expect strokes.looks 1
key ctrl+a
expect strokes.selected 2
key delete
expect strokes.count 0
expect strokes.selected 0
key ctrl+z
wait
expect strokes.count 2
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

// While a slider moves the picture is made anew, and the settings follow when it is let go.
TEST(Studio, ShowsTheGuideWhileItsSlidersMove) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(open builtin:ball
wait
click "Guide"
wait
expect strokes.guides 1
expect strokes.displacement > 0.05
drag 0.4,0.4 0.5,0.42 0.6,0.4
wait
slide "Smoothing" 0
wait
expect strokes.guides > 1
expect strokes.smoothing < 0.1
expect strokes.displacement < 0.05
slide "Closeness" 0.8
wait
expect strokes.beta 0.8 0.1
expect strokes.looks 1
click "Apply to layer"
wait
expect strokes.looks 1
drag 0.4,0.5 0.5,0.52 0.6,0.5
wait
expect strokes.looks 1
expect strokes.count 2
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

// A straight line drawn as a style: said, and strokes stay as they are drawn.
TEST(Studio, SaysThatAStraightStyleHasNothingToLearn) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(open builtin:ball
wait
click "Guide"
key s
drag 0.05,0.85 0.3,0.85
wait
expect strokes.styles 1
expect strokes.displacement 0
drag 0.4,0.5 0.5,0.52 0.6,0.5
wait
expect strokes.count 1
expect strokes.points < 20000
shot plain all
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, ValuesAreTypedAfterADoubleClick) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(click "Radius value" double
frames 4
type "7.5"
key enter
frames 30
expect strokes.radius_mm 7.5
click "Radius value" double
frames 4
type "3"
key escape
frames 30
expect strokes.radius_mm 7.5
click "Radius value" double
frames 4
type "1000000"
key enter
frames 30
expect strokes.radius_mm 30
click "Advanced"
click "Seed value" double
frames 4
type "12 of them"
key enter
frames 30
expect strokes.seed 12
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, PanelsFoldAndResize) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(frames 2
click "tool panel border"
frames 2
expect studio.tool_panel_width 0
click "tool panel border"
frames 2
expect studio.tool_panel_width 300
drag "tool panel border" 0.1,0.5
frames 2
expect studio.tool_panel_width > 320
key tab
frames 2
expect studio.tool_panel_width 0
key tab
frames 2
expect studio.tool_panel_width > 320
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, DocumentsComeBackAsTheyWere) {
    const Folder folder;
    const std::string document = (folder / "mine.filigree").string();
    ASSERT_EQ(play_text(folder,
                        "open builtin:ball\nwait\ndrag 0.4,0.4 0.6,0.5 0.5,0.6\nclick \"New layer\"\n"
                        "click \"style knit\"\ndrag 0.45,0.3 0.55,0.35\nwait\nclick \"Draw\"\nmove 0.99,0.99\n"
                        "expect studio.unsaved 1\nsave " +
                            document + "\nexpect studio.unsaved 0\nframes 2\nshot saved\n")
                  .status,
              0);
    const Outcome loaded =
        play_text(folder, "load " + document +
                              "\nwait\nexpect strokes.count 2\nexpect strokes.layers 2\n"
                              "expect scene.meshes 1\nexpect studio.unsaved 0\nclick \"Draw\"\nmove 0.99,0.99\n"
                              "frames 2\nshot loaded\n");
    ASSERT_EQ(loaded.status, 0) << loaded.err;
    const Difference difference = compare_pictures(folder / "saved.png", folder / "loaded.png");
    EXPECT_LT(difference.mean, 0.1);
}

TEST(Studio, AStrokeReachesToWhereTheHandLetsGo) {
    const Folder folder;
    const std::string file = (folder / "lines.xyz").string();
    // The same line from both ends: each end is once the first that is drawn.
    const Outcome outcome = play_text(folder,
                                      "look 0,0,-1\nclick \"View plane\"\nclick \"Unstyled\"\n"
                                      "drag 0.3,0.4 0.7,0.4\ndrag 0.7,0.6 0.3,0.6\nwait\n"
                                      "expect strokes.count 2\nexport \"Strokes\" " +
                                          file + "\n");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    std::ifstream lines(file);
    double middle = 0.0, count = 0.0;
    std::vector<std::pair<double, double>> points;
    for (std::string line; std::getline(lines, line);) {
        double x = 0.0, y = 0.0;
        if (std::sscanf(line.c_str(), "%lf %lf", &x, &y) != 2) continue;
        points.emplace_back(x, y);
        middle += y, count += 1.0;
    }
    ASSERT_GT(points.size(), 20u);
    for (const auto& [x, y] : points) {
        const int line = y > middle / count ? 0 : 1;
        low[line] = std::min(low[line], x);
        high[line] = std::max(high[line], x);
    }
    const double length = high[1] - low[0];
    EXPECT_NEAR(high[0], high[1], 0.01 * length);
    EXPECT_NEAR(low[0], low[1], 0.01 * length);
}

TEST(Studio, AMissingMeshStaysInItsDocument) {
    const Folder folder;
    const std::string document = (folder / "mine.filigree").string();
    folder.write("mine.filigree", R"({"filigree": 1, "front": 3, "scene": {"active": 1, "meshes": [
        {"source": "/no/such/mesh.obj"}, {"source": "builtin:ball"}]}})");
    const std::string before = folder.read("mine.filigree");
    // The other one comes; saving asks for a name, and what is missing is still named there.
    const Outcome outcome =
        play_text(folder, "load " + document + "\nwait\nexpect scene.meshes 2\nexpect studio.unsaved 1\n" +
                              "key ctrl+s\nclick \"Cancel##file\"\nsave " + document + "2\n");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder.read("mine.filigree"), before);
    EXPECT_NE(folder.read("mine.filigree2").find("/no/such/mesh.obj"), std::string::npos);
}

TEST(Studio, SavingInTheMiddleOfAStepKeepsWhatWasThereBefore) {
    const Folder folder;
    const std::string document = (folder / "mine.filigree").string();
    // The step takes many frames, and the mesh before its own is gone by the time it is saved.
    const Outcome outcome =
        play_text(folder,
                  "open builtin:ball\nwait\nopen builtin:cat\nwait\nclick \"Tangles\"\nwait\n"
                  "click \"Contour\"\nwait\nkey enter\nwait\nexpect tangles.acts 1\nframes 60\n"
                  "click \"Cells\"\nclick \"x##remove ball\"\n"
                  "expect scene.meshes 1\nsave " +
                      document + "\nload " + document + "\nwait\nexpect tangles.acts 1\nexpect tangles.leaves > 1\n",
                  {"--workers", "0", "--budget", "100"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, AsksBeforeWorkIsLost) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(drag 0.4,0.4 0.5,0.5
wait
key ctrl+n
click "Cancel##changes"
expect strokes.count 1
key ctrl+n
click "Discard##changes"
expect strokes.count 0
expect studio.unsaved 0
key ctrl+n
expect strokes.count 0
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, WorkSurvivesBeingKilled) {
    const Folder folder;
    folder.write("work.txt", "drag 0.4,0.4 0.5,0.5\nwait\nframes 100000000\n");
    const std::string copies = (folder / "copies").string(), log = (folder / "log").string();
    const std::string start = std::string(FLG_STUDIO_PROGRAM) + " --script " + (folder / "work.txt").string() +
                              " --offscreen --autosave " + copies + " 2> " + log + " & pid=$!";
    const std::string wait = "for i in $(seq 1200); do [ -e " + copies +
                             "/autosave-$pid.filigree ] && break; sleep 0.1; done; kill -KILL $pid; wait $pid";
    run_program("/bin/sh", {"-c", start + "; " + wait}, folder.path());
    EXPECT_EQ(folder.read("log"), "");
    const Outcome next = play_text(folder,
                                   "frames 2\nclick \"Recover##copy\"\nwait\nexpect strokes.count 1\n"
                                   "expect studio.unsaved 1\n",
                                   {"--autosave", copies});
    EXPECT_EQ(next.status, 0) << next.err;
    const Outcome last = play_text(folder,
                                   "frames 2\nexpect strokes.count 0\ndrag 0.4,0.4 0.5,0.5\nwait\n"
                                   "expect strokes.count 1\n",
                                   {"--autosave", copies});
    EXPECT_EQ(last.status, 0) << "what was brought back is not offered again: " << last.err;
}

TEST(Studio, GoesOnAfterTheDeviceIsLost) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(open builtin:ball
wait
drag 0.4,0.4 0.5,0.5
wait
move 0.98,0.98
shot before
lose_device
frames 50
wait
shot after
lose_device
resize 900 600
frames 50
wait
expect strokes.count 1
)");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(folder.read("before.png"), folder.read("after.png"));
}

TEST(Studio, DamagedDocumentsAreRefusedOrTakenAsFarAsTheyGo) {
    const Folder folder;
    folder.write("none.filigree", "not json");
    folder.write("other.filigree", "{\"a\": 1}");
    folder.write("later.filigree", "{\"filigree\": 99}");
    const std::pair<const char*, const char*> refused[] = {{"none.filigree", "is not valid JSON"},
                                                           {"other.filigree", "is not a Filigree document"},
                                                           {"later.filigree", "this program reads version 1"}};
    for (const auto& [file, sentence] : refused) {
        const Outcome outcome = play_text(folder, "load " + (folder / file).string() + "\n");
        EXPECT_EQ(outcome.status, 1) << file;
        EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
    }
    folder.write("half.filigree", R"({"filigree": 1, "scene": {"meshes": [{"source": "builtin:ball"}]}, "camera": 7,
        "strokes": {"layers": [{"name": "a"}]}})");
    const Outcome half = play_text(folder, "load " + (folder / "half.filigree").string() +
                                               "\nwait\nexpect scene.meshes 1\nexpect studio.notices > 0\n"
                                               "expect strokes.count 0\nexpect studio.unsaved 1\n");
    EXPECT_EQ(half.status, 0) << half.err;
}

}  // namespace
}  // namespace flg::test
