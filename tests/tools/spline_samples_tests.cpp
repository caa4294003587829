// SPDX-License-Identifier: MIT
// The commands that the pages of splines show, on the files of samples/splines.
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "cli_test.h"

namespace flg::test {
namespace {

using Strings = std::vector<std::string>;
using Place = std::array<double, 3>;

class SplineSamples : public Cli {
protected:
    // Its commands, which are set in by four columns, without the program's name; files of samples where they are.
    static std::vector<Strings> commands_of(const std::string& page) {
        std::ifstream file(std::string(FLG_SOURCES) + "/" + page);
        std::vector<Strings> commands;
        const std::string start = "    filigree ";
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with(start)) continue;
            std::istringstream words(line.substr(start.size()));
            Strings& command = commands.emplace_back();
            for (std::string word; words >> word;) {
                command.push_back(word.starts_with("samples/") ? std::string(FLG_SOURCES) + "/" + word : word);
            }
        }
        return commands;
    }
    void run_page(const std::string& page) const {
        const std::vector<Strings> commands = commands_of(page);
        EXPECT_GE(commands.size(), 5u) << page;
        for (const Strings& command : commands) {
#if !defined(FLG_WITH_RENDERER)
            if (command[0] == "render") continue;
#endif
            const Outcome outcome = done(command);
            EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << page << ": " << outcome.err;
            const auto output = std::find(command.begin(), command.end(), "-o");
            ASSERT_LT(output + 1, command.end()) << page;
            EXPECT_FALSE(folder.read(*(output + 1)).empty()) << page << ": " << *(output + 1);
        }
    }
    std::vector<Place> points(const std::string& name) const {
        std::vector<Place> list;
        std::istringstream lines(folder.read(name));
        for (std::string line; std::getline(lines, line);) {
            Place p;
            std::istringstream words(line);
            if (words >> p[0] >> p[1] >> p[2]) list.push_back(p);
        }
        return list;
    }
};

TEST_F(SplineSamples, TheRoomsPageRunsAsItIs) {
    run_page("sdk/splines/README.md");
}

// Numbers are those of tunnel.json: blocks up to 0.26 left and right, from -0.08 to 0.02 apart, the upper one up to
// 0.6.
TEST_F(SplineSamples, TheirPageRunsAsItIsAndSidesAreKept) {
    run_page("samples/splines/README.md");
    constexpr double clearance = 0.013, rounding = 1e-9;
    int beside = 0;
    for (const Place& p : points("through.xyz")) {
        if (std::abs(p[0]) > 0.26) continue;
        ++beside;
        EXPECT_GE(p[1], -0.08 + clearance - rounding);
        EXPECT_LE(p[1], 0.02 - clearance + rounding);
    }
    for (const Place& p : points("over.xyz")) {
        if (std::abs(p[0]) > 0.26) continue;
        ++beside;
        EXPECT_GE(p[1], 0.6 + clearance - rounding);
    }
    EXPECT_GT(beside, 20);
}

}  // namespace
}  // namespace flg::test
