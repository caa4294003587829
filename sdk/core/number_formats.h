// SPDX-License-Identifier: MIT
// Numbers as graphics cards take them. Values beyond a format's range become the nearest it holds, NaN its least.
#pragma once

#include <array>
#include <bit>
#include <cmath>
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

// A direction on the octahedron |x| + |y| + |z| = 1, its lower half folded over the upper one's corners.
inline void to_octahedral16(const float* direction, int16_t* to) {
    const float size = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
    const float scale = size > 0 ? 1 / size : 0;
    float x = direction[0] * scale, y = direction[1] * scale;
    if (direction[2] < 0) {
        const float folded = (1 - std::abs(y)) * (x >= 0 ? 1.0f : -1.0f);
        y = (1 - std::abs(x)) * (y >= 0 ? 1.0f : -1.0f);
        x = folded;
    }
    to[0] = to_snorm16(x);
    to[1] = to_snorm16(y);
}

// The linear values from which on a byte of sRGB is k (IEC 61966-2-1): ((k - 1/2) / 255 + 0.055) / 1.055 to the 2.4.
constexpr std::array<float, 256> make_srgb_thresholds() {
    std::array<float, 256> thresholds{};
    for (int k = 1; k < 256; ++k) {
        const double value = (k - 0.5) / 255;
        const double base = (value + 0.055) / 1.055, square = base * base;
        double fifth_root = 1;  // of the square, from above: Newton's method decreases to it
        for (int i = 0; i < 40; ++i) {
            const double cube = fifth_root * fifth_root * fifth_root;
            fifth_root = (4 * fifth_root + square / (cube * fifth_root)) / 5;
        }
        thresholds[static_cast<size_t>(k)] = static_cast<float>(value <= 0.04045 ? value / 12.92 : square * fifth_root);
    }
    return thresholds;
}
inline constexpr std::array<float, 256> srgb_thresholds = make_srgb_thresholds();

// The nearest byte: a polynomial in roots (off by 0.2 % at most, more near 0) and then the thresholds.
inline uint8_t to_srgb8(float linear) {
    const float v = clamped(linear, 0, 1);
    const float half = std::sqrt(v), quarter = std::sqrt(half), eighth = std::sqrt(quarter);
    const float guess =
        v < 0.0031308f ? 12.92f * v : 0.585122381f * half + 0.783140355f * quarter - 0.368262736f * eighth;
    auto byte = static_cast<size_t>(255 * clamped(guess, 0, 1) + 0.5f);
    while (byte < 255 && v >= srgb_thresholds[byte + 1]) ++byte;
    while (v < srgb_thresholds[byte]) --byte;
    return static_cast<uint8_t>(byte);
}

// Formats of rows, of which a number is not stored by itself.
inline bool is_of_rows(FlgNumberFormat format) {
    return format == FLG_NUMBER_FORMAT_OCTAHEDRAL16 || format == FLG_NUMBER_FORMAT_SRGB8;
}
// A row in such a format: three numbers of a direction, `components` of a colour.
inline void store_row(FlgNumberFormat format, const float* row, uint32_t components, void* to) {
    if (format == FLG_NUMBER_FORMAT_OCTAHEDRAL16) return to_octahedral16(row, static_cast<int16_t*>(to));
    auto* const bytes = static_cast<uint8_t*>(to);
    for (uint32_t k = 0; k < components; ++k) bytes[k] = k < 3 ? to_srgb8(row[k]) : to_unorm8(row[k]);
}

// visit(convert), where convert(float) is the number as the format stores it. Not for whole numbers and rows.
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
    constexpr uint32_t bytes[] = {4, 2, 1, 1, 2, 2, 4, 2, 1, 2, 1};
    return format >= 0 && format < 11 ? bytes[format] : 0;
}

// Bytes of a row of so many numbers.
inline uint32_t row_size(FlgNumberFormat format, uint32_t components) {
    return format == FLG_NUMBER_FORMAT_OCTAHEDRAL16 ? 2 * sizeof(int16_t) : components * bytes_of(format);
}

// Whether it stores whole numbers.
inline bool is_whole(FlgNumberFormat format) {
    return format == FLG_NUMBER_FORMAT_UINT8 || format == FLG_NUMBER_FORMAT_UINT16 ||
           format == FLG_NUMBER_FORMAT_UINT32;
}

}  // namespace flg
