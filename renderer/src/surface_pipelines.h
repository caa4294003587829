// SPDX-License-Identifier: MIT
// The pipelines of surfaces and of the lines between their regions.
#pragma once

#include <glm/glm.hpp>

#include "device.h"

namespace flg::render {

// Mirrors the push constants of shaders/surface_draw.glsl.
struct SurfacePush {
    glm::vec3 isoline_color;
    float isoline_half_width_px;
    float field_low;
    float colors_per_unit;    // 1 / what the map spans
    float isolines_per_unit;  // 0 = none
    uint32_t flags;

    static constexpr uint32_t shows_field = 1;
    static constexpr uint32_t is_flat = 2;
};

constexpr uint32_t border_vertices = 12;  // of a line: four triangles, mirrors shaders/border.vert

class SurfacePipelines {
public:
    SurfacePipelines(const Device& device, VkRenderPass main_pass, VkSampleCountFlagBits samples,
                     VkRenderPass shadow_pass, VkDescriptorSetLayout view_layout);
    ~SurfacePipelines();
    SurfacePipelines(const SurfacePipelines&) = delete;
    SurfacePipelines& operator=(const SurfacePipelines&) = delete;

    VkPipelineLayout layout() const { return layout_; }  // set 0: the view
    VkPipeline surface() const { return surface_; }      // vertex buffers: positions, SurfaceVertex
    VkPipeline shadow() const { return shadow_; }        // positions
    VkPipeline border() const { return border_; }        // an instance each: BorderEdge

private:
    void destroy();

    VkDevice device_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline surface_ = VK_NULL_HANDLE;
    VkPipeline shadow_ = VK_NULL_HANDLE;
    VkPipeline border_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
