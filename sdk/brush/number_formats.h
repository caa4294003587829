// SPDX-License-Identifier: MIT
// Numbers as graphics cards take them. Values beyond a format's range become the nearest it holds.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "brush/library.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

// IEEE half, rounded to the nearest, ties to even.
inline uint16_t to_half(float value) {
    const auto bits = std::bit_cast<uint32_t>(value);
    const auto sign = static_cast<uint16_t>(bits >> 16 & 0x8000u);
    const uint32_t size = bits & 0x7fffffffu;
    constexpr uint32_t least_normal = 0x38800000u;  // 2^-14
    constexpr uint32_t most = 0x477fe000u;          // 65504
    if (size >= most) return static_cast<uint16_t>(sign | 0x7bffu);
    if (size < least_normal) {
        // Added to a half, what is left of the sum's last places is the result.
        const float shifted = std::bit_cast<float>(size) + 0.5f;
        return static_cast<uint16_t>(sign | (std::bit_cast<uint32_t>(shifted) - std::bit_cast<uint32_t>(0.5f)));
    }
    const uint32_t odd = size >> 13 & 1u;
    return static_cast<uint16_t>(sign | ((size - (112u << 23) + 0xfffu + odd) >> 13));
}

inline float clamped(float value, float least, float most) {
    return value < least ? least : value > most ? most : value;
}

inline uint8_t to_unorm8(float value) {
    return static_cast<uint8_t>(clamped(value, 0, 1) * 255.0f + 0.5f);
}
inline int8_t to_snorm8(float value) {
    return static_cast<int8_t>(std::floor(clamped(value, -1, 1) * 127.0f + 0.5f));
}
inline int16_t to_snorm16(float value) {
    return static_cast<int16_t>(std::floor(clamped(value, -1, 1) * 32767.0f + 0.5f));
}

// Bytes of a number; 0 for what is none.
inline uint32_t bytes_of(int32_t format) {
    constexpr uint32_t bytes[] = {4, 2, 1, 1, 2, 2, 4};
    return format >= 0 && format < 7 ? bytes[format] : 0;
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
