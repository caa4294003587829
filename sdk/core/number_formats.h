// SPDX-License-Identifier: MIT
// Numbers as graphics cards take them. Values beyond a format's range become the nearest it holds, NaN its least.
#pragma once

#include <bit>
#include <cstdint>

#include "filigree/filigree.h"

namespace flg {

// IEEE half, rounded to the nearest, ties to even.
inline uint16_t to_half(float value) {
    const auto bits = std::bit_cast<uint32_t>(value);
    const auto sign = static_cast<uint16_t>(bits >> 16 & 0x8000u);
    const uint32_t size = bits & 0x7fffffffu;
    constexpr uint32_t min_normal = 0x38800000u;  // 2^-14
    constexpr uint32_t most = 0x477fe000u;        // 65504
    constexpr uint32_t infinite = 0x7f800000u;
    if (size >= most) return size > infinite ? uint16_t{0xfbff} : static_cast<uint16_t>(sign | 0x7bffu);
    if (size < min_normal) {
        // Added to a half, what is left of the sum's last places is the result.
        const float shifted = std::bit_cast<float>(size) + 0.5f;
        return static_cast<uint16_t>(sign | (std::bit_cast<uint32_t>(shifted) - std::bit_cast<uint32_t>(0.5f)));
    }
    const uint32_t odd = size >> 13 & 1u;
    return static_cast<uint16_t>(sign | ((size - (112u << 23) + 0xfffu + odd) >> 13));
}

inline float clamped(float value, float least, float most) {
    return value > least ? value < most ? value : most : least;
}

// The nearest whole number, of two the larger.
inline int32_t to_nearest(float value) {
    const float raised = value + 0.5f;
    const auto whole = static_cast<int32_t>(raised);
    return whole - static_cast<int32_t>(static_cast<float>(whole) > raised);
}

inline uint8_t to_unorm8(float value) {
    return static_cast<uint8_t>(static_cast<int32_t>(clamped(value, 0, 1) * 255.0f + 0.5f));
}
inline uint16_t to_unorm16(float value) {
    return static_cast<uint16_t>(static_cast<int32_t>(clamped(value, 0, 1) * 65535.0f + 0.5f));
}
inline int8_t to_snorm8(float value) {
    return static_cast<int8_t>(to_nearest(clamped(value, -1, 1) * 127.0f));
}
inline int16_t to_snorm16(float value) {
    return static_cast<int16_t>(to_nearest(clamped(value, -1, 1) * 32767.0f));
}

// visit(convert), where convert(float) is the number as the format stores it. Not for whole numbers.
template <class Visit>
void with_conversion(FlgNumberFormat format, const Visit& visit) {
    switch (format) {
        case FLG_NUMBER_FORMAT_FLOAT16: return visit([](float value) { return to_half(value); });
        case FLG_NUMBER_FORMAT_UNORM8: return visit([](float value) { return to_unorm8(value); });
        case FLG_NUMBER_FORMAT_UNORM16: return visit([](float value) { return to_unorm16(value); });
        case FLG_NUMBER_FORMAT_SNORM8: return visit([](float value) { return to_snorm8(value); });
        case FLG_NUMBER_FORMAT_SNORM16: return visit([](float value) { return to_snorm16(value); });
        default: return visit([](float value) { return value; });
    }
}

// Bytes of a number; 0 for what is none.
inline uint32_t bytes_of(int32_t format) {
    constexpr uint32_t bytes[] = {4, 2, 1, 1, 2, 2, 4, 2, 1};
    return format >= 0 && format < 9 ? bytes[format] : 0;
}

// Whether it stores whole numbers.
inline bool is_whole(FlgNumberFormat format) {
    return format == FLG_NUMBER_FORMAT_UINT8 || format == FLG_NUMBER_FORMAT_UINT16 ||
           format == FLG_NUMBER_FORMAT_UINT32;
}

}  // namespace flg
