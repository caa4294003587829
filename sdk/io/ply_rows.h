// SPDX-License-Identifier: MIT
// The rows of a PLY file's elements, as text or as bytes: the same questions to both.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "io/byte_reader.h"
#include "io/ply_header.h"

namespace flg::io {

// One row a line; lines without words are passed over.
class PlyTextRows {
public:
    explicit PlyTextRows(TextLines& lines) : lines_(lines) {}

    void begin_row(const PlyElement& element) {
        for (std::string_view line; lines_.next(line);) {
            cursor_ = LineCursor(line, lines_.number());
            if (cursor_.more()) return;
        }
        fail(FLG_ERROR_FORMAT, place(), "ends too early: rows of the element %s are missing",
             cited(element.name).c_str());
    }
    void end_row() {
        if (!cursor_.more()) return;
        fail(FLG_ERROR_FORMAT, place(), "more values than the element has: %s", cited(cursor_.word()).c_str());
    }
    float number(PlyType, const char* name) { return cursor_.number(name); }
    int64_t integer(PlyType, const char* name) { return cursor_.integer(name); }
    void skip(PlyType, const char* name) {
        if (cursor_.word().empty()) fail(FLG_ERROR_FORMAT, place(), "the %s is missing", name);
    }

    std::string place() const { return line_place(lines_.number()); }
    uint64_t left() const { return lines_.rest().size(); }

private:
    TextLines& lines_;
    LineCursor cursor_{{}, 0};
};

template <std::endian order>
class PlyByteRows {
public:
    PlyByteRows(Bytes file, size_t position) : reader_(file, "", position) {}

    void begin_row(const PlyElement&) {}
    void end_row() {}
    float number(PlyType type, const char* name) {
        const float value = type == PlyType::float32   ? read<float>(name)
                            : type == PlyType::float64 ? static_cast<float>(read<double>(name))
                                                       : static_cast<float>(integer(type, name));
        if (!(std::abs(value) <= max_coordinate)) {
            fail(FLG_ERROR_FORMAT, byte_place("", reader_.position() - ply_size(type)),
                 "the %s is %g: must be finite and at most 1e30 in size", name, double{value});
        }
        return value;
    }
    int64_t integer(PlyType type, const char* name) {
        switch (type) {
            case PlyType::int8: return read<int8_t>(name);
            case PlyType::uint8: return read<uint8_t>(name);
            case PlyType::int16: return read<int16_t>(name);
            case PlyType::uint16: return read<uint16_t>(name);
            case PlyType::int32: return read<int32_t>(name);
            default: return read<uint32_t>(name);
        }
    }
    void skip(PlyType type, const char* name) { reader_.take(ply_size(type), name); }

    std::string place() const { return reader_.place(); }
    uint64_t left() const { return reader_.left(); }

private:
    template <class T>
    T read(const char* name) {
        T value = reader_.read<T>(name);
        if constexpr (order != std::endian::native && sizeof(T) > 1) {
            using Bits =
                std::conditional_t<sizeof(T) == 2, uint16_t, std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>;
            Bits bits = std::bit_cast<Bits>(value), turned = 0;
            for (size_t i = 0; i < sizeof(T); ++i) turned = static_cast<Bits>(turned << 8 | (bits >> (8 * i) & 0xff));
            value = std::bit_cast<T>(turned);
        }
        return value;
    }

    ByteReader reader_;
};

}  // namespace flg::io
