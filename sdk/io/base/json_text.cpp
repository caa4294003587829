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

std::string json_number(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string json_triple(double x, double y, double z) {
    std::string text = "[";
    text += json_number(x);
    text += ',';
    text += json_number(y);
    text += ',';
    text += json_number(z);
    text += ']';
    return text;
}

std::string json_translation(const Origin& origin) {
    if (origin == Origin{}) return "";
    return ",\"translation\":" + json_triple(origin[0], origin[1], origin[2]);
}

}  // namespace flg::io
