// SPDX-License-Identifier: MIT
#include "stylization/live_follower.h"

#include "core/failure.h"

namespace flg {

namespace {

double mean_radius(const PreparedStyle& style) {
    for (const StyleAttribute& attribute : style.attributes) {
        if (attribute.attribute != FLG_ATTRIBUTE_RADIUS) continue;
        double sum = 0;
        for (float value : attribute.values) sum += value;
        return sum > 0 ? sum / static_cast<double>(attribute.values.size()) : 1.0;
    }
    return 1;
}

}  // namespace

LiveFollower::LiveFollower(const LiveSettings& settings, const LiveStyle& style)
    : style_(style),
      basis_(scaled_basis(style.scale, settings.basis)),
      radius_unit_(mean_radius(*style.style)),
      seed_(settings.seed),
      from_start_(settings.from_start) {}

FollowedStyle LiveFollower::begin() const {
    const bool has_end = style_.point_count > 1;
    FollowedStyle at;
    at.walk = StyleWalk(style_.trees, from_start_, seed_, 0, has_end ? style_.point_count : StyleWalk::endless);
    at.walk.heat(style_.hot_trees);
    at.walk.begin_with_cap();
    if (has_end) at.walk.end_with_cap();
    at.blend = SeamBlend(style().graph.patch, fitted_bend(basis_, style()), style().attributes);
    return at;
}

// Kept out of what strokes run through while they are drawn.
[[gnu::noinline]] void LiveFollower::lead_home(FollowedStyle& at) const {
    if (!at.walk.turns_home()) return;
    at.walk.go_home(style_.point_count - 1, style_.displacement, at.blend);
}

void LiveFollower::refuse() {
    throw Failure(FLG_ERROR_INTERNAL, "a live stroke's path tree is missing");
}

}  // namespace flg
