// SPDX-License-Identifier: MIT
#include "io/base/json_value.h"

#include <algorithm>
#include <cmath>

namespace flg::io {

JsonValue::Json JsonValue::parse(Bytes text, int most_levels) {
    const auto check_depth = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > most_levels) fail(FLG_ERROR_LIMIT, "", "its JSON nests deeper than %d levels", most_levels);
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), check_depth);
    } catch (const Json::parse_error& error) {
        fail(FLG_ERROR_FORMAT, byte_place("", error.byte), "is no JSON");
    } catch (const Json::exception& error) {
        fail(FLG_ERROR_FORMAT, "", "is no JSON: %s", error.what());
    }
}

void JsonValue::allow(std::initializer_list<const char*> keys) const {
    if (!value_->is_object()) refuse("must be an object");
    for (const auto& [key, value] : value_->items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse("does not know " + cited(key));
    }
}

std::optional<JsonValue> JsonValue::find(const char* key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonValue(*found, place_.empty() ? key : place_ + "." + key);
}

JsonValue JsonValue::at(const char* key) const {
    const std::optional<JsonValue> found = find(key);
    if (!found) refuse(std::string("needs '") + key + "'");
    return *found;
}

size_t JsonValue::size() const {
    if (!value_->is_array()) refuse("must be a list");
    return value_->size();
}

JsonValue JsonValue::operator[](size_t index) const {
    return {(*value_)[index], place_ + "[" + std::to_string(index) + "]"};
}

std::string JsonValue::text() const {
    if (!value_->is_string()) refuse("must be a text");
    return value_->get<std::string>();
}

bool JsonValue::flag() const {
    if (!value_->is_boolean()) refuse("must be true or false");
    return value_->get<bool>();
}

float JsonValue::number() const {
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(std::abs(value) <= double{max_coordinate})) refuse("must be a number of at most 1e30 in size");
    return static_cast<float>(value);
}

uint64_t JsonValue::count(uint64_t most) const {
    if (!value_->is_number_unsigned() || value_->get<uint64_t>() > most) {
        refuse("must be a whole number from 0 to " + std::to_string(most));
    }
    return value_->get<uint64_t>();
}

size_t JsonValue::word(std::span<const char* const> words) const {
    const std::string text = this->text();
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<size_t>(found - words.begin());
    std::string list;
    for (const char* word : words) list += std::string(list.empty() ? "" : ", ") + word;
    refuse("is " + cited(text) + ", must be one of " + list);
}

}  // namespace flg::io
