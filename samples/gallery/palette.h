// SPDX-License-Identifier: MIT
// 256 colours for a picture: busy ones pack into a third of the bytes then.
#pragma once

#include <cstdint>
#include <vector>

#include "filigree_renderer/image.h"

namespace flg::gallery {

struct Indexed {
    std::vector<uint8_t> palette;  // RGB, at most 256 colours
    std::vector<uint8_t> pixels;   // a number each
};

// Median cut (Heckbert 1982): the box of colours with the largest spread times pixels is halved at its median until there are 256.
Indexed with_palette(const render::Image& image);

}  // namespace flg::gallery
