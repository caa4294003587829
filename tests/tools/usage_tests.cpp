// SPDX-License-Identifier: MIT
// Exit statuses, error lines and help of the command line.
#include "cli_test.h"

namespace flg::test {
namespace {

using Usage = Cli;

constexpr int kFailed = 1, kBadUsage = 2;

std::vector<std::string> stylize_with(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"stylize",         "--style", "builtin:tremor", "--target",
                                          "builtin:s_curve", "-o",      "out.xyz"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_F(Usage, VersionIsPrinted) {
    EXPECT_EQ(done({"--version"}).out, "filigree 0.1.0\n");
}

TEST_F(Usage, HelpOfEachCommandNamesItsOptions) {
    EXPECT_NE(done({"--help"}).out.find("stylize"), std::string::npos);
    const std::string help = done({"stylize", "--help"}).out;
    for (const char* option :
         {"--style", "--target", "--guide", "--sigma", "--tau", "--patch", "--alpha", "--beta", "--scale", "--frame",
          "--start", "--as", "--save-guide", "--save-matching", "--save-path"}) {
        EXPECT_NE(help.find(option), std::string::npos) << option;
    }
    for (const char* command : {"info", "mesh", "geodesic", "path", "contour", "render", "bench"})
        EXPECT_FALSE(done({command, "--help"}).out.empty());
}

TEST_F(Usage, BadUsageExitsWithTwo) {
    expect_refused({}, kBadUsage, {"subcommand"});
    expect_refused({"nosuch"}, kBadUsage, {"nosuch"});
    expect_refused({"info"}, kBadUsage, {"FILE"});
    expect_refused({"stylize", "--target", "builtin:s_curve", "-o", "out.xyz"}, kBadUsage, {"--style"});
    expect_refused(stylize_with({"--nosuch"}), kBadUsage, {"--nosuch"});
    for (const char* seed : {"many", "-1", "1.5", "18446744073709551616", "99999999999999999999999"}) {
        expect_refused(stylize_with({"--seed", seed}), kBadUsage, {"--seed", seed, "0 to 18446744073709551615"});
    }
    expect_refused(stylize_with({"--workers", "1000"}), kBadUsage, {"--workers"});
    expect_refused(stylize_with({"--workers", "-1"}), kBadUsage, {"--workers"});
    expect_refused(stylize_with({"--budget", "-1"}), kBadUsage, {"--budget"});
    expect_refused({"bench", "nosuch"}, kBadUsage, {"nosuch"});
    EXPECT_TRUE(folder.list().empty());
}

// One door for all that is written: what killed saves left is gone, and modes stay.
TEST_F(Usage, SavesCleanUpAndKeepModes) {
    const std::vector<std::string> arguments = stylize_with({"--report", "report.json", "--save-path", "path.txt"});
    done(arguments);
    const std::vector<std::string> files = folder.list();
    ASSERT_EQ(files.size(), 3u);
    for (const std::string& name : files) {
        folder.write(name + ".flg-saving3", "half");
        std::filesystem::permissions(folder / name,
                                     std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }
    done(arguments);
    EXPECT_EQ(folder.list(), files);
    for (const std::string& name : files) {
        EXPECT_EQ(std::filesystem::status(folder / name).permissions(),
                  std::filesystem::perms::owner_read | std::filesystem::perms::owner_write)
            << name;
    }
}

TEST_F(Usage, NumbersOutOfRangeExitWithTwo) {
    const std::pair<const char*, std::vector<const char*>> bad[] = {{"--sigma", {"nan", "inf", "1e39", "much"}},
                                                                    {"--tau", {"-0.1", "nan", "inf"}},
                                                                    {"--patch", {"0", "1025", "-3", "1.5"}},
                                                                    {"--alpha", {"-0.1", "1.1", "nan"}},
                                                                    {"--beta", {"0", "1", "nan"}},
                                                                    {"--scale", {"-1", "1e-50", "nan", "inf"}},
                                                                    {"--frame", {"bishop"}},
                                                                    {"--start", {"end"}},
                                                                    {"--as", {"cloud"}}};
    for (const auto& [option, values] : bad) {
        for (const char* value : values) expect_refused(stylize_with({option, value}), kBadUsage, {option});
    }
    EXPECT_TRUE(folder.list().empty());
}

TEST_F(Usage, NumbersOutOfRangeAreToldTheRange) {
    expect_refused(stylize_with({"--tau", "inf"}), kBadUsage, {"--tau", "'inf'", "0 to 3.4e38"});
    expect_refused(stylize_with({"--sigma", "1e39"}), kBadUsage, {"--sigma", "-3.4e38 to 3.4e38"});
    done(stylize_with({"--seed", "18446744073709551615", "--quiet"}));
}

TEST_F(Usage, OutputsThatShareAFileExitWithTwo) {
    for (const char* option : {"--save-guide", "--save-matching", "--save-path", "--report"}) {
        expect_refused(stylize_with({option, "out.xyz"}), kBadUsage, {"out.xyz", option});
        expect_refused(stylize_with({option, "./out.xyz"}), kBadUsage, {"out.xyz", option});
    }
    expect_refused(stylize_with({"--save-path", "a.txt", "--save-matching", "a.txt"}), kBadUsage, {"a.txt"});
    EXPECT_TRUE(folder.list().empty());
    folder.write("real.xyz", "");
    std::filesystem::create_symlink("real.xyz", folder / "link.xyz");
    expect_refused(stylize_with({"--save-guide", "link.xyz", "--save-path", "real.xyz"}), kBadUsage, {"real.xyz"});
}

TEST_F(Usage, OutputsThroughLinksKeepTheLinks) {
    std::filesystem::create_directory(folder / "real");
    for (const char* name : {"out.xyz", "path.txt", "report.json"}) {
        std::filesystem::create_symlink(std::string("real/") + name, folder / name);
    }
    done(stylize_with({"--save-path", "path.txt", "--report", "report.json", "--quiet"}));
    for (const char* name : {"out.xyz", "path.txt", "report.json"}) {
        EXPECT_TRUE(std::filesystem::is_symlink(folder / name)) << name;
        EXPECT_FALSE(folder.read(std::string("real/") + name).empty()) << name;
    }
}

TEST_F(Usage, OutputsOfOtherKindsExitWithTwo) {
    expect_refused({"stylize", "--style", "builtin:tremor", "--target", "builtin:s_curve", "-o", "out.png"}, kBadUsage,
                   {"out.png"});
    expect_refused(stylize_with({"--as", "tube"}), kBadUsage, {"out.xyz"});
    expect_refused(stylize_with({"--save-guide", "guide.pdf"}), kBadUsage, {"guide.pdf"});
}

TEST_F(Usage, MissingFilesExitWithOneAndAreNamed) {
    expect_refused({"info", "nosuch.tilt"}, kFailed, {"nosuch.tilt"});
    expect_refused({"stylize", "--style", "nosuch.xyz", "--target", "builtin:s_curve", "-o", "out.xyz"}, kFailed,
                   {"nosuch.xyz"});
    expect_refused({"stylize", "--style", "builtin:tremor", "--target", "nosuch.obj", "-o", "out.xyz"}, kFailed,
                   {"nosuch.obj"});
    expect_refused(stylize_with({"--guide", "nosuch.xyz"}), kFailed, {"nosuch.xyz"});
    EXPECT_TRUE(folder.list().empty());
}

TEST_F(Usage, UnknownBuiltInCurvesExitWithOneAndListTheKnownOnes) {
    expect_refused({"info", "builtin:nosuch"}, kFailed, {"builtin:nosuch:", "loops", "thomas"});
    expect_refused({"info", "builtin:thomas:many"}, kFailed, {"builtin:thomas:many:", "many"});
    expect_refused({"info", "builtin:thomas:1"}, kFailed, {"builtin:thomas:1:"});
    expect_refused({"info", "builtin:"}, kFailed, {"builtin:"});
}

TEST_F(Usage, BadLinesAreNamedByFileAndPlace) {
    folder.write("bad.xyz", "0 0 0\n1 nan 0\n2 0 0\n");
    expect_refused({"info", "bad.xyz"}, kFailed, {"bad.xyz:2:"});
    folder.write("letters.xyz", "0 0 0\n1 0 0\n2 0 x\n");
    expect_refused({"stylize", "--style", "letters.xyz", "--target", "builtin:s_curve", "-o", "out.xyz"}, kFailed,
                   {"letters.xyz:3:"});
    folder.write("bad.tilt", "this is no sketch");
    expect_refused({"info", "bad.tilt"}, kFailed, {"bad.tilt:"});
    folder.write("empty.xyz", "");
    expect_refused({"info", "empty.xyz"}, kFailed, {"empty.xyz"});
    EXPECT_FALSE(folder.has("out.xyz"));
}

TEST_F(Usage, StylesThatCannotBePreparedAreNamed) {
    folder.write("point.xyz", "1 2 3\n");
    folder.write("still.xyz", "1 2 3\n1 2 3\n1 2 3\n1 2 3\n");
    folder.write("ring.xyz", "# closed\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
    for (const char* style : {"point.xyz", "still.xyz", "ring.xyz"}) {
        expect_refused({"--quiet", "stylize", "--style", style, "--target", "builtin:s_curve", "-o", "out.xyz"},
                       kFailed, {style});
    }
    EXPECT_FALSE(folder.has("out.xyz"));
}

TEST_F(Usage, UnwritableOutputsAreRefusedBeforeTheWork) {
    for (const char* option : {"--save-guide", "--save-matching", "--save-path", "--report"}) {
        expect_refused(stylize_with({option, "nosuch/file.xyz"}), kFailed, {"nosuch/file.xyz"});
    }
    expect_refused({"stylize", "--style", "builtin:tremor", "--target", "builtin:s_curve", "-o", "nosuch/out.xyz"},
                   kFailed, {"nosuch/out.xyz"});
    std::filesystem::create_directory(folder / "taken.xyz");
    expect_refused({"stylize", "--style", "builtin:tremor", "--target", "builtin:s_curve", "-o", "taken.xyz"}, kFailed,
                   {"taken.xyz"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"taken.xyz"});
}

}  // namespace
}  // namespace flg::test
