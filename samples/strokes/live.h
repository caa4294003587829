// SPDX-License-Identifier: MIT
// The frame loop: a tick of the SDK, whatever has become visible goes to the renderer, a frame is drawn.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree.h"
#include "filigree_renderer/renderer.h"
#include "strokes/strokes.h"

namespace flg::samples {

struct FrameLog {
    std::vector<float> tick_us, frame_ms;
    float max_slice_us = 0.0f;
    std::string max_slice_stage;
    uint32_t jobs = 0;
    float busy_ms = 0.0f;  // work on all jobs, over all threads
    uint64_t style_points = 0, target_points = 0, result_points = 0;

    // Writes it as JSON; throws std::runtime_error.
    void write(const std::string& path, uint32_t budget_us, uint32_t workers, const std::string& device) const;
};

// Stylizes the groups as jobs of one context while frames are drawn. Throws std::runtime_error.
class Live {
public:
    Live(uint32_t workers, uint32_t budget_us);
    ~Live();
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    // Starts the jobs: the style from `style`'s first curve, then one for each group.
    void start(const CurveSource& style, std::vector<StrokeGroup>& groups);
    // One frame. False once all that was started is drawn.
    bool frame(render::Renderer& renderer, render::Target& target, const render::Camera& camera);
    // 0 to 1.
    float progress() const;
    // What the jobs made; when frame() has returned false.
    StrokeSet result() const;
    const FrameLog& log() const { return log_; }

private:
    struct Item {
        StrokeGroup* group;
        FlgCurveSet result = {};
        FlgJob job = {};
        uint32_t curves_drawn = 0;
    };

    void start_groups();
    bool show(Item& item, render::Renderer& renderer);

    FlgContext context_{};
    uint32_t budget_us_;
    FlgStyle style_ = {};
    FlgJob style_job_ = {};
    bool style_ready_ = false;
    std::vector<StrokeGroup>* groups_ = nullptr;
    std::vector<Item> items_;
    FrameLog log_;
};

}  // namespace flg::samples
