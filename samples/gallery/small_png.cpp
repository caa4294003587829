// SPDX-License-Identifier: MIT
// PNG (ISO/IEC 15948), 8 bits of RGB, one filter for all rows, whichever packs best; with a palette where that is large.
#include "gallery/small_png.h"

#include <zlib.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "gallery/palette.h"

namespace flg::gallery {
namespace {

using Bytes = std::vector<uint8_t>;

constexpr uint32_t kChannels = 3;
// None, left, above.
constexpr uint8_t kFilters[] = {0, 1, 2};

void append_number(Bytes& to, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<uint8_t>(value >> shift));
}

void append_chunk(Bytes& to, const char* type, const Bytes& data) {
    append_number(to, static_cast<uint32_t>(data.size()));
    const size_t start = to.size();
    to.insert(to.end(), type, type + 4);
    to.insert(to.end(), data.begin(), data.end());
    append_number(to, static_cast<uint32_t>(crc32(0, to.data() + start, static_cast<uInt>(to.size() - start))));
}

Bytes filtered(const render::Image& image, uint8_t filter) {
    Bytes rows;
    for (uint32_t y = 0; y < image.height; ++y) {
        rows.push_back(filter);
        for (uint32_t x = 0; x < image.width; ++x) {
            for (uint32_t c = 0; c < kChannels; ++c) {
                uint8_t guess = 0;
                if (filter == 1 && x > 0) guess = image.at(x - 1, y)[c];
                if (filter == 2 && y > 0) guess = image.at(x, y - 1)[c];
                rows.push_back(static_cast<uint8_t>(image.at(x, y)[c] - guess));
            }
        }
    }
    return rows;
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

}  // namespace

void write_small_png(const render::Image& image, const std::string& path) {
    // More than this, and the picture gets a palette.
    constexpr size_t kLarge = 290'000;
    Bytes smallest, palette;
    for (const uint8_t filter : kFilters) {
        Bytes bytes = packed(filtered(image, filter));
        if (smallest.empty() || bytes.size() < smallest.size()) smallest = std::move(bytes);
    }
    if (smallest.size() > kLarge) {
        Indexed indexed = with_palette(image);
        Bytes rows;
        for (uint32_t y = 0; y < image.height; ++y) {
            rows.push_back(0);
            const auto row = indexed.pixels.begin() + static_cast<ptrdiff_t>(size_t{y} * image.width);
            rows.insert(rows.end(), row, row + image.width);
        }
        smallest = packed(rows);
        palette = std::move(indexed.palette);
    }
    Bytes header;
    append_number(header, image.width);
    append_number(header, image.height);
    // Bits, RGB or palette, deflate, filters, not interlaced.
    header.insert(header.end(), {8, static_cast<uint8_t>(palette.empty() ? 2 : 3), 0, 0, 0});
    Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(file, "IHDR", header);
    if (!palette.empty()) append_chunk(file, "PLTE", palette);
    append_chunk(file, "IDAT", smallest);
    append_chunk(file, "IEND", {});
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    out.flush();
    if (!out) throw std::runtime_error(path + ": can't be written");
}

}  // namespace flg::gallery
