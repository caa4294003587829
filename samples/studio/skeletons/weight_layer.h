// SPDX-License-Identifier: MIT
// The drawing's painted strokes on the body as it is now. A new body, or an undone stroke, is painted from its own
// weights again, some dabs a frame; what has no place or joint on it is counted and kept.
#pragma once

#include "skeletons/editor.h"
#include "skeletons/weight_brush.h"

namespace flg::studio {

class WeightLayer {
public:
    explicit WeightLayer(Editor& editor) : editor_(editor) {}

    // Once a frame. `is_shown`: weights are wanted even where nothing is painted.
    void update(bool is_shown);
    bool busy() const;

    // Null until those of the newest body are painted.
    const PaintedWeights* weights() const;
    uint64_t revision() const { return revision_; }  // of the weights

    // A dab of a stroke that is under way, or nothing where it has no place. Then the stroke is the drawing's last.
    void paint(const WeightStroke& stroke, const WeightDab& dab);
    void keep(WeightStroke stroke);
    // The stroke under way has not been.
    void drop() { of_ = 0; }

    // Strokes of which at least one dab has no joint or place.
    size_t lost_count() const { return lost_.size(); }
    void forget_lost();

private:
    // False where its joint or its place is not on this body.
    bool paint_dab(const WeightStroke& stroke, const WeightDab& dab);
    void begin();

    Editor& editor_;
    PaintedWeights weights_;
    uint64_t of_ = 0, revision_ = 0;  // the first: of the body's shape; 0: none
    std::vector<WeightStrokePtr> painted_, lost_;
    size_t next_dab_ = 0;  // of the stroke after `painted_`
    bool is_given_ = true, has_told_ = false;
};

}  // namespace flg::studio
