// SPDX-License-Identifier: MIT
// Numbers as sentences show them: whole ones whole, others with as few digits as tell them from their neighbours (of
// floats if the number is one).
#pragma once

#include <charconv>
#include <cmath>

namespace flg {

class NumberText {
public:
    explicit NumberText(double value) {
        constexpr double whole_max = 1e15;
        char* end = text_ + sizeof text_ - 1;
        if (value == std::trunc(value) && std::abs(value) < whole_max) {
            end = std::to_chars(text_, end, value, std::chars_format::fixed).ptr;
        } else if (const auto narrow = static_cast<float>(value); double{narrow} == value) {
            end = std::to_chars(text_, end, narrow).ptr;
        } else {
            end = std::to_chars(text_, end, value).ptr;
        }
        *end = 0;
    }
    const char* c_str() const { return text_; }

private:
    char text_[32];
};

}  // namespace flg
