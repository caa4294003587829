// SPDX-License-Identifier: MIT
// Pictures on the host.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flg::render {

// 8 bits per channel, RGBA in sRGB, rows from the top, tightly packed.
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> pixels;

    const uint8_t* at(uint32_t x, uint32_t y) const { return pixels.data() + 4 * (size_t{y} * width + x); }
};

// Writes the file completely or not at all (through a temporary file next to it); throws Error.
void write_png(const Image& image, const std::string& path);

}  // namespace flg::render
