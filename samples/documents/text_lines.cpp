// SPDX-License-Identifier: MIT
#include "documents/text_lines.h"

namespace flg::cli {

bool next_line(std::istream& file, std::string& line) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    const bool is_first = file.tellg() == std::istream::pos_type(0);
    if (!std::getline(file, line)) return false;
    if (is_first && line.starts_with(mark)) line.erase(0, mark.size());
    if (line.ends_with('\r')) line.pop_back();
    return true;
}

std::string quoted_line(std::string_view line) {
    return "'" + shortened(line) + "'";
}

std::string shortened(std::string_view text) {
    constexpr size_t longest = 80;
    std::string shown;
    for (const char c : text.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
    return shown + (text.size() > longest ? "..." : "");
}

}  // namespace flg::cli
