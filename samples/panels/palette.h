// SPDX-License-Identifier: MIT
// A few colours for a picture: busy ones pack into a third of the bytes then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "filigree_renderer/image.h"

namespace flg::panels {

struct Indexed {
    std::vector<uint8_t> palette;  // RGB
    std::vector<uint8_t> pixels;   // a number each
};

// Median cut (Heckbert 1982): the box of colours with the largest spread times pixels is halved at its median until
// there are `colors`, at most 256.
Indexed with_palette(const render::Image& image, size_t colors = 256);

}  // namespace flg::panels
