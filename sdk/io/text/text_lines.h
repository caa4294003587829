// SPDX-License-Identifier: MIT
// Text formats: lines, and the numbers and words on them. Numbers do not depend on the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "io/base/failure.h"
#include "io/base/limits.h"
#include "io/base/memory.h"

namespace flg::io {

// Hands out a text's lines without their ends (LF or CR LF), and without a byte order mark.
class TextLines {
public:
    explicit TextLines(std::string_view text) : rest_(text) {
        if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    }
    bool next(std::string_view& line) {
        if (rest_.empty()) return false;
        ++number_;
        const void* end = std::memchr(rest_.data(), '\n', rest_.size());
        const size_t length = end ? static_cast<size_t>(static_cast<const char*>(end) - rest_.data()) : rest_.size();
        line = rest_.substr(0, length);
        rest_.remove_prefix(end ? length + 1 : length);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return true;
    }
    uint64_t number() const { return number_; }  // of the last line, from 1
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
    uint64_t number_ = 0;
};

// Walks over the words of one line.
class LineCursor {
public:
    LineCursor(std::string_view line, uint64_t number)
        : at_(line.data()), end_(line.data() + line.size()), number_(number) {}

    // Whether a word is left.
    bool more() {
        while (at_ != end_ && is_blank(*at_)) ++at_;
        return at_ != end_;
    }
    // The next word, "" at the end.
    std::string_view word() {
        if (!more()) return {};
        const char* start = at_;
        while (at_ != end_ && !is_blank(*at_)) ++at_;
        return {start, static_cast<size_t>(at_ - start)};
    }
    // All that is left, without blanks around it.
    std::string_view rest() {
        if (!more()) return {};
        const char* end = end_;
        while (is_blank(end[-1])) --end;
        return {at_, static_cast<size_t>(end - at_)};
    }
    char peek() const { return *at_; }

    // A position's coordinate or a radius: finite and at most 1e30 in size.
    float number(const char* what) {
        if (!more()) fail(FLG_ERROR_FORMAT, line_place(number_), "the %s is missing", what);
        const char* start = at_ + (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-' ? 1 : 0);
        float value = 0;
        auto [stop, error] = std::from_chars(start, end_, value);
        if (error == std::errc::result_out_of_range) value = beyond_float(start, stop);
        if (error == std::errc::invalid_argument || (stop != end_ && !is_blank(*stop))) {
            fail(FLG_ERROR_FORMAT, line_place(number_), "the %s is no number: %s", what, cited(word()).c_str());
        }
        if (!(std::abs(value) <= max_coordinate)) {
            fail(FLG_ERROR_FORMAT, line_place(number_), "the %s must be finite and at most 1e30 in size: %s", what,
                 cited(word()).c_str());
        }
        at_ = stop;
        return value;
    }

    // A coordinate relative to an origin's.
    float coordinate(const char* what, double origin) {
        LineCursor ahead = *this;
        const float as_given = number(what);
        if (origin == 0) return as_given;
        ahead.more();
        double value = 0;
        std::from_chars(*ahead.at_ == '+' ? ahead.at_ + 1 : ahead.at_, at_, value);
        return static_cast<float>(value - origin);
    }

    // A whole number of at most 32 bits, with or without sign.
    int64_t integer(const char* what) {
        if (!more()) fail(FLG_ERROR_FORMAT, line_place(number_), "the %s is missing", what);
        int64_t value = 0;
        const auto [stop, error] = std::from_chars(at_, end_, value);
        if (error == std::errc::invalid_argument || (stop != end_ && !is_blank(*stop))) {
            fail(FLG_ERROR_FORMAT, line_place(number_), "the %s is no whole number: %s", what, cited(word()).c_str());
        }
        if (error != std::errc{} || value < INT32_MIN || value > int64_t{UINT32_MAX}) {
            fail(FLG_ERROR_FORMAT, line_place(number_), "the %s has more than 32 bits: %s", what,
                 cited(word()).c_str());
        }
        at_ = stop;
        return value;
    }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t'; }

    // Values that float has no room for: too small becomes 0 (or a denormal), too large infinity.
    static float beyond_float(const char* start, const char* stop) {
        double value = 0;
        if (std::from_chars(start, stop, value).ec == std::errc{}) return static_cast<float>(value);
        // Beyond double too: the value is about 10 to the power of `magnitude`.
        int64_t magnitude = 0;
        bool fraction = false;
        bool leading_zeros = true;
        const char* at = start + (*start == '-' ? 1 : 0);
        for (; at != stop && *at != 'e' && *at != 'E'; ++at) {
            if (*at == '.') {
                fraction = true;
                continue;
            }
            leading_zeros &= *at == '0';
            if (!leading_zeros && !fraction) ++magnitude;
            if (leading_zeros && fraction) --magnitude;
        }
        int32_t exponent = 0;
        if (at != stop) ++at;
        if (at != stop && *at == '+') ++at;
        if (std::from_chars(at, stop, exponent).ec == std::errc::result_out_of_range) {
            return *at == '-' ? 0.0f : HUGE_VALF;
        }
        return magnitude + exponent > 0 ? HUGE_VALF : 0.0f;
    }

    const char* at_;
    const char* end_;
    uint64_t number_;
};

// Appends a number with 9 significant digits: enough to get the same float back.
inline void append_number(String& text, float value) {
    constexpr int digits = 9;
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
    text.append(buffer, end);
}

// A coordinate relative to an origin's, as one from 0: to the digit that gets the same double back.
inline void append_coordinate(String& text, float value, double origin) {
    if (origin == 0) {
        append_number(text, value);
        return;
    }
    char buffer[32];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, double{value} + origin).ptr);
}

// Numbers, each with a blank before it.
inline void append_numbers(String& text, const float* values, size_t count) {
    for (size_t i = 0; i < count; ++i) append_number(text += ' ', values[i]);
}

}  // namespace flg::io
