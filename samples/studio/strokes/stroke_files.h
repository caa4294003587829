// SPDX-License-Identifier: MIT
// Strokes from files, and results into files.
#pragma once

#include "strokes/stroke_layers.h"

namespace flg::studio {

// Whether the name is one of a file with curves: .tilt, .xyz, .txt, builtin:NAME of the scenes.
bool is_stroke_file(const std::string& path);

// Adds a layer with the file's strokes, placed as `find_place` says, and makes it the active one: in their own colours
// and sizes, those of flat brushes as ribbons, those of a painting program without a style. `next` gets sizes that fit
// them. Whether they have colours of their own. Throws StudioError.
using FindPlace = std::function<render::Placement(const render::Box& strokes)>;
bool import_strokes(StrokeDocument& document, StrokeSettings& next, const FindPlace& find_place,
                    const std::string& path);

// All visible layers that have results, as one file. Throws StudioError.
void export_strokes(const StrokeDocument& document, const StrokeLayers& layers, const Scene& scene,
                    const std::string& path);

}  // namespace flg::studio
