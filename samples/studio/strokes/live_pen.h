// SPDX-License-Identifier: MIT
// The pen while it is down: samples go to a live stroke, and the points that each makes to the renderer, which uploads
// only these. Behind them is the stroke's tip, until the next sample, so that the line ends at the pen.
#pragma once

#include "strokes/stroke_layers.h"

namespace flg::studio {

class LivePen {
public:
    LivePen(AppContext& app, StyleCache& style_cache) : app_(app), style_cache_(style_cache) {}
    ~LivePen() { lift(); }
    LivePen(const LivePen&) = delete;
    LivePen& operator=(const LivePen&) = delete;

    // With the settings, number and colour of `like`, and, if it has been drawn before, its size. While the style is
    // not ready or not warm, the stroke is recorded and not seen.
    void begin(const StrokeDocument& document, const Stroke& like);
    void add(const StrokeSample& sample);
    // What is drawn is on this mesh, which stands there.
    void stand_on(uint32_t mesh, const render::Placement& placement);
    // What was drawn, to where the hand let go: null if it was no more than a dot. It stays on the screen until lift().
    StrokePtr end();
    // Takes what it shows off the screen.
    void lift();

    bool down() const { return down_; }
    bool shows() const { return drawn_.value != 0; }
    const DrawnStroke& stroke() const { return stroke_; }
    void device_lost() { drawn_ = {}; }

private:
    void show(const FlgCurveSetView& made);

    AppContext& app_;
    StyleCache& style_cache_;
    DrawnStroke stroke_;
    filigree::LiveStroke live_;
    render::CurvesId drawn_{};
    uint32_t final_points_ = 0;  // on the screen; behind them is the tip
    bool down_ = false;
};

}  // namespace flg::studio
