// SPDX-License-Identifier: MIT
// Rooms include each other downwards only (design, section 1).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace flg::test {
namespace {

namespace fs = std::filesystem;
using Rooms = std::set<std::string>;

// Which rooms of sdk/ each may include, besides itself. "filigree" are the public headers.
const std::map<std::string, Rooms> allowed = {
    {"sdk/core", {"filigree"}},
    {"sdk/runtime", {"filigree", "core"}},
    {"sdk/curves", {"filigree", "core", "runtime"}},
    {"sdk/stylization", {"filigree", "core", "runtime", "curves"}},
    {"sdk/surfaces", {"filigree", "core", "runtime", "curves"}},
    {"sdk/splines", {"filigree", "core", "runtime", "curves", "surfaces"}},
    {"sdk/skeletons", {"filigree", "core", "runtime", "curves", "surfaces"}},
    {"sdk/inflation", {"filigree", "core", "runtime", "skeletons"}},
    {"sdk/bones", {"filigree", "core", "runtime", "curves", "surfaces", "skeletons", "inflation"}},
    {"sdk/tangles", {"filigree", "core", "runtime", "curves", "surfaces"}},
    {"sdk/api",
     {"filigree", "core", "runtime", "curves", "stylization", "surfaces", "splines", "skeletons", "inflation", "bones",
      "tangles"}},
    {"sdk/io", {"filigree"}},
    {"sdk/pick", {"filigree", "core"}},
    {"sdk/include", {"filigree"}},
    {"renderer", {"filigree"}},
};
const Rooms rooms = {"filigree", "core",    "runtime",   "curves",    "stylization",
                     "surfaces", "splines", "skeletons", "inflation", "bones",
                     "tangles",  "api",     "io",        "pick",      "filigree_renderer"};

std::set<std::string> violations(const std::string& folder, const Rooms& may_include) {
    std::set<std::string> found;
    const fs::path root = fs::path(FLG_SOURCE_DIR) / folder;
    const std::regex include("^\\s*#include \"([^\"/]+)/");
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".hpp" && extension != ".cpp") continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);) {
            if (!std::regex_search(line, match, include)) continue;
            const std::string room = match[1];
            const bool own = root.filename() == room || (folder == "renderer" && room == "filigree_renderer");
            if (rooms.contains(room) && !own && !may_include.contains(room)) {
                found.insert(fs::relative(entry.path(), FLG_SOURCE_DIR).string() + " includes " + room);
            }
        }
    }
    return found;
}

TEST(Architecture, RoomsIncludeDownwardsOnly) {
    for (const auto& [folder, may_include] : allowed) EXPECT_EQ(violations(folder, may_include), Rooms{}) << folder;
}

TEST(Architecture, TheCheckFindsWhatItLooksFor) {
    EXPECT_NE(violations("sdk/api", {"filigree"}), Rooms{});
}

TEST(Architecture, EveryRoomOfTheSdkIsCovered) {
    const Rooms without_code = {"docs", "package"};
    for (const auto& entry : fs::directory_iterator(fs::path(FLG_SOURCE_DIR) / "sdk")) {
        if (!entry.is_directory() || without_code.contains(entry.path().filename().string())) continue;
        EXPECT_TRUE(allowed.contains("sdk/" + entry.path().filename().string())) << entry.path();
    }
}

}  // namespace
}  // namespace flg::test
