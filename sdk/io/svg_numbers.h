// SPDX-License-Identifier: MIT
// Numbers and words in the attributes of SVG, where `1-2.5.5` are three numbers.
#pragma once

#include <charconv>
#include <cmath>
#include <string_view>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

class SvgNumbers {
public:
    SvgNumbers(std::string_view text, uint64_t line) : text_(text), line_(line) {}

    // Past blanks and commas: whether anything is left, and whether that is a number.
    bool more() {
        while (!text_.empty() && (text_[0] == ',' || is_blank(text_[0]))) text_.remove_prefix(1);
        return !text_.empty();
    }
    bool at_number() {
        if (!more()) return false;
        const char c = text_[0];
        return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    }
    // Finite and at most 1e30 in size; otherwise it fails.
    double number() {
        if (!at_number()) refuse();
        std::string_view rest = text_.substr(text_[0] == '+' ? 1 : 0);
        const std::string_view digits = rest.substr(rest.starts_with('-') ? 1 : 0);
        double value = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        const bool begins = !digits.empty() && (digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9'));
        if (error != std::errc() || !begins || !(std::abs(value) <= double{max_coordinate})) refuse();
        text_.remove_prefix(static_cast<size_t>(end - text_.data()));
        return value;
    }
    // 0 or 1, which the next number may follow at once.
    bool flag() {
        if (!more() || (text_[0] != '0' && text_[0] != '1')) refuse();
        const bool set = text_[0] == '1';
        text_.remove_prefix(1);
        return set;
    }
    char take() {
        const char c = text_[0];
        text_.remove_prefix(1);
        return c;
    }
    std::string_view rest() const { return text_; }
    void skip(size_t count) { text_.remove_prefix(count); }
    [[noreturn]] void refuse() const {
        fail(FLG_ERROR_FORMAT, line_place(line_), "no number, or one beyond 1e30: %s", cited(text_).c_str());
    }
    uint64_t line() const { return line_; }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

    std::string_view text_;
    uint64_t line_;
};

}  // namespace flg::io
