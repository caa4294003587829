// SPDX-License-Identifier: MIT
#include "io/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

namespace {

constexpr int most_tries = 1000;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail_writing(int error) {
    fail(FLG_ERROR_FILE, "", "can't be written: %s", std::generic_category().message(error).c_str());
}

// Where a file of this name is: renaming over a symbolic link would replace the link.
std::filesystem::path followed(std::filesystem::path path) {
    constexpr int most_links = 40;  // as the kernel has it
    for (int i = 0; i < most_links; ++i) {
        if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path))) return path;
        path = path.parent_path() / std::filesystem::read_symlink(path);
    }
    fail_writing(ELOOP);
}

// A new file beside `path`; the names of files that exist, also of other programs writing now, are passed over.
File open_beside(const std::filesystem::path& path, std::filesystem::path& temporary) {
    for (int i = 0; i < most_tries; ++i) {
        temporary = path;
        temporary += ".tmp" + std::to_string(i);
        if (std::FILE* file = std::fopen(temporary.string().c_str(), "wbx")) return File(file, std::fclose);
        if (errno != EEXIST) break;
    }
    fail_writing(errno);
}

}  // namespace

void write_file(const std::filesystem::path& name, std::string_view content) {
    if (content.size() > max_bytes) {
        fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", content.size());
    }
    const std::filesystem::path path = followed(name);
    if (std::filesystem::is_directory(path)) fail_writing(EISDIR);
    std::filesystem::path temporary;
    File file = open_beside(path, temporary);
    int error = 0;
    if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size()) error = errno;
    if (std::fclose(file.release()) != 0 && error == 0) error = errno;
    std::error_code renamed;
    if (error == 0) std::filesystem::rename(temporary, path, renamed);
    if (error == 0 && renamed) error = renamed.value();
    if (error != 0) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        fail_writing(error);
    }
}

}  // namespace flg::io
