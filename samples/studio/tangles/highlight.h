// SPDX-License-Identifier: MIT
// Lines on a mesh that show which regions are meant: hidden by what lies before them, as thick near as far.
#pragma once

#include <span>

#include "filigree_renderer/renderer.h"
#include "tangles/region_outline.h"

namespace flg::studio {

class Highlight {
public:
    Highlight(render::Renderer& renderer, const glm::vec3& color, float width)
        : renderer_(renderer), color_(color), width_(width) {}
    ~Highlight() { clear(); }
    Highlight(const Highlight&) = delete;
    Highlight& operator=(const Highlight&) = delete;

    // Loops of a mesh's own space, `lift` of its metres above the surface, placed as it is; `scale` as AppContext's.
    void show(std::span<const BorderLoop> loops, float lift, const render::Placement& placement, float scale);
    void clear();
    void device_lost() { drawn_ = {}; }

private:
    void upload(float scale);

    render::Renderer& renderer_;
    const glm::vec3 color_;
    const float width_;  // units
    render::CurvesId drawn_{};
    std::vector<glm::vec3> points_, normals_;
    std::vector<uint32_t> offsets_;
    std::vector<uint8_t> flags_;
};

}  // namespace flg::studio
