// SPDX-License-Identifier: MIT
// Source: Wavefront's OBJ specification. What readers of lines and of faces share: statements, and indices of vertices.
#pragma once

#include <string>
#include <string_view>

#include "io/text_lines.h"

namespace flg::io {

// Hands out statements: lines, joined where a backslash continues them.
class ObjStatements {
public:
    explicit ObjStatements(std::string_view text) : lines_(text) {}

    // Lives until the next call.
    bool next(std::string_view& statement) {
        if (!lines_.next(statement)) return false;
        line_ = lines_.number();
        if (!statement.ends_with('\\')) return true;
        joined_.clear();
        do {
            joined_.append(statement.substr(0, statement.size() - 1)) += ' ';
        } while (lines_.next(statement) && statement.ends_with('\\'));
        if (!statement.ends_with('\\')) joined_.append(statement);
        statement = joined_;
        return true;
    }
    uint64_t line() const { return line_; }  // of the statement's first line, from 1
    uint64_t last_line() const { return lines_.number(); }

private:
    TextLines lines_;
    std::string joined_;
    uint64_t line_ = 0;
};

// The vertex of `v`, `v/vt`, `v//vn` or `v/vt/vn`, from 0, by the number of vertices so far; whether it exists is seen
// at the end of the file.
inline uint32_t read_obj_index(std::string_view word, uint64_t vertex_count, uint64_t line) {
    const int64_t count = static_cast<int64_t>(vertex_count);
    int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = stop == word.data() + word.size() || *stop == '/';
    if (error == std::errc::invalid_argument || !whole) {
        fail(FLG_ERROR_FORMAT, line_place(line), "no vertex index: %s", cited(word).c_str());
    }
    const int64_t index = value < 0 ? count + value : value - 1;
    if (error != std::errc{} || index < 0 || index >= static_cast<int64_t>(max_points)) {
        fail(FLG_ERROR_FORMAT, line_place(line), "the vertex index %s is out of range: %lld vertices so far",
             cited(word).c_str(), static_cast<long long>(count));
    }
    return static_cast<uint32_t>(index);
}

}  // namespace flg::io
