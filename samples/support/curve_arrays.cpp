// SPDX-License-Identifier: MIT
#include "support/curve_arrays.h"

namespace flg::samples {

CurveArrays::CurveArrays(std::span<const scenes::Curve> curves) {
    for (const scenes::Curve& curve : curves) {
        for (size_t i = 0; i < curve.points.size(); ++i) {
            const scenes::Point& p = curve.points[i];
            positions_.insert(positions_.end(), {p.x, p.y, p.z});
            const scenes::Color& color = curve.colors.empty() ? curve.color : curve.colors[i];
            colors_.insert(colors_.end(), color.begin(), color.end());
        }
        radii_.insert(radii_.end(), curve.radii.begin(), curve.radii.end());
        angles_.insert(angles_.end(), curve.angles.begin(), curve.angles.end());
        for (const scenes::Point& n : curve.normals) normals_.insert(normals_.end(), {n.x, n.y, n.z});
        offsets_.push_back(static_cast<uint32_t>(positions_.size() / 3));
        flags_.push_back(curve.closed ? FLG_CURVE_CLOSED : 0);
    }
    columns_ = {{FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0}, {FLG_ATTRIBUTE_COLOR, 4, colors_.data(), 0, 0}};
    const size_t points = offsets_.back();
    if (radii_.size() == points) columns_.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii_.data(), 0, 0});
    if (angles_.size() == points) columns_.push_back({FLG_ATTRIBUTE_ANGLE, 1, angles_.data(), 0, 0});
    if (normals_.size() == 3 * points) columns_.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals_.data(), 0, 0});
}

FlgCurveSetView CurveArrays::view() const {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(flags_.size());
    view.curve_offsets = offsets_.data();
    view.curve_flags = flags_.data();
    view.columns = columns_.data();
    view.column_count = static_cast<uint32_t>(columns_.size());
    return view;
}

}  // namespace flg::samples
