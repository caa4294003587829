// SPDX-License-Identifier: MIT
// The parts that PNG files (ISO/IEC 15948) are made of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flg::panels {

using Bytes = std::vector<uint8_t>;

// Big-endian.
void append_number(Bytes& to, uint32_t value);
void append_short(Bytes& to, uint16_t value);

// By zlib, as tightly as it can.
Bytes packed(const Bytes& bytes);

class PngChunks {
public:
    // 8 bits a channel, RGB or with a palette, not interlaced.
    PngChunks(uint32_t width, uint32_t height, bool palette);
    void append(const char* type, const Bytes& data);
    // With the end. Throws std::runtime_error.
    void write(const std::string& path);

private:
    Bytes file_;
};

}  // namespace flg::panels
