// SPDX-License-Identifier: MIT
// How large a style is drawn on a curve when nobody says so: the target decides.
//
// A style is learnt from an example, whose guide has a size; a target gets the style in the proportion that the example
// shows. The size of a curve is D (D / L)^(1/3), with D the diagonal of its box and L its length: its length if it is
// straight, the less the more it is wound up. So a style on its own guide has the scale 1.
// Strokes that were painted have a width, which says how fine they are meant: on them the style swings kSwingPerRadius
// radii away, as long as that is no more than the example's proportion, and no less than 1 / kFinest of it.
#pragma once

#include <cstdint>
#include <vector>

#include "filigree/filigree.h"

namespace flg::cli {

struct CurveSize {
    float scale;      // FlgCurveSetStylizeDesc::scale
    float thickness;  // factor on the curve's radii: thinner than painted, so that the style's turns stay apart
};

class RelativeSize {
public:
    // `rms`: how far the style swings away from its guide, metres (FlgStyleInfo::displacement_rms).
    RelativeSize(const FlgCurveSetView& guide, float rms);

    CurveSize of(const FlgCurveSetView& target, uint32_t curve) const;
    // Metres; of curves that have none of their own.
    float radius_at(float scale) const;

private:
    double guide_size_ = 0.0, rms_;
};

// Curves that get the same scale.
struct ScaleGroup {
    float scale;
    std::vector<uint32_t> curves;
};

// By scale, those of half an octave together, each group at the geometric mean of its least and its greatest.
std::vector<ScaleGroup> group_by_scale(const std::vector<CurveSize>& sizes);

}  // namespace flg::cli
