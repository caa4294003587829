// SPDX-License-Identifier: MIT
// Attributes of a style (Minarcik, Fiser, Sykora, sec. 5): phi at the matched places delta_i, and how it enters the
// distance of patches, whose right-hand side becomes
//   sum over k of  |d[i+k] - d[c+k]|^2 + sum over attributes of (weight * rho_phi(phi[i+k], phi[c+k]))^2.
// Between the example's points values are interpolated by arc length, angles by the shorter way around their circle or
// projective line. Angles come out unwrapped: each is the representative nearest to the one before it, so that what
// follows them along the style never makes a turn of its own.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "curves/curve_set.h"
#include "stylization/patch_matrix.h"

namespace flg {

constexpr uint32_t style_attributes_max = 8;
constexpr uint32_t attribute_components_max = 16;

struct ValueRange {
    float low = HUGE_VALF, high = -HUGE_VALF;
};

// An attribute that the style transfers.
struct StyleAttribute {
    FlgAttribute attribute = FLG_ATTRIBUTE_USER;
    uint32_t components = 0;
    FlgMetric metric =
        FLG_METRIC_EUCLIDEAN;  // never AUTO; of RADII it is the third component's, on a circle unless PROJECTIVE
    double weight = 0;         // metres for a difference of 1
    // One value a point of the guide, `components` floats each: what the style has at the place matched to that point.
    // Angles are not reduced: they may be any finite number of turns.
    Buffer<float> values;
    // What each component's values lie within, over the whole style.
    std::array<ValueRange, attribute_components_max> ranges;

    // The first components, so many, are lengths: they grow with the style.
    uint32_t length_count() const;
    // Components from this one on are angles.
    uint32_t first_angle() const;
    // Length of the circle that a component lies on, radians; 0: on a line.
    double period(uint32_t component) const;
    // Widens the ranges by a point's values.
    void extend_ranges(uint32_t point);
};

// What a style may transfer.
bool can_transfer(int32_t attribute);
// Whether values of so many components can be measured so; `metric` is not AUTO.
bool metric_fits(FlgAttribute attribute, uint32_t components, FlgMetric metric);

// Throws FLG_ERROR_INVALID_ARGUMENT if the example has no column for attribute number `index` of a request, or one that
// the metric does not fit.
void check_attribute_column(const CurveSet& example, const FlgStyleAttribute& wanted, uint32_t index);

// An attribute whose column has been checked, with memory for the values of `points` points.
StyleAttribute make_attribute(const CurveSet& example, const FlgStyleAttribute& wanted, uint32_t points,
                              Memory* memory);

// Takes the values of all attributes along one style curve. `places`: the matched arc lengths, non-decreasing, of the
// guide's points from `first_point` on; `curve` of the example has a length. What is referred to outlives the task.
// About 30 ns a point of example or guide, and 2 ns a component.
Task<void> take_values(Pace& pace, const CurveSet& example, uint32_t curve, std::span<const double> places,
                       uint32_t first_point, std::span<StyleAttribute> attributes);

// Appends the attribute's components as patch distances take them in. `attribute` has a weight above 0.
Task<void> add_channels(Pace& pace, const StyleAttribute& attribute, std::pmr::vector<PatchChannel>& channels);

}  // namespace flg
