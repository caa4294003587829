// SPDX-License-Identifier: MIT
#include "io/base/files.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "io/base/failure.h"

namespace flg::io {

ByteBlock read_file(const std::filesystem::path& path, const std::string& place, uint64_t limit) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        fail(FLG_ERROR_FILE, place, "can't be opened: %s", error ? error.message().c_str() : "No such file");
    }
    // Pipes and devices have no size to check before reading, and may never end.
    if (!std::filesystem::is_regular_file(status)) fail(FLG_ERROR_FILE, place, "is not a regular file");
    const uint64_t size = std::filesystem::file_size(path, error);
    if (error) fail(FLG_ERROR_FILE, place, "can't be read: %s", error.message().c_str());
    if (size > limit) {
        fail(FLG_ERROR_LIMIT, place, "has %llu bytes, more than the limit of %s", static_cast<unsigned long long>(size),
             size_text(limit).c_str());
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        fail(FLG_ERROR_FILE, place, "can't be opened: %s", std::generic_category().message(errno).c_str());
    }
    ByteBlock block(size);
    file.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(size));
    if (static_cast<uint64_t>(file.gcount()) != size) {
        fail(FLG_ERROR_FILE, place, "can't be read: %lld of %llu bytes came", static_cast<long long>(file.gcount()),
             static_cast<unsigned long long>(size));
    }
    return block;
}

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
