// SPDX-License-Identifier: MIT
// All pipelines and their layouts.
#pragma once

#include "device.h"

namespace flg::render {

// Mirrors the push constants of shaders/curve.vert and curve.frag.
struct CurvePush {
    uint32_t columns;
    uint32_t part;
    uint32_t cap_rings;
    uint32_t round_cap;
    float line_half_width_px;
    float gloss;
    float magnitude_offset;
    uint32_t in_front;
};

constexpr uint32_t curve_buffers = 4;  // of set 1: centers, looks, chunks, displacements

class Pipelines {
public:
    Pipelines(const Device& device, VkRenderPass main_pass, VkSampleCountFlagBits samples, VkRenderPass shadow_pass);
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    VkDescriptorSetLayout view_layout() const { return view_layout_; }      // set 0
    VkDescriptorSetLayout curves_layout() const { return curves_layout_; }  // set 1
    VkPipelineLayout layout() const { return layout_; }

    // `displaced`: of points moved by a magnitude offset.
    VkPipeline curve(const CurveLook& look, bool displaced) const;
    VkPipeline curve_shadow(Shape shape, bool displaced) const { return shadow_[displaced][static_cast<int>(shape)]; }
    VkPipeline backdrop() const { return backdrop_; }

private:
    void destroy();

    VkDevice device_;
    VkDescriptorSetLayout view_layout_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout curves_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline curve_[2][3] = {};     // displaced or not, by shape; both sides
    VkPipeline closed_tube_[2] = {};  // whose inside is never seen
    VkPipeline shadow_[2][2] = {};    // lines cast none
    VkPipeline backdrop_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
