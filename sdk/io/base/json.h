// SPDX-License-Identifier: MIT
// JSON, parsed: values in an arena that goes back at once, whatever they nest.
//
// Written here: nlohmann-json, like all parsers at hand, takes memory for its lexer and for the destruction of nested
// values past any allocator, and ends the process where there is none.
#pragma once

#include <memory_resource>
#include <span>
#include <string_view>

#include "io/base/files.h"

namespace flg::io {

struct JsonMember;

// A value; its document must outlive it.
class Json {
public:
    Json() = default;

    bool is_boolean() const { return type_ == Type::boolean; }
    bool is_number() const { return type_ == Type::count || type_ == Type::number; }
    // Written without a sign, a point and an exponent, below 2^64.
    bool is_count() const { return type_ == Type::count; }
    bool is_string() const { return type_ == Type::string; }
    bool is_array() const { return type_ == Type::array; }
    bool is_object() const { return type_ == Type::object; }

    bool boolean() const { return value_.count != 0; }
    uint64_t count() const { return value_.count; }
    double number() const { return is_count() ? static_cast<double>(value_.count) : value_.number; }
    std::string_view string() const { return {value_.string, size_}; }
    std::string_view string_or(std::string_view otherwise) const { return is_string() ? string() : otherwise; }

    // Of arrays; 0 for others.
    size_t size() const { return is_array() ? size_ : 0; }
    const Json& operator[](size_t index) const { return value_.items[index]; }
    // Of objects: by name, each once; none for others.
    std::span<const JsonMember> members() const;
    // A member; null if there is none, and for what is no object.
    const Json* find(std::string_view name) const;

    bool operator==(std::string_view text) const { return is_string() && string() == text; }
    bool operator==(const Json& other) const;

private:
    friend class JsonParser;
    enum class Type : uint8_t { null, boolean, count, number, string, array, object };

    union Value {
        uint64_t count = 0;
        double number;
        const char* string;
        const Json* items;
        const JsonMember* members;
    } value_;
    uint32_t size_ = 0;
    Type type_ = Type::null;
};

struct JsonMember {
    std::string_view name;
    Json value;
};

class JsonDocument {
public:
    // Refuses what is no JSON, and what nests deeper than `max_levels`. Of several members of one name the last
    // counts. `part`: what failures name before the place. With `only`, the root's other members are checked and passed
    // over.
    JsonDocument(Bytes text, uint32_t max_levels, std::string_view part = {}, std::string_view only = {});

    const Json& root() const { return root_; }

private:
    CurrentMemory memory_;
    std::pmr::monotonic_buffer_resource arena_{&memory_};
    Json root_;
};

}  // namespace flg::io
