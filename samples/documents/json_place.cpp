// SPDX-License-Identifier: MIT
#include "documents/json_place.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "documents/failure.h"
#include "documents/text_lines.h"

namespace flg::cli {

namespace {

// What the parser says, without its number of the error, and with no more of the file than fits a sentence.
std::string sentence_of(std::string what) {
    if (const size_t number = what.find("] "); what.starts_with("[json.") && number != what.npos)
        what = "is no JSON: " + what.substr(number + 2);
    constexpr std::string_view before = "last read: '", after = "'; expected";
    const size_t begin = what.find(before);
    if (begin == what.npos) return what;
    const size_t token = begin + before.size(), end = what.rfind(after);
    const bool has_end = end != what.npos && end >= token;
    const std::string rest = has_end ? what.substr(end + 1) : "";
    return what.substr(0, token - 1) + quoted_line(what.substr(token, has_end ? end - token : what.npos)) + rest;
}

}  // namespace

nlohmann::json JsonPlace::read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError(file + ": can't be opened");
    try {
        return nlohmann::json::parse(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file + ": " + sentence_of(error.what()));
    }
}

void JsonPlace::fail(const std::string& what) const {
    throw InputError(path_ + ": " + what);
}

void JsonPlace::allow(std::initializer_list<const char*> keys) const {
    if (!value_->is_object()) fail("must be an object");
    for (const auto& [key, value] : value_->items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) fail("does not know `" + shortened(key) + "`");
    }
}

std::optional<JsonPlace> JsonPlace::find(const char* key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) return std::nullopt;
    return JsonPlace(*found, path_ + "." + key);
}

JsonPlace JsonPlace::at(const char* key) const {
    const std::optional<JsonPlace> found = find(key);
    if (!found) fail(std::string("needs `") + key + "`");
    return *found;
}

std::vector<JsonPlace> JsonPlace::items() const {
    if (!value_->is_array()) fail("must be a list");
    std::vector<JsonPlace> items;
    for (const nlohmann::json& item : *value_) {
        items.emplace_back(item, path_ + "[" + std::to_string(items.size()) + "]");
    }
    return items;
}

std::string JsonPlace::text() const {
    if (!value_->is_string()) fail("must be a text");
    return value_->get<std::string>();
}

bool JsonPlace::flag() const {
    if (!value_->is_boolean()) fail("must be true or false");
    return value_->get<bool>();
}

float JsonPlace::number(double least, double most) const {
    return static_cast<float>(real(least, most));
}

double JsonPlace::real(double least, double most) const {
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(value >= least && value <= most)) {
        fail("must be a number from " + nlohmann::json(least).dump() + " to " + nlohmann::json(most).dump());
    }
    return value;
}

uint32_t JsonPlace::count(uint32_t least, uint32_t most) const {
    const bool fits =
        value_->is_number_unsigned() && value_->get<uint64_t>() >= least && value_->get<uint64_t>() <= most;
    if (!fits) fail("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return value_->get<uint32_t>();
}

size_t JsonPlace::word(std::span<const char* const> words) const {
    const std::string text = this->text();
    const auto found = std::find(words.begin(), words.end(), text);
    if (found != words.end()) return static_cast<size_t>(found - words.begin());
    std::string list;
    for (const char* word : words) list += std::string(list.empty() ? "" : ", ") + word;
    fail("is `" + shortened(text) + "`, must be one of " + list);
}

}  // namespace flg::cli
