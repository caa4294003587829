// SPDX-License-Identifier: MIT
// The tags of an XML text, one after the other. Comments, processing instructions, declarations and text are passed over;
// entities are not replaced, so that no file can blow up.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace flg::io {

struct SvgTag {
    enum class Kind { open, close, empty };
    Kind kind;
    std::string_view name;  // without its namespace
    std::vector<std::pair<std::string_view, std::string_view>> attributes;
    uint64_t line;  // it begins on

    // "" if there is none.
    std::string_view attribute(std::string_view attribute_name) const;
};

class SvgTags {
public:
    explicit SvgTags(std::string_view text) : text_(text) {}
    // False at the end. Fails where a tag or a comment does not end, or an attribute has no value in quotes.
    bool next(SvgTag& tag);

private:
    bool skip_past(std::string_view begin, std::string_view end);
    void read_attributes(SvgTag& tag);
    void advance(size_t count);

    std::string_view text_;
    uint64_t line_ = 1;
};

}  // namespace flg::io
