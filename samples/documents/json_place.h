// SPDX-License-Identifier: MIT
// A value in a JSON file that knows where it stands, so that errors can say it.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flg::cli {

// All functions throw InputError `FILE: a.b[2]: what is wrong`.
class JsonPlace {
public:
    // Reads a file.
    static nlohmann::json read(const std::string& file);

    JsonPlace(const nlohmann::json& value, std::string path) : value_(&value), path_(std::move(path)) {}

    // For objects: refuses all keys but these.
    void allow(std::initializer_list<const char*> keys) const;
    std::optional<JsonPlace> find(const char* key) const;
    JsonPlace at(const char* key) const;
    // For arrays.
    std::vector<JsonPlace> items() const;

    bool is_string() const { return value_->is_string(); }
    bool is_null() const { return value_->is_null(); }
    bool is_array() const { return value_->is_array(); }
    std::string text() const;
    bool flag() const;
    float number(double least, double most) const;
    double real(double least, double most) const;  // the same with all its digits
    uint32_t count(uint32_t least, uint32_t most) const;
    // One of these words: its place in the list.
    size_t word(std::span<const char* const> words) const;
    size_t word(std::initializer_list<const char*> words) const { return word({words.begin(), words.size()}); }

    [[noreturn]] void fail(const std::string& what) const;
    const std::string& path() const { return path_; }

private:
    const nlohmann::json* value_;
    std::string path_;
};

}  // namespace flg::cli
