// SPDX-License-Identifier: MIT
// What the SDK includes from elsewhere is listed in sdk/docs/dependencies.md with a licence that asks nothing of a
// closed host.
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

// Those a closed host can live with; the MPL because it ends at the files it is in.
const std::set<std::string> permissive = {"MIT", "BSD-3-Clause", "Zlib", "Apache-2.0", "MPL-2.0"};

// Header -> licence, of the table under this heading.
std::map<std::string, std::string> listed(const std::string& heading) {
    std::ifstream file(fs::path(FLG_SOURCE_DIR) / "sdk/docs/dependencies.md");
    std::map<std::string, std::string> licences;
    bool inside = false;
    const std::regex row("^\\| (`.*`) \\| [^|]* \\| ([^|]*) \\|.*"), header("`([^`]+)`");
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("## ")) inside = line == "## " + heading;
        if (!inside || !std::regex_match(line, match, row)) continue;
        const std::string headers = match[1], licence = match[2];
        for (std::sregex_iterator it(headers.begin(), headers.end(), header), end; it != end; ++it)
            licences[(*it)[1]] = licence;
    }
    return licences;
}

// Headers that the sources of a folder take from elsewhere, but for those of the system: those of C++ have no folder
// and no `.h`.
std::set<std::string> foreign_headers(const std::string& folder) {
    const std::set<std::string> of_system = {"dirent.h",   "fcntl.h",    "io.h",       "stddef.h", "stdint.h",
                                             "sys/file.h", "sys/mman.h", "sys/stat.h", "unistd.h", "windows.h"};
    const std::regex include("^\\s*#include <([^>]+)>");
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FLG_SOURCE_DIR) / folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".hpp" && extension != ".cpp" && extension != ".inl") continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);) {
            if (!std::regex_search(line, match, include)) continue;
            const std::string header = match[1];
            const bool is_foreign = header.find_first_of("./") != std::string::npos;
            if (is_foreign && !of_system.contains(header)) found.insert(header);
        }
    }
    return found;
}

TEST(Dependencies, OfTheSdkAreListedAndPermissive) {
    std::set<std::string> names;
    for (const auto& [header, licence] : listed("In the SDK")) {
        names.insert(header);
        EXPECT_TRUE(permissive.contains(licence)) << header << ": " << licence;
    }
    EXPECT_EQ(foreign_headers("sdk"), names);
}

TEST(Dependencies, BesideItAreListed) {
    const std::map<std::string, std::string> beside = listed("Beside it");
    const std::set<std::string> of_the_system = {"fcntl.h", "signal.h", "unistd.h", "elf.h",
                                                 "time.h",  "math.h",   "stdio.h",  "stdlib.h"};
    for (const char* folder : {"renderer", "samples", "tools"}) {
        for (const std::string& header : foreign_headers(folder)) {
            const bool ours = header.starts_with("filigree/"), is_of_sdk = listed("In the SDK").contains(header);
            if (ours || is_of_sdk || of_the_system.contains(header)) continue;
            bool found = false;
            for (const auto& [prefix, licence] : beside) found = found || header.starts_with(prefix);
            EXPECT_TRUE(found) << folder << " includes " << header;
        }
    }
}

// The one that spreads stays where it is.
TEST(Dependencies, TheGplIsInOneBenchmarkAlone) {
    EXPECT_EQ(listed("Beside it").at("CGAL/"), "GPL-3.0-or-later");
    for (const char* folder : {"sdk", "renderer", "samples", "tools/filigree"}) {
        for (const std::string& header : foreign_headers(folder)) EXPECT_FALSE(header.starts_with("CGAL/")) << folder;
    }
}

}  // namespace
}  // namespace flg::test
