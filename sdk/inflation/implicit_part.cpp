// SPDX-License-Identifier: MIT
#include "inflation/implicit_part.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double not_even = 1e-3;  // how far axes may be from right angles and one length

struct FieldSample {
    double value, x, y;
};

// Cubic interpolation (Catmull, Rom 1974) between values 1 and 2, and its slope.
void weights(double t, double (&value)[4], double (&slope)[4]) {
    const double t2 = t * t, t3 = t2 * t;
    value[0] = 0.5 * (-t3 + 2 * t2 - t);
    value[1] = 0.5 * (3 * t3 - 5 * t2 + 2);
    value[2] = 0.5 * (-3 * t3 + 4 * t2 + t);
    value[3] = 0.5 * (t3 - t2);
    slope[0] = 0.5 * (-3 * t2 + 4 * t - 1);
    slope[1] = 0.5 * (9 * t2 - 10 * t);
    slope[2] = 0.5 * (-9 * t2 + 8 * t + 1);
    slope[3] = 0.5 * (3 * t2 - 2 * t);
}

FieldSample field(const PartRaster& raster, double u, double v) {
    // In cells; at the edge of the raster the last whole cell goes on.
    const double x = (u - raster.origin.x) / raster.spacing, y = (v - raster.origin.y) / raster.spacing;
    const double inner_x = std::clamp(x, 1.0, raster.width - 2.0), inner_y = std::clamp(y, 1.0, raster.height - 2.0);
    const auto column = std::min(static_cast<uint32_t>(inner_x), raster.width - 3),
               row = std::min(static_cast<uint32_t>(inner_y), raster.height - 3);
    double wx[4], sx[4], wy[4], sy[4];
    weights(inner_x - column, wx, sx);
    weights(inner_y - row, wy, sy);
    FieldSample result{0, 0, 0};
    for (uint32_t j = 0; j < 4; ++j) {
        const double* values = &raster.values[size_t{raster.width} * (row + j - 1) + column - 1];
        const double along = (wx[0] * values[0] + wx[1] * values[1]) + (wx[2] * values[2] + wx[3] * values[3]);
        const double slope = (sx[0] * values[0] + sx[1] * values[1]) + (sx[2] * values[2] + sx[3] * values[3]);
        result.value += wy[j] * along;
        result.x += wy[j] * slope;
        result.y += sy[j] * along;
    }
    result.x /= raster.spacing;
    result.y /= raster.spacing;
    const double ex = (x - inner_x) * raster.spacing, ey = (y - inner_y) * raster.spacing;
    if (ex != 0 || ey != 0) {
        // Beyond the raster it goes on falling as a ball's does.
        const double beyond = std::hypot(ex, ey), steep = std::hypot(result.x, result.y);
        result.value -= beyond * (beyond + steep);
        result.x -= ex / beyond * (2 * beyond + steep);
        result.y -= ey / beyond * (2 * beyond + steep);
    }
    return result;
}

}  // namespace

ImplicitPart::ImplicitPart(const PlacedPart& placed, uint32_t number)
    : part_(placed.part), thickness_(placed.thickness) {
    const auto& m = placed.placement;
    matrix_ << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    origin_ = Vec3(m[3], m[7], m[11]);
    const double determinant = matrix_.determinant();
    scale_ = std::cbrt(std::fabs(determinant));
    if (!std::isfinite(determinant) || !origin_.allFinite() || !(scale_ > 0) ||
        !((matrix_.transpose() * matrix_ - scale_ * scale_ * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
          not_even * scale_ * scale_))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "part %u: its placement is not a rotation, one scale above 0 and a translation", number);
    if (!(thickness_ > 0) || !std::isfinite(thickness_))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "part %u: its thickness is %g, not above 0", number, thickness_);
    inverse_ = matrix_.inverse();
    const double highest = part_->highest / part_->thickness;
    radius_ = scale_ * highest * std::min(thickness_, std::sqrt(0.5));
    const PartRaster& raster = part_->raster;
    const double depth = thickness_ * highest;
    for (uint32_t i = 0; i < 8; ++i) {
        // Two of the raster's cells around the contour; as much above and below.
        const double around = 2 * raster.spacing;
        const Vec3 corner =
            place(Vec3(raster.origin.x + ((i & 1) ? raster.spacing * (raster.width - 1) - around / 2 : around / 2),
                       raster.origin.y + ((i & 2) ? raster.spacing * (raster.height - 1) - around / 2 : around / 2),
                       (i & 4) ? depth + around : -depth - around));
        low_ = i == 0 ? corner : Vec3(low_.cwiseMin(corner));
        high_ = i == 0 ? corner : Vec3(high_.cwiseMax(corner));
    }
}

ImplicitPart::Sample ImplicitPart::sample(const Vec3& p) const {
    const Vec3 local = inverse_ * (p - origin_);
    const FieldSample g = field(part_->raster, local.x(), local.y());
    const double squared = thickness_ * thickness_, w = local.z();
    const double value = squared * g.value - w * w;
    const Vec3 gradient(squared * g.x, squared * g.y, -2 * w);
    const double steep_squared = gradient.squaredNorm(), steep = std::sqrt(steep_squared);
    const double sum = steep + std::sqrt(std::max(0.0, steep_squared + 4 * value));
    // Both are 0 only where F is 0 and flat: nowhere but at points.
    if (!(sum > 0)) return {value < 0 ? -scale_ * std::sqrt(-value) : 0, Vec3::Zero()};
    return {scale_ * 2 * value / sum, steep > 0 ? Vec3(matrix_ * gradient / (scale_ * steep)) : Vec3(Vec3::Zero())};
}

}  // namespace flg
