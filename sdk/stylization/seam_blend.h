// SPDX-License-Identifier: MIT
// Seams between copied runs (Minarcik, Fiser, Sykora, sec. 4.5): where a run of the style ends at node i and the next
// begins at node j, the displacement is let go slowly of what would have followed, d[i + 1], instead of jumping to
// d[j].
//
// The paper takes what the patch graph gives, and that a patch has a like one is no promise that they meet: on styles
// with rare shapes a seam is a step of up to ten mean steps, and a turn. Departure: the gaps at a seam in value and in
// step,
//   g = d[i + 1] + what is left of the blend before - d[j],   h = the step to that - (d[j + 1] - d[j]),
// are added to the copy that begins there and fade by Hermite's cubic over n points:
//   (3 r^2 - 2 r^3) g + (1 - r) r^2 n h,   r from 1 at j to 0 at the n-th point behind it;
// from there on the copy is exact again. So a result goes on at a seam where it was and as it went. It needs the past
// only: live strokes blend alike. n is the patch size p, or as many as keep what is added from bending more,
//   6 |g| / n^2 + 4 |h| / n,
// than the style does by itself (root mean square), up to 4 p. Where a blend is not over, n is p. Where runs are
// shorter than p, at high temperatures, blends run into each other and shrink the displacement.
//
// The last seam of a closed curve has to meet the style again at whatever phase of its waves. It is cross-faded: the
// run that is left goes on beside the one that is taken, with weights 3 r^2 - 2 r^3 and the rest, so that nothing
// between two copies goes further than they do.
//
// Attributes (sec. 5) are blended alike, each component by its own metric:
// - on a line (R+ and R): the gap is a difference; what comes out is kept within what the style has, so that sizes stay
//   sizes and speeds above 0;
// - on a circle or the projective line (S1, RP1): the gap goes the shorter way, and the whole turns that it leaves out
//   are added to all that follows: angles come out continuous along the curve, however often the style is jumped about
//   in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/vec.h"
#include "stylization/style_attributes.h"

namespace flg {

// A value: copies go on independently.
class SeamBlend {
public:
    SeamBlend() = default;
    // Over so many points, at least 1, or more where they bend less than `bend`, metres. The attributes outlive the
    // blend.
    explicit SeamBlend(uint32_t points, double bend = 0, std::span<const StyleAttribute> attributes = {})
        : attributes_(attributes), bend_(bend), points_(points) {}

    // To the next sample, from node `from` to node `to`; `displacement(node)` is the style's. A node that is jumped
    // from has one behind it on the same style curve, and so has one that is jumped to.
    template <class DisplacementAt>
    void step(uint32_t from, uint32_t to, const DisplacementAt& displacement) {
        if (to == from + 1) {
            go_on();
            return;
        }
        const Vec3 shown = displacement(from) + offset();
        const Shares shares_at_from = shares_;
        go_on();
        const Vec3 followed = displacement(from + 1) + offset();
        const Vec3 carried = offset();
        const Vec3& copied = displacement(to);
        find_attribute_gaps(from, to, shares_at_from);
        gap_ = followed - copied;
        step_gap_ = (followed - shown) - (displacement(to + 1) - copied);
        fades_ = cross_fades_;
        if (fades_) {
            carried_ = carried;
            left_run_ = {from + 1, curve_end_[from] - 1};
            taken_run_ = {to, curve_end_[to] - 1};
        }
        left_ = span_ = fades_ || left_ > 0 ? points_ : length();
        per_span_ = 1.0 / span_;
        shares_ = {1, 0};
    }
    // The next seam, and all behind it, are cross-faded over so many points. A run whose style curve ends stays at its
    // last point. `displacement` and `curve_end` are the style's, by node, and outlive the blend.
    void cross_fade(uint32_t points, std::span<const Vec3> displacement, std::span<const uint32_t> curve_end) {
        cross_fades_ = true;
        points_ = points;
        faded_ = displacement;
        curve_end_ = curve_end;
    }
    // Seams from the next one on are blended again, over so many points.
    void stop_cross_fading(uint32_t points) {
        cross_fades_ = false;
        points_ = points;
    }
    // To the next sample of the same run.
    void go_on() {
        if (left_ == 0) return;
        --left_;
        const double r = left_ * per_span_;
        shares_ = {r * r * (3 - 2 * r), fades_ ? 0 : r * r * (span_ - left_)};
        if (fades_) gap_ = carried_ + faded_[left_run_.next()] - faded_[taken_run_.next()];
    }

