// SPDX-License-Identifier: MIT
// APNG, as in the third edition of the PNG specification: one palette for all frames, whose last colour is transparent.
#include "gallery/animated_png.h"

#include <algorithm>
#include <stdexcept>

#include "panels/palette.h"
#include "panels/png_chunks.h"

namespace flg::gallery {
namespace {

// Columns left to right - 1, rows top to bottom - 1.
struct Area {
    uint32_t left, top, right, bottom;
};

bool same(const render::Image& a, const render::Image& b, uint32_t x, uint32_t y) {
    return std::equal(a.at(x, y), a.at(x, y) + 3, b.at(x, y));
}

Area changed(const render::Image& before, const render::Image& after) {
    Area area{after.width, after.height, 0, 0};
    for (uint32_t y = 0; y < after.height; ++y) {
        for (uint32_t x = 0; x < after.width; ++x) {
            if (same(before, after, x, y)) continue;
            area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x + 1),
                    std::max(area.bottom, y + 1)};
        }
    }
    // A frame must have a pixel.
    return area.left < area.right ? area : Area{0, 0, 1, 1};
}

}  // namespace

void write_animated_png(std::span<const Frame> frames, const std::string& path) {
    constexpr uint8_t kTransparent = 255;
    if (frames.empty()) throw std::runtime_error(path + ": an animation needs a frame");
    const render::Image& first = frames[0].image;
    std::vector<Area> areas = {{0, 0, first.width, first.height}};
    // All pixels that any frame shows anew, in one row: so they share a palette.
    render::Image shown{0, 1, {}};
    const auto is_new = [&](size_t frame, uint32_t x, uint32_t y) {
        return frame == 0 || !same(frames[frame - 1].image, frames[frame].image, x, y);
    };
    for (size_t i = 0; i < frames.size(); ++i) {
        const render::Image& image = frames[i].image;
        if (image.width != first.width || image.height != first.height) {
            throw std::runtime_error(path + ": frames of an animation have one size");
        }
        if (i > 0) areas.push_back(changed(frames[i - 1].image, image));
        for (uint32_t y = areas[i].top; y < areas[i].bottom; ++y) {
            for (uint32_t x = areas[i].left; x < areas[i].right; ++x) {
                if (is_new(i, x, y)) shown.pixels.insert(shown.pixels.end(), image.at(x, y), image.at(x, y) + 4);
            }
        }
    }
    shown.width = static_cast<uint32_t>(shown.pixels.size() / 4);
    Indexed indexed = with_palette(shown, kTransparent);
    indexed.palette.resize(3 * (size_t{kTransparent} + 1));
    Bytes alphas(kTransparent, 255);
    alphas.push_back(0);

    PngChunks file(first.width, first.height, true);
    Bytes control;
    append_number(control, static_cast<uint32_t>(frames.size()));
    append_number(control, 0);  // for ever
    file.append("acTL", control);
    file.append("PLTE", indexed.palette);
    file.append("tRNS", alphas);
    uint32_t sequence = 0;
    auto pixel = indexed.pixels.begin();
    for (size_t i = 0; i < frames.size(); ++i) {
        const Area& area = areas[i];
        Bytes frame;
        append_number(frame, sequence++);
        append_number(frame, area.right - area.left);
        append_number(frame, area.bottom - area.top);
        append_number(frame, area.left);
        append_number(frame, area.top);
        append_short(frame, frames[i].milliseconds);
        append_short(frame, 1000);
        // It stays, and lies over what was there.
        frame.insert(frame.end(), {0, 1});
        file.append("fcTL", frame);
        Bytes rows;
        for (uint32_t y = area.top; y < area.bottom; ++y) {
            rows.push_back(0);
            for (uint32_t x = area.left; x < area.right; ++x) rows.push_back(is_new(i, x, y) ? *pixel++ : kTransparent);
        }
        if (i == 0) {
            file.append("IDAT", packed(rows));
            continue;
        }
        Bytes data;
        append_number(data, sequence++);
        const Bytes bytes = packed(rows);
        data.insert(data.end(), bytes.begin(), bytes.end());
        file.append("fdAT", data);
    }
    file.write(path);
}

}  // namespace flg::gallery
