// SPDX-License-Identifier: MIT
#include "io/file_bytes.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "io/failure.h"
#include "io/limits.h"

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

}  // namespace flg::io
