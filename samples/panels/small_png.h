// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "filigree_renderer/image.h"

namespace flg::panels {

// Writes a PNG without alpha, packed as tightly as zlib can: about half the size of render::write_png's, for ten
// times its time. Throws std::runtime_error.
void write_small_png(const render::Image& image, const std::string& path);

}  // namespace flg::panels
