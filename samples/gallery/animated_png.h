// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "filigree_renderer/image.h"
#include "panels/png_chunks.h"

namespace flg::gallery {

using namespace panels;

struct Frame {
    render::Image image;
    uint16_t milliseconds;  // that it is shown
};

// Writes an animated PNG that begins again for ever. Frames are of one size; each holds what differs from the one
// before. Programs that know no animation show the first. Throws std::runtime_error.
void write_animated_png(std::span<const Frame> frames, const std::string& path);

}  // namespace flg::gallery
