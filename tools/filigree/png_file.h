// SPDX-License-Identifier: MIT
// PNG files of numbers: 8 or 16 bits, grey, RGB or RGBA. Not of pictures alone: no colour space is said.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace flg::cli {

struct PngShape {
    uint32_t width = 0, height = 0;
    uint32_t channels = 1;  // 1, 3 or 4
};

// The bytes of a file; rows from the top, tightly packed. Both throw InputError, which names the path.
std::string encode_png(const std::string& path, const PngShape& shape, std::span<const uint8_t> values);
std::string encode_png(const std::string& path, const PngShape& shape, std::span<const uint16_t> values);

}  // namespace flg::cli
