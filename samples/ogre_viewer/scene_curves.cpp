// SPDX-License-Identifier: MIT
#include "scene_curves.h"

namespace viewer {

filigree::CurveSet curve_set(filigree::Context& context, const std::vector<flg::scenes::Curve>& curves) {
    std::vector<uint32_t> offsets = {0};
    std::vector<flg::scenes::Point> points;
    std::vector<float> radii;
    std::vector<flg::scenes::Color> colours;
    for (const flg::scenes::Curve& curve : curves) {
        points.insert(points.end(), curve.points.begin(), curve.points.end());
        radii.insert(radii.end(), curve.radii.begin(), curve.radii.end());
        colours.insert(colours.end(), curve.points.size(), curve.color);
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &points[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, colours[0].data(), 0, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(curves.size());
    view.curve_offsets = offsets.data();
    view.columns = columns;
    view.column_count = radii.size() == points.size() ? 3 : 2;
    return context.curve_set(view);
}

}  // namespace viewer
