// SPDX-License-Identifier: MIT
#include "brush/row_writer.h"

#include <cstring>

#include "core/number_formats.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {
namespace {

using Pair = double __attribute__((vector_size(16)));

void put_three(char* to, const Lanes& value) {
    const double first_two = reinterpret_cast<Pair>(value)[0];
    const float third = value[2];
    std::memcpy(to, &first_two, sizeof first_two);
    std::memcpy(to + sizeof first_two, &third, sizeof third);
}

}  // namespace

RowWriter::RowWriter(const Style& style, const CrossSection& section, const Output& output)
    : style_(style), section_(section), output_(output) {
    const auto is_plain = [&](Of kind) {
        return wanted(kind) && output[kind].format == FLG_NUMBER_FORMAT_FLOAT32 && output[kind].components == 3;
    };
    plain_ = is_plain(Of::position) && is_plain(Of::normal);
    // Turned around, two corners of each triangle change places.
    const uint32_t second = style.left_handed ? 2 : 1, third = 3 - second;
    for (uint32_t q = 0; q < section.quads; ++q) {
        uint32_t* const corners = ahead_ + size_t{6} * q;
        corners[0] = corners[3] = section.left[q];
        corners[second] = section.right[q];
        corners[third] = corners[3 + second] = section.vertices + section.right[q];
        corners[3 + third] = section.vertices + section.left[q];
    }
}

template <uint32_t own, class Value>
void RowWriter::store(Of kind, uint32_t count, Value value) {
    const FlgBufferColumn& column = output_[kind];
    char* at = static_cast<char*>(column.data) + static_cast<size_t>(vertices_) * column.stride;
    const auto lanes_of = [&](uint32_t v) {
        Lanes lanes = value(v);
        for (uint32_t k = own; k < 4; ++k) lanes[k] = column.fill[k];
        return lanes;
    };
    if (is_of_rows(column.format)) {
        for (uint32_t v = 0; v < count; ++v, at += column.stride) {
            const Lanes lanes = lanes_of(v);
            float row[4];
            std::memcpy(row, &lanes, sizeof row);
            store_row(column.format, row, column.components, at);
        }
        return;
    }
    with_conversion(column.format, [&](auto convert) {
        using Number = decltype(convert(0.0f));
        for (uint32_t v = 0; v < count; ++v, at += column.stride) {
            const Lanes lanes = lanes_of(v);
            auto* const numbers = reinterpret_cast<Number*>(at);
            for (uint32_t k = 0; k < column.components; ++k) numbers[k] = convert(lanes[k]);
        }
    });
}

// Both at once: buffers that interleave them are written from front to back. The loop keeps to locals, since what it
// writes may be anything.
void RowWriter::write_places_and_normals(const Row& row) {
    const Lanes center = row.center, arm = row.arm[0], other_arm = row.arm[1];
    const Lanes out = row.normal_out * row.normal, side = row.normal_out * row.binormal,
                lean = row.normal_along * row.tangent;
    const CrossSection& section = section_;
    const uint32_t count = section.vertices;
    const FlgBufferColumn& places = output_[Of::position];
    const FlgBufferColumn& normals = output_[Of::normal];
    const size_t place_stride = places.stride, normal_stride = normals.stride;
    char* place = static_cast<char*>(places.data) + static_cast<size_t>(vertices_) * place_stride;
    char* normal = static_cast<char*>(normals.data) + static_cast<size_t>(vertices_) * normal_stride;
    for (uint32_t v = 0; v < count; ++v, place += place_stride, normal += normal_stride) {
        put_three(place, center + (section.place[0][v] * arm + section.place[1][v] * other_arm));
        put_three(normal, lean + (section.normal[0][v] * out + section.normal[1][v] * side));
    }
}

int64_t RowWriter::write(const Row& row) {
    const uint32_t count = section_.vertices;
    // Normals and tangents: outwards and along the curve, turned against each other as the surface leans.
    const auto direction = [&](float out, float along) {
        const Lanes a = out * row.normal, b = out * row.binormal, t = along * row.tangent;
        return [this, a, b, t](uint32_t v) { return t + (section_.normal[0][v] * a + section_.normal[1][v] * b); };
    };
    if (plain_) {
        write_places_and_normals(row);
    } else {
        if (wanted(Of::position)) {
            store<3>(Of::position, count, [&](uint32_t v) {
                return row.center + (section_.place[0][v] * row.arm[0] + section_.place[1][v] * row.arm[1]);
            });
        }
        if (wanted(Of::normal)) store<3>(Of::normal, count, direction(row.normal_out, row.normal_along));
    }
    if (wanted(Of::tangent)) {
        const auto tangent = direction(-row.normal_along, row.normal_out);
        const float hand = style_.left_handed ? 1.0f : -1.0f;
        store<4>(Of::tangent, count, [&](uint32_t v) {
            Lanes lanes = tangent(v);
            lanes[3] = hand;
            return lanes;
        });
    }
    if (wanted(Of::color)) {
        const Lanes color = {row.color[0], row.color[1], row.color[2], row.color[3]};
        store<4>(Of::color, count, [&](uint32_t) { return color; });
    }
    if (wanted(Of::uv)) {
        const auto uv = [&](uint32_t v) { return Lanes{row.along, row.width * section_.around[v], 0, 0}; };
        style_.uv ? store<2>(Of::uv, count, uv) : store<0>(Of::uv, count, uv);
    }
    const int64_t number = vertices_;
    vertices_ += count;
    return number;
}

