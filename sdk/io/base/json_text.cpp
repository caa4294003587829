// SPDX-License-Identifier: MIT
#include "io/base/json_text.h"

#include <charconv>
#include <nlohmann/json.hpp>

namespace flg::io {

bool is_utf8(std::string_view text) {
    try {
        json_text(text);
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

std::string json_text(std::string_view text) {
    return nlohmann::json(text).dump();
}

std::string json_number(float value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, double{value}).ptr};
}

}  // namespace flg::io
