// SPDX-License-Identifier: MIT
// Columns of a view, checked, and values as compact as the shaders take them (shaders/packing.glsl): written by
// filigree_buffers.h.
#pragma once

#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <span>

#include "filigree/filigree.h"

namespace flg::render {

constexpr float largest_coordinate = 1e30f;  // as in filigree.h

struct Column {
    const char* data = nullptr;
    size_t stride = 0;
    explicit operator bool() const { return data != nullptr; }
    template <class T>
    T at(uint32_t point) const {
        T value;
        std::memcpy(&value, data + stride * point, sizeof value);
        return value;
    }
};

// Null if there is none; throws Error for one that can't be read.
Column find_column(std::span<const FlgColumn> columns, FlgAttribute attribute, uint32_t components, const char* name);

// Finite, and not beyond the largest coordinate.
bool is_usable(glm::vec3 p);

// Throws Error unless the value is within low to high.
void check_in(float value, float low, float high, const char* name);
void check_color(glm::vec3 color, const char* name);

// Columns of a view as filigree_buffers.h writes them; throws Error.
void write_columns(std::span<const FlgColumn> from, uint32_t rows, std::span<const FlgBufferColumn> to);

// FLG_NUMBER_FORMAT_OCTAHEDRAL16, `stride` bytes from one to the next.
void write_normals(std::span<const glm::vec3> normals, uint32_t* to, uint32_t stride);

// Linear to FLG_NUMBER_FORMAT_SRGB8, opaque; likewise.
void write_colors(std::span<const glm::vec4> colors, uint32_t* to, uint32_t stride);
uint32_t packed_color(glm::vec3 linear);

}  // namespace flg::render
