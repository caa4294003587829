// SPDX-License-Identifier: MIT
// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace flg::io {

// Writes a temporary file beside `name`, or beside what it links to, and renames it; on failure nothing is left behind
// and all is as it was. Refuses more than max_bytes.
void write_file(const std::filesystem::path& name, std::string_view content);

}  // namespace flg::io
