// SPDX-License-Identifier: MIT
// The pen while it is down: samples go to a live stroke, and the points that each makes to the renderer, which uploads only these.
#pragma once

#include "strokes/stroke_layers.h"

namespace flg::studio {

class LivePen {
public:
    LivePen(Desk& desk, StyleShelf& shelf) : desk_(desk), shelf_(shelf) {}
    ~LivePen() { lift(); }
    LivePen(const LivePen&) = delete;
    LivePen& operator=(const LivePen&) = delete;

    // `number`: of the stroke in its layer, which chooses its random numbers. While the style is not ready or not warm, the
    // stroke is recorded and not seen.
    void begin(const StrokeDocument& document, const StrokeSettings& settings, uint32_t number,
               const std::optional<glm::vec3>& color);
    void add(const StrokeSample& sample);
    // What was drawn: null if it was no more than a dot. It stays on the screen until lift().
    StrokePtr end();
    // Takes what it shows off the screen.
    void lift();

    bool down() const { return down_; }
    bool shows() const { return drawn_.value != 0; }
    const DrawnStroke& stroke() const { return stroke_; }
    void device_lost() { drawn_ = {}; }

private:
    Desk& desk_;
    StyleShelf& shelf_;
    DrawnStroke stroke_;
    filigree::LiveStroke live_;
    render::CurvesId drawn_{};
    bool down_ = false;
};

}  // namespace flg::studio
