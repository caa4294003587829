// SPDX-License-Identifier: MIT
#include "io/base/json_value.h"

#include <algorithm>
#include <cmath>

namespace flg::io {

void JsonValue::allow(std::initializer_list<const char*> keys) const {
    if (!value_->is_object()) refuse("must be an object");
    for (const JsonMember& member : value_->members()) {
        if (std::find(keys.begin(), keys.end(), member.name) == keys.end())
            refuse("does not know " + cited(member.name));
    }
}

std::optional<JsonValue> JsonValue::find(const char* key) const {
    const Json* const found = value_->find(key);
    if (!found) return std::nullopt;
    return JsonValue(*found, place_.empty() ? key : place_ + "." + key);
}

JsonValue JsonValue::at(const char* key) const {
    const std::optional<JsonValue> found = find(key);
    if (!found) refuse(String("needs '") + key + "'");
    return *found;
}

size_t JsonValue::size() const {
    if (!value_->is_array()) refuse("must be a list");
    return value_->size();
}

JsonValue JsonValue::operator[](size_t index) const {
    return {(*value_)[index], place_ + "[" + to_text(index) + "]"};
}

String JsonValue::text() const {
    if (!value_->is_string()) refuse("must be a text");
    return String(value_->string());
}

bool JsonValue::flag() const {
    if (!value_->is_boolean()) refuse("must be true or false");
    return value_->boolean();
}

float JsonValue::number() const {
    const double value = value_->is_number() ? value_->number() : std::nan("");
    if (!(std::abs(value) <= double{max_coordinate})) refuse("must be a number of at most 1e30 in size");
    return static_cast<float>(value);
}

uint64_t JsonValue::count(uint64_t most) const {
    if (!value_->is_count() || value_->count() > most) {
        refuse("must be a whole number from 0 to " + to_text(most));
    }
    return value_->count();
}

size_t JsonValue::word(std::span<const char* const> words) const {
    const String text = this->text();
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<size_t>(found - words.begin());
    String list;
    for (const char* word : words) list += String(list.empty() ? "" : ", ") + word;
    refuse("is " + cited(text) + ", must be one of " + list);
}

}  // namespace flg::io
