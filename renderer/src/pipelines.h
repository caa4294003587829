// SPDX-License-Identifier: MIT
// All pipelines and their layouts.
#pragma once

#include "device.h"
#include "eyes.h"
#include "shaders.h"

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
    // Those for one eye; those for both when they are first needed.
    Pipelines(const Device& device, const Shaders& shaders, const RenderPasses& passes);
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    VkDescriptorSetLayout view_layout() const { return view_layout_; }      // set 0
    VkDescriptorSetLayout curves_layout() const { return curves_layout_; }  // set 1
    VkPipelineLayout layout() const { return layout_; }

    // Before anything is drawn for both eyes.
    void need_stereo();
    bool has_stereo() const { return backdrop(Eyes::both); }
    // With those of others for the same device and passes, and their shaders.
    void swap_pipelines(Pipelines& other);

    // `displaced`: of points moved by a magnitude offset.
    VkPipeline curve(const CurveLook& look, bool displaced, Eyes eyes) const;
    VkPipeline curve_shadow(Shape shape, bool displaced) const { return shadow_[displaced][static_cast<int>(shape)]; }
    VkPipeline backdrop(Eyes eyes) const { return main_[static_cast<int>(eyes)].backdrop; }

private:
    // Of a main pass.
    struct Main {
        VkPipeline curve[2][3] = {};     // displaced or not, by shape; both sides
        VkPipeline closed_tube[2] = {};  // whose inside is never seen
        VkPipeline backdrop = VK_NULL_HANDLE;
    };
    void make_main(Eyes eyes);
    void make_shadow();
    void destroy();

    VkDevice device_;
    const Shaders* shaders_;
    RenderPasses passes_;
    VkDescriptorSetLayout view_layout_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout curves_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    Main main_[2];                  // by Eyes
    VkPipeline shadow_[2][2] = {};  // lines cast none
};

}  // namespace flg::render
