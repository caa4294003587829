// SPDX-License-Identifier: MIT
#include "panels/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace flg::panels {
namespace {

struct Entry {
    std::array<uint8_t, 3> color;
    uint32_t pixels;
};

// Entries first to last - 1.
struct Box {
    size_t first, last;
    int axis;
    double weight;  // spread along the axis, times pixels
};

Box measured(const std::vector<Entry>& entries, size_t first, size_t last) {
    Box box = {first, last, 0, 0.0};
    uint64_t pixels = 0;
    for (size_t i = first; i < last; ++i) pixels += entries[i].pixels;
    int widest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax_element(
            entries.begin() + static_cast<std::ptrdiff_t>(first), entries.begin() + static_cast<std::ptrdiff_t>(last),
            [=](const Entry& a, const Entry& b) { return a.color[axis] < b.color[axis]; });
        const int spread = high->color[axis] - low->color[axis];
        if (spread > widest) widest = spread, box.axis = axis;
    }
    // A wide box of few pixels matters as well: small bright things are what one looks at.
    box.weight = widest * std::sqrt(static_cast<double>(pixels));
    return box;
}

}  // namespace

Indexed with_palette(const render::Image& image, size_t colors) {
    std::map<std::array<uint8_t, 3>, uint32_t> numbers;
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        ++numbers[{image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]}];
    }
    std::vector<Entry> entries;
    for (const auto& [color, pixels] : numbers) entries.push_back({color, pixels});
    std::vector<Box> boxes = {measured(entries, 0, entries.size())};
    while (boxes.size() < colors) {
        const auto largest = std::max_element(boxes.begin(), boxes.end(),
                                              [](const Box& a, const Box& b) { return a.weight < b.weight; });
        if (largest->weight == 0.0) break;
        const Box box = *largest;
        const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(box.first),
                   end = entries.begin() + static_cast<std::ptrdiff_t>(box.last);
        std::sort(begin, end, [&](const Entry& a, const Entry& b) {
            return a.color[box.axis] != b.color[box.axis] ? a.color[box.axis] < b.color[box.axis] : a.color < b.color;
        });
        uint64_t all = 0, before = 0;
        for (size_t i = box.first; i < box.last; ++i) all += entries[i].pixels;
        size_t middle = box.first;
        while (middle + 1 < box.last && 2 * before < all) before += entries[middle++].pixels;
        middle = std::clamp(middle, box.first + 1, box.last - 1);
        *largest = measured(entries, box.first, middle);
        boxes.push_back(measured(entries, middle, box.last));
    }
    Indexed indexed;
    std::map<std::array<uint8_t, 3>, uint8_t> index;
    for (size_t b = 0; b < boxes.size(); ++b) {
        std::array<uint64_t, 3> sum = {};
        uint64_t pixels = 0;
        for (size_t i = boxes[b].first; i < boxes[b].last; ++i) {
            for (size_t c = 0; c < 3; ++c) sum[c] += uint64_t{entries[i].color[c]} * entries[i].pixels;
            pixels += entries[i].pixels;
            index[entries[i].color] = static_cast<uint8_t>(b);
        }
        for (const uint64_t s : sum) indexed.palette.push_back(static_cast<uint8_t>((s + pixels / 2) / pixels));
    }
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        indexed.pixels.push_back(index[{image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]}]);
    }
    return indexed;
}

}  // namespace flg::panels
