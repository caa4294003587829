// SPDX-License-Identifier: MIT
// From a picture and its depths to the finished picture: shaders/occlusion.frag, then shaders/finish.frag. Each layer
// of an image has its own, as llvmpipe goes wrong over both at once (device.h).
#pragma once

#include "device.h"
#include "pipeline_build.h"
#include "shaders.h"
#include "target_image.h"

namespace flg::render {

// Mirrors the push constants of shaders/picture_place.glsl.
struct FinishPush {
    glm::ivec2 size;
    glm::ivec2 out_corner;
    glm::ivec2 out_size;
};

class FinishPass {
public:
    // `samples`: of the picture's depths.
    FinishPass(const Device& device, const Shaders& shaders, VkDescriptorSetLayout view_layout,
               VkSampleCountFlagBits samples);
    ~FinishPass();
    FinishPass(const FinishPass&) = delete;
    FinishPass& operator=(const FinishPass&) = delete;
    // With those of another for the same device and samples.
    void swap_pipelines(FinishPass& other);

    VkRenderPass occlusion_pass() const { return occlusion_pass_; }
    VkRenderPass finish_pass() const { return finish_pass_; }
    VkRenderPass mean_pass(bool first) const { return mean_passes_[first ? 0 : 1]; }
    // For the sets of so many layers.
    VkDescriptorPool make_pool(uint32_t layers) const;
    VkDescriptorSet make_set(VkDescriptorPool pool, VkImageView depth, VkImageView scene, VkImageView occlusion) const;

    // Finishes a layer's picture of `drawn` pixels into `area` of the image; the rest of it is black.
    void record(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, uint32_t layer,
                VkExtent2D drawn, const VkRect2D& area) const;
    // The same into the mean of `frame` frames, the last of them this one.
    void record_mean(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, VkExtent2D drawn,
                     const VkRect2D& area, uint32_t frame) const;
    // Shows the mean.
    static void record_copy(VkCommandBuffer commands, const TargetImage& image);

private:
    void make_pipelines(const Shaders& shaders, VkSampleCountFlagBits samples);
    void record_occlusion(VkCommandBuffer commands, const TargetImage& image, uint32_t layer, VkExtent2D drawn) const;
    void bind(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, uint32_t layer,
              VkExtent2D drawn, const VkRect2D& area) const;
    void destroy();

    VkDevice device_;
    VkRenderPass occlusion_pass_ = VK_NULL_HANDLE, finish_pass_ = VK_NULL_HANDLE;
    VkRenderPass mean_passes_[2] = {};  // of the first frame, and of those after it
    VkSampler nearest_ = VK_NULL_HANDLE, linear_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline occlusion_ = VK_NULL_HANDLE, finish_ = VK_NULL_HANDLE, mean_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
