// SPDX-License-Identifier: MIT
// Draws with a controller: while its trigger is pressed samples go to a live stroke, and the points that each makes to
// a curve that grows in the renderer. Behind them is the stroke's tip, until the next sample, so that what is seen is
// where the controller is.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree_live.h"
#include "filigree_renderer/renderer.h"
#include "live_strokes/xr_source.h"
#include "support/curve_source.h"

namespace flg::samples {

// What a frame has added.
struct Added {
    uint32_t samples = 0;
    uint32_t points = 0;
    uint32_t strokes = 0;  // that were changed
    uint32_t tips = 0;     // points of provisional ends, taken off again with the next sample
    double push_us = 0;    // of the frame's pushes
};

class Painter {
public:
    // Makes the context and prepares the style, whose displacement will be `displacement` metres; returns when it is
    // ready. Throws std::runtime_error.
    Painter(render::Renderer& renderer, const CurveSource& style, float displacement);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // Takes the controller's state; once a frame.
    Added paint(const XrController& controller, double time_s);
    // A tick of the SDK; strokes whose end has been worked out get it. Returns what the SDK says of the tick.
    FlgFrameReport tick(Added& in_out_added);

    uint32_t stroke_count() const { return stroke_count_; }
    uint64_t point_count() const { return point_count_; }

private:
    struct Stroke {
        FlgLiveStroke live = {};
        FlgJob ending = {};
        render::CurvesId curve;
        uint32_t points = 0;  // in the curve, the tip's not counted
    };
    void begin();
    void push(const XrController& controller, double time_s, Added& added);
    void end();
    void append(Stroke& stroke, const FlgCurveSetView& view, Added& added);
    void show_tip(const Stroke& stroke, Added& added);

    render::Renderer& renderer_;
    FlgContext context_{};
    FlgLiveStrokeDesc desc_ = {};
    Stroke stroke_;
    bool pressed_ = false;
    std::vector<Stroke> ending_;
    uint32_t stroke_count_ = 0;
    uint64_t point_count_ = 0;
};

}  // namespace flg::samples
