// SPDX-License-Identifier: MIT
#include "stylization/applied_style.h"

#include <algorithm>

namespace flg {

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
          .displacement = Buffer<Vec3>(style.point_count(), memory), .attributes = style.attributes, .scale = scale} {}

bool AppliedStyleKernel::run(uint32_t n) {
    const uint32_t count = style_.point_count();
    const uint32_t end = done_ + std::min(n, count - done_);
    const Displacement& d = style_.displacement;
    for (; done_ < end; ++done_) {
        std::construct_at(&result_.displacement[done_],
                          scaled_basis_ * Vec3(d.along_tangent[done_], d.along_normal[done_], d.along_binormal[done_]));
    }
    return done_ == count;
}

}  // namespace flg
