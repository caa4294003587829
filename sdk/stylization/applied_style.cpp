// SPDX-License-Identifier: MIT
#include "stylization/applied_style.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg {

namespace {

// The first components, so many, are lengths.
uint32_t length_count(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_WIDTH: return 1;
        case FLG_ATTRIBUTE_RADII: return 2;
        default: return 0;
    }
}

uint32_t first_angle(const StyleAttribute& attribute) {
    if (attribute.attribute == FLG_ATTRIBUTE_RADII) return 2;
    return attribute.metric == FLG_METRIC_EUCLIDEAN ? attribute.components : 0;
}

}  // namespace

const AppliedAttribute* AppliedStyle::find(FlgAttribute attribute) const {
    const auto place = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const auto& other) { return other.attribute == attribute; });
    return place == attributes.end() ? nullptr : &*place;
}

AppliedStyleKernel::AppliedStyleKernel(const PreparedStyle& style, double scale, const std::array<double, 9>& basis,
                                       Memory* memory)
    : style_(style),
      scale_(scale),
      scaled_basis_(scale * Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(basis.data())),
      result_(memory) {
    const uint32_t count = style.point_count();
    result_.displacement = Buffer<Vec3>(count, memory);
    for (const StyleAttribute& attribute : style.attributes) {
        const bool half_turn = attribute.metric == FLG_METRIC_PROJECTIVE;
        result_.attributes.push_back({.attribute = attribute.attribute,
                                      .components = attribute.components,
                                      .first_angle = first_angle(attribute),
                                      .period_rad = half_turn ? std::numbers::pi : 2 * std::numbers::pi,
                                      .values = Buffer<float>(size_t{count} * attribute.components, memory)});
    }
    if (result_.find(FLG_ATTRIBUTE_ANGLE)) result_.turns = Buffer<AppliedStyle::Turn>(count, memory);
}

bool AppliedStyleKernel::run(uint32_t n) {
    const uint32_t count = style_.point_count();
    const uint32_t end = done_ + std::min(n, count - done_);
    for (; done_ < end; ++done_) apply_point(done_);
    return done_ == count;
}

void AppliedStyleKernel::apply_point(uint32_t node) {
    const Displacement& d = style_.displacement;
    std::construct_at(&result_.displacement[node],
                      scaled_basis_ * Vec3(d.along_tangent[node], d.along_normal[node], d.along_binormal[node]));
    for (size_t i = 0; i < result_.attributes.size(); ++i) {
        AppliedAttribute& applied = result_.attributes[i];
        const float* from = style_.attributes[i].values.data() + size_t{node} * applied.components;
        float* to = applied.values.data() + size_t{node} * applied.components;
        const uint32_t lengths = length_count(applied.attribute);
        for (uint32_t k = 0; k < applied.components; ++k) {
            to[k] = k < lengths ? static_cast<float>(scale_ * from[k]) : from[k];
        }
        if (applied.attribute == FLG_ATTRIBUTE_ANGLE) {
            const double angle_rad = *from;
            result_.turns[node] = {std::cos(angle_rad), std::sin(angle_rad)};
        }
    }
}

}  // namespace flg
