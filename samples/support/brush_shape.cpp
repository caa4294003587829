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
    std::vector<FlgCurveGeometry> shapes;
    FlgStroke stroke = flgStrokeDefaults();
    for (uint32_t i = 0; source.file() && flgCurveFileGetStroke(source.file(), i, &stroke) == FLG_OK; ++i) {
        shapes.push_back(shape_of_brush(stroke.brush));
    }
    return shapes;
}

}  // namespace flg::samples
