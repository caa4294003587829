// SPDX-License-Identifier: MIT
#include "text_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "failure.h"

namespace flg::cli {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw InputError(path + ": can't be written: " + std::strerror(error));
}

}  // namespace

void write_text_file(const std::string& path, std::string_view text) {
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
    const std::filesystem::path target(path);
    std::filesystem::path folder = target.parent_path();
    if (folder.empty()) folder = ".";
    if (!std::filesystem::is_directory(folder)) fail(path, ENOENT);
    if (std::filesystem::is_directory(target)) fail(path, EISDIR);
    if (access(folder.c_str(), W_OK) != 0) fail(path, errno);
}

}  // namespace flg::cli
