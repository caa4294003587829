// SPDX-License-Identifier: MIT
// Runs a program of the project as a user would, and gives each test a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flg::test {

struct Outcome {
    int status;  // exit status; -1 if it crashed
    std::string out, err;
};

// Runs `program` with `arguments` in `folder` and waits for it.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& folder);

// An empty folder that is removed at the end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    void write(const std::string& name, const std::string& text) const;
    // Empty if there is no such file.
    std::string read(const std::string& name) const;
    bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }
    // Names of all files in it.
    std::vector<std::string> list() const;

private:
    std::filesystem::path path_;
};

}  // namespace flg::test
