// SPDX-License-Identifier: MIT
// What the frame costs, in a corner of the picture: a graph of the last frames, or all of it: tick and workers against
// their budgets, the longest chunk and whose it was, the queue; what the renderer took, pass by pass, and its memory.
#pragma once

#include <array>

#include "filigree/filigree.h"
#include "filigree_renderer/renderer.h"

namespace flg::studio {

class FrameBudget {
public:
    // Of both its windows: what they show changes with every frame.
    static constexpr const char* kWindow = "##budget";

    // `frame_ms`: of the whole frame, of which the tick is a part.
    void add(const FlgFrameReport& report, double frame_ms);
    // Nothing, the graph, everything, and nothing again.
    void show_more() {
        shown_ = shown_ == Shown::nothing ? Shown::graph : shown_ == Shown::graph ? Shown::all : Shown::nothing;
    }
    bool shows() const { return shown_ != Shown::nothing; }
    // In the lower right corner of `viewport`.
    void draw(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const;

private:
    void draw_graph(const glm::ivec4& viewport) const;
    void draw_all(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const;

    enum class Shown { nothing, graph, all } shown_ = Shown::nothing;
    static constexpr size_t kFrames = 120;
    std::array<float, kFrames> tick_us_{}, worker_us_{}, frame_ms_{};
    size_t next_ = 0;
    FlgFrameReport last_{};
    float max_us_ = 0.0f;  // since the start
    const char* max_stage_ = "";
};

}  // namespace flg::studio
