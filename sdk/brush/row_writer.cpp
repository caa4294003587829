// SPDX-License-Identifier: MIT
#include "brush/row_writer.h"

#include "core/number_formats.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {
namespace {

// Vectors as the inner loops take them.
struct Floats {
    float x, y, z;
};

Floats floats(const Vec3& v, bool left_handed) {
    const auto z = static_cast<float>(v.z());
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), left_handed ? -z : z};
}

template <uint32_t components>
void store_components(const FlgVertexColumn& column, int64_t first, const float* const* values, uint32_t count) {
    with_conversion(column.format, [&](auto convert) {
        using Number = decltype(convert(0.0f));
        char* at = static_cast<char*>(column.data) + static_cast<size_t>(first) * column.stride;
        for (uint32_t v = 0; v < count; ++v, at += column.stride) {
            auto* const numbers = reinterpret_cast<Number*>(at);
            for (uint32_t k = 0; k < components; ++k) numbers[k] = convert(values[k][v]);
        }
    });
}

}  // namespace

RowWriter::RowWriter(const Style& style, const CrossSection& section, const Output& output)
    : style_(style), section_(section), output_(output) {}

void RowWriter::store(FlgVertexAttribute attribute, const float* const* values, uint32_t count) {
    const FlgVertexColumn& column = output_.columns[attribute];
    switch (attribute) {
        case FLG_VERTEX_ATTRIBUTE_POSITION:
        case FLG_VERTEX_ATTRIBUTE_NORMAL: return store_components<3>(column, vertices_, values, count);
        case FLG_VERTEX_ATTRIBUTE_UV: return store_components<2>(column, vertices_, values, count);
        default: return store_components<4>(column, vertices_, values, count);
    }
}

int64_t RowWriter::write(const Row& row) {
    constexpr uint32_t most = CrossSection::most;
    const bool mirror = style_.left_handed;
    const uint32_t count = section_.vertices;
    float x[most], y[most], z[most], w[most];
    const float* const values[] = {x, y, z, w};
    if (output_.columns[FLG_VERTEX_ATTRIBUTE_POSITION].data) {
        const Floats c = floats(row.center, mirror), a = floats(row.arm[0], mirror), b = floats(row.arm[1], mirror);
        for (uint32_t v = 0; v < count; ++v) {
            const float p = section_.place[0][v], q = section_.place[1][v];
            x[v] = c.x + (p * a.x + q * b.x);
            y[v] = c.y + (p * a.y + q * b.y);
            z[v] = c.z + (p * a.z + q * b.z);
        }
        store(FLG_VERTEX_ATTRIBUTE_POSITION, values, count);
    }
    // Normals and tangents: outwards and along the curve, turned against each other as the surface leans.
    const auto store_direction = [&](FlgVertexAttribute attribute, double out, double along) {
        const Floats a = floats(out * row.normal, mirror), b = floats(out * row.binormal, mirror),
                     t = floats(along * row.tangent, mirror);
        for (uint32_t v = 0; v < count; ++v) {
            const float p = section_.normal[0][v], q = section_.normal[1][v];
            x[v] = t.x + (p * a.x + q * b.x);
            y[v] = t.y + (p * a.y + q * b.y);
            z[v] = t.z + (p * a.z + q * b.z);
        }
        store(attribute, values, count);
    };
    if (output_.columns[FLG_VERTEX_ATTRIBUTE_NORMAL].data)
        store_direction(FLG_VERTEX_ATTRIBUTE_NORMAL, row.normal_out, row.normal_along);
    if (output_.columns[FLG_VERTEX_ATTRIBUTE_TANGENT].data) {
        for (uint32_t v = 0; v < count; ++v) w[v] = mirror ? 1.0f : -1.0f;
        store_direction(FLG_VERTEX_ATTRIBUTE_TANGENT, -row.normal_along, row.normal_out);
    }
    if (output_.columns[FLG_VERTEX_ATTRIBUTE_COLOR].data) {
        for (uint32_t v = 0; v < count; ++v) {
            x[v] = row.color[0];
            y[v] = row.color[1];
            z[v] = row.color[2];
            w[v] = row.color[3];
        }
        store(FLG_VERTEX_ATTRIBUTE_COLOR, values, count);
    }
    if (output_.columns[FLG_VERTEX_ATTRIBUTE_UV].data) {
        const auto along = static_cast<float>(row.along), width = static_cast<float>(row.width);
        for (uint32_t v = 0; v < count; ++v) {
            x[v] = along;
            y[v] = width * section_.around[v];
        }
        store(FLG_VERTEX_ATTRIBUTE_UV, values, count);
    }
    const int64_t number = vertices_;
    vertices_ += count;
    return number;
}

int64_t RowWriter::write_apex(const Row& row, const Vec3& facing) {
    const bool mirror = style_.left_handed;
    const auto one = [&](FlgVertexAttribute attribute, const Floats& value, float last) {
        if (!output_.columns[attribute].data) return;
        const float* const values[] = {&value.x, &value.y, &value.z, &last};
        store(attribute, values, 1);
    };
    one(FLG_VERTEX_ATTRIBUTE_POSITION, floats(row.center, mirror), 0);
    one(FLG_VERTEX_ATTRIBUTE_NORMAL, floats(facing, mirror), 0);
    // Across what it faces: along the curve where it can be.
    const Vec3& along = style_.tube() ? row.normal : row.tangent;
    one(FLG_VERTEX_ATTRIBUTE_TANGENT, floats(along, mirror), mirror ? 1.0f : -1.0f);
    one(FLG_VERTEX_ATTRIBUTE_COLOR, {row.color[0], row.color[1], row.color[2]}, row.color[3]);
    one(FLG_VERTEX_ATTRIBUTE_UV, {static_cast<float>(row.along), static_cast<float>(0.5 * row.width), 0}, 0);
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
