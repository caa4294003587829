// SPDX-License-Identifier: MIT
// Seams between copied runs (Minarcik, Fiser, Sykora, sec. 4.5): where a run of the style ends at node i and the next
// begins at node j, the displacement is let go slowly of what would have followed, d[i + 1], instead of jumping to
// d[j].
//
// The paper takes what the patch graph gives, and that a patch has a like one is no promise that they meet: on styles
// with rare shapes a seam is a step of up to ten mean steps, which shows as a kink. Departure: the gap at a seam,
//   g = d[i + 1] + what is left of the blend before - d[j],
// is added to the copy that begins there and fades linearly, by p / (p + 1) at j to 1 / (p + 1) at the p-th point, p
// being the patch size; after that the copy is exact again. So a seam's step is spread over as many points as the
// patches were compared over. It needs the past only: live strokes blend alike. (Over ten built-in styles on the Thomas
// attractor at temperature 0 this brings the largest step down from up to 9 to the style's own, and patches across
// seams nearer to the style's on average; p against p / 2 and 2 p, and against smooth fades, is the best of these or
// next to it. Where runs are shorter than p, at high temperatures, blends run into each other and shrink the
// displacement: at temperature 10, with runs of 1.2 points, "loops" to 0.89 of the style's rms and "beads" to 0.40.
// Unblended copies have 0.97 and 0.73, but steps 2.5 and 14 times the style's mean, and are further from its patches.
// Fading over no more points than the run before had keeps 0.96 and 0.64, but brings such steps back, from temperature
// 1 on.)
//
// Attributes (sec. 5) are blended alike, each component by its own metric:
// - on a line (R+ and R): the gap is a difference; what comes out is kept within what the style has, so that sizes stay
//   sizes and speeds above 0;
// - on a circle or the projective line (S1, RP1): the gap goes the shorter way, and the whole turns that it leaves out
//   are added to all that follows: angles come out continuous along the curve, however often the style is jumped about
//   in.
#pragma once

#include <array>
#include <span>

#include "core/vec.h"
#include "stylization/style_attributes.h"

namespace flg {

// A value: copies go on independently.
class SeamBlend {
public:
    SeamBlend() = default;
    // The attributes outlive the blend.
    explicit SeamBlend(uint32_t patch, std::span<const StyleAttribute> attributes = {})
        : attributes_(attributes), patch_(patch) {}

    // To the next sample, from node `from` to node `to`; `displacement(node)` is the style's. A node that is jumped
    // from has a patch, so the one after it is of the same style curve.
    template <class DisplacementAt>
    void step(uint32_t from, uint32_t to, const DisplacementAt& displacement) {
        if (left_ > 0) --left_;
        if (to == from + 1) return;
        gap_ = displacement(from + 1) + offset() - displacement(to);
        find_attribute_gaps(from + 1, to);
        left_ = patch_;
    }

    // What is added to the copied displacement.
    Vec3 offset() const { return share() * gap_; }

    // A component of attribute `index` at the node that was stepped to.
    double value(size_t index, uint32_t component, uint32_t node) const {
        const StyleAttribute& attribute = attributes_[index];
        const double copied = attribute.values[size_t{node} * attribute.components + component];
        if (component >= attribute.first_angle()) return copied + wound_rad_[index] + share() * gaps_[index][component];
        if (left_ == 0) return copied;
        const ValueRange range = attribute.ranges[component];
        return std::clamp<double>(copied + share() * gaps_[index][component], range.low, range.high);
    }
    // All components, lengths times `scale`.
    void write(size_t index, uint32_t node, double scale, float* out) const {
        const uint32_t lengths = attributes_[index].length_count();
        for (uint32_t k = 0; k < attributes_[index].components; ++k) {
            out[k] = static_cast<float>((k < lengths ? scale : 1.0) * value(index, k, node));
        }
    }

private:
    double share() const { return left_ / (patch_ + 1.0); }

    // `followed` would have come without the seam.
    void find_attribute_gaps(uint32_t followed, uint32_t to);

    std::span<const StyleAttribute> attributes_;
    Vec3 gap_ = Vec3::Zero();
    std::array<std::array<float, attribute_components_max>, style_attributes_max> gaps_{};
    std::array<double, style_attributes_max> wound_rad_{};  // whole turns since the curve's start; an attribute has one
                                                            // angle at most
    uint32_t left_ = 0;                                     // points with an offset, this one included
    uint32_t patch_ = 0;
};

}  // namespace flg
