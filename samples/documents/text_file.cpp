// SPDX-License-Identifier: MIT
#include "documents/text_file.h"

#include <filesystem>
#include <system_error>

#include "core/saved_file.h"
#include "documents/failure.h"

namespace flg::cli {
namespace {

[[noreturn]] void fail(const std::string& path, const std::error_code& error) {
    throw InputError(path + ": can't be written: " + error.message());
}

}  // namespace

void write_text_file(const std::string& path, std::string_view text) {
    try {
        SavedFile file(path);
        file.write(text);
        file.save();
    } catch (const std::system_error& error) {
        fail(path, error.code());
    }
}

void require_writable(const std::string& path) {
    if (path.empty()) return;
    std::error_code ignored;
    const std::filesystem::file_status there = std::filesystem::status(path, ignored);
    if (std::filesystem::is_other(there) || std::filesystem::is_fifo(there)) return;  // opening them is writing
    try {
        SavedFile file(path);  // never saved
    } catch (const std::system_error& error) {
        fail(path, error.code());
    }
}

}  // namespace flg::cli
