// SPDX-License-Identifier: MIT
// What the frame costs, over the picture: tick and workers against their budgets, the longest chunk and whose it was, the
// queue; what the renderer took, pass by pass, and its memory.
#pragma once

#include <array>

#include "filigree/filigree.h"
#include "filigree_renderer/renderer.h"

namespace flg::studio {

class FrameBudget {
public:
    void add(const FlgFrameReport& report, double frame_ms);
    // A small window in the upper right corner of `viewport`.
    void draw(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const;

private:
    static constexpr size_t kFrames = 120;
    std::array<float, kFrames> tick_us_{}, worker_us_{}, frame_ms_{};
    size_t next_ = 0;
    FlgFrameReport last_{};
    float longest_us_ = 0.0f;  // since the start
    const char* longest_stage_ = "";
};

}  // namespace flg::studio