    // Points with an offset, this one included.
    uint32_t points_left() const { return left_; }
    // What is added to the copied displacement.
    Vec3 offset() const {
        if (left_ == 0) return Vec3::Zero();
        return shares_.of_gap * gap_ + shares_.of_step_gap * step_gap_;
    }
    // What is added to a component of attribute `index`, but for whole turns and before it is kept within its range.
    double offset(size_t index, uint32_t component) const { return offset(index, component, shares_); }

    // A component of attribute `index` at the node that was stepped to.
    double value(size_t index, uint32_t component, uint32_t node) const {
        return value(index, component, node, shares_);
    }
    // All components, lengths times `scale`.
    void write(size_t index, uint32_t node, double scale, float* out) const {
        const uint32_t lengths = attributes_[index].length_count();
        for (uint32_t k = 0; k < attributes_[index].components; ++k) {
            out[k] = static_cast<float>((k < lengths ? scale : 1.0) * value(index, k, node));
        }
    }
    // As write(), of nodes from `node` on that are copied as they are: no point is left with an offset.
    void write_run(size_t index, uint32_t node, uint32_t count, double scale, float* out) const {
        const StyleAttribute& attribute = attributes_[index];
        const uint32_t components = attribute.components, lengths = attribute.length_count();
        const uint32_t angle = attribute.first_angle();
        const float* values = attribute.values.data() + size_t{node} * components;
        for (uint32_t k = 0; k < components; ++k) {
            const double factor = k < lengths ? scale : 1.0, wound = k >= angle ? wound_rad_[index] : 0.0;
            for (uint32_t i = 0; i < count; ++i) {
                out[i * components + k] = static_cast<float>(factor * (values[i * components + k] + wound));
            }
        }
    }

private:
    // A run that goes on until its curve ends.
    struct Run {
        uint32_t node = 0, last = 0;
        uint32_t next() { return node = std::min(node + 1, last); }
    };
    // What is left of the gaps.
    struct Shares {
        double of_gap = 0, of_step_gap = 0;
    };

    double offset(size_t index, uint32_t component, const Shares& shares) const {
        const Gap& gap = gaps_[index][component];
        double value = gap.value;
        if (fades_) value += of_style(index, component, left_run_.node) - of_style(index, component, taken_run_.node);
        return shares.of_gap * value + shares.of_step_gap * gap.step;
    }
    double of_style(size_t index, uint32_t component, uint32_t node) const {
        const StyleAttribute& attribute = attributes_[index];
        return attribute.values[size_t{node} * attribute.components + component];
    }
    double value(size_t index, uint32_t component, uint32_t node, const Shares& shares) const {
        const StyleAttribute& attribute = attributes_[index];
        const double copied = of_style(index, component, node);
        if (component >= attribute.first_angle()) {
            return copied + wound_rad_[index] + offset(index, component, shares);
        }
        if (shares.of_gap == 0) return copied;
        const ValueRange range = attribute.ranges[component];
        return std::clamp<double>(copied + offset(index, component, shares), range.low, range.high);
    }
    // Of a blend, so that it bends no more than the style.
    uint32_t length() const {
        constexpr uint32_t max_patches = 4;
        if (!(bend_ > 0)) return points_;
        const double g = gap_.norm(), h = step_gap_.norm();
        const double points = (2 * h + std::sqrt(4 * h * h + 6 * g * bend_)) / bend_;
        if (!(points < max_patches * points_)) return max_patches * points_;
        return std::max(points_, static_cast<uint32_t>(std::ceil(points)));
    }
    void find_attribute_gaps(uint32_t from, uint32_t to, const Shares& shares_at_from);

    struct Gap {
        float value = 0, step = 0;  // of a cross-fade: the value without both runs' own
    };

    std::span<const StyleAttribute> attributes_;
    double bend_ = 0;
    Vec3 gap_ = Vec3::Zero(), step_gap_ = Vec3::Zero();
    std::array<std::array<Gap, attribute_components_max>, style_attributes_max> gaps_{};
    std::array<double, style_attributes_max> wound_rad_{};  // whole turns since the curve's start; an attribute has one
                                                            // angle at most
    std::span<const Vec3> faded_;          // the style's displacements, if the next seam is cross-faded
    std::span<const uint32_t> curve_end_;  // likewise
    Run left_run_, taken_run_;             // of the cross-fade that there is
    Vec3 carried_ = Vec3::Zero();          // what was left of the blend before it
    bool cross_fades_ = false;             // the seams to come are
    bool fades_ = false;                   // the seam's blend is a cross-fade
    Shares shares_;
    double per_span_ = 1;
    uint32_t left_ = 0;
    uint32_t span_ = 1;    // of the blend that there is
    uint32_t points_ = 1;  // of those to come
};

}  // namespace flg