int64_t RowWriter::write_apex(const Row& row, const Lanes& facing) {
    if (wanted(Of::position)) store<3>(Of::position, 1, [&](uint32_t) { return row.center; });
    if (wanted(Of::normal)) store<3>(Of::normal, 1, [&](uint32_t) { return facing; });
    if (wanted(Of::tangent)) {
        // Across what it faces: along the curve where it can be.
        Lanes along = style_.tube() ? row.normal : row.tangent;
        along[3] = style_.left_handed ? 1.0f : -1.0f;
        store<4>(Of::tangent, 1, [&](uint32_t) { return along; });
    }
    if (wanted(Of::color)) {
        const Lanes color = {row.color[0], row.color[1], row.color[2], row.color[3]};
        store<4>(Of::color, 1, [&](uint32_t) { return color; });
    }
    if (wanted(Of::uv)) {
        const auto uv = [&](uint32_t) { return Lanes{row.along, 0.5f * row.width, 0, 0}; };
        style_.uv ? store<2>(Of::uv, 1, uv) : store<0>(Of::uv, 1, uv);
    }
    return vertices_++;
}

template <class Index>
void RowWriter::strip_as(int64_t from, int64_t to, bool back) {
    auto* at = static_cast<Index*>(output_.indices) + indices_;
    const auto a = static_cast<uint32_t>(output_.first_index_value + from);
    const auto b = static_cast<uint32_t>(output_.first_index_value + to);
    // Turned around, two corners of each triangle change places.
    const size_t second = back ? 2 : 1, third = 3 - second;
    for (uint32_t q = 0; q < section_.quads; ++q, at += 6) {
        at[0] = at[3] = static_cast<Index>(a + section_.left[q]);
        at[third] = at[3 + second] = static_cast<Index>(b + section_.right[q]);
        at[second] = static_cast<Index>(a + section_.right[q]);
        at[3 + third] = static_cast<Index>(b + section_.left[q]);
    }
    indices_ += 6 * uint64_t{section_.quads};
}

void RowWriter::strip(int64_t from, int64_t to, bool back) {
    if (!output_.indices) return;
    back = back != style_.left_handed;
    return output_.narrow_indices ? strip_as<uint16_t>(from, to, back) : strip_as<uint32_t>(from, to, back);
}

template <class Index>
void RowWriter::strip_ahead_as(int64_t from) {
    auto* const at = static_cast<Index*>(output_.indices) + indices_;
    const auto a = static_cast<uint32_t>(output_.first_index_value + from);
    const uint32_t count = 6 * section_.quads;
    for (uint32_t i = 0; i < count; ++i) at[i] = static_cast<Index>(a + ahead_[i]);
    indices_ += count;
}

void RowWriter::strip_ahead(int64_t from) {
    if (!output_.indices) return;
    return output_.narrow_indices ? strip_ahead_as<uint16_t>(from) : strip_ahead_as<uint32_t>(from);
}

void RowWriter::triangle(int64_t a, int64_t b, int64_t c, bool back) {
    const int64_t corners[] = {a, back ? c : b, back ? b : c};
    for (const int64_t corner : corners) {
        const auto index = static_cast<uint32_t>(output_.first_index_value + corner);
        if (output_.narrow_indices)
            static_cast<uint16_t*>(output_.indices)[indices_++] = static_cast<uint16_t>(index);
        else
            static_cast<uint32_t*>(output_.indices)[indices_++] = index;
    }
}

void RowWriter::tip(int64_t from, int64_t to, bool back) {
    if (!output_.indices) return;
    for (uint32_t q = 0; q < section_.quads; ++q)
        triangle(from + section_.left[q], from + section_.right[q], to + section_.left[q], back != style_.left_handed);
}

void RowWriter::fan(int64_t from, int64_t apex, bool back) {
    if (!output_.indices) return;
    for (uint32_t q = 0; q < section_.quads; ++q)
        triangle(from + section_.left[q], from + section_.right[q], apex, back != style_.left_handed);
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
