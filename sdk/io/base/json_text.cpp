// SPDX-License-Identifier: MIT
#include "io/base/json_text.h"

#include <charconv>
#include <cstdio>

namespace flg::io {

size_t utf8_size(std::string_view text) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4) return 0;
    for (size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
    }
    // Neither longer than needed, nor half of a pair, nor beyond the last character.
    const bool sound = !(first == 0xe0 && byte(1) < 0xa0) && !(first == 0xed && byte(1) >= 0xa0) &&
                       !(first == 0xf0 && byte(1) < 0x90) && !(first == 0xf4 && byte(1) >= 0x90);
    return sound ? size : 0;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const size_t size = utf8_size(text);
        if (size == 0) return false;
        text.remove_prefix(size);
    }
    return true;
}

String json_text(std::string_view text) {
    constexpr std::string_view names = "\"\\bfnrt", values = "\"\\\b\f\n\r\t";
    String result = "\"";
    for (const char c : text) {
        if (const size_t known = values.find(c); known != values.npos) {
            result += '\\';
            result += names[known];
        } else if (static_cast<unsigned char>(c) < ' ') {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", c);
            result += escape;
        } else {
            result += c;
        }
    }
    return result + '"';
}

String json_number(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

String json_triple(double x, double y, double z) {
    String text = "[";
    text += json_number(x);
    text += ',';
    text += json_number(y);
    text += ',';
    text += json_number(z);
    text += ']';
    return text;
}

String json_translation(const Origin& origin) {
    if (origin == Origin{}) return "";
    return ",\"translation\":" + json_triple(origin[0], origin[1], origin[2]);
}

String json_text(const Json& value) {
    if (value.is_string()) return json_text(value.string());
    if (value.is_count()) return to_text(value.count());
    if (value.is_number()) return json_number(value.number());
    if (value.is_boolean()) return value.boolean() ? "true" : "false";
    String text;
    if (value.is_array()) {
        for (size_t i = 0; i < value.size(); ++i) {
            separate(text);
            text += json_text(value[i]);
        }
        return "[" + text + "]";
    }
    if (!value.is_object()) return "null";
    for (const JsonMember& member : value.members()) {
        separate(text);
        text += json_text(member.name) + ":" + json_text(member.value);
    }
    return "{" + text + "}";
}

}  // namespace flg::io
