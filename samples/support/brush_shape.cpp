// SPDX-License-Identifier: MIT
#include "support/brush_shape.h"

#include <algorithm>

namespace flg::samples {
namespace {

constexpr std::string_view kRound[] = {"Comet", "Disco",    "Icing",  "LightWire", "Lofted",          "NeonPulse",
                                       "Toon",  "TubeFlat", "Spikes", "Wire",      "TubeHighlighter", "TubeMarker"};

}  // namespace

FlgCurveGeometry shape_of_brush(std::string_view brush) {
    const bool round = std::find(std::begin(kRound), std::end(kRound), brush) != std::end(kRound);
    return round ? FLG_CURVE_GEOMETRY_TUBE : FLG_CURVE_GEOMETRY_RIBBON;
}

std::vector<FlgCurveGeometry> shapes_of_strokes(const CurveSource& source) {
    const FlgStroke* strokes = nullptr;
    uint32_t count = 0;
    std::vector<FlgCurveGeometry> shapes;
    if (source.file() == nullptr || flgCurveFileGetStrokes(source.file(), &strokes, &count) != FLG_OK) return shapes;
    for (uint32_t i = 0; i < count; ++i) shapes.push_back(shape_of_brush(strokes[i].brush));
    return shapes;
}

}  // namespace flg::samples
