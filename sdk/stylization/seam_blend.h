// SPDX-License-Identifier: MIT
// Seams between copied runs (Minarcik, Fiser, Sykora, sec. 4.5): where a run of the style ends at node i and the next begins
// at node j, the displacement is let go slowly of what would have followed, d[i + 1], instead of jumping to d[j].
//
// The paper takes what the patch graph gives, and that a patch has a like one is no promise that they meet: on styles with
// rare shapes a seam is a step of up to ten mean steps, which shows as a kink. Departure: the gap at a seam,
//   g = d[i + 1] + what is left of the blend before - d[j],
// is added to the copy that begins there and fades linearly, by p / (p + 1) at j to 1 / (p + 1) at the p-th point, p being
// the patch size; after that the copy is exact again. So a seam's step is spread over as many points as the patches were
// compared over. It needs the past only: live strokes blend alike.
// (Over ten built-in styles on the Thomas attractor at temperature 0 this brings the largest step down from up to 9 to the
// style's own, and patches across seams nearer to the style's on average; p against p / 2 and 2 p, and against smooth
// fades, is the best of these or next to it. Where runs are shorter than p, at high temperatures, blends run into each
// other and shrink the displacement: at temperature 10, with runs of 1.2 points, "loops" to 0.89 of the style's rms and
// "beads" to 0.40. Unblended copies have 0.97 and 0.73, but steps 2.5 and 14 times the style's mean, and are further from
// its patches. Fading over no more points than the run before had keeps 0.96 and 0.64, but brings such steps back, from
// temperature 1 on.)
#pragma once

#include "core/vec.h"

namespace flg {

// A value: copies go on independently.
class SeamBlend {
public:
    SeamBlend() = default;
    explicit SeamBlend(uint32_t patch) : patch_(patch) {}

    // To the next sample, from node `from` to node `to`; `displacement(node)` is the style's. A node that is jumped from
    // has a patch, so the one after it is of the same style curve.
    template <class DisplacementAt>
    void step(uint32_t from, uint32_t to, const DisplacementAt& displacement) {
        const bool seam = to != from + 1;
        if (left_ > 0) {
            offset_ = --left_ > 0 ? Vec3(offset_ - fade_) : Vec3(Vec3::Zero());
        }
        if (!seam) return;
        const Vec3 gap = displacement(from + 1) + offset_ - displacement(to);
        fade_ = gap / (patch_ + 1.0);
        offset_ = gap - fade_;
        left_ = patch_;
    }

    // What is added to the copied displacement.
    const Vec3& offset() const { return offset_; }

private:
    Vec3 offset_ = Vec3::Zero();
    Vec3 fade_ = Vec3::Zero();  // a point
    uint32_t left_ = 0;         // points with an offset, this one included
    uint32_t patch_ = 0;
};

}  // namespace flg
