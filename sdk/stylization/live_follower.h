// SPDX-License-Identifier: MIT
// How a live stroke copies one style, point by point.
//
// Departure from synthesis: there is no last sample to aim at, so a run never goes on to the style's end instead of
// jumping (StyleWalk is told of more samples than there can be). Only a stroke that is drawn again, once it has ended,
// knows its end, and can have the style's end cap.
#pragma once

#include <Eigen/Core>

#include "stylization/live_settings.h"
#include "stylization/seam_blend.h"
#include "stylization/synthesis.h"

namespace flg {

// A value: copies go on independently.
struct FollowedStyle {
    StyleWalk walk;
    SeamBlend blend;
};

// What doesn't change along the stroke.
class LiveFollower {
public:
    LiveFollower() = default;
    LiveFollower(const LiveSettings& settings, const LiveStyle& style);

    const PreparedStyle& style() const { return *style_.style; }
    double scale() const { return style_.scale; }
    // What the style's radii are measured by: their mean.
    double radius_unit() const { return radius_unit_; }
    // At the stroke's first point.
    FollowedStyle begin() const;
    // To the next one, the stroke's `point` by the style's count.
    void advance(FollowedStyle& at, uint32_t point, const Steered& steered) const {
        const uint32_t from = at.walk.node();
        if (style_.point_count > 0) [[unlikely]]
            lead_home(at);
        if (!at.walk.advance(steered.is_hot(seed_, 0, point))) refuse();
        at.blend.step(from, at.walk.node(), [this](uint32_t node) { return displacement_of(node); });
    }
    // Metres along tangent, first and second normal, but for what is left of a seam.
    Vec3 displacement_of(uint32_t node) const { return fitted(basis_, style_.style->displacement, node); }
    Vec3 displacement(const FollowedStyle& at) const { return displacement_of(at.walk.node()) + at.blend.offset(); }

private:
    void lead_home(FollowedStyle& at) const;
    [[noreturn]] static void refuse();

    LiveStyle style_;
    Eigen::Matrix3d basis_ = Eigen::Matrix3d::Identity();  // with the scale
    double radius_unit_ = 1;
    uint64_t seed_ = 1;
    bool from_start_ = true;
};

}  // namespace flg
