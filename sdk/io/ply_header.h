// SPDX-License-Identifier: MIT
// The header of a PLY file: which elements follow, and what each of their rows holds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_lines.h"

namespace flg::io {

enum class PlyType : uint8_t { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr uint32_t ply_size(PlyType type) {
    constexpr uint32_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<size_t>(type)];
}
constexpr bool is_integer(PlyType type) {
    return type != PlyType::none && type < PlyType::float32;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::none;
    PlyType count_type = PlyType::none;  // of a list

    bool is_list() const { return count_type != PlyType::none; }
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    uint64_t line = 0;  // of the header
    std::vector<PlyProperty> properties;

    // Null if there is none.
    const PlyProperty* find(std::string_view property) const;
};

enum class PlyEncoding : uint8_t { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;

    // Null if there is none.
    const PlyElement* find(std::string_view element) const;
    // The fewest bytes a row of this element can take.
    uint64_t least_row(const PlyElement& element) const;
};

// Takes the header off the lines; the rows follow.
PlyHeader read_ply_header(TextLines& lines);

}  // namespace flg::io
