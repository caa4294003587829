// SPDX-License-Identifier: MIT
// PNG (ISO/IEC 15948), 8 bits of RGB, one filter for all rows, whichever packs best; with a palette where that is
// large.
#include "panels/small_png.h"

#include "panels/palette.h"
#include "panels/png_chunks.h"

namespace flg::panels {
namespace {

constexpr uint32_t kChannels = 3;
// None, left, above.
constexpr uint8_t kFilters[] = {0, 1, 2};

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

}  // namespace

void write_small_png(const render::Image& image, const std::string& path) {
    // More than this, and the picture gets a palette.
    constexpr size_t kLarge = 420'000;
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
    PngChunks file(image.width, image.height, !palette.empty());
    if (!palette.empty()) file.append("PLTE", palette);
    file.append("IDAT", smallest);
    file.write(path);
}

}  // namespace flg::panels
