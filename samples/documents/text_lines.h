// SPDX-License-Identifier: MIT
// Lines of text files, as all readers here take them.
#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace flg::cli {

// The next line without its end (LF or CR LF), the first without a byte order mark; false at the end.
bool next_line(std::istream& file, std::string& line);

// A line fit for a sentence: in quotes, at most 80 characters of it, with nothing unprintable.
std::string quoted_line(std::string_view line);
// The same without quotes.
std::string shortened(std::string_view text);

}  // namespace flg::cli
