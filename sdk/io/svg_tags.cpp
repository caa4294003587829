// SPDX-License-Identifier: MIT
#include "io/svg_tags.h"

#include <algorithm>

#include "io/failure.h"

namespace flg::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view without_namespace(std::string_view name) {
    const size_t colon = name.rfind(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

}  // namespace

std::string_view SvgTag::attribute(std::string_view attribute_name) const {
    for (const auto& [key, value] : attributes) {
        if (key == attribute_name) return value;
    }
    return {};
}

void SvgTags::advance(size_t count) {
    line_ += static_cast<uint64_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
    text_.remove_prefix(count);
}

// Passes over what begins and ends so, if that comes next.
bool SvgTags::skip_past(std::string_view begin, std::string_view end) {
    if (!text_.starts_with(begin)) return false;
    const size_t found = text_.find(end, begin.size());
    if (found == text_.npos) fail(FLG_ERROR_FORMAT, line_place(line_), "%s does not end", cited(begin).c_str());
    advance(found + end.size());
    return true;
}

bool SvgTags::next(SvgTag& tag) {
    for (;;) {
        const size_t begin = text_.find('<');
        if (begin == text_.npos) return false;
        advance(begin);
        if (!skip_past("<!--", "-->") && !skip_past("<![CDATA[", "]]>") && !skip_past("<?", "?>") &&
            !skip_past("<!", ">")) {
            break;
        }
    }
    tag = {SvgTag::Kind::open, {}, {}, line_};
    advance(1);
    if (text_.starts_with('/')) {
        tag.kind = SvgTag::Kind::close;
        advance(1);
    }
    const size_t length = std::min(text_.find_first_of(" \t\r\n/>"), text_.size());
    tag.name = without_namespace(text_.substr(0, length));
    advance(length);
    read_attributes(tag);
    return true;
}

void SvgTags::read_attributes(SvgTag& tag) {
    for (;;) {
        advance(std::min(text_.find_first_not_of(blanks), text_.size()));
        if (text_.starts_with('>')) {
            advance(1);
            return;
        }
        if (text_.starts_with("/>") && tag.kind == SvgTag::Kind::open) {
            tag.kind = SvgTag::Kind::empty;
            advance(2);
            return;
        }
        const size_t equals = text_.find_first_of("=<>");
        if (equals == text_.npos || text_[equals] != '=') {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the tag %s does not end, or an attribute has no value",
                 cited(tag.name).c_str());
        }
        std::string_view name = text_.substr(0, equals);
        name = name.substr(0, name.find_first_of(blanks));
        advance(equals + 1);
        advance(std::min(text_.find_first_not_of(blanks), text_.size()));
        const char quote = text_.empty() ? '\0' : text_[0];
        const size_t end = quote == '"' || quote == '\'' ? text_.find(quote, 1) : text_.npos;
        if (end == text_.npos) {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the attribute %s has no value in quotes",
                 cited(name).c_str());
        }
        tag.attributes.emplace_back(name, text_.substr(1, end - 1));
        advance(end + 1);
    }
}

}  // namespace flg::io
