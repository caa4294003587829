// SPDX-License-Identifier: MIT
// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace flg::io {

// Writes a temporary file beside `path` and renames it; on failure nothing is left behind and `path` is as it was.
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace flg::io
