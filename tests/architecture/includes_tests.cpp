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
    {"sdk/brush", {"filigree", "core"}},
    {"sdk/runtime", {"filigree", "core"}},
    {"sdk/buffers", {"filigree", "core", "runtime"}},
    {"sdk/linear", {"filigree", "core", "runtime"}},
    {"sdk/curves", {"filigree", "core", "runtime"}},
    {"sdk/stylization", {"filigree", "core", "runtime", "curves"}},
    {"sdk/surfaces", {"filigree", "core", "runtime", "curves"}},
    {"sdk/splines", {"filigree", "core", "runtime", "linear", "curves", "surfaces"}},
    {"sdk/skeletons", {"filigree", "core", "runtime", "curves", "surfaces"}},
    {"sdk/inflation", {"filigree", "core", "runtime", "linear", "skeletons"}},
    {"sdk/bones", {"filigree", "core", "runtime", "curves", "surfaces", "skeletons", "inflation"}},
    {"sdk/rigs", {"filigree", "core", "bones"}},
    {"sdk/solids", {"filigree", "core", "runtime", "surfaces", "skeletons", "inflation", "bones", "rigs"}},
    {"sdk/pulling", {"filigree", "core", "runtime", "linear", "surfaces", "inflation"}},
    {"sdk/tangles", {"filigree", "core", "runtime", "curves", "surfaces"}},
    {"sdk/baking", {"filigree", "core", "runtime", "surfaces", "tangles"}},
    {"sdk/api",
     {"baking", "filigree", "core", "brush", "runtime", "buffers", "curves", "stylization", "surfaces", "splines",
      "skeletons", "inflation", "bones", "rigs", "solids", "pulling", "tangles"}},
    {"sdk/io", {"filigree", "core", "brush"}},
    {"sdk/pick", {"filigree", "core"}},
    {"sdk/include", {"filigree"}},
    {"renderer", {"filigree", "core"}},
};
// Which sub-rooms of its room each folder may include, besides itself. "" is the room's own folder.
const std::map<std::string, Rooms> allowed_within = {
    {"surfaces/mesh", {}},
    {"surfaces/repair", {"mesh"}},
    {"surfaces/geodesics", {"mesh"}},
    {"surfaces/tracing", {"mesh"}},
    {"surfaces/cutting", {"mesh"}},
    {"surfaces/sampling", {"mesh", "geodesics"}},
    {"surfaces/", {"mesh", "repair", "geodesics", "tracing", "cutting", "sampling"}},
    {"splines/manifolds", {}},
    {"splines/optimizer", {"manifolds"}},
    {"splines/obstacles", {"manifolds"}},
    {"splines/", {"manifolds", "optimizer", "obstacles"}},
    {"splines/motion", {"", "manifolds", "optimizer"}},
    {"io/base", {}},
    {"io/gltf", {"base"}},
    {"io/text", {"base"}},
    {"io/tilt", {"base"}},
    {"io/svg", {"base"}},
    {"io/tangle", {"base"}},
    {"io/", {"base", "gltf", "text", "tilt", "svg"}},
};
const Rooms rooms = {"filigree", "core",        "brush",    "runtime",          "buffers",   "linear",
                     "curves",   "stylization", "surfaces", "splines",          "skeletons", "inflation",
                     "bones",    "rigs",        "solids",   "pulling",          "tangles",   "baking",
                     "api",      "io",          "pick",     "filigree_renderer"};

bool is_source(const fs::path& file) {
    const std::string extension = file.extension();
    return extension == ".h" || extension == ".hpp" || extension == ".cpp" || extension == ".inl";
}

// The folders that a file includes by their paths from the root of its sources.
Rooms folders_included(const fs::path& path) {
    static const std::regex include("^\\s*#include \"([^\"]+)/[^\"/]+\"");
    Rooms found;
    std::ifstream file(path);
    std::smatch match;
    for (std::string line; std::getline(file, line);)
        if (std::regex_search(line, match, include)) found.insert(match[1]);
    return found;
}

std::set<std::string> violations(const std::string& folder, const Rooms& may_include) {
    std::set<std::string> found;
    const fs::path root = fs::path(FLG_SOURCE_DIR) / folder;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (!is_source(entry.path())) continue;
        for (const std::string& included : folders_included(entry.path())) {
            const std::string room = included.substr(0, included.find('/'));
            const bool own = root.filename() == room || (folder == "renderer" && room == "filigree_renderer");
            if (rooms.contains(room) && !own && !may_include.contains(room)) {
                found.insert(fs::relative(entry.path(), FLG_SOURCE_DIR).string() + " includes " + room);
            }
        }
    }
    return found;
}

// `folder`: "room/sub-room", or "room/" for the files beside the sub-rooms.
std::set<std::string> violations_within(const std::string& folder, const Rooms& may_include) {
    std::set<std::string> found;
    const std::string room = folder.substr(0, folder.find('/')), own = folder.substr(room.size() + 1);
    for (const auto& entry : fs::directory_iterator(fs::path(FLG_SOURCE_DIR) / "sdk" / folder)) {
        if (!is_source(entry.path())) continue;
        for (const std::string& included : folders_included(entry.path())) {
            if (included != room && !included.starts_with(room + "/")) continue;
            const std::string sub_room = included == room ? "" : included.substr(room.size() + 1);
            if (sub_room == own || may_include.contains(sub_room)) continue;
            found.insert(fs::relative(entry.path(), FLG_SOURCE_DIR).string() + " includes " + included);
        }
    }
    return found;
}

TEST(Architecture, RoomsIncludeDownwardsOnly) {
    for (const auto& [folder, may_include] : allowed) EXPECT_EQ(violations(folder, may_include), Rooms{}) << folder;
}

TEST(Architecture, SubRoomsIncludeDownwardsOnly) {
    for (const auto& [folder, may_include] : allowed_within)
        EXPECT_EQ(violations_within(folder, may_include), Rooms{}) << folder;
}

TEST(Architecture, TheChecksFindWhatTheyLookFor) {
    EXPECT_NE(violations("sdk/api", {"filigree"}), Rooms{});
    EXPECT_NE(violations_within("surfaces/sampling", {"mesh"}), Rooms{});
    EXPECT_NE(violations_within("splines/motion", {"manifolds", "optimizer"}), Rooms{});
    EXPECT_NE(violations_within("splines/", {"manifolds", "optimizer"}), Rooms{});
}

TEST(Architecture, EveryRoomOfTheSdkIsCovered) {
    const Rooms without_code = {"data", "docs", "package"};
    for (const auto& entry : fs::directory_iterator(fs::path(FLG_SOURCE_DIR) / "sdk")) {
        if (!entry.is_directory() || without_code.contains(entry.path().filename().string())) continue;
        const std::string room = entry.path().filename();
        EXPECT_TRUE(allowed.contains("sdk/" + room)) << entry.path();
        if (room == "include") continue;
        for (const auto& inner : fs::directory_iterator(entry.path())) {
            if (!inner.is_directory()) continue;
            EXPECT_TRUE(allowed_within.contains(room + "/" + inner.path().filename().string())) << inner.path();
        }
    }
}

}  // namespace
}  // namespace flg::test
