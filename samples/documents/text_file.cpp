// SPDX-License-Identifier: MIT
#include "documents/text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "documents/failure.h"

namespace flg::cli {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw InputError(path + ": can't be written: " + std::strerror(error));
}

// Where a file of this name is: renaming over a symbolic link would replace the link.
std::string followed(const std::string& name) {
    constexpr int kMaxLinks = 40;  // as the kernel has it
    std::filesystem::path path(name);
    for (int i = 0; i < kMaxLinks; ++i) {
        if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path))) return path.string();
        path = path.parent_path() / std::filesystem::read_symlink(path);
    }
    fail(name, ELOOP);
}

}  // namespace

void write_text_file(const std::string& name, std::string_view text) {
    const std::string path = followed(name);
    const std::string temporary = path + ".part";
    {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.flush();
        if (!file) {
            const int error = errno;
            std::remove(temporary.c_str());
            fail(path, error);
        }
    }
    if (std::rename(temporary.c_str(), path.c_str()) != 0) {
        const int error = errno;
        std::remove(temporary.c_str());
        fail(path, error);
    }
}

void require_writable(const std::string& path) {
    if (path.empty()) return;
    const std::filesystem::path target(followed(path));
    std::filesystem::path folder = target.parent_path();
    if (folder.empty()) folder = ".";
    if (!std::filesystem::is_directory(folder)) fail(path, ENOENT);
    if (std::filesystem::is_directory(target)) fail(path, EISDIR);
    if (access(folder.c_str(), W_OK) != 0) fail(path, errno);
}

}  // namespace flg::cli
