// SPDX-License-Identifier: MIT
// Strokes from files, and results into files.
#pragma once

#include "strokes/stroke_layers.h"

namespace flg::studio {

// Whether the name is one of a file with curves: .tilt, .xyz, .txt, builtin:NAME of the scenes.
bool is_stroke_file(const std::string& path);

// Adds a layer with the file's strokes, and makes it the active one: radii and size of the style as they suit them. Throws
// StudioError.
void import_strokes(StrokeDocument& document, const std::string& path);

// All visible layers that have results, as one file. Throws StudioError.
void export_strokes(const StrokeDocument& document, const StrokeLayers& layers, const std::string& path);

}  // namespace flg::studio
