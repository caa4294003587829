// SPDX-License-Identifier: MIT
// The list of brushes in the metadata of .tilt sketches.
#pragma once

#include <string>
#include <vector>

#include "io/file_bytes.h"

namespace flg::io {

// GUIDs of the brushes that strokes name by number. `part`: the metadata's name within the sketch, for failures.
std::vector<std::string> read_brush_index(Bytes metadata, const std::string& part);

}  // namespace flg::io
