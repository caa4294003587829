// SPDX-License-Identifier: MIT
// Source: Turk, The PLY Polygon File Format (1994), with the sized type names that later writers use.
// Invariants: names are printable, those of elements unique, those of properties within their element; lists are counted
// by integers. At most most_entries elements, and properties of each.
#include "io/ply_header.h"

#include <algorithm>
#include <array>

namespace flg::io {

namespace {

struct TypeName {
    std::string_view name, sized_name;
    PlyType type;
};
constexpr TypeName type_names[] = {
    {"char", "int8", PlyType::int8},        {"uchar", "uint8", PlyType::uint8},
    {"short", "int16", PlyType::int16},     {"ushort", "uint16", PlyType::uint16},
    {"int", "int32", PlyType::int32},       {"uint", "uint32", PlyType::uint32},
    {"float", "float32", PlyType::float32}, {"double", "float64", PlyType::float64},
};

constexpr size_t most_entries = 256;

class HeaderReader {
public:
    explicit HeaderReader(TextLines& lines) : lines_(lines) {}

    PlyHeader read() {
        if (next_keyword() != "ply") refuse("no PLY file: its first word is not 'ply'", keyword_);
        if (next_keyword() != "format") refuse("`format` must come second", keyword_);
        read_format();
        while (next_keyword() != "end_header") {
            if (keyword_ == "element")
                read_element();
            else if (keyword_ == "property")
                read_property();
            else
                refuse("no keyword of a PLY header", keyword_);
        }
        return std::move(header_);
    }

private:
    std::string place() const { return line_place(lines_.number()); }

    [[noreturn]] void refuse(const char* reason, std::string_view word) const {
        fail(FLG_ERROR_FORMAT, place(), "%s: %s", reason, cited(word).c_str());
    }

    // Of the next line that says something.
    std::string_view next_keyword() {
        do {
            std::string_view line;
            if (!lines_.next(line)) fail(FLG_ERROR_FORMAT, place(), "ends within the header: no end_header");
            cursor_ = LineCursor(line, lines_.number());
            keyword_ = cursor_.word();
        } while (keyword_.empty() || keyword_ == "comment" || keyword_ == "obj_info");
        return keyword_;
    }

    void read_format() {
        const std::string_view encoding = cursor_.word();
        if (encoding == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (encoding == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (encoding == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            refuse("no format of a PLY file", encoding);
        const std::string_view version = cursor_.word();
        if (version != "1.0") refuse("only the version 1.0 is known", version);
    }

    std::string read_name(size_t entries) {
        const std::string_view name = cursor_.word();
        const bool printable = std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; });
        if (name.empty() || !printable) refuse("no name", name);
        if (entries == most_entries) {
            fail(FLG_ERROR_LIMIT, place(), "more than %zu elements, or properties of one", most_entries);
        }
        return std::string(name);
    }

    void read_element() {
        PlyElement element;
        element.name = read_name(header_.elements.size());
        element.line = lines_.number();
        const std::string_view count = cursor_.word();
        const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (error != std::errc{} || stop != count.data() + count.size()) {
            refuse("no count of rows", count);
        }
        if (header_.find(element.name)) refuse("a second element of this name", element.name);
        header_.elements.push_back(std::move(element));
    }

    PlyType read_type() {
        const std::string_view word = cursor_.word();
        for (const TypeName& known : type_names) {
            if (word == known.name || word == known.sized_name) return known.type;
        }
        refuse("no type of a PLY property", word);
    }

    void read_property() {
        if (header_.elements.empty()) fail(FLG_ERROR_FORMAT, place(), "a property before the first element");
        PlyProperty property;
        LineCursor ahead = cursor_;
        if (ahead.word() == "list") {
            cursor_ = ahead;
            property.count_type = read_type();
            if (!is_integer(property.count_type)) fail(FLG_ERROR_FORMAT, place(), "a list must be counted by integers");
        }
        property.type = read_type();
        PlyElement& element = header_.elements.back();
        property.name = read_name(element.properties.size());
        if (element.find(property.name)) refuse("a second property of this name", property.name);
        element.properties.push_back(std::move(property));
    }

    TextLines& lines_;
    LineCursor cursor_{{}, 0};
    std::string_view keyword_;
    PlyHeader header_;
};

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
    const auto found =
        std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
    const auto found =
        std::find_if(elements.begin(), elements.end(), [&](const PlyElement& e) { return e.name == element; });
    return found == elements.end() ? nullptr : &*found;
}

uint64_t PlyHeader::least_row(const PlyElement& element) const {
    // A digit each, and blanks or the end of the line between them.
    if (encoding == PlyEncoding::ascii) return 2 * element.properties.size();
    uint64_t size = 0;
    for (const PlyProperty& property : element.properties) {
        size += ply_size(property.is_list() ? property.count_type : property.type);
    }
    return size;
}

PlyHeader read_ply_header(TextLines& lines) {
    return HeaderReader(lines).read();
}

}  // namespace flg::io
