// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "filigree_renderer/image.h"

namespace flg::studio {

// A .png or .jpg, made smaller by halves until it is no larger than 4096 pixels either way. [any thread] Throws StudioError.
render::Image read_image(const std::string& path);

}  // namespace flg::studio
