// SPDX-License-Identifier: MIT
// Values as JSON.
#pragma once

#include <string_view>

#include "core/origin.h"
#include "io/base/json.h"
#include "io/base/memory.h"

namespace flg::io {

// Of the character that the text begins with, in bytes; 0: it is no UTF-8.
size_t utf8_size(std::string_view text);

bool is_utf8(std::string_view text);

// Goes on with a list of values.
inline void separate(String& list) {
    if (!list.empty()) list += ',';
}

// In quotes, with what JSON escapes escaped; of UTF-8.
String json_text(std::string_view text);

// A float's shortest text as a double: readers get exactly the float.
String json_number(double value);
inline String json_number(float value) {
    return json_number(double{value});
}

// Any value: the same content, without spaces.
String json_text(const Json& value);

// `[x,y,z]`.
String json_triple(double x, double y, double z);

// `,"translation":[x,y,z]`, a glTF node's; empty for none.
String json_translation(const Origin& origin);

}  // namespace flg::io
