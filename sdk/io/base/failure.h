// SPDX-License-Identifier: MIT
// How reading or writing says that it can't go on: a Failure with a place and a reason, to which the ABI adds the name
// of the file. All of this room is in flg::io, because a program may link it together with the rest of the SDK.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "core/failure.h"
#include "io/base/memory.h"

namespace flg::io {

class Failure : public flg::Failure {
public:
    // An empty `place` means the file as a whole.
    Failure(FlgResult result, String place, const char* reason)
        : flg::Failure(result, "%s", reason), place_(std::move(place)) {}
    const String& place() const { return place_; }

private:
    String place_;
};

// Throws a Failure; `format` and what follows as for printf.
[[noreturn, gnu::format(printf, 3, 4)]] inline void fail(FlgResult result, String place, const char* format, ...) {
    char reason[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(reason, sizeof reason, format, arguments);
    va_end(arguments);
    throw Failure(result, std::move(place), reason);
}

// No place for line 0, of a file without lines.
inline String line_place(uint64_t line) {
    return line == 0 ? String() : to_text(line);
}

inline String byte_place(std::string_view part, uint64_t offset) {
    String place(part);
    place += '@';
    return place += to_text(offset);
}

// A piece of a file fit for a sentence: in quotes, cut short, with nothing unprintable in it.
inline String cited(std::string_view text) {
    constexpr size_t longest = 40;
    String result = "'";
    for (char c : text.substr(0, longest)) result += (c >= ' ' && c <= '~') ? c : '?';
    return result + (text.size() > longest ? "...'" : "'");
}

}  // namespace flg::io
