// SPDX-License-Identifier: MIT
// filigree replay: strokes through live strokes, at their own times or not.
#include "cli_test.h"

namespace flg::test {
namespace {

using Replay = Cli;

// Ten samples of a bent stroke of 90 cm.
std::string stroke() {
    std::string text;
    for (int i = 0; i < 10; ++i) text += std::to_string(0.1 * i) + " " + std::to_string(0.01 * i * i) + " 0\n";
    return text;
}

// Many strokes in a row: while one is drawn, workers end those before it, and allocate.
TEST_F(Replay, CountsThePushesOwnAllocations) {
    std::string text;
    for (int k = 0; k < 12; ++k) text += stroke() + "\n";
    folder.write("strokes.xyz", text);
    done({"replay", "strokes.xyz", "--style", "builtin:zigzag", "--scale", "0.02", "-o", "out.xyz", "--fast",
          "--workers", "1", "--report", "report.json", "--quiet"});
    const nlohmann::json json = report();
    EXPECT_EQ(json.at("counts").at("strokes"), 12);
    EXPECT_EQ(json.at("quality").at("allocations"), 0);
}

TEST_F(Replay, ReportsLatenciesAndAllocatesNothing) {
    done({"replay", "builtin:flourish", "--style", "builtin:zigzag", "--scale", "0.2", "-o", "out.xyz", "--fast",
          "--report", "report.json", "--quiet"});
    const nlohmann::json json = report();
    EXPECT_EQ(json.at("command"), "replay");
    EXPECT_EQ(json.at("parameters").at("fast"), true);
    const nlohmann::json& quality = json.at("quality");
    EXPECT_EQ(quality.at("allocations"), 0);
    EXPECT_GT(quality.at("p50_us"), 0);
    EXPECT_GE(quality.at("p99_us"), quality.at("p50_us"));
    EXPECT_GE(quality.at("max_us"), quality.at("p99_us"));
    const nlohmann::json& counts = json.at("counts");
    EXPECT_EQ(counts.at("strokes"), 1);
    EXPECT_GT(counts.at("result_points"), 100);
}

TEST_F(Replay, OwnTimesAndWorkersDoNotChangeTheBits) {
    folder.write("stroke.xyz", stroke());
    done({"replay", "stroke.xyz", "--style", "builtin:loops", "--scale", "0.2", "-o", "slow.xyz", "--quiet"});
    done({"replay", "stroke.xyz", "--style", "builtin:loops", "--scale", "0.2", "-o", "fast.xyz", "--fast", "--workers",
          "0", "--quiet"});
    const std::string slow = folder.read("slow.xyz");
    EXPECT_GT(slow.size(), 1000u);
    EXPECT_EQ(slow, folder.read("fast.xyz"));
}

TEST_F(Replay, EndedStrokesGetTheEndCapIfWanted) {
    folder.write("stroke.xyz", stroke());
    const std::vector<std::string> plain = {"replay", "stroke.xyz", "--style", "builtin:loops", "--scale", "0.2",
                                            "-o",     "plain.xyz",  "--fast",  "--caps",        "0:0.3",   "--quiet"};
    done(plain);
    std::vector<std::string> capped = plain;
    capped[7] = "capped.xyz";
    capped.emplace_back("--end-cap");
    done(capped);
    EXPECT_NE(folder.read("plain.xyz"), folder.read("capped.xyz"));
}

TEST_F(Replay, SeveralStylesAreChosenAmong) {
    std::string text = "# columns x y z pressure\n";
    for (int i = 0; i <= 50; ++i) text += std::to_string(0.1 * i) + " 0 0 " + std::to_string(0.02 * i) + "\n";
    folder.write("stroke.xyz", text);
    const auto with = [&](const std::string& choice) {
        return std::vector<std::string>{"replay",
                                        "stroke.xyz",
                                        "--style",
                                        "builtin:loops",
                                        "--style",
                                        "builtin:zigzag",
                                        "--drive",
                                        "pressure=style:" + choice,
                                        "--style-blend",
                                        "0.5",
                                        "--scale",
                                        "0.1",
                                        "-o",
                                        "out.xyz",
                                        "--fast",
                                        "--report",
                                        "report.json",
                                        "--quiet"};
    };
    done(with("0:1"));
    const nlohmann::json json = report();
    EXPECT_EQ(json.at("parameters").at("style").size(), 2u);
    EXPECT_EQ(json.at("parameters").at("style_blend"), 0.5);
    EXPECT_EQ(json.at("quality").at("allocations"), 0);
    const std::string mixed = folder.read("out.xyz");
    done(with("1:1"));
    EXPECT_NE(folder.read("out.xyz"), mixed);
    expect_refused(with("0:2"), 2, {"--drive pressure=style:0:2", "0 to 1"});
}

TEST_F(Replay, WhatHasNoEffectIsRefused) {
    folder.write("stroke.xyz", stroke());
    const auto refused = [&](const std::vector<std::string>& more, int status, const std::vector<std::string>& words) {
        std::vector<std::string> all = {"replay", "stroke.xyz", "--style", "builtin:loops", "-o", "out.xyz", "--fast"};
        all.insert(all.end(), more.begin(), more.end());
        expect_refused(all, status, words);
    };
    refused({"--drive", "pressure=magnitude:0:1"}, 1, {"stroke.xyz: --drive pressure=magnitude:0:1", "no such column"});
    refused({"--drive", "speed=magnitude:0:1"}, 1, {"--drive speed=magnitude:0:1", "no times"});
    refused({"--drive", "radius=magnitude:0:1"}, 2, {"--drive radius=magnitude:0:1", "hand"});
    refused({"--end-cap"}, 2, {"--end-cap", "--caps"});
    refused({"--style-blend", "1"}, 2, {"--style-blend"});
}

TEST_F(Replay, PressuresBeyondTheHandsAreSaid) {
    folder.write("stroke.xyz", "# columns x y z pressure\n0 0 0 0.5\n1 0 0 1.5\n2 0 0 -1\n3 0 0 1\n");
    const Outcome outcome = done({"replay", "stroke.xyz", "--style", "builtin:loops", "--scale", "0.1", "--max-jump",
                                  "2", "-o", "out.xyz", "--fast"});
    EXPECT_NE(outcome.err.find("2 pressures below 0 or above 1"), std::string::npos);
}

TEST_F(Replay, BreaksStrokesAtJumps) {
    std::string text = stroke();
    for (int i = 0; i < 10; ++i) text += std::to_string(50 + 0.1 * i) + " 0 0\n";
    folder.write("jump.xyz", text);
    const Outcome outcome = done({"replay", "jump.xyz", "--style", "builtin:loops", "--scale", "0.2", "-o", "out.xyz",
                                  "--fast", "--report", "report.json"});
    EXPECT_NE(outcome.err.find("broken"), std::string::npos);
    const nlohmann::json counts = report().at("counts");
    EXPECT_EQ(counts.at("strokes"), 1);
    EXPECT_EQ(counts.at("samples"), 20);
    EXPECT_EQ(counts.at("drawn_strokes"), 2);
    EXPECT_EQ(counts.at("broken_at_jumps"), 1);
    EXPECT_EQ(counts.at("broken_when_full"), 0);
    EXPECT_EQ(counts.at("refused_samples"), 0);
    EXPECT_NE(folder.read("out.xyz").find("\n\n"), std::string::npos);  // two curves
}

TEST_F(Replay, SaysWhereItIsWhenItTakesLong) {
    std::string text;
    for (int i = 0; i < 240; ++i) text += std::to_string(0.01 * i) + " 0 0\n";  // 2.7 s at 90 Hz
    folder.write("stroke.xyz", text);
    const std::vector<std::string> replay = {"replay", "stroke.xyz", "--style", "builtin:loops", "-o", "out.xyz"};
    done(replay);
    EXPECT_NE(progress.find(" s: drawing stroke 1 of 1"), std::string::npos) << progress;
    std::vector<std::string> quiet = replay;
    quiet.push_back("--quiet");
    const Outcome outcome = done(quiet);
    EXPECT_EQ(progress + outcome.err, "");
}

// The style's options are stylize's: a style that stylize saved gives what the same options give.
TEST_F(Replay, TakesTheOptionsOfStylize) {
    folder.write("stroke.xyz", stroke());
    const std::vector<std::string> style = {"--style", "builtin:loops", "--patch", "6", "--attributes", "radius:0.5"};
    const std::vector<std::string> apply = {"--fast",
                                            "--scale",
                                            "0.2",
                                            "--tau",
                                            "0.5",
                                            "--start",
                                            "random",
                                            "--frame",
                                            "rmf",
                                            "--basis",
                                            "1,0,0,0,0,1,0,-1,0",
                                            "--seed",
                                            "7",
                                            "--quiet"};
    const auto with = [](std::vector<std::string> first, const std::vector<std::string>& more) {
        first.insert(first.end(), more.begin(), more.end());
        return first;
    };
    done(with(with({"replay", "stroke.xyz", "-o", "learnt.xyz", "--style-file", "saved.bin"}, style), apply));
    done(with({"replay", "stroke.xyz", "-o", "loaded.xyz", "--style-file", "saved.bin", "--report", "report.json"},
              apply));
    const std::string learnt = folder.read("learnt.xyz");
    EXPECT_GT(learnt.size(), 1000u);
    EXPECT_EQ(learnt, folder.read("loaded.xyz"));
    const nlohmann::json parameters = report().at("parameters");
    EXPECT_EQ(parameters.at("start"), "random");
    EXPECT_EQ(parameters.at("basis").size(), 9u);
    // Each of them counts.
    const std::vector<std::string> replay = {"replay", "stroke.xyz", "-o",      "other.xyz",
                                             "--fast", "--quiet",    "--scale", "0.2"};
    done(with(with(replay, style), {}));
    const std::string plain = folder.read("other.xyz");
    EXPECT_NE(plain, learnt);
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--basis", "1,0,0,0,0,1,0,-1,0"}, {"--start", "random", "--seed", "7"}, {"--sigma", "0.5"}}) {
        done(with(with(replay, style), more));
        EXPECT_NE(folder.read("other.xyz"), plain) << more[0];
    }
    expect_refused(with(with(replay, style), {"--frame", "frenet"}), 2, {"--frame", "frenet", "rmf|supplied"});
    expect_refused({"replay", "stroke.xyz", "-o", "o.xyz", "--style-file", "saved.bin", "--patch", "5"}, 2,
                   {"--patch"});
}

// One style is made, by the options that `stylize` has.
TEST_F(Replay, MakesTheGuideThatStylizeMakes) {
    done({"replay", "builtin:s_curve", "-o", "a.xyz", "--fast", "--style", "builtin:curls", "--beta", "0.4",
          "--guide-smoothing", "0.1", "--save-guide", "replayed.xyz"});
    done({"stylize", "--target", "builtin:s_curve", "-o", "b.xyz", "--style", "builtin:curls", "--beta", "0.4",
          "--smoothing", "0.1", "--save-guide", "stylized.xyz"});
    EXPECT_GT(folder.read("replayed.xyz").size(), 1000u);
    EXPECT_EQ(folder.read("replayed.xyz"), folder.read("stylized.xyz"));
    expect_refused({"replay", "builtin:flourish", "--style", "builtin:loops", "-o", "out.xyz", "--save-guide", "g.pdf"},
                   2, {"g.pdf"});
}

TEST_F(Replay, RefusesBadUsageAndBadFiles) {
    expect_refused({"replay", "builtin:flourish", "-o", "out.xyz"}, 2, {"--style"});
    expect_refused({"replay", "none.tilt", "--style", "builtin:loops", "-o", "out.xyz"}, 1, {"none.tilt"});
    expect_refused({"replay", "builtin:flourish", "--style", "builtin:loops", "-o", "out.xyz", "--smoothing", "-1"}, 2,
                   {"--smoothing"});
    expect_refused({"replay", "builtin:flourish", "--style", "builtin:loops", "-o", "out.png"}, 2, {"out.png"});
}

}  // namespace
}  // namespace flg::test
