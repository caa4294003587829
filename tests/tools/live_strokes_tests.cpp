// SPDX-License-Identifier: MIT
// The sample live_strokes: what its report says, and that a session that is not paced is the same every time.
#if defined(FLG_LIVE_STROKES_PROGRAM)
#include "cli_test.h"

namespace flg::test {
namespace {

class LiveStrokes : public Cli {
protected:
    // A short session of small pictures under the validation layer.
    nlohmann::json session(const std::string& out, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments = {"--fast",    "--validation", "--width",   "96",
                                              "--height",  "96",           "--samples", "1",
                                              "--seconds", "1.2",          "--out",     out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run_program(FLG_LIVE_STROKES_PROGRAM, arguments, folder.path());
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return report(out + "/live_strokes.json");
    }
};

TEST_F(LiveStrokes, SameSessionSamePictures) {
    const nlohmann::json first = session("a"), second = session("b");
    EXPECT_EQ(first["frames"], 108);
    EXPECT_EQ(first["missed"], 0);
    EXPECT_EQ(first["points"], second["points"]);
    for (const char* eye : {"/left.png", "/right.png"}) {
        EXPECT_GT(folder.read(std::string("a") + eye).size(), 500u);
        EXPECT_EQ(folder.read(std::string("a") + eye), folder.read(std::string("b") + eye)) << eye;
    }
    EXPECT_NE(folder.read("a/left.png"), folder.read("a/right.png"));
}

TEST_F(LiveStrokes, UploadsWhatIsNewAndSaysWhatFramesTook) {
    const nlohmann::json report = session("out");
    EXPECT_EQ(report["frames_over_bound"], 0);
    const auto points = report["points"].get<double>(), bytes = report["growth_bytes"].get<double>();
    EXPECT_GT(points, 200);
    EXPECT_GE(bytes, 24 * points);
    const auto tips = report["tip_points"].get<double>();
    EXPECT_GT(tips, 0);
    EXPECT_LT(tips, 3 * points) << "a tip reaches to the last sample and no further";
    EXPECT_LT(bytes, 40 * (points + tips)) << "a few points a frame, the last one again, and the tip";
    EXPECT_GT(report["samples"].get<int>(), 60) << "one a frame while the trigger is pressed";
    for (const char* figure : {"push_us", "tick_us", "record_ms", "submit_ms", "wait_ms", "frame_ms"}) {
        const nlohmann::json& row = report[figure];
        EXPECT_GE(row["p50"].get<double>(), 0.0) << figure;
        EXPECT_GE(row["p99"], row["p50"]) << figure;
        EXPECT_GE(row["p99.9"], row["p99"]) << figure;
        EXPECT_GE(row["max"], row["p99.9"]) << figure;
    }
    EXPECT_GE(report["frame_ms"]["p50"], report["record_ms"]["p50"]);
}

TEST_F(LiveStrokes, PacedSessionsKeepTheirClock) {
    std::vector<std::string> arguments = {"builtin:bouquet", "--no-window", "--width", "64", "--height",  "64",
                                          "--samples",       "1",           "--hertz", "20", "--seconds", "1",
                                          "--out",           "paced"};
    const Outcome outcome = run_program(FLG_LIVE_STROKES_PROGRAM, arguments, folder.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json paced = report("paced/live_strokes.json");
    EXPECT_LE(paced["frames"].get<int>() + paced["missed"].get<int>(), 20) << "a display each, drawn or missed";
    EXPECT_GE(paced["frames"].get<int>(), 1);
}

TEST_F(LiveStrokes, RefusesWhatItCannotRead) {
    const Outcome outcome = run_program(FLG_LIVE_STROKES_PROGRAM, {"nosuch.tilt", "--no-window"}, folder.path());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("live_strokes: nosuch.tilt")) << outcome.err;
}

}  // namespace
}  // namespace flg::test
#endif
