// SPDX-License-Identifier: MIT
// A value of a JSON file that knows where it stands: what is not as it should be is a Failure that names the place.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>

#include "io/base/failure.h"
#include "io/base/json.h"

namespace flg::io {

class JsonValue {
public:
    JsonValue(const Json& value, String place) : value_(&value), place_(std::move(place)) {}

    // Of objects: refuses all keys but these.
    void allow(std::initializer_list<const char*> keys) const;
    std::optional<JsonValue> find(const char* key) const;
    JsonValue at(const char* key) const;
    // Of lists.
    size_t size() const;
    JsonValue operator[](size_t index) const;

    bool is_list() const { return value_->is_array(); }
    String text() const;
    bool flag() const;
    // Finite, at most max_coordinate in size.
    float number() const;
    uint64_t count(uint64_t most) const;
    // One of these words: its place in the list.
    size_t word(std::span<const char* const> words) const;

    [[noreturn]] void refuse(const String& why) const { fail(FLG_ERROR_FORMAT, place_, "%s", why.c_str()); }

private:
    const Json* value_;
    String place_;
};

}  // namespace flg::io
