// SPDX-License-Identifier: MIT
// Several styles along one live stroke: each is followed from the stroke's start on, whether it counts or not, as in
// style_mix.h; what they displace is mixed point by point.
//
// The points are those of the style whose points are closest together. Between the points of the others their
// displacements along the frame, and their attributes, are interpolated: a point of them need not be known before the
// hand is there. (style_mix interpolates places. Where steps are alike both are the same to the bit; elsewhere they
// differ by what the curve bends within a step of the wider style.) A temperature that is driven is there one step
// earlier, too.
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "stylization/live_follower.h"

namespace flg {

// One of the styles: the last sample of its own that is needed, and the one before.
struct MixedFollower {
    FollowedStyle at;
    uint32_t sample = 0;
    uint32_t node_before = 0;
    Vec3 offset_before = Vec3::Zero();
    std::array<float, style_attributes_max * attribute_components_max> values_before{};
    // Whole turns that are added to its angles, by attribute of the first style.
    std::array<double, style_attributes_max> turns{};
};

// In memory of whoever draws, of one size.
struct LiveMixState {
    LiveChoice* choice = nullptr;
    StyleShares* weights = nullptr;  // at the last point
    std::span<MixedFollower> followers{};

    void copy(const LiveMixState& other) const {
        if (followers.empty()) return;
        std::construct_at(choice, *other.choice);
        std::construct_at(weights, *other.weights);
        std::uninitialized_copy(other.followers.begin(), other.followers.end(), followers.begin());
    }
};

// So many states; none of strokes with one style.
class LiveMixStates {
public:
    LiveMixStates() = default;
    LiveMixStates(uint32_t styles, size_t count, Memory* memory);

    LiveMixState operator[](size_t i);

private:
    uint32_t styles_ = 0;
    Buffer<LiveChoice> choices_;
    Buffer<StyleShares> weights_;
    Buffer<MixedFollower> followers_;
};

class LiveMix {
public:
    LiveMix() = default;
    LiveMix(const LiveSettings& settings, const LiveMixState& state);

    bool empty() const { return count_ == 0; }
    const LiveMixState& state() const { return state_; }

    void begin();
    // The next segment, over which the value that chooses goes evenly.
    void read(float from, float to, double length) { state_.choice->read(from, to, length); }
    // To the stroke's `point`, at t of the segment.
    void go_to(uint32_t point, float t, const Steered& steered);

    // There: metres along tangent, first and second normal.
    const Vec3& displacement() const { return displacement_; }
    // Through the points of all styles, one style behind the other.
    uint32_t node() const { return node_; }
    // Of the first style's attributes; a radius in proportion to the mean.
    const double* values(size_t attribute) const { return &values_[attribute * attribute_components_max]; }

private:
    // Where a point of the stroke lies between two of a style's.
    struct Place {
        bool between = false;
        double t = 1;
    };
    Place follow(uint32_t style, uint32_t point, const Steered& steered);
    void keep_sample(uint32_t style);
    double value(uint32_t style, size_t attribute, uint32_t component) const;
    void take_turns(size_t attribute, const StyleShares& weights);
    void mix_attributes(const StyleShares& weights, const Steered& steered);

    LiveMixState state_;
    uint32_t count_ = 0;
    double blend_ = 1;
    std::array<LiveFollower, styles_max> followers_;
    std::array<double, styles_max> ratios_{};         // a style's samples for one of the stroke
    std::array<uint32_t, styles_max> first_nodes_{};  // in the count through all
    std::array<uint32_t, styles_max> point_counts_{};
    // Where the first style's attributes are among each style's.
    std::array<std::array<uint8_t, style_attributes_max>, styles_max> attributes_{};
    // At the point.
    std::array<Place, styles_max> places_{};
    Vec3 displacement_ = Vec3::Zero();
    uint32_t node_ = 0;
    std::array<double, style_attributes_max * attribute_components_max> values_{};
};

}  // namespace flg
