// SPDX-License-Identifier: MIT
#include "stylization/applied_style.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double coordinate_max = 1e30;  // as curve sets have it

}  // namespace

size_t AppliedStyle::find(FlgAttribute attribute) const {
    const auto place = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const auto& other) { return other.attribute == attribute; });
    return static_cast<size_t>(place - attributes.begin());
}

Eigen::Matrix3d scaled_basis(double scale, const std::array<double, 9>& basis) {
    return scale * Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(basis.data());
}

double fitted_bend(const Eigen::Matrix3d& scaled_basis, const PreparedStyle& style) {
    return style.bend * (scaled_basis.norm() / std::sqrt(3.0));
}

void check_attribute_sizes(const PreparedStyle& style, double scale, double largest_scale) {
    for (const StyleAttribute& attribute : style.attributes) {
        for (uint32_t k = 0; k < attribute.length_count(); ++k) {
            const double largest = largest_scale * attribute.ranges[k].high;
            if (largest <= coordinate_max) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.scale is %g: attribute %d of the style would be %g m, above 1e30", scale,
                          static_cast<int>(attribute.attribute), largest);
        }
    }
}

Task<AppliedStyle> fit_style(Pace& pace, const PreparedStyle& style, double scale, std::array<double, 9> basis,
                             double largest_scale) {
    check_attribute_sizes(style, scale, largest_scale);
    const double growth = largest_scale / scale;
    const Eigen::Matrix3d matrix = scaled_basis(scale, basis);
    AppliedStyle applied;
    applied.displacement = Buffer<Vec3>(style.point_count(), pace.memory());
    for (Buffer<float>& values : applied.along) values = Buffer<float>(style.point_count(), pace.memory());
    applied.attributes = style.attributes;
    applied.scale = scale;
    applied.bend = fitted_bend(matrix, style);
    co_await each(pace, style.point_count(), Cost::tens_of_ns, [&](uint32_t i) {
        const Vec3 scaled = fitted(matrix, style.displacement, i);
        if (!(growth * scaled.cwiseAbs().maxCoeff() <= coordinate_max)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.scale is %g: with desc.basis the style's displacement would be %g m, above 1e30", scale,
                          growth * scaled.norm());
        }
        std::construct_at(&applied.displacement[i], scaled);
        for (size_t c = 0; c < 3; ++c) applied.along[c][i] = static_cast<float>(scaled[static_cast<int>(c)]);
    });
    co_return applied;
}

}  // namespace flg
