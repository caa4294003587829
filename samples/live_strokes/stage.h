// SPDX-License-Identifier: MIT
// What is there besides the strokes: a round floor, and two controllers that follow their poses.
#pragma once

#include "filigree_renderer/renderer.h"
#include "live_strokes/xr_source.h"

namespace flg::samples {

class Stage {
public:
    explicit Stage(render::Renderer& renderer);
    void place(const XrFrame& frame);

private:
    render::Renderer& renderer_;
    render::SurfaceId drawing_, other_;
};

}  // namespace flg::samples
