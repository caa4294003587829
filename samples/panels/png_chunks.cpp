// SPDX-License-Identifier: MIT
#include "panels/png_chunks.h"

#include <zlib.h>

#include <fstream>
#include <stdexcept>

namespace flg::panels {

void append_number(Bytes& to, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<uint8_t>(value >> shift));
}

void append_short(Bytes& to, uint16_t value) {
    to.push_back(static_cast<uint8_t>(value >> 8));
    to.push_back(static_cast<uint8_t>(value));
}

Bytes packed(const Bytes& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    Bytes result(size);
    if (compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK) {
        throw std::runtime_error("out of memory");
    }
    result.resize(size);
    return result;
}

PngChunks::PngChunks(uint32_t width, uint32_t height, bool palette)
    : file_{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'} {
    Bytes header;
    append_number(header, width);
    append_number(header, height);
    // Bits, RGB or palette, deflate, filters, not interlaced.
    header.insert(header.end(), {8, static_cast<uint8_t>(palette ? 3 : 2), 0, 0, 0});
    append("IHDR", header);
}

void PngChunks::append(const char* type, const Bytes& data) {
    append_number(file_, static_cast<uint32_t>(data.size()));
    const size_t start = file_.size();
    file_.insert(file_.end(), type, type + 4);
    file_.insert(file_.end(), data.begin(), data.end());
    append_number(file_,
                  static_cast<uint32_t>(crc32(0, file_.data() + start, static_cast<uInt>(file_.size() - start))));
}

void PngChunks::write(const std::string& path) {
    append("IEND", {});
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(file_.data()), static_cast<std::streamsize>(file_.size()));
    out.flush();
    if (!out) throw std::runtime_error(path + ": can't be written");
}

}  // namespace flg::panels
