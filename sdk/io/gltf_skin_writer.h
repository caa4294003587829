// SPDX-License-Identifier: MIT
// Skins as glTF 2.0, binary.
#pragma once

#include <string>

#include "io/checked_skin.h"

namespace flg::io {

std::string write_glb_skin(const CheckedSkin& skin);

}  // namespace flg::io
