// SPDX-License-Identifier: MIT
#include "stylization/applied_style.h"

#include <algorithm>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double coordinate_max = 1e30;  // as curve sets have it

}  // namespace

size_t AppliedStyle::find(FlgAttribute attribute) const {
    const auto place = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const auto& other) { return other.attribute == attribute; });
    return static_cast<size_t>(place - attributes.begin());
}

AppliedStyleKernel::AppliedStyleKernel(const PreparedStyle& style, double scale, const std::array<double, 9>& basis,
                                       Memory* memory)
    : style_(style),
      scaled_basis_(scale * Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(basis.data())),
      result_{
          .displacement = Buffer<Vec3>(style.point_count(), memory), .attributes = style.attributes, .scale = scale} {
    for (const StyleAttribute& attribute : style.attributes) {
        for (uint32_t k = 0; k < attribute.length_count(); ++k) {
            if (scale * attribute.ranges[k].high <= coordinate_max) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.scale is %g: attribute %d of the style would be %g m, above 1e30", scale,
                          static_cast<int>(attribute.attribute), scale * attribute.ranges[k].high);
        }
    }
}

bool AppliedStyleKernel::run(uint32_t n) {
    const uint32_t count = style_.point_count();
    const uint32_t end = done_ + std::min(n, count - done_);
    const Displacement& d = style_.displacement;
    for (; done_ < end; ++done_) {
        const Vec3 scaled =
            scaled_basis_ * Vec3(d.along_tangent[done_], d.along_normal[done_], d.along_binormal[done_]);
        if (!(scaled.cwiseAbs().maxCoeff() <= coordinate_max)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.scale is %g: with desc.basis the style's displacement would be %g m, above 1e30",
                          result_.scale, scaled.norm());
        }
        std::construct_at(&result_.displacement[done_], scaled);
    }
    return done_ == count;
}

}  // namespace flg
