// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "filigree_renderer/image.h"

namespace flg::studio {

struct ImageSize {
    uint32_t width, height;  // pixels
};
// From the file's head. Throws StudioError.
ImageSize image_size(const std::string& path);

// A .png or .jpg, made smaller by halves until it is no larger than 4096 pixels either way. [any thread] Throws
// StudioError.
render::Image read_image(const std::string& path);

}  // namespace flg::studio
