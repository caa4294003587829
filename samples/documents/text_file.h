// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flg::cli {

// Writes the file whole or not at all (core/saved_file.h). Throws InputError.
void write_text_file(const std::string& path, std::string_view text);

// Throws InputError unless a file of this name could be written: found out before the work, not after it.
void require_writable(const std::string& path);

}  // namespace flg::cli
