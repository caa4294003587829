// SPDX-License-Identifier: MIT
#include "field_file.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "documents/failure.h"
#include "documents/text_lines.h"

namespace flg::cli {

std::vector<float> read_field_file(const std::string& name) {
    std::ifstream file(name);
    if (!file) throw InputError(name + ": can't be read: " + std::strerror(errno));
    std::vector<float> values;
    for (std::string line; next_line(file, line);) {
        float value = 0.0f;
        const char* end = line.data() + line.size();
        const auto [stop, error] = std::from_chars(line.data(), end, value);
        if (error != std::errc() || stop != end || std::isnan(value)) {
            throw InputError(name + ":" + std::to_string(values.size() + 1) + ": " + quoted_line(line) +
                             " is not a number; one a line is wanted, inf where there is none");
        }
        values.push_back(value);
    }
    if (file.bad()) throw InputError(name + ": can't be read: " + std::strerror(errno));
    return values;
}

}  // namespace flg::cli
