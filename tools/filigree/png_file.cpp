// SPDX-License-Identifier: MIT
#include "png_file.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "documents/failure.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace flg::cli {
namespace {

constexpr int quality = 8;                           // of the compression, as stb's own for pictures
constexpr uint8_t filter = 2;                        // each row is what it adds to the one above
constexpr uint8_t colour_types[] = {0, 0, 4, 2, 6};  // by channels

void put_number(std::string& out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
}

void put_chunk(std::string& out, const char* type, std::string_view content) {
    put_number(out, static_cast<uint32_t>(content.size()));
    std::string checked = type + std::string(content);
    const uint32_t sum =
        stbiw__crc32(reinterpret_cast<unsigned char*>(checked.data()), static_cast<int>(checked.size()));
    out += checked;
    put_number(out, sum);
}

// `rows`: of bytes, big-endian.
std::string pack(const std::string& path, const PngShape& shape, uint8_t bits, const std::vector<uint8_t>& rows) {
    const size_t stride = rows.size() / shape.height;
    std::vector<uint8_t> filtered;
    filtered.reserve(rows.size() + shape.height);
    for (size_t y = 0; y < shape.height; ++y) {
        filtered.push_back(filter);
        for (size_t i = y * stride; i < (y + 1) * stride; ++i)
            filtered.push_back(static_cast<uint8_t>(rows[i] - (y > 0 ? rows[i - stride] : 0)));
    }
    if (filtered.size() > std::numeric_limits<int>::max() / 2)
        throw InputError(path + ": can't be written: a picture of so many texels is too large, take a smaller size");
    int size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> packed(
        stbi_zlib_compress(filtered.data(), static_cast<int>(filtered.size()), &size, quality), std::free);
    if (!packed) throw InputError(path + ": can't be written: there is no memory for its compression");
    std::string header;
    put_number(header, shape.width);
    put_number(header, shape.height);
    for (const uint8_t byte : {bits, colour_types[shape.channels], uint8_t{0}, uint8_t{0}, uint8_t{0}})
        header += static_cast<char>(byte);
    std::string file = "\x89PNG\r\n\x1a\n";
    put_chunk(file, "IHDR", header);
    put_chunk(file, "IDAT", {reinterpret_cast<const char*>(packed.get()), static_cast<size_t>(size)});
    put_chunk(file, "IEND", {});
    return file;
}

}  // namespace

std::string encode_png(const std::string& path, const PngShape& shape, std::span<const uint8_t> values) {
    return pack(path, shape, 8, {values.begin(), values.end()});
}

std::string encode_png(const std::string& path, const PngShape& shape, std::span<const uint16_t> values) {
    std::vector<uint8_t> bytes;
    bytes.reserve(2 * values.size());
    for (const uint16_t value : values) {
        bytes.push_back(static_cast<uint8_t>(value >> 8));
        bytes.push_back(static_cast<uint8_t>(value & 0xff));
    }
    return pack(path, shape, 16, bytes);
}

}  // namespace flg::cli
