// SPDX-License-Identifier: MIT
// Steering along the way: what columns of a target, or the hand that draws it, make of magnitude, scale, temperature
// and radius from point to point.
//
// Each point of a target has its Steered values; in between they go evenly, so that a constant column steers to the bit
// like a constant. Scales make the steps longer and shorter that samples are apart (curves/step_scale): a sample stays
// one point of the style, whose waves and displacements so keep their proportions.
// Temperatures: the path trees of a drive's two temperatures serve all between them. Each sample's hop is the one or
// the other tree's, by chance, in proportion to the `heat`.
#pragma once

#include <array>
#include <span>

#include "curves/curve_set.h"
#include "runtime/task.h"

namespace flg {

constexpr uint32_t style_drives_max = 8;

// At one place of a target. As it is by default, nothing changes, to the bit.
struct Steered {
    float magnitude = 1, scale = 1, radius = 1;  // factors
    float heat = 0;                              // 0: paths of a drive's temperature `at_from`, 1: of its `at_to`

    // On the displacement.
    double weight() const { return double{magnitude} * double{scale}; }
    // On an attribute's lengths.
    double size(FlgAttribute attribute) const {
        return attribute == FLG_ATTRIBUTE_RADIUS ? double{scale} * double{radius} : double{scale};
    }
    // With t from 0 to 1.
    Steered between(const Steered& next, float t) const {
        return {magnitude + t * (next.magnitude - magnitude), scale + t * (next.scale - scale),
                radius + t * (next.radius - radius), heat + t * (next.heat - heat)};
    }
    // Whether sample `index` of a stroke goes by the second temperature; `item` is the stroke's key.
    bool is_hot(uint64_t seed, uint64_t item, uint32_t index) const;
};

// The host's drives, which have been checked.
class StyleDrives {
public:
    StyleDrives() = default;
    explicit StyleDrives(std::span<const FlgStyleDrive> drives);

    bool empty() const { return count_ == 0; }
    std::span<const FlgStyleDrive> list() const { return {drives_.data(), count_}; }
    bool drive(FlgStyleDriven driven) const;
    bool drive_by(FlgAttribute attribute) const;
    // `otherwise` twice if no temperature is driven.
    std::array<float, 2> temperatures(float otherwise) const;
    // The largest size of a factor.
    double largest(FlgStyleDriven driven) const;
    // `value_of(k)` is what drive k is driven by.
    // But for those of one kind.
    StyleDrives without(FlgStyleDriven driven) const;
    // Which style the one drive of the style says; 0 without one.
    template <class ValueOf>
    float style(const ValueOf& value_of) const {
        for (uint32_t k = 0; k < count_; ++k) {
            if (drives_[k].driven == FLG_STYLE_DRIVEN_STYLE)
                return driven_value(drives_[k], share(drives_[k], value_of(k)));
        }
        return 0;
    }
    template <class ValueOf>
    Steered steer(const ValueOf& value_of) const {
        Steered steered;
        for (uint32_t k = 0; k < count_; ++k) drive(drives_[k], value_of(k), steered);
        return steered;
    }

private:
    // How far a value is from `from` to `to`; 0 to 1.
    static double share(const FlgStyleDrive& drive, float value);
    static float driven_value(const FlgStyleDrive& drive, double share);
    static void drive(const FlgStyleDrive& drive, float value, Steered& steered);

    std::array<FlgStyleDrive, style_drives_max> drives_{};
    uint32_t count_ = 0;
};

// Throws FLG_ERROR_INVALID_ARGUMENT if the target has no column of one float for a drive.
void check_drive_columns(const CurveSet& target, const StyleDrives& drives);

// Metres a second from one place to the next, as floats have it.
float speed_between(const Vec3& from, const Vec3& to, double seconds);

// Of a whole target, one a point; empty if nothing is driven.
struct Steering {
    Buffer<Steered> points;
    Buffer<float> styles;  // which of several; empty if that is not driven
    Buffer<float> scales;  // the same values once more, as samplers take them; empty if no scale is driven
};

// Checks the columns; about 10 ns a point and drive. Where SPEED is no column it is made of TIME: on the way to each
// point from the last one that is elsewhere; at a curve's start that of its first way.
Task<Steering> steer(Pace& pace, const CurveSet& target, const StyleDrives& drives);

}  // namespace flg
