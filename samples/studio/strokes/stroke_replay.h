// SPDX-License-Identifier: MIT
// Draws a layer's strokes again, one after the other, as they were drawn: sample by sample, at their times, through the
// live pen.
#pragma once

#include "strokes/live_pen.h"

namespace flg::studio {

class StrokeReplay {
public:
    StrokeReplay(AppContext& app, StyleCache& style_cache) : app_(app), style_cache_(style_cache) {}

    // `speed`: times as fast as the hand was.
    void start(const StrokeLayer& layer, float speed);
    void stop();
    // Pushes what is due.
    void update(const StrokeDocument& document);
    // The layer that is being replayed; 0: none.
    uint32_t layer() const { return layer_; }
    void device_lost();

private:
    AppContext& app_;
    StyleCache& style_cache_;
    uint32_t layer_ = 0;
    float speed_ = 1.0f;
    size_t stroke_ = 0, sample_ = 0;
    double stroke_start_s_ = 0.0;
    std::vector<std::unique_ptr<LivePen>> pens_;  // one a stroke: what is drawn stays
};

}  // namespace flg::studio
