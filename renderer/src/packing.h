// SPDX-License-Identifier: MIT
// Columns of a view, checked, and values as compact as the shaders take them (shaders/packing.glsl).
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

// Octahedral, 2 x snorm16; of any length but zero.
uint32_t pack_normal(glm::vec3 normal);

// Linear to sRGB, 4 x unorm8; clamped, opaque.
uint32_t pack_color(glm::vec3 linear);

}  // namespace flg::render
