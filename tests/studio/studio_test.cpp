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
void plays(const std::string& name) {
    const Folder folder;
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
    plays("strokes");
}

TEST(Studio, OrnamentsAVase) {
    plays("tangles");
}

TEST(Studio, DrawsAnAnimalThatIsMovedRefinedAndPosed) {
    plays("skeletons");
}

TEST(Studio, LaysCurvesAroundObstaclesAndPlaysAMotion) {
    plays("splines");
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
        {"expect strokes.nonsense 1\n", "script.txt:1: strokes count "},
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
    EXPECT_NE(none.err.find("can't be read"), std::string::npos) << none.err;
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
    const Outcome outcome = play_text(folder,
                                      "open builtin:ball\nwait\nopen builtin:cat\nwait\nclick \"Tangles\"\nwait\n"
                                      "click \"Contour\"\nwait\nkey enter\nwait\nexpect tangles.acts 1\nframes 60\n"
                                      "click \"Cells\"\nclick \"x##remove ball\"\nclick \"Take it out\"\n"
                                      "expect scene.meshes 1\nsave " +
                                          document + "\nload " + document + "\nwait\nexpect tangles.acts 1\n",
                                      {"--workers", "0", "--budget", "100"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, AsksBeforeAMeshGoes) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(open builtin:ball
wait
click "x##remove ball"
click "Keep it"
expect scene.meshes 1
click "x##remove ball"
click "Take it out"
expect scene.meshes 0
)");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Studio, AsksBeforeWorkIsLost) {
    const Folder folder;
    const Outcome outcome = play_text(folder, R"(drag 0.4,0.4 0.5,0.5
wait
key ctrl+n
click "Stay here"
expect strokes.count 1
key ctrl+n
click "Discard them"
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
                                   "frames 2\nclick \"Bring it back\"\nwait\nexpect strokes.count 1\n"
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
frames 12
wait
shot after
lose_device
resize 900 600
frames 12
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
    const std::pair<const char*, const char*> refused[] = {{"none.filigree", "is no JSON"},
                                                           {"other.filigree", "is no document of this program"},
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
